// SPDX-License-Identifier: GPL-3.0-or-later
#include <cerrno>
#include <cstring>
#include <fstream>
#include <set>
#include <span>
#include <system_error>
#include <utility>

#include <fcntl.h>
#include <hdf5.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>
#include <zlib.h>

#include "core/text/error.hpp"
#include "core/version.hpp"
#include "pipeline/app/sweep/bytes.hpp"
#include "pipeline/app/sweep/sweep.hpp"
#include "pipeline/files/file.hpp"
#include "pipeline/present/export/folder.hpp"

namespace ashimpact {

namespace {

/// HDF5's shuffle: the first bytes of all numbers, then the second ones, ...
std::string shuffled(std::vector<double> column, std::size_t rows) {
    column.resize(rows, 0.0);
    const auto* const plain = reinterpret_cast<const char*>(column.data());
    std::string bytes(rows * sizeof(double), '\0');
    for (std::size_t row = 0; row < rows; ++row)
        for (std::size_t byte = 0; byte < sizeof(double); ++byte)
            bytes[byte * rows + row] = plain[row * sizeof(double) + byte];
    return bytes;
}

std::string deflated(const std::string& bytes) {
    uLongf size = compressBound(static_cast<uLong>(bytes.size()));
    std::string packed(size, '\0');
    const int status = compress2(reinterpret_cast<Bytef*>(packed.data()), &size,
                                 reinterpret_cast<const Bytef*>(bytes.data()),
                                 static_cast<uLong>(bytes.size()), deflate_level);
    if (status != Z_OK) throw std::runtime_error("zlib cannot deflate a chunk of the table");
    packed.resize(size);
    return packed;
}

constexpr std::size_t digest_length = 64;  ///< of a SHA-256 in hexadecimal
/// Beyond the rows of any chunk: a length above it is damaged, and no memory is asked for.
constexpr std::uint64_t most_packed_bytes = std::uint64_t{1} << 28U;

std::string digest_of(std::uint64_t chunk, const std::string& packed) {
    return sha256(std::to_string(chunk) + "\n" + packed);
}

/// The packed columns of the next chunk; none unless it has this number and is unchanged.
std::optional<std::vector<std::string>> read_sealed_rows(std::istream& stream, std::uint64_t chunk) {
    std::string digest(digest_length, '\0');
    std::uint64_t length = 0;
    stream.read(digest.data(), static_cast<std::streamsize>(digest.size()));
    stream.read(reinterpret_cast<char*>(&length), sizeof(length));
    if (!stream || length > most_packed_bytes) return std::nullopt;
    std::string packed_rows(length, '\0');
    stream.read(packed_rows.data(), static_cast<std::streamsize>(length));
    if (!stream || digest != digest_of(chunk, packed_rows)) return std::nullopt;
    return unpacked<std::vector<std::string>>(packed_rows);  // as they were written: the digest agrees
}

/// A failed call of HDF5. Its own messages are long and would go to standard error, see silence().
class Hdf5Error : public std::runtime_error {
  public:
    explicit Hdf5Error(const char* what) : std::runtime_error(std::string("HDF5: ") + what + " failed") {}
};

/// @throws Hdf5Error for a negative status
void check(herr_t status, const char* what) {
    if (status < 0) throw Hdf5Error(what);
}

/// Owns an HDF5 identifier.
class Handle {
  public:
    using Close = herr_t (*)(hid_t);

    Handle(hid_t id, Close closer, const char* what) : id_(id), close_(closer) {
        if (id < 0) throw Hdf5Error(what);
    }
    Handle(Handle&& other) noexcept : id_(std::exchange(other.id_, -1)), close_(other.close_) {}
    ~Handle() {
        if (id_ >= 0) close_(id_);
    }
    [[nodiscard]] hid_t id() const { return id_; }
    /// Closes it now. @throws Hdf5Error if not all was written
    void close(const char* what) { check(close_(std::exchange(id_, -1)), what); }

