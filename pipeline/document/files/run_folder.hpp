// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "pipeline/document/files/file.hpp"

namespace ashimpact {

/// Locks a folder for one run, so that a second one is refused. The lock ends with the process that holds it,
/// however that ends, and leaves nothing in the folder.
class FolderLock {
  public:
    FolderLock() = default;
    /// Locks an existing folder; does nothing on a file system without locks.
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

/// Checks that nothing but plain files has one of the names in a folder. Nothing is opened, because opening a
/// pipe could block. @throws InputError naming the other kind of file
void require_plain_files(const std::filesystem::path& folder, std::span<const std::string> names);

/// Completes or reverts an interrupted replace_files() in a folder, and removes its temporary files. The
/// folder must be locked. @throws InputError if that fails
void settle(const std::filesystem::path& folder, std::span<const std::string> names);

struct NamedContent {
    std::string name;
    std::string content;
};

/// Replaces files of a folder, all or none, and leaves every other file unchanged. The new files are first
/// written to a folder of their own, `.ashimpact-new`, and forced onto the disk. Then a journal is renamed
/// into that folder, which commits the replacement, and each file is renamed to its place. If a rename fails,
/// the earlier ones are reverted. A process of its own renames, so that killing this one does not stop it
/// halfway; settle() completes what is interrupted nevertheless. docs/decisions/0011-run-folder.md.
/// @throws InputError if it fails; the old files are then in place
void replace_files(const std::filesystem::path& folder, std::span<const NamedContent> files);

}  // namespace ashimpact
