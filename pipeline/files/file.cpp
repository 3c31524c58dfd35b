// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/files/file.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdint>
#include <fstream>
#include <optional>
#include <string_view>
#include <system_error>
#include <vector>

#include <fcntl.h>
#include <fmt/format.h>
#include <nettle/sha2.h>
#include <unistd.h>

#include "core/json/document.hpp"
#include "core/text/error.hpp"

namespace ashimpact {

namespace {

std::string reason(int error) {
    return std::generic_category().message(error);
}

[[noreturn]] void refuse_write(const std::filesystem::path& path, const std::string& why) {
    throw InputError("cannot be written: " + why, "a place you may write to").at(FileName{path.string()});
}

/// Writes bytes to a file, which is made or emptied. @return 0, or the error
int write_bytes(const std::filesystem::path& path, std::string_view bytes, bool onto_disk) {
    const auto again = [](auto&& call) {
        auto result = call();
        while (result < 0 && errno == EINTR) result = call();
        return result;
    };
    const int file =
        again([&] { return open(path.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666); });
    if (file < 0) return errno;
    int error = 0;
    while (error == 0 && !bytes.empty()) {
        const ssize_t written = again([&] { return write(file, bytes.data(), bytes.size()); });
        if (written < 0)
            error = errno;
        else
            bytes.remove_prefix(static_cast<std::size_t>(written));
    }
    // A pipe and some file systems cannot be synchronised; only errors of the disk count.
    const bool forced = !onto_disk || error != 0 || again([&] { return fsync(file); }) == 0;
    if (!forced && errno != EINVAL && errno != ENOTSUP) error = errno;
    if (close(file) != 0 && error == 0 && errno != EINTR) error = errno;
    return error;
}

/// Files under temporary names. The destructor removes those that commit() has not renamed.
class Staged {
  public:
    Staged() = default;
    ~Staged() {
        for (const Entry& entry : entries_) std::filesystem::remove(entry.temporary, ignored_);
    }
    Staged(const Staged&) = delete;
    Staged& operator=(const Staged&) = delete;
    Staged(Staged&&) = delete;
    Staged& operator=(Staged&&) = delete;

    void add(const FileContent& file) {
        if (std::filesystem::is_directory(file.path, ignored_)) refuse_write(file.path, "it is a folder");
        const auto status = std::filesystem::status(file.path, ignored_);
        if (std::filesystem::exists(status) && !std::filesystem::is_regular_file(status)) {
            streams_.push_back(&file);  // a device or a pipe has no content to be replaced
            return;
        }
        const auto place = through_links(file.path);
        const auto folder = place.parent_path();
        make_folder(folder);
        const auto name = "." + place.filename().string() + "." + std::to_string(getpid()) + ".tmp";
        entries_.push_back({folder / name, place});
        write(file, entries_.back().temporary);
    }

    void commit() {
        for (const FileContent* file : streams_) write(*file, file->path);
        const SignalsHeld held;
        for (; !entries_.empty(); entries_.erase(entries_.begin())) {
            std::error_code failure;
            std::filesystem::rename(entries_.front().temporary, entries_.front().place, failure);
            if (failure) refuse_write(entries_.front().place, failure.message());
        }
    }

  private:
    /// The file that a symbolic link names; any other path as it is.
    static std::filesystem::path through_links(const std::filesystem::path& path) {
        std::error_code failure;
        if (!std::filesystem::is_symlink(path, failure)) return path;
        auto target = std::filesystem::weakly_canonical(path, failure);
        if (failure) refuse_write(path, failure.message());
        return target;
    }

    static void write(const FileContent& file, const std::filesystem::path& to) {
        if (const int error = write_bytes(to, file.content, false)) refuse_write(file.path, reason(error));
    }

