#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "pipeline/files/file.hpp"

namespace ashimpact {

/// Keeps a folder for one run: a second one is refused. The lock ends with the process that holds it, however
/// it ends; nothing is left in the folder.
class FolderLock {
  public:
    FolderLock() = default;
    /// Locks a folder that exists; a file system without locks is used without.
    /// @throws InputError if another run has it
    explicit FolderLock(const std::filesystem::path& folder);
    ~FolderLock();
    FolderLock(const FolderLock&) = delete;
    FolderLock& operator=(const FolderLock&) = delete;
    FolderLock(FolderLock&& other) noexcept;
    FolderLock& operator=(FolderLock&& other) noexcept;

    [[nodiscard]] bool held() const { return file_ >= 0; }

  private:
    int file_ = -1;
};

/// Refuses a folder in which something else than a plain file bears one of the names, without opening it: a
/// pipe would wait for ever. @throws InputError naming it
void require_plain_files(const std::filesystem::path& folder, std::span<const std::string> names);

/// Completes, or takes back, what an interrupted replace_files() left in a folder, and removes its temporary
/// files. To be called with the folder locked.
/// @throws InputError if that cannot be done
void settle(const std::filesystem::path& folder, std::span<const std::string> names);

struct NamedContent {
    std::string name;
    std::string content;
};

/// Replaces files of a folder, all or none, and leaves every other file as it is. The new files are written
/// beside first (in a folder of their own, `.ashimpact-new`) and forced onto the disk; then a journal is put
/// there under its name, which decides; then each file is renamed to its place. Where a rename fails those
/// before it are taken back. A process of its own renames, so that killing this one does not stop it halfway;
/// and whatever is interrupted nevertheless, settle() completes. docs/decisions/0011-run-folder.md.
/// @throws InputError if it cannot be done; then the old files are there
void replace_files(const std::filesystem::path& folder, std::span<const NamedContent> files);

}  // namespace ashimpact
