#include "pipeline/sweep/table/row_log.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>

#include "materials/base/error.hpp"

namespace ashimpact {

RowLog::RowLog(std::filesystem::path path, std::uint64_t size)
    : path_(std::move(path)), file_(open(path_.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666)), size_(size) {
    if (file_ < 0) refuse("written");
    if (flock(file_, LOCK_EX | LOCK_NB) != 0) {
        close(file_);
        throw InputError("another sweep writes here", "another -o, or patience").in_file(path_.string());
    }
    struct stat status {};
    const bool known = fstat(file_, &status) == 0;
    if (known && static_cast<std::uint64_t>(status.st_size) < size_) {
        close(file_);
        throw InputError("is shorter than its checkpoint says", "--restart to begin anew")
            .in_file(path_.string());
    }
    if (!known || ftruncate(file_, static_cast<off_t>(size_)) != 0 || lseek(file_, 0, SEEK_END) < 0) {
        close(file_);
        refuse("written");
    }
    if (size_ > 0) return;
    try {
        append(row_log_mark);
    } catch (const InputError&) {
        close(file_);
        throw;
    }
}

RowLog::~RowLog() {
    close(file_);
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
        .in_file(path_.string());
}

}  // namespace ashimpact
