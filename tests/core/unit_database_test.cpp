// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/units/unit_database.hpp"

#include <array>
#include <string>

#include <doctest/doctest.h>

#include "core/units/unit_text.hpp"
#include "tests/relative_difference.hpp"

namespace ashimpact::test {

namespace {

constexpr std::array targets{"1", "m", "kg", "s", "m/s", "kg/m3", "Pa", "N", "J", "J/m2", "kg/s", "Pa s"};

/// What our reader of the database and the library of UDUNITS-2 say of a unit.
struct Comparison {
    const UnitDatabase database{"/usr/share/xml/udunits"};
    int convertible = 0;

    void compare(const std::string& unit) {
        for (const std::string target : targets) {
            const UnitScale theirs = database_scale_to(unit, target);
            const UnitScale ours = names_a_unit(unit) ? database.scale(unit, target)
                                                      : UnitScale{.problem = UnitProblem::unknown};
            CAPTURE(unit);
            CAPTURE(target);
            CHECK(ours.problem == theirs.problem);
            if (theirs.problem != UnitProblem::none) continue;
            CHECK(relative_difference(ours.scale, theirs.scale) < 1e-14);
            ++convertible;
        }
    }
};

}  // namespace

TEST_CASE("every unit of the database is what UDUNITS-2 takes it for") {
    Comparison comparison;
    const std::vector<std::string> names = comparison.database.names();
    CHECK(names.size() > 500);
    for (const std::string& name : names)
        for (const char* prefix : {"", "m", "k", "da", "micro", "kilo"}) comparison.compare(prefix + name);
    CHECK(comparison.convertible > 1000);
}

TEST_CASE("units are combined by the grammar of UDUNITS-2") {
    Comparison comparison;
    for (const char* unit : {"kg.m-3",
                             "kg m-3",
                             "kg/m^3",
                             "kg m^-3",
                             "g/cm3",
                             "kg*m^-3",
                             "kg/(m.s)",
                             "kg/m/s2",
                             "N-s",
                             "Pa s",
                             "lb/ft3",
                             "mm/ms",
                             "J/(m2)",
                             "(m)(s-1)",
                             "m per s",
                             "m  per  s",
                             "meters/second",
                             "MICROMETERS",
                             "um",
                             "mmm",
                             "kkg",
                             "m^",
                             "m^ 2",
                             "m . s",
                             "m ",
                             " m",
                             "m..s",
                             "()",
                             "m/",
                             "/m",
                             "perm",
                             "J perm2",
                             "J pers",
                             "J per3",
                             "(J)perm2",
                             "(J)per m2",
                             "(J)pers",
                             "(J)per",
                             "percent",
                             "m256",
                             "m255",
                             "m-255",
                             "degC",
                             "J/degC",
                             "dBm",
                             "m^+2",
                             "m+2",
                             "m()",
                             "((m))",
                             "(m",
                             "m)",
                             "m))",
                             "m)s",
                             "%",
                             "%m",
                             "m%",
                             "%%",
                             "% m",
                             "oven",
                             "",
                             "1",
                             "s-1",
                             "Hz",
                             "mo",
                             "m_",
                             "_m",
                             "d",
                             "da",
                             "dam",
                             "Mg",
                             "mg",
                             "MG",
                             "pa",
                             "PA"})
        comparison.compare(unit);
    CHECK(comparison.convertible > 20);
}

}  // namespace ashimpact::test
