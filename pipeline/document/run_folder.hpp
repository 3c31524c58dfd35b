// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <span>
#include <string>

#include "pipeline/files/file.hpp"

namespace ashimpact {

/// Locks an existing folder for one run, so that a second one is refused, and completes what an interrupted
/// one has left there. The lock ends with the process that holds it, however that ends, and leaves nothing in
/// the folder. On a file system without locks it does nothing.
class FolderLock {
  public:
    /// @throws InputError if another run has the folder, or an interrupted one cannot be completed
    explicit FolderLock(const std::filesystem::path& folder);
    ~FolderLock();
    FolderLock(const FolderLock&) = delete;
    FolderLock& operator=(const FolderLock&) = delete;
    FolderLock(FolderLock&&) = delete;
    FolderLock& operator=(FolderLock&&) = delete;

  private:
    int file_ = -1;
};

/// Completes a replacement that was killed halfway, so that the folder can be read. @throws InputError if
/// another process is still at it, or it cannot be completed
void complete_interrupted(const std::filesystem::path& folder);

/// Checks that nothing but plain files has one of the names in a folder. Nothing is opened, because opening a
/// pipe could block. @throws InputError naming the other kind of file
void require_plain_files(const std::filesystem::path& folder, std::span<const std::string> names);

struct NamedContent {
    std::string name;
    std::string content;  ///< empty: the file is removed
};

/// Replaces files of a locked folder, all or none, and leaves every other file unchanged. The new files are
/// first written to a folder of their own, `.ashimpact-new`, and forced onto the disk. Renaming that folder
/// to `.ashimpact-run` decides: before it the old files count, after it the new ones. Then each new file is
/// renamed to its place, and all old ones are put back if that fails. docs/decisions/0011-run-folder.md.
/// @throws InputError if it fails; the old files are then in place
void replace_files(const std::filesystem::path& folder, std::span<const NamedContent> files);

}  // namespace ashimpact
