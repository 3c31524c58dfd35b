// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/present/report/figure_file.hpp"

#include <array>
#include <cerrno>
#include <csignal>
#include <system_error>
#include <vector>

#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include "core/error.hpp"
#include "core/text.hpp"

namespace ashimpact::report {

namespace {

constexpr const char* converter = "rsvg-convert";

/// Both ends of a pipe, closed when they are no longer needed.
class Pipe {
  public:
    Pipe() {
        if (pipe2(ends_.data(), O_CLOEXEC) != 0)
            throw std::system_error(errno, std::generic_category(), "pipe");
    }
    ~Pipe() {
        close_reading();
        close_writing();
    }
    Pipe(const Pipe&) = delete;
    Pipe& operator=(const Pipe&) = delete;

    [[nodiscard]] int reading() const { return ends_[0]; }
    [[nodiscard]] int writing() const { return ends_[1]; }
    void close_reading() { close_end(ends_[0]); }
    void close_writing() { close_end(ends_[1]); }

  private:
    static void close_end(int& end) {
        if (end >= 0) close(end);
        end = -1;
    }
    std::array<int, 2> ends_{-1, -1};
};

[[noreturn]] void missing() {
    throw InputError(std::string(converter) + " is missing, which makes PDF and PNG of an SVG",
                     "the Debian package librsvg2-bin, or a file that ends in .svg")
        .at(converter);
}

/// Starts the converter on two pipes; its environment fixes the date that PDF files carry.
pid_t start(const std::vector<std::string>& arguments, Pipe& in, Pipe& out) {
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_adddup2(&actions, in.reading(), STDIN_FILENO);
    posix_spawn_file_actions_adddup2(&actions, out.writing(), STDOUT_FILENO);
    std::vector<std::string> words{converter};
    words.insert(words.end(), arguments.begin(), arguments.end());
    std::vector<char*> pointers;
    pointers.reserve(words.size() + 1);
    for (std::string& word : words) pointers.push_back(word.data());
    pointers.push_back(nullptr);
    std::string date = "SOURCE_DATE_EPOCH=0";
    std::vector<char*> environment;
    for (char** variable = environ; *variable != nullptr; ++variable) environment.push_back(*variable);
    environment.push_back(date.data());
    environment.push_back(nullptr);
    pid_t process = -1;
    const int status =
        posix_spawnp(&process, converter, &actions, nullptr, pointers.data(), environment.data());
    posix_spawn_file_actions_destroy(&actions);
    if (status == ENOENT) missing();
    if (status != 0)
        throw InputError("cannot be started: " + std::generic_category().message(status)).at(converter);
    in.close_reading();
    out.close_writing();
    return process;
}

/// Writes all of @p input and reads all that comes, whichever is ready.
std::string exchange(const std::string& input, Pipe& in, Pipe& out) {
    std::string output;
    std::size_t written = 0;
    fcntl(in.writing(), F_SETFL, O_NONBLOCK);
    while (true) {
        std::array<pollfd, 2> ends{pollfd{in.writing(), POLLOUT, 0}, pollfd{out.reading(), POLLIN, 0}};
        if (poll(ends.data(), ends.size(), -1) < 0 && errno != EINTR)
            throw std::system_error(errno, std::generic_category(), "poll");
        if (in.writing() >= 0 && (ends[0].revents & (POLLOUT | POLLERR | POLLHUP)) != 0) {
            const ssize_t count = write(in.writing(), input.data() + written, input.size() - written);
            if (count > 0) written += static_cast<std::size_t>(count);
            if (written == input.size() || (count < 0 && errno != EAGAIN && errno != EINTR))
                in.close_writing();
        }
        if ((ends[1].revents & (POLLIN | POLLHUP)) == 0) continue;
        std::array<char, 65536> block{};
        const ssize_t count = read(out.reading(), block.data(), block.size());
        if (count > 0) output.append(block.data(), static_cast<std::size_t>(count));
        if (count == 0 || (count < 0 && errno != EAGAIN && errno != EINTR)) return output;
    }
}

std::string convert(const std::string& input, const std::vector<std::string>& arguments) {
    Pipe in;
    Pipe out;
    const pid_t process = start(arguments, in, out);
    struct sigaction ignore {};
    struct sigaction before {};
    ignore.sa_handler = SIG_IGN;  // a converter that dies closes its end: that is an error of ours to report
    sigaction(SIGPIPE, &ignore, &before);
    std::string output = exchange(input, in, out);
    sigaction(SIGPIPE, &before, nullptr);
    int status = 0;
    while (waitpid(process, &status, 0) < 0 && errno == EINTR) continue;
    if (WIFEXITED(status) && WEXITSTATUS(status) == 127) missing();
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