    struct Entry {
        std::filesystem::path temporary;
        std::filesystem::path place;
    };
    std::vector<Entry> entries_;
    std::vector<const FileContent*> streams_;
    std::error_code ignored_;
};

/// The value of "schema" in quotes, where a JSON document begins with it, as our artifacts do: they need not
/// be parsed as a whole to learn it. None in any other document.
std::optional<std::string_view> leading_schema(std::string_view document) {
    const auto skip = [&](std::string_view text) {
        document.remove_prefix(std::min(document.find_first_not_of(" \t\r\n"), document.size()));
        const bool present = document.starts_with(text);
        if (present) document.remove_prefix(text.size());
        return present;
    };
    if (!skip("{") || !skip("\"schema\"") || !skip(":") || !skip("\"")) return std::nullopt;
    const std::size_t end = document.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789-");
    if (end == std::string_view::npos || document[end] != '"') return std::nullopt;
    return std::string_view(document.data() - 1, end + 2);
}

std::string kind_of(std::string_view bytes) {
    for (const std::string_view mark : {own_page_mark, own_figure_mark})
        if (bytes.find(mark) != std::string_view::npos) return std::string(mark);
    if (bytes.starts_with("%PDF")) return "PDF";
    if (const auto schema = leading_schema(bytes)) return "JSON " + std::string(*schema);
    const Json document = bytes.starts_with('{') ? Json::parse(bytes, nullptr, false) : Json();
    if (document.is_object()) return "JSON " + document.value("schema", Json()).dump();
    return std::string(bytes.substr(0, bytes.find('\n')));
}

}  // namespace

std::string read_file(const std::filesystem::path& path) {
    std::string content = read_start(path, longest_file + 1);
    if (content.size() > longest_file)
        throw InputError("is longer than 256 MiB", "a file of at most 256 MiB").at(FileName{path.string()});
    return content;
}

void make_folder(const std::filesystem::path& folder) {
    std::error_code failure;
    if (!folder.empty()) std::filesystem::create_directories(folder, failure);
    if (failure) refuse_write(folder, failure.message());
}

bool is_same_file(const std::filesystem::path& one, const std::filesystem::path& other) {
    std::error_code ignored;
    return std::filesystem::equivalent(one, other, ignored);
}

void require_writable_folder(const std::filesystem::path& folder) {
    std::error_code failure;
    auto there = std::filesystem::absolute(folder, failure);
    const auto kind = [&] { return std::filesystem::status(there, failure).type(); };
    while (kind() == std::filesystem::file_type::not_found && there.has_relative_path())
        there = there.parent_path();
    if (kind() == std::filesystem::file_type::none) refuse_write(folder, failure.message());
    if (kind() != std::filesystem::file_type::directory) refuse_write(there, "it is no folder");
    if (access(there.c_str(), W_OK | X_OK) != 0) refuse_write(folder, reason(errno));
}

std::string read_start(const std::filesystem::path& path, std::size_t most) {
    std::error_code ignored;
    errno = 0;
    std::ifstream stream(path, std::ios::binary);
    const bool folder = std::filesystem::is_directory(path, ignored);
    if (!stream || folder) {
        const std::string why = folder ? "it is a folder" : reason(errno != 0 ? errno : EIO);
        throw InputError("cannot be read: " + why, "a file").at(FileName{path.string()});
    }
    std::string content;
    std::array<char, 1 << 16> block{};
    while (stream && content.size() < most) {
        stream.read(block.data(),
                    static_cast<std::streamsize>(std::min(block.size(), most - content.size())));
        content.append(block.data(), static_cast<std::size_t>(stream.gcount()));
    }
    return content;
}

void write_through(const std::filesystem::path& path, const std::string& content) {
    if (const int error = write_bytes(path, content, true)) refuse_write(path, reason(error));
}

void require_replaceable(const std::filesystem::path& path, std::string_view content) {
    std::error_code ignored;
    if (!std::filesystem::is_regular_file(path, ignored) || std::filesystem::is_empty(path, ignored)) return;
    if (kind_of(read_file(path)) != kind_of(content))
        throw InputError("is there already, and is nothing that this command writes",
                         "another name, or the file removed")
            .at(FileName{path.string()});
}

void write_files(std::span<const FileContent> files) {
    Staged staged;
    for (const FileContent& file : files) staged.add(file);
    staged.commit();
}

void write_file(const std::filesystem::path& path, const std::string& content) {
    require_replaceable(path, content);
    const FileContent file{path, content};
    write_files(std::span(&file, 1));
}

std::string sha256(std::string_view bytes) {
    sha256_ctx context;
    sha256_init(&context);
    // The one cast the C interface needs: it reads octets.
    sha256_update(&context, bytes.size(), reinterpret_cast<const std::uint8_t*>(bytes.data()));
    std::array<std::uint8_t, SHA256_DIGEST_SIZE> digest{};
    sha256_digest(&context, digest.size(), digest.data());
    return fmt::format("{:02x}", fmt::join(digest, ""));
}

}  // namespace ashimpact
