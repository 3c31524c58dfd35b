// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

#include <sys/types.h>

#include "core/json/document.hpp"
#include "pipeline/app/run_stages.hpp"

namespace ashimpact::test {

/// A folder of its own that is gone with it.
class Sandbox {
  public:
    Sandbox();
    ~Sandbox();
    Sandbox(const Sandbox&) = delete;
    Sandbox& operator=(const Sandbox&) = delete;
    Sandbox(Sandbox&&) = delete;
    Sandbox& operator=(Sandbox&&) = delete;

    [[nodiscard]] const std::filesystem::path& folder() const { return folder_; }
    [[nodiscard]] std::string path(const std::string& name) const { return (folder_ / name).string(); }

    void write(const std::string& name, const std::string& content) const;
    [[nodiscard]] std::string read(const std::string& name) const;
    [[nodiscard]] Json json(const std::string& name) const;
    [[nodiscard]] bool has(const std::string& name) const;
    /// Every file below the folder with its content, sorted by path.
    [[nodiscard]] std::vector<std::pair<std::string, std::string>> everything() const;

  private:
    std::filesystem::path folder_;
};

/// What a run of the program left.
struct Finished {
    int status;
    std::string out;
    std::string err;      ///< each message on one line
    std::string printed;  ///< standard error as it was, long messages broken
};

/// Runs the built program in the sandbox, as a newcomer would type it.
[[nodiscard]] Finished ashimpact_program(const Sandbox& sandbox, const std::string& arguments);

/// Does so and requires exit status 0.
Finished succeeded(const Sandbox& sandbox, const std::string& arguments);

/// Puts folder "results" into the sandbox, what `ashimpact run` leaves of the built-in case: computed once a
/// test program. @return how that run ended
const Finished& put_built_in_run(const Sandbox& sandbox);

/// Checks that a command is refused: exit status 2, no output, one line on standard error that contains
/// @p says, every file as it was. @return that line
std::string check_refused(const Sandbox& sandbox, const std::string& arguments, const std::string& says);

/// A piece of a text: CHECK(text == containing("piece")) prints both.
struct Containing {
    std::string piece;

    friend bool operator==(const std::string& text, const Containing& wanted) {
        return text.find(wanted.piece) != std::string::npos;
    }
    friend std::ostream& operator<<(std::ostream& out, const Containing& wanted) {
        return out << "containing " << wanted.piece;
    }
};
[[nodiscard]] inline Containing containing(std::string piece) {
    return {std::move(piece)};
}

/// Lines of a text, without their ends.
[[nodiscard]] std::vector<std::string> lines_of(const std::string& text);

/// A document after edits such as `/wall/rigid = true ; - /name`: a value for a pointer, and what is taken
/// away.
[[nodiscard]] Json edited(Json document, const std::string& edits);

/// The example case of `init`, which runs as it is.
[[nodiscard]] Json example_case();

/// The example's case under other laws, without the range of cohesion if none takes it.
[[nodiscard]] Json under_laws(Json document, const std::vector<std::string>& laws);

/// The same under one law: fits to measured impacts take their time.
[[nodiscard]] Json example_under(const char* law);

/// Takes what takes time out of a case: all samples but the first, and laws but these.
[[nodiscard]] Json with_one_sample(Json document, const std::vector<std::string>& laws);

/// Puts the example's case and the files it names into the sandbox.
void write_example(const Sandbox& sandbox, const Json& document);

/// The artifacts of that case, with the example's files beside it.
[[nodiscard]] Artifacts computed_from(const Json& document, std::string_view last = "comparison");

/// How a program ended.
struct Ended {
    int status;  ///< its exit status, or 128 and the signal that ended it
    std::string out;
    std::string err;
    long peak_memory;  ///< greatest resident set [kB]
};

/// A program running in a sandbox.
class Process {
  public:
    /// @param environment "NAME=value", beside what there is
    Process(const Sandbox& sandbox, const std::vector<std::string>& command,
            const std::vector<std::string>& environment = {});
    ~Process();
    Process(const Process&) = delete;
    Process& operator=(const Process&) = delete;
    Process(Process&&) = delete;
    Process& operator=(Process&&) = delete;

    void signal(int number) const;
    [[nodiscard]] Ended wait();

  private:
    Sandbox outputs_;
    pid_t id_;
};

/// Runs a program to its end.
[[nodiscard]] Ended run(const Sandbox& sandbox, const std::vector<std::string>& command,
                        const std::vector<std::string>& environment = {});

/// The command that starts a program with so many MPI processes, more than there are cores if need be.
[[nodiscard]] std::vector<std::string> under_mpi(int processes, const std::vector<std::string>& command);

}  // namespace ashimpact::test
