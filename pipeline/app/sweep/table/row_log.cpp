// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/app/sweep/table/row_log.hpp"

#include <cerrno>
#include <system_error>

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include "core/text/error.hpp"

namespace ashimpact {

RowLog::RowLog(std::filesystem::path path) : path_(std::move(path)) {
    for (;;) {
        file_ = open(path_.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
        if (file_ < 0) refuse("written");
        const bool locked = flock(file_, LOCK_EX | LOCK_NB) == 0;
        if (locked && is_current()) return;
        close(file_);
        if (!locked)
            throw InputError("another sweep writes here", "another -o, or patience")
                .at(FileName{path_.string()});
    }
}

RowLog::~RowLog() {
    struct stat status {};
    if (fstat(file_, &status) == 0 && status.st_size == 0 && is_current()) unlink(path_.c_str());
    close(file_);
}

bool RowLog::is_current() const {
    struct stat own {};
    struct stat named {};
    return fstat(file_, &own) == 0 && stat(path_.c_str(), &named) == 0 && own.st_dev == named.st_dev &&
           own.st_ino == named.st_ino;
}

void RowLog::resume(std::uint64_t size) {
    struct stat status {};
    if (fstat(file_, &status) == 0 && static_cast<std::uint64_t>(status.st_size) < size)
        throw InputError("is shorter than its checkpoint says", "--restart to begin anew")
            .at(FileName{path_.string()});
    truncate(size);
    if (size == 0) append(row_log_mark);
}

void RowLog::clear() {
    truncate(0);
}

void RowLog::truncate(std::uint64_t size) {
    if (ftruncate(file_, static_cast<off_t>(size)) != 0 || lseek(file_, 0, SEEK_END) < 0) refuse("written");
    size_ = size;
}

void RowLog::append(std::string_view rows) {
    size_ += rows.size();
    while (!rows.empty()) {
        const ssize_t written = write(file_, rows.data(), rows.size());
        if (written < 0 && errno != EINTR) refuse("written");
        if (written > 0) rows.remove_prefix(static_cast<std::size_t>(written));
    }
}

void RowLog::sync() {
    if (fdatasync(file_) != 0) refuse("written");
}

void RowLog::refuse(const std::string& doing) const {
    throw InputError("cannot be " + doing + ": " + std::generic_category().message(errno),
                     "a place you may write to")
        .at(FileName{path_.string()});
}

}  // namespace ashimpact