  private:
    hid_t id_;
    Close close_;
};

/// Before any other call: no messages of HDF5, and no clean-up at exit, which would crash on a full disk;
/// every file is closed explicitly.
void silence() {
    static const herr_t no_clean_up = H5dont_atexit();  // refused from the second time on
    check(no_clean_up, "H5dont_atexit");
    check(H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr), "H5Eset_auto");
}

/// A property list without time stamps.
Handle timeless(hid_t kind) {
    Handle properties(H5Pcreate(kind), H5Pclose, "H5Pcreate");
    check(H5Pset_obj_track_times(properties.id(), false), "H5Pset_obj_track_times");
    return properties;
}

/// Adds a text to a file, group or dataset.
void add_attribute(hid_t object, const char* name, const std::string& value) {
    const Handle type(H5Tcopy(H5T_C_S1), H5Tclose, "H5Tcopy");
    check(H5Tset_size(type.id(), value.size() + 1), "H5Tset_size");
    const Handle space(H5Screate(H5S_SCALAR), H5Sclose, "H5Screate");
    const Handle attribute(H5Acreate2(object, name, type.id(), space.id(), H5P_DEFAULT, H5P_DEFAULT),
                           H5Aclose, "H5Acreate");
    check(H5Awrite(attribute.id(), type.id(), value.c_str()), "H5Awrite");
}

/// Adds a dataset of doubles, with their values if they are known, its unit and description.
Handle add_dataset(const Handle& file, const TableColumn& column, const std::vector<hsize_t>& extent,
                   const Handle& properties, const double* values = nullptr) {
    const Handle space(H5Screate_simple(static_cast<int>(extent.size()), extent.data(), nullptr), H5Sclose,
                       "H5Screate_simple");
    Handle dataset(H5Dcreate2(file.id(), column.path.c_str(), H5T_IEEE_F64LE, space.id(), H5P_DEFAULT,
                              properties.id(), H5P_DEFAULT),
                   H5Dclose, "H5Dcreate");
    if (values != nullptr)
        check(H5Dwrite(dataset.id(), H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values), "H5Dwrite");
    add_attribute(dataset.id(), "unit", column.unit);
    add_attribute(dataset.id(), "description", column.description);
    return dataset;
}

constexpr auto spec_attribute = "spec_sha256";

std::string rows_text(const SweepPlan& plan) {
    if (!plan.with_sensitivity()) return "row n is point n";
    const std::string width = std::to_string(plan.impacts_a_point());
    return "row " + width + " n + k is point n: k = 0 at a, 1 at b, 2 + i at a with variable i from b";
}

/// Adds the columns of the full table, shuffled and deflated, in groups by the beginnings of their paths.
std::vector<Handle> add_columns(const Handle& file, const SweepPlan& plan) {
    const Handle properties = timeless(H5P_DATASET_CREATE);
    const hsize_t rows_in_chunk = plan.rows_in_chunk();
    check(H5Pset_chunk(properties.id(), 1, &rows_in_chunk), "H5Pset_chunk");
    check(H5Pset_shuffle(properties.id()), "H5Pset_shuffle");
    check(H5Pset_deflate(properties.id(), deflate_level), "H5Pset_deflate");
    const Handle of_group = timeless(H5P_GROUP_CREATE);
    std::set<std::string> groups;
    std::vector<Handle> columns;
    for (const TableColumn& column : plan.table_columns()) {
        const std::string group = column.path.substr(0, column.path.find('/'));
        if (groups.insert(group).second)
            Handle(H5Gcreate2(file.id(), group.c_str(), H5P_DEFAULT, of_group.id(), H5P_DEFAULT), H5Gclose,
                   "H5Gcreate");
        columns.push_back(add_dataset(file, column, {plan.rows()}, properties));
    }
    return columns;
}

/// @throws InputError naming the file of rows if they are not those that were sealed
void copy_rows(const std::filesystem::path& file, const SweepPlan& plan, const std::vector<Handle>& columns) {
    std::ifstream rows(file, std::ios::binary);
    rows.seekg(row_log_mark.size());
    for (std::uint64_t chunk = 0; chunk < plan.chunks(); ++chunk) {
        const auto packed = read_sealed_rows(rows, chunk);
        const hsize_t offset = chunk * plan.rows_in_chunk();
        if (!packed || packed->size() != columns.size())
            throw InputError("is damaged from row " + std::to_string(offset) + " of the table on",
                             "--restart to begin anew, or another -o")
                .at(FileName{file.string()});
        for (std::size_t i = 0; i < columns.size(); ++i) {
            const std::string& column = (*packed)[i];
            check(H5Dwrite_chunk(columns[i].id(), H5P_DEFAULT, 0, &offset, column.size(), column.data()),
                  "H5Dwrite_chunk");
        }
    }
}

void fill_table(const std::filesystem::path& path, const SweepPlan& plan, const std::filesystem::path& rows) {
    silence();
    const Handle properties = timeless(H5P_FILE_CREATE);
    Handle file(H5Fcreate(path.c_str(), H5F_ACC_TRUNC, properties.id(), H5P_DEFAULT), H5Fclose, "H5Fcreate");
    add_attribute(file.id(), "program", "ashimpact " + std::string(program_version()));
    add_attribute(file.id(), "revision", std::string(program_revision()));
    add_attribute(file.id(), spec_attribute, plan.hash());
    add_attribute(file.id(), "rows", rows_text(plan));
    std::vector<Handle> columns = add_columns(file, plan);
    copy_rows(rows, plan, columns);
    for (Handle& column : columns) column.close("H5Dclose");
    file.close("H5Fclose");
}

std::string read_text_attribute(hid_t object, const char* name) {
    const Handle attribute(H5Aopen(object, name, H5P_DEFAULT), H5Aclose, "H5Aopen");
    const Handle type(H5Aget_type(attribute.id()), H5Tclose, "H5Aget_type");
    if (H5Tget_class(type.id()) != H5T_STRING || H5Tis_variable_str(type.id()) != 0)
        throw Hdf5Error("reading a text");
    constexpr std::size_t longest_text = 1000;
    const std::size_t size = H5Tget_size(type.id());
    if (size == 0 || size > longest_text) throw Hdf5Error("reading a text");
    std::string text(size, '\0');
    check(H5Aread(attribute.id(), type.id(), text.data()), "H5Aread");
    return text.substr(0, text.find('\0'));
}

constexpr std::size_t growth = std::size_t{1} << 20U;  // of the image in memory [byte]

void add(const Handle& file, const TableColumn& column, const std::vector<hsize_t>& extent,
         std::span<const double> values) {
    add_dataset(file, column, extent, timeless(H5P_DATASET_CREATE), values.data());
}

void add_sizes(const Handle& file, const ImpactTable& table) {
    const std::vector<hsize_t> sizes{table.diameter.size()};
    const std::vector<double> none(table.diameter.size(), 0.0);
    add(file, {"diameter", "m", "evenly in its logarithm"}, sizes, table.diameter);
    add(file, {"critical_velocity", "m/s", "below it a particle stays; 0: none does"}, sizes,
        table.captures ? table.start_velocity : none);
    add(file, {"start_velocity", "m/s", "v_0 of t"}, sizes, table.start_velocity);
    add(file, {"slope", "1", "d ln v_0 / d ln d"}, sizes, table.slope);
    add(file, {"t", "1", "asinh(sqrt(v/v_0 - 1))"}, {table.t.size()}, table.t);
}

void add_impacts(const Handle& file, const ExportSubject& subject, const ImpactTable& table) {
    const std::vector<hsize_t> extent{table.diameter.size(), table.t.size()};
    const auto add_table = [&](const char* name, std::string_view unit, const char* description,
                               const Eigen::ArrayXXd& values) {
        const Eigen::Array<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> rows = values;
        add(file, {name, std::string(unit), description}, extent,
            {rows.data(), static_cast<std::size_t>(rows.size())});
    };
    add_table("velocity", "m/s", "v_in = v_0 (1 + sinh(t)^2)", table.velocity);
    add_table("restitution", "1", "e_n; 0 for a capture", table.restitution);
    add_table("contact_time", "s", "not a number for a capture", table.contact_time);
    add_table("damping", unit_of(subject.damping_law), "coefficient of the damping law", table.damping);
}

std::string image_of(const Handle& file) {
    check(H5Fflush(file.id(), H5F_SCOPE_GLOBAL), "H5Fflush");
    const auto size = H5Fget_file_image(file.id(), nullptr, 0);
    check(size < 0 ? -1 : 0, "H5Fget_file_image");
    std::string image(static_cast<std::size_t>(size), '\0');
    check(H5Fget_file_image(file.id(), image.data(), image.size()) < 0 ? -1 : 0, "H5Fget_file_image");
    return image;
}

}  // namespace

