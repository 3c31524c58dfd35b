// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/document/run_folder.hpp"

#include <cerrno>
#include <cstdio>
#include <system_error>
#include <vector>

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include "core/text/error.hpp"
#include "pipeline/files/file.hpp"

namespace ashimpact {

namespace {

namespace fs = std::filesystem;

constexpr auto unfinished_name = ".ashimpact-new";  ///< new files, perhaps incomplete
constexpr auto decided_name = ".ashimpact-run";     ///< new files that belong in their places
constexpr std::string_view new_mark = "new.";
constexpr std::string_view old_mark = "old.";

[[noreturn]] void refuse(const fs::path& path, int error) {
    throw InputError("cannot be written: " + std::generic_category().message(error),
                     "a place you may write to")
        .at(FileName{path.string()});
}

void sync_folder(const fs::path& folder) {
    const int file = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (file < 0) return;
    static_cast<void>(::fsync(file));  // not every file system can
    ::close(file);
}

/// Renames a file, if there is one. @return 0, or the error
int move(const fs::path& from, const fs::path& to) {
    return ::rename(from.c_str(), to.c_str()) == 0 || errno == ENOENT ? 0 : errno;
}

/// One file of a decided replacement, which is carried out by renaming. Each step may be repeated.
class Replacement {
  public:
    Replacement(const fs::path& folder, const std::string& name)
        : fresh_(folder / decided_name / (std::string(new_mark) + name)),
          kept_(folder / decided_name / (std::string(old_mark) + name)),
          place_(folder / name) {
        std::error_code failure;
        if (fs::is_symlink(place_, failure)) place_ = fs::weakly_canonical(place_, failure);  // stays a link
        removes_ = fs::is_empty(fresh_, failure);
    }

    /// Keeps the old file under a second name, or moves it where there are no links, and puts the new one in
    /// its place. @return 0, or the error
    [[nodiscard]] int carry_out() const {
        std::error_code failure;
        if (!fs::exists(fresh_, failure)) return 0;  // done before
        if (removes_) return move(place_, kept_);
        if (::link(place_.c_str(), kept_.c_str()) != 0 && errno != ENOENT && errno != EEXIST)
            if (const int error = move(place_, kept_)) return error;
        return ::rename(fresh_.c_str(), place_.c_str()) == 0 ? 0 : errno;
    }

    [[nodiscard]] int take_back() const {
        std::error_code failure;
        if (!fs::exists(fresh_, failure))
            if (const int error = move(place_, fresh_)) return error;
        return move(kept_, place_);
    }

  private:
    fs::path fresh_;
    fs::path kept_;
    fs::path place_;
    bool removes_ = false;
};

/// Removes the folder of a replacement whose files are all in their places.
void clear(const fs::path& folder) {
    std::error_code ignored;
    sync_folder(folder);
    fs::rename(folder / decided_name, folder / unfinished_name, ignored);
    fs::remove_all(folder / unfinished_name, ignored);
}

/// Carries out a replacement that was decided and interrupted; removes one that was not decided.
void finish_interrupted(const fs::path& folder) {
    std::error_code ignored;
    fs::remove_all(folder / unfinished_name, ignored);
    if (!fs::exists(folder / decided_name, ignored)) return;
    std::vector<std::string> names;
    for (const auto& entry : fs::directory_iterator(folder / decided_name, ignored))
        if (const auto name = entry.path().filename().string(); name.starts_with(new_mark))
            names.push_back(name.substr(new_mark.size()));
    for (const std::string& name : names)
        if (const int error = Replacement(folder, name).carry_out()) refuse(folder / name, error);
    clear(folder);
}

/// Writes the new files, forces them onto the disk, and decides that they replace the old ones.
void decide(const fs::path& folder, std::span<const NamedContent> files) {
    const fs::path unfinished = folder / unfinished_name;
    if (::mkdir(unfinished.c_str(), 0777) != 0) refuse(unfinished, errno);
    for (const NamedContent& file : files)
        write_through(unfinished / (std::string(new_mark) + file.name), file.content);
    sync_folder(unfinished);
    if (::rename(unfinished.c_str(), (folder / decided_name).c_str()) != 0) refuse(unfinished, errno);
    sync_folder(folder);
}

}  // namespace

FolderLock::FolderLock(const fs::path& folder)
    : file_(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC)) {
    if (file_ < 0) refuse(folder, errno);
    int status = 0;
    do status = ::flock(file_, LOCK_EX | LOCK_NB);
    while (status != 0 && errno == EINTR);
    const bool taken = status != 0 && errno == EWOULDBLOCK;
    try {
        if (taken)
            throw InputError("another run is at work in this folder", "another -o, or wait until it is done")
                .at(FileName{folder.string()});
        finish_interrupted(folder);
    } catch (...) {
        ::close(file_);
        throw;
    }
}

FolderLock::~FolderLock() {
    ::close(file_);
}

void complete_interrupted(const fs::path& folder) {
    std::error_code ignored;
    if (fs::exists(folder / decided_name, ignored)) const FolderLock finishes(folder);
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

void replace_files(const fs::path& folder, std::span<const NamedContent> files) {
    try {
        decide(folder, files);
    } catch (...) {
        std::error_code ignored;
        fs::remove_all(folder / unfinished_name, ignored);
        throw;
    }
    const SignalsHeld held;
    std::vector<Replacement> replacements;
    for (const NamedContent& file : files) replacements.emplace_back(folder, file.name);
    int error = 0;
    for (std::size_t i = 0; i < replacements.size() && error == 0; ++i) error = replacements[i].carry_out();
    bool whole = true;
    if (error != 0)
        for (const Replacement& replacement : replacements) whole = replacement.take_back() == 0 && whole;
    if (whole) clear(folder);
    if (error != 0) refuse(folder, error);
}

}  // namespace ashimpact
