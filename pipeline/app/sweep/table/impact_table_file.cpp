// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/app/sweep/table/impact_table_file.hpp"

#include <span>
#include <vector>

#include "core/version.hpp"
#include "pipeline/app/sweep/table/hdf5_file.hpp"
#include "pipeline/present/export/folder.hpp"

namespace ashimpact {

namespace {

using hdf5::check;
using hdf5::Handle;

constexpr std::size_t growth = std::size_t{1} << 20U;  // of the image in memory [byte]

struct Dataset {
    const char* name;
    std::string unit;
    const char* description;
    std::vector<hsize_t> extent;
};

void add(const Handle& file, const Dataset& dataset, std::span<const double> values) {
    const Handle properties = hdf5::timeless(H5P_DATASET_CREATE);
    const Handle space(
        H5Screate_simple(static_cast<int>(dataset.extent.size()), dataset.extent.data(), nullptr), H5Sclose,
        "H5Screate_simple");
    const Handle set(H5Dcreate2(file.id(), dataset.name, H5T_IEEE_F64LE, space.id(), H5P_DEFAULT,
                                properties.id(), H5P_DEFAULT),
                     H5Dclose, "H5Dcreate");
    check(H5Dwrite(set.id(), H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()), "H5Dwrite");
    hdf5::add_attribute(set.id(), "unit", dataset.unit);
    hdf5::add_attribute(set.id(), "description", dataset.description);
}

void add_sizes(const Handle& file, const ImpactTable& table) {
    const std::vector<hsize_t> sizes{table.diameter.size()};
    const std::vector<double> none(table.diameter.size(), 0.0);
    add(file, {"diameter", "m", "evenly in its logarithm", sizes}, table.diameter);
    add(file, {"critical_velocity", "m/s", "below it a particle stays; 0: none does", sizes},
        table.captures ? table.start_velocity : none);
    add(file, {"start_velocity", "m/s", "v_0 of t", sizes}, table.start_velocity);
    add(file, {"slope", "1", "d ln v_0 / d ln d", sizes}, table.slope);
    add(file, {"t", "1", "asinh(sqrt(v/v_0 - 1))", {table.t.size()}}, table.t);
}

void add_impacts(const Handle& file, const ExportSubject& subject, const ImpactTable& table) {
    const std::vector<hsize_t> extent{table.diameter.size(), table.t.size()};
    const auto add_table = [&](const char* name, std::string_view unit, const char* description,
                               const Eigen::ArrayXXd& values) {
        const Eigen::Array<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> rows = values;
        add(file, {name, std::string(unit), description, extent},
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

std::string impact_table_image(const ExportSubject& subject, const ImpactTable& table) {
    hdf5::silence();
    const Handle access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose, "H5Pcreate");
    check(H5Pset_fapl_core(access.id(), growth, false), "H5Pset_fapl_core");  // in memory alone
    const Handle properties = hdf5::timeless(H5P_FILE_CREATE);
    const Handle file(H5Fcreate("table.h5", H5F_ACC_TRUNC, properties.id(), access.id()), H5Fclose,
                      "H5Fcreate");
    hdf5::add_attribute(file.id(), "program", "ashimpact " + std::string(program_version()));
    hdf5::add_attribute(file.id(), "law", std::string(subject.law.name()));
    hdf5::add_attribute(file.id(), "detachment", std::string(name_of(subject.detachment)));
    hdf5::add_attribute(file.id(), "damping_law", std::string(name_of(subject.damping.law)));
    hdf5::add_attribute(file.id(), "from_velocity", exact(table.from_velocity));
    hdf5::add_attribute(file.id(), "to_velocity", exact(table.to_velocity));
    add_sizes(file, table);
    add_impacts(file, subject, table);
    return image_of(file);
}

}  // namespace ashimpact