std::string sealed_rows(std::uint64_t chunk, const std::vector<std::vector<double>>& columns,
                        std::size_t rows) {
    std::vector<std::string> packed_columns;
    for (const auto& column : columns) packed_columns.push_back(deflated(shuffled(column, rows)));
    const std::string packed_rows = packed(std::move(packed_columns));
    return digest_of(chunk, packed_rows) + packed(packed_rows);
}

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

std::optional<std::string> spec_of_table(const std::filesystem::path& file) {
    try {
        silence();
        const Handle opened(H5Fopen(file.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT), H5Fclose, "H5Fopen");
        if (!read_text_attribute(opened.id(), "program").starts_with("ashimpact ")) return std::nullopt;
        return read_text_attribute(opened.id(), spec_attribute);
    } catch (const Hdf5Error&) {
        return std::nullopt;
    }
}

void write_table(const std::filesystem::path& file, const SweepPlan& plan,
                 const std::filesystem::path& rows) {
    const auto temporary = file.parent_path() / ("." + file.filename().string() + ".tmp");
    std::error_code ignored;
    try {
        fill_table(temporary, plan, rows);
        std::filesystem::rename(temporary, file);
    } catch (const InputError&) {
        std::filesystem::remove(temporary, ignored);
        throw;
    } catch (const std::runtime_error& error) {  // HDF5's and the file system's
        std::filesystem::remove(temporary, ignored);
        throw InputError(std::string("cannot be written: ") + error.what(), "a place with room")
            .at(FileName{file.string()});
    }
}

std::string impact_table_image(const ExportSubject& subject, const ImpactTable& table) {
    silence();
    const Handle access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose, "H5Pcreate");
    check(H5Pset_fapl_core(access.id(), growth, false), "H5Pset_fapl_core");  // in memory alone
    const Handle properties = timeless(H5P_FILE_CREATE);
    const Handle file(H5Fcreate("table.h5", H5F_ACC_TRUNC, properties.id(), access.id()), H5Fclose,
                      "H5Fcreate");
    add_attribute(file.id(), "program", "ashimpact " + std::string(program_version()));
    add_attribute(file.id(), "law", std::string(subject.law.name()));
    add_attribute(file.id(), "detachment", std::string(name_of(subject.detachment)));
    add_attribute(file.id(), "damping_law", std::string(name_of(subject.damping_law)));
    add_attribute(file.id(), "from_velocity", exact(table.from_velocity));
    add_attribute(file.id(), "to_velocity", exact(table.to_velocity));
    add_sizes(file, table);
    add_impacts(file, subject, table);
    return image_of(file);
}

}  // namespace ashimpact
