// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/document/files/run_folder.hpp"

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <optional>
#include <sstream>
#include <system_error>
#include <utility>

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include "core/error.hpp"
#include "pipeline/document/files/signals.hpp"

namespace ashimpact {

namespace {

namespace fs = std::filesystem;

constexpr auto staging_name = ".ashimpact-new";
constexpr auto journal_name = "journal";        ///< there: the files are to be put into their places
constexpr auto way_back_name = "journal.back";  ///< becomes the journal where they are to be taken back
constexpr auto unfinished_name = "journal.part";
constexpr std::string_view forward_mark = "ashimpact run folder 1: forward\n";
constexpr std::string_view backward_mark = "ashimpact run folder 1: backward\n";

[[noreturn]] void refuse(const fs::path& path, int error) {
    throw InputError("cannot be written: " + std::generic_category().message(error),
                     "a place you may write to")
        .at(FileName{path.string()});
}

/// One file of a replacement. The journal states whether it replaces an old file, which can then be restored.
struct Move {
    std::string name;
    bool replaces;
    std::string staged;  ///< the new file
    std::string kept;    ///< second name of the old file, if there was one
    std::string place;
};

Move move_of(const fs::path& folder, const std::string& name, bool replaces) {
    const fs::path staging = folder / staging_name;
    std::error_code failure;
    fs::path place = folder / name;
    if (fs::is_symlink(place, failure)) place = fs::weakly_canonical(place, failure);  // a link stays one
    return {name, replaces, (staging / name).string(), (staging / ("old." + name)).string(), place.string()};
}

bool is_there(const std::string& path) {
    struct stat status {};
    return ::lstat(path.c_str(), &status) == 0;
}

/// Renames every staged file to its place. Allocates no memory, as it also runs in a process made by fork().
/// @return 0, or the error of the first rename that failed
int go_forward(const std::vector<Move>& moves) {
    for (const Move& move : moves)
        if (is_there(move.staged) && ::rename(move.staged.c_str(), move.place.c_str()) != 0) return errno;
    return 0;
}

/// Restores every old file; may be repeated. @return 0, or the error of the first failure
int go_back(const std::vector<Move>& moves) {
    int error = 0;
    for (const Move& move : moves) {
        const bool failed =
            move.replaces ? is_there(move.kept) && ::rename(move.kept.c_str(), move.place.c_str()) != 0
                          : !is_there(move.staged) && ::unlink(move.place.c_str()) != 0 && errno != ENOENT;
        if (failed && error == 0) error = errno;
    }
    return error;
}

/// How a committed replacement ended.
enum class Ended { replaced, taken_back, undecided };

/// Renames all files, and reverts them all if one rename fails. @param error that of the failed rename
Ended carry_out(const std::vector<Move>& moves, const std::string& journal, const std::string& way_back,
                int& error) {
    error = go_forward(moves);
    if (error == 0) return Ended::replaced;
    if (::rename(way_back.c_str(), journal.c_str()) != 0 || go_back(moves) != 0) return Ended::undecided;
    return Ended::taken_back;
}

/// What the process that renames tells the one that waits for it.
struct Result {
    Ended ended;
    int error;
};

/// The result that comes through a pipe; none where the other end closed without one.
std::optional<Result> result_through(int pipe) {
    Result result{};
    ssize_t bytes = 0;
    do bytes = ::read(pipe, &result, sizeof(result));
    while (bytes < 0 && errno == EINTR);
    return bytes == static_cast<ssize_t>(sizeof(result)) ? std::optional(result) : std::nullopt;
}

/// Like carry_out(), but in a process of its own, which goes on if this one is killed; in this process if no
/// other can be started. The pipe says when the other is done, by its result or by its end: nothing else may,
/// as two that rename at once would take each other's renames for failures.
Ended carry_out_apart(const std::vector<Move>& moves, const std::string& journal, const std::string& way_back,
                      int& error) {
    const SignalsHeld held;
    int ends[2] = {-1, -1};
    const pid_t child = ::pipe(ends) == 0 ? ::fork() : -1;
    if (child == 0) {  // only what is safe after fork(): no memory, no locks
        ::setsid();
        Result result{};
        result.ended = carry_out(moves, journal, way_back, result.error);
        const ssize_t told = ::write(ends[1], &result, sizeof(result));
        ::_exit(told == static_cast<ssize_t>(sizeof(result)) ? 0 : 1);
    }
    std::optional<Result> result;
    if (child > 0) {
        ::close(std::exchange(ends[1], -1));
        result = result_through(ends[0]);
        while (::waitpid(child, nullptr, 0) < 0 && errno == EINTR) {
        }
    }
    for (const int end : ends)
        if (end >= 0) ::close(end);
    if (result) error = result->error;
    if (result) return result->ended;
    if (is_there(way_back)) return carry_out(moves, journal, way_back, error);
    error = EIO;  // the other process was taking the files back; its own error is lost
    return go_back(moves) == 0 ? Ended::taken_back : Ended::undecided;
}

/// The moves that a journal lists, one a line behind its mark: "=name" replaces a file, "+name" does not.
std::vector<Move> moves_in(const fs::path& folder, std::istream& lines) {
    std::vector<Move> moves;
    for (std::string line; std::getline(lines, line);)
        if (line.size() > 1) moves.push_back(move_of(folder, line.substr(1), line.front() == '='));
    return moves;
}

/// Removes the traces of a finished replacement: the journal first, without which the rest has no effect.
void clear(const fs::path& staging) {
    std::error_code ignored;
    fs::remove(staging / journal_name, ignored);
    fs::remove_all(staging, ignored);
}

void sync_folder(const fs::path& folder) {
    const int file = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (file < 0) return;
    static_cast<void>(::fsync(file));  // not every file system can
    ::close(file);
}

/// Keeps the old file under a second name, or as a copy on a file system without links.
void keep_old(const Move& move) {
    if (::link(move.place.c_str(), move.kept.c_str()) == 0) return;
    write_through(move.kept, read_file(move.place));
}

void stage(const fs::path& folder, std::span<const NamedContent> files, std::vector<Move>& moves) {
    const fs::path staging = folder / staging_name;
    if (::mkdir(staging.c_str(), 0777) != 0) refuse(staging, errno);
    for (const NamedContent& file : files) {
        const Move& move =
            moves.emplace_back(move_of(folder, file.name, is_there(move_of(folder, file.name, false).place)));
        write_through(move.staged, file.content);
        if (move.replaces) keep_old(move);
    }
    std::string list;
    for (const Move& move : moves) list += (move.replaces ? '=' : '+') + move.name + '\n';
    write_through(staging / way_back_name, std::string(backward_mark) + list);
    write_through(staging / unfinished_name, std::string(forward_mark) + list);
    sync_folder(staging);
}

/// Temporary files of runs that were killed, of earlier versions of the program too.
void remove_stale(const fs::path& folder, std::span<const std::string> names) {
    std::error_code ignored;
    std::vector<fs::path> stale;
    for (const auto& entry : fs::directory_iterator(folder, ignored)) {
        const std::string name = entry.path().filename().string();
        const auto is_of = [&](const std::string& own) {
            if (!name.starts_with("." + own + ".") || !name.ends_with(".tmp")) return false;
            const std::string number = name.substr(own.size() + 2, name.size() - own.size() - 6);
            return !number.empty() && number.find_first_not_of("0123456789") == std::string::npos;
        };
        if (std::any_of(names.begin(), names.end(), is_of)) stale.push_back(entry.path());
    }
    for (const fs::path& path : stale) fs::remove(path, ignored);
}

}  // namespace

FolderLock::FolderLock(const fs::path& folder)
    : file_(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC)) {
    if (file_ < 0) refuse(folder, errno);
    int status = 0;
    do status = ::flock(file_, LOCK_EX | LOCK_NB);
    while (status != 0 && errno == EINTR);
    if (status == 0 || errno != EWOULDBLOCK) return;
    ::close(std::exchange(file_, -1));
    throw InputError("another run is at work in this folder", "another -o, or wait until it is done")
        .at(FileName{folder.string()});
}

