// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/app/sweep/table/table_file.hpp"

#include <array>
#include <fstream>
#include <set>

#include "core/text/error.hpp"
#include "core/version.hpp"
#include "pipeline/app/sweep/table/hdf5_file.hpp"
#include "pipeline/app/sweep/table/row_log.hpp"
#include "pipeline/app/sweep/table/rows.hpp"

namespace ashimpact {

namespace {

using hdf5::add_attribute;
using hdf5::check;
using hdf5::Handle;
using hdf5::Hdf5Error;
using hdf5::silence;
using hdf5::timeless;

constexpr auto spec_attribute = "spec_sha256";

std::string rows_text(const SweepPlan& plan) {
    if (!plan.with_sensitivity()) return "row n is point n";
    const std::string width = std::to_string(plan.impacts_a_point());
    return "row " + width + " n + k is point n: k = 0 at a, 1 at b, 2 + i at a with variable i from b";
}

/// The file while it is filled.
class TableFile {
  public:
    TableFile(const std::filesystem::path& path, const SweepPlan& plan)
        : plan_(plan), file_(create(path)), properties_(dataset_properties()) {
        add_attribute(file_.id(), "program", "ashimpact " + std::string(program_version()));
        add_attribute(file_.id(), "revision", std::string(program_revision()));
        add_attribute(file_.id(), spec_attribute, plan.hash());
        add_attribute(file_.id(), "rows", rows_text(plan));
        std::set<std::string> groups;
        for (const TableColumn& column : plan.table_columns()) {
            const std::string group = column.path.substr(0, column.path.find('/'));
            if (groups.insert(group).second) add_group(group);
            add_column(column);
        }
    }

    [[nodiscard]] std::size_t columns() const { return columns_.size(); }

    void add_chunk(std::size_t column, std::uint64_t chunk, const std::string& packed) {
        const hsize_t offset = chunk * plan_.rows_in_chunk();
        check(H5Dwrite_chunk(columns_[column].id(), H5P_DEFAULT, 0, &offset, packed.size(), packed.data()),
              "H5Dwrite_chunk");
    }

    void close() {
        for (Handle& column : columns_) column.close("H5Dclose");
        file_.close("H5Fclose");
    }

  private:
    static Handle create(const std::filesystem::path& path) {
        silence();
        const Handle properties = timeless(H5P_FILE_CREATE);
        return {H5Fcreate(path.c_str(), H5F_ACC_TRUNC, properties.id(), H5P_DEFAULT), H5Fclose, "H5Fcreate"};
    }

    [[nodiscard]] Handle dataset_properties() const {
        Handle properties = timeless(H5P_DATASET_CREATE);
        const hsize_t rows = plan_.rows_in_chunk();
        check(H5Pset_chunk(properties.id(), 1, &rows), "H5Pset_chunk");
        check(H5Pset_shuffle(properties.id()), "H5Pset_shuffle");
        check(H5Pset_deflate(properties.id(), deflate_level), "H5Pset_deflate");
        return properties;
    }

    void add_group(const std::string& name) {
        const Handle properties = timeless(H5P_GROUP_CREATE);
        const Handle group(H5Gcreate2(file_.id(), name.c_str(), H5P_DEFAULT, properties.id(), H5P_DEFAULT),
                           H5Gclose, "H5Gcreate");
    }

    void add_column(const TableColumn& column) {
        const hsize_t rows = plan_.rows();
        const Handle space(H5Screate_simple(1, &rows, nullptr), H5Sclose, "H5Screate_simple");
        columns_.emplace_back(H5Dcreate2(file_.id(), column.path.c_str(), H5T_IEEE_F64LE, space.id(),
                                         H5P_DEFAULT, properties_.id(), H5P_DEFAULT),
                              H5Dclose, "H5Dcreate");
        add_attribute(columns_.back().id(), "unit", column.unit);
        add_attribute(columns_.back().id(), "description", column.description);
    }

    const SweepPlan& plan_;
    Handle file_;
    Handle properties_;
    std::vector<Handle> columns_;
};

void copy_rows(std::ifstream& rows, const SweepPlan& plan, TableFile& table) {
    for (std::uint64_t chunk = 0; chunk < plan.chunks(); ++chunk) {
        const std::vector<std::string> packed = read_sealed_rows(rows, chunk, table.columns());
        for (std::size_t column = 0; column < packed.size(); ++column)
            table.add_chunk(column, chunk, packed[column]);
    }
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
        TableFile table(temporary, plan);
        copy_rows(stream, plan, table);
        table.close();
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

}  // namespace ashimpact
