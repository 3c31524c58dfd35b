// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "pipeline/case/case.hpp"
#include "pipeline/run/results/comparison.hpp"
#include "pipeline/run/results/contact.hpp"
#include "pipeline/run/results/critical_velocity.hpp"
#include "pipeline/run/results/sizes.hpp"

namespace ashimpact {

/// What critical velocities by size follow from.
struct SizeSources {
    LawChoice choice;  ///< the reported law
    DampingLaw damping_law;
    const ContactResult& contacts;
    const CriticalVelocityResult& velocities;
    const std::vector<FittedDamping>& dampings;  ///< fitted to all samples
};

/// Critical velocities against diameter.
struct VelocitiesBySize {
    std::vector<SizeVelocity> rows{};  ///< by assumption, then from small to large
    SizeSummary summary;
};

/// Which sizes stick: v_c from a quarter of the smallest to four times the largest measured size. Over the
/// measured sizes as measured; elsewhere by assumptions on damping: every damping law that explains all
/// impacts, or, if none does, every law whose constant may be the same for all samples by their v_c; the
/// critical damping as a power of the diameter where there are several sizes. And by adhesion alone.
/// Of several samples of one size the geometric mean counts, with an interval that holds all of theirs.
/// Between two samples density, E* and work of adhesion are interpolated over ln d, beyond them those of the
/// nearest sample hold; of rough surfaces the work of adhesion without its roughness_reduction(), which each
/// size has of its own.
/// @return none if no sample has a velocity by the reported law
[[nodiscard]] std::optional<VelocitiesBySize> velocities_by_size(const SizeSources& sources);

/// Sentences without full stop on sizes that several samples with a velocity by the reported law share.
[[nodiscard]] std::vector<std::string> shared_sizes(const ComparisonResult& comparison);

/// Warning that contacts of other sizes use the stated Tabor parameter of the nearest sample, although it
/// depends on the size. None if no sample has one.
[[nodiscard]] std::optional<Finding> kept_properties_finding(const ContactResult& contacts);

/// The contact of a sphere of that diameter, from those of the samples, as velocities_by_size() has it. @pre
/// at least one sample
[[nodiscard]] SampleContact contact_of_size(const ContactResult& contacts, double diameter);

}  // namespace ashimpact
