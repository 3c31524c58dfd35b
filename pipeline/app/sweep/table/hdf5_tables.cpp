// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/app/sweep/table/hdf5_tables.hpp"

#include <fstream>
#include <set>
#include <span>
#include <stdexcept>
#include <utility>
#include <vector>

#include <hdf5.h>

#include "core/text/error.hpp"
#include "core/version.hpp"
#include "pipeline/app/sweep/table/rows.hpp"
#include "pipeline/present/export/folder.hpp"

namespace ashimpact {

namespace {

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

/// Stops HDF5 from writing messages to standard error, and from its clean-up at exit, which would crash when
/// it writes again what a full disk refused before. Every file is closed explicitly, so no clean-up is
/// needed. To be called before anything else of HDF5.
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

void copy_rows(std::istream& rows, const SweepPlan& plan, const std::vector<Handle>& columns) {
    for (std::uint64_t chunk = 0; chunk < plan.chunks(); ++chunk) {
        const std::vector<std::string> packed = read_sealed_rows(rows, chunk, columns.size());
        const hsize_t offset = chunk * plan.rows_in_chunk();
        for (std::size_t i = 0; i < columns.size(); ++i)
            check(
                H5Dwrite_chunk(columns[i].id(), H5P_DEFAULT, 0, &offset, packed[i].size(), packed[i].data()),
                "H5Dwrite_chunk");
    }
}

void fill_table(const std::filesystem::path& path, const SweepPlan& plan, std::istream& rows) {
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
    add_table("damping", unit_of(subject.damping.law), "coefficient of the damping law", table.damping);
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
    try {
        std::ifstream stream(rows, std::ios::binary);
        stream.seekg(row_log_mark.size());
        fill_table(temporary, plan, stream);
        std::filesystem::rename(temporary, file);
    } catch (const DamagedRows& damaged) {
        std::error_code ignored;
        std::filesystem::remove(temporary, ignored);
        const std::uint64_t first = damaged.chunk() * plan.rows_in_chunk();
        throw InputError("is damaged from row " + std::to_string(first) + " of the table on",
                         "--restart to begin anew, or another -o")
            .at(FileName{rows.string()});
    } catch (const std::runtime_error& error) {  // HDF5's and the file system's
        std::error_code ignored;
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
    add_attribute(file.id(), "damping_law", std::string(name_of(subject.damping.law)));
    add_attribute(file.id(), "from_velocity", exact(table.from_velocity));
    add_attribute(file.id(), "to_velocity", exact(table.to_velocity));
    add_sizes(file, table);
    add_impacts(file, subject, table);
    return image_of(file);
}

}  // namespace ashimpact