FolderLock::~FolderLock() {
    if (file_ >= 0) ::close(file_);
}

FolderLock::FolderLock(FolderLock&& other) noexcept : file_(std::exchange(other.file_, -1)) {}

FolderLock& FolderLock::operator=(FolderLock&& other) noexcept {
    std::swap(file_, other.file_);
    return *this;
}

void require_plain_files(const fs::path& folder, std::span<const std::string> names) {
    for (const std::string& name : names) {
        std::error_code failure;
        const auto status = fs::status(folder / name, failure);
        if (fs::exists(status) && !fs::is_regular_file(status))
            throw InputError(fs::is_directory(status) ? "cannot be written: it is a folder"
                                                      : "cannot be written: it is no plain file",
                             "a plain file, or another -o")
                .at(FileName{(folder / name).string()});
    }
}

void settle(const fs::path& folder, std::span<const std::string> names) {
    const fs::path staging = folder / staging_name;
    remove_stale(folder, names);
    if (!is_there(staging.string())) return;
    if (is_there((staging / journal_name).string())) {
        std::istringstream journal(read_file(staging / journal_name));
        std::string mark;
        std::getline(journal, mark);
        const std::vector<Move> moves = moves_in(folder, journal);
        const int error = mark + "\n" == backward_mark ? go_back(moves) : go_forward(moves);
        if (error != 0) refuse(folder, error);
        sync_folder(folder);
    }
    clear(staging);
}

void replace_files(const fs::path& folder, std::span<const NamedContent> files) {
    const fs::path staging = folder / staging_name;
    std::vector<Move> moves;
    try {
        stage(folder, files, moves);
        if (::rename((staging / unfinished_name).c_str(), (staging / journal_name).c_str()) != 0)
            refuse(staging, errno);
    } catch (...) {
        clear(staging);
        throw;
    }
    sync_folder(staging);
    int error = 0;
    const Ended ended =
        carry_out_apart(moves, (staging / journal_name).string(), (staging / way_back_name).string(), error);
    sync_folder(folder);
    if (ended != Ended::undecided) clear(staging);
    if (ended != Ended::replaced) refuse(folder, error);
}

}  // namespace ashimpact
