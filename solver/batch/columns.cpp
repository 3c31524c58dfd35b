// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/batch/columns.hpp"

#include <string>

#include "core/text/error.hpp"

namespace ashimpact {

std::vector<ParameterColumn> single_columns(const ParameterValues<double>& values) {
    std::vector<ParameterColumn> columns;
    for (const auto& entry : values)
        columns.push_back({entry.first, Eigen::Map<const Eigen::ArrayXd>(&entry.second, 1)});
    return columns;
}

Eigen::Index common_size(const ContactColumns& contact, const std::vector<NamedColumn>& others) {
    std::vector<NamedColumn> columns{{"mass", contact.mass.size()},
                                     {"effective_radius", contact.effective_radius.size()},
                                     {"contact_modulus", contact.contact_modulus.size()},
                                     {"work_of_adhesion", contact.work_of_adhesion.size()},
                                     {"yield_pressure", contact.yield_pressure.size()}};
    for (const ParameterColumn& column : contact.parameters)
        columns.push_back({column.name, column.values.size()});
    columns.insert(columns.end(), others.begin(), others.end());
    NamedColumn longest{{}, 1};
    for (const NamedColumn& column : columns) {
        if (column.size == 1) continue;
        if (longest.name.empty()) longest = column;
        if (column.size == longest.size) continue;
        throw InputError(
            "column " + std::string(column.name) + " has " + std::to_string(column.size) + " values",
            "1, or " + std::to_string(longest.size) + " as column " + std::string(longest.name));
    }
    return longest.size;
}

}  // namespace ashimpact
