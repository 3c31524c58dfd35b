// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "tests/oracles/time_domain.hpp"

namespace ashimpact::oracles {

/// One column of the comparison: anything that can compute impacts. The functions take many impacts at a time
/// because a DEM code is started once for all of them.
struct Column {
    std::string name;
    std::function<bool(const Impact&)> covers;
    std::function<std::vector<OracleResult>(std::span<const Impact>)> impacts;
    std::function<std::vector<bool>(std::span<const Impact>)> rebounds;
};

/// Integration in time with GSL: every law and detachment.
Column time_domain_oracle();

/// Debian's LAMMPS: Hertz, DMT, and JKR ending load-controlled.
Column lammps_oracle();

/// Debian's LIGGGHTS: Hertz and DMT.
Column liggghts_oracle();

/// What is put to the test: solve_impact(), which claims a relative 1e-10.
Column solver_under_test();

/// Returns the critical velocity [m/s] by the solver under test.
/// @throws std::bad_optional_access where it finds none
double solver_critical_velocity(const Impact& impact);

/// All columns; deviations are given from the first. A further column is one more function here.
std::vector<Column> columns();

/// Returns whether the impact rebounds at that velocity [m/s].
bool rebounds(const Column& column, const Impact& impact, double velocity);

/// One impact and what each oracle that covers it found, in the order of the oracles.
struct ComparedImpact {
    struct Answer {
        std::string column;
        OracleResult result;
    };
    Impact impact;
    std::vector<Answer> answers;
};

/// One set of parameters around its critical velocity.
struct ComparedVerdict {
    struct Answer {
        std::string column;
        bool rebounds_below;  ///< at 0.999 of the critical velocity
        bool rebounds_above;  ///< at 1.001
    };
    Impact impact;
    double critical_velocity;  ///< [m/s]
    std::vector<Answer> answers;
};

std::vector<ComparedImpact> compare_impacts(std::span<const Column> columns, std::span<const Impact> impacts);

/// @param critical_velocity what is put to the test [m/s]
std::vector<ComparedVerdict> compare_verdicts(std::span<const Column> columns,
                                              std::span<const Impact> impacts,
                                              const std::function<double(const Impact&)>& critical_velocity);

/// Returns the largest relative difference of restitution, contact time and maximum overlap [-].
double deviation(const OracleResult& a, const OracleResult& b);

/// Returns the largest relative error claimed for restitution, contact time and maximum overlap [-].
double claimed_error(const OracleResult& result);

/// The comparisons as Markdown tables, deviations from the first oracle.
std::string impacts_table(std::span<const Column> columns, std::span<const ComparedImpact> compared);
std::string verdicts_table(std::span<const Column> columns, std::span<const ComparedVerdict> compared);

}  // namespace ashimpact::oracles
