// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/present/report/drawing/figure_file.hpp"

#include <cerrno>
#include <cstdio>
#include <memory>
#include <system_error>
#include <vector>

#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include "core/text/error.hpp"
#include "core/text/text.hpp"

namespace ashimpact::report {

namespace {

constexpr const char* converter = "rsvg-convert";

/// A file without a name that is gone when it is closed.
using TemporaryFile = std::unique_ptr<std::FILE, int (*)(std::FILE*)>;

TemporaryFile temporary_file(const std::string& content) {
    TemporaryFile file(std::tmpfile(), std::fclose);
    if (!file || std::fwrite(content.data(), 1, content.size(), file.get()) != content.size())
        throw std::system_error(errno, std::generic_category(), "temporary file");
    std::rewind(file.get());
    return file;
}

std::string content_of(std::FILE* file) {
    std::rewind(file);
    std::string content;
    std::vector<char> block(65536);
    while (const std::size_t count = std::fread(block.data(), 1, block.size(), file))
        content.append(block.data(), count);
    return content;
}

[[noreturn]] void missing() {
    throw InputError(std::string(converter) + " is missing, which makes PDF and PNG of an SVG",
                     "the Debian package librsvg2-bin, or a file that ends in .svg")
        .at(converter);
}

std::vector<char*> pointers_to(std::vector<std::string>& words) {
    std::vector<char*> pointers;
    for (std::string& word : words) pointers.push_back(word.data());
    pointers.push_back(nullptr);
    return pointers;
}

/// Starts the converter; its environment fixes the date that PDF files carry.
pid_t start(const std::vector<std::string>& arguments, std::FILE* in, std::FILE* out) {
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_adddup2(&actions, fileno(in), STDIN_FILENO);
    posix_spawn_file_actions_adddup2(&actions, fileno(out), STDOUT_FILENO);
    std::vector<std::string> words{converter};
    words.insert(words.end(), arguments.begin(), arguments.end());
    std::vector<std::string> variables;
    for (char** variable = environ; *variable != nullptr; ++variable) variables.emplace_back(*variable);
    variables.emplace_back("SOURCE_DATE_EPOCH=0");
    pid_t process = -1;
    const int status = posix_spawnp(&process, converter, &actions, nullptr, pointers_to(words).data(),
                                    pointers_to(variables).data());
    posix_spawn_file_actions_destroy(&actions);
    if (status == ENOENT) missing();
    if (status != 0)
        throw InputError("cannot be started: " + std::generic_category().message(status)).at(converter);
    return process;
}

std::string convert(const std::string& input, const std::vector<std::string>& arguments) {
    const TemporaryFile in = temporary_file(input);
    const TemporaryFile out = temporary_file("");
    const pid_t process = start(arguments, in.get(), out.get());
    int status = 0;
    while (waitpid(process, &status, 0) < 0 && errno == EINTR) continue;
    if (WIFEXITED(status) && WEXITSTATUS(status) == 127) missing();
    std::string output = content_of(out.get());
    if (!WIFEXITED(status) || WEXITSTATUS(status) != 0 || output.empty())
        throw InputError("failed to convert the figure",
                         "a working librsvg2-bin, or a file that ends in .svg")
            .at(converter);
    return output;
}

}  // namespace

FigureFormat format_of(const std::filesystem::path& file) {
    const std::string ending = lower_case(file.extension().string());
    if (ending == ".svg") return FigureFormat::svg;
    if (ending == ".pdf") return FigureFormat::pdf;
    if (ending == ".png") return FigureFormat::png;
    throw InputError("the file name " + in_quotes(file.filename().string()) + " tells no format",
                     "one that ends in .svg, .pdf or .png")
        .at("-o");
}

void require_converter(FigureFormat format) {
    if (format != FigureFormat::svg) static_cast<void>(convert("", {"--version"}));
}

std::string figure_bytes(const Figure& figure, Width width, FigureFormat format) {
    std::string svg = svg_file(figure, width);
    if (format == FigureFormat::svg) return svg;
    if (format == FigureFormat::pdf) return convert(svg, {"--format=pdf"});
    return convert(svg, {"--format=png", "--dpi-x=600", "--dpi-y=600"});
}

}  // namespace ashimpact::report
