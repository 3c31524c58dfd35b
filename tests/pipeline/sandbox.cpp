// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/pipeline/sandbox.hpp"

#include <algorithm>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <sstream>
#include <stdexcept>

#include <doctest/doctest.h>
#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include "core/embedded.hpp"

namespace ashimpact::test {

namespace {

void redirect(int stream, const std::string& path, int flags) {
    const int file = open(path.c_str(), flags, 0600);
    if (file < 0 || dup2(file, stream) < 0) _exit(127);
}

/// Messages with the lines that they were broken into put together.
std::string unbroken(const std::string& text) {
    std::string out;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const std::size_t next = std::min(text.find_first_not_of(' ', i + 1), text.size());
        const bool continues = text[i] == '\n' && next > i + 1 && next < text.size();
        out += continues ? ' ' : text[i];
        if (continues) i = next - 1;
    }
    return out;
}

}  // namespace

Sandbox::Sandbox() {
    std::string name = (std::filesystem::temp_directory_path() / "ashimpact-XXXXXX").string();
    if (mkdtemp(name.data()) == nullptr) throw std::runtime_error("no temporary folder");
    folder_ = name;
}

Sandbox::~Sandbox() {
    std::error_code ignored;
    std::filesystem::remove_all(folder_, ignored);
}

void Sandbox::write(const std::string& name, const std::string& content) const {
    std::filesystem::create_directories((folder_ / name).parent_path());
    std::ofstream(folder_ / name, std::ios::binary) << content;
}

std::string Sandbox::read(const std::string& name) const {
    std::ifstream stream(folder_ / name, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
}

Json Sandbox::json(const std::string& name) const {
    return parse_json(read(name));
}

bool Sandbox::has(const std::string& name) const {
    return std::filesystem::exists(folder_ / name);
}

std::vector<std::pair<std::string, std::string>> Sandbox::everything() const {
    std::vector<std::pair<std::string, std::string>> files;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder_)) {
        const std::string name = std::filesystem::relative(entry.path(), folder_).string();
        files.emplace_back(name, entry.is_regular_file() ? read(name) : "");
    }
    std::sort(files.begin(), files.end());
    return files;
}

Finished ashimpact_program(const Sandbox& sandbox, const std::string& arguments) {
    const Sandbox outputs;
    const std::string command = "cd '" + sandbox.folder().string() + "' && '" ASHIMPACT_PROGRAM "' " +
                                arguments + " >'" + outputs.path("out") + "' 2>'" + outputs.path("err") +
                                "' </dev/null";
    const int result = std::system(command.c_str());
    const std::string printed = outputs.read("err");
    return {WIFEXITED(result) ? WEXITSTATUS(result) : -1, outputs.read("out"), unbroken(printed), printed};
}

Finished succeeded(const Sandbox& sandbox, const std::string& arguments) {
    Finished finished = ashimpact_program(sandbox, arguments);
    REQUIRE_MESSAGE(finished.status == 0, arguments, "\n", finished.err);
    return finished;
}

const Finished& put_built_in_run(const Sandbox& sandbox) {
    static const Sandbox made;
    static const Finished run = succeeded(made, "run");
    std::filesystem::copy(made.folder(), sandbox.folder(), std::filesystem::copy_options::recursive);
    return run;
}

std::string check_refused(const Sandbox& sandbox, const std::string& arguments, const std::string& says) {
    CAPTURE(arguments);
    const auto before = sandbox.everything();
    const Finished finished = ashimpact_program(sandbox, arguments);
    CHECK(finished.status == 2);
    CHECK(finished.out.empty());
    CHECK(finished.err == containing(says));
    CHECK(lines_of(finished.err).size() == 1);
    CHECK(sandbox.everything() == before);
    return finished.err;
}

std::vector<std::string> lines_of(const std::string& text) {
    std::vector<std::string> lines;
    std::istringstream stream(text);
    for (std::string line; std::getline(stream, line);) lines.push_back(line);
    return lines;
}

