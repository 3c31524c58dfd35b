// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/json/document.hpp"
#include "pipeline/present/export/subject.hpp"

namespace ashimpact {

/// How far the exported restitution is from the impacts of one sample, rebounds and captures.
struct LaboratoryDifference {
    const Laboratory* laboratory;
    std::size_t compared = 0;        ///< impacts; of very many some, evenly chosen
    double fastest = 0;              ///< v_in of the fastest impact [m/s]
    double largest = 0;              ///< |e exported - e measured| [1]
    double at_velocity = 0;          ///< where it is the largest [m/s]
    double root_mean_square = 0;     ///< of the same differences [1]
    std::size_t other_outcomes = 0;  ///< impacts that rebounded and are captured, or the reverse
};

/// Those of every sample with impacts. Of the stiff contact, if the subject is softened.
[[nodiscard]] std::vector<LaboratoryDifference> laboratory_differences(const ExportSubject& subject);

/// e that the laboratory measured at a velocity, from the means of neighbouring rebounds, 0 below the slowest
/// impact that rebounded; none for another size, beyond the impacts, or where captures and rebounds mix [1].
[[nodiscard]] std::optional<double> measured_restitution(const ExportSubject& subject, double diameter,
                                                         double velocity);

/// Lines of a README on how far e is from the laboratory; empty without a run.
[[nodiscard]] std::string laboratory_lines(const ExportSubject& subject);

/// For expected.json: the differences by sample, and the largest.
[[nodiscard]] Json laboratory_json(const ExportSubject& subject);

}  // namespace ashimpact