Json edited(Json document, const std::string& edits) {
    for (std::size_t begin = 0; begin < edits.size();) {
        const std::size_t end = std::min(edits.find(" ; ", begin), edits.size());
        const std::string edit = edits.substr(begin, end - begin);
        begin = end + 3;
        const std::size_t equals = edit.find(" = ");
        if (equals != std::string::npos) {
            document[Json::json_pointer(edit.substr(0, equals))] = Json::parse(edit.substr(equals + 3));
            continue;
        }
        const Json::json_pointer gone(edit.substr(2));
        Json& from = document.at(gone.parent_pointer());
        if (from.is_array())
            from.erase(std::stoul(gone.back()));
        else
            from.erase(gone.back());
    }
    return document;
}

Json example_case() {
    return parse_json(embedded_file("cases/example/case.json").value());
}

Json under_laws(Json document, const std::vector<std::string>& laws) {
    document["laws"] = laws;
    if (std::ranges::count(laws, "maugis-dugdale") == 0) document.erase("particle");
    return document;
}

Json example_under(const char* law) {
    return under_laws(example_case(), {law});
}

Json with_one_sample(Json document, const std::vector<std::string>& laws) {
    document = under_laws(std::move(document), laws);
    while (document["samples"].size() > 1) document["samples"].erase(1);
    return document;
}

void write_example(const Sandbox& sandbox, const Json& document) {
    sandbox.write("case.json", document.dump(1));
    for (const auto* name : {"ash.csv", "impacts.csv"})
        sandbox.write(name, std::string(embedded_file(std::string("cases/example/") + name).value()));
}

Artifacts computed_from(const Json& document, std::string_view last) {
    const Sandbox sandbox;
    write_example(sandbox, document);
    return compute_artifacts(sandbox.path("case.json"), last);
}

Process::Process(const Sandbox& sandbox, const std::vector<std::string>& command,
                 const std::vector<std::string>& environment)
    : id_(fork()) {
    if (id_ < 0) throw std::runtime_error("no new process");
    if (id_ > 0) return;
    redirect(STDIN_FILENO, "/dev/null", O_RDONLY);
    redirect(STDOUT_FILENO, outputs_.path("out"), O_WRONLY | O_CREAT);
    redirect(STDERR_FILENO, outputs_.path("err"), O_WRONLY | O_CREAT);
    if (chdir(sandbox.folder().c_str()) != 0) _exit(127);
    for (const std::string& each : environment) {
        const auto equals = each.find('=');
        setenv(each.substr(0, equals).c_str(), each.substr(equals + 1).c_str(), 1);
    }
    std::vector<std::string> words = command;
    std::vector<char*> arguments;
    arguments.reserve(words.size() + 1);
    for (std::string& word : words) arguments.push_back(word.data());
    arguments.push_back(nullptr);
    execvp(arguments.front(), arguments.data());
    _exit(127);
}

Process::~Process() {
    if (id_ <= 0) return;
    signal(SIGKILL);
    static_cast<void>(wait());
}

void Process::signal(int number) const {
    kill(id_, number);
}

Ended Process::wait() {
    int result = 0;
    rusage usage{};
    wait4(id_, &result, 0, &usage);
    id_ = 0;
    const int status = WIFEXITED(result) ? WEXITSTATUS(result) : 128 + WTERMSIG(result);
    return {status, outputs_.read("out"), outputs_.read("err"), usage.ru_maxrss};
}

Ended run(const Sandbox& sandbox, const std::vector<std::string>& command,
          const std::vector<std::string>& environment) {
    return Process(sandbox, command, environment).wait();
}

std::vector<std::string> under_mpi(int processes, const std::vector<std::string>& command) {
    // Open MPI leaves memory behind, of parts it has unloaded: nothing that could be told by name. It takes
    // two locks of its own in either order, in its TCP transport.
    std::vector<std::string> whole{"env",    "ASAN_OPTIONS=detect_leaks=0", "TSAN_OPTIONS=detect_deadlocks=0",
                                   "mpirun", "--allow-run-as-root",         "--oversubscribe",
                                   "-n",     std::to_string(processes)};
    whole.insert(whole.end(), command.begin(), command.end());
    return whole;
}

}  // namespace ashimpact::test
