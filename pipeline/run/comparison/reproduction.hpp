// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "pipeline/run/results/run.hpp"

namespace ashimpact {

/// What the reported velocities of reconstructed samples leave open, and how far each law is from the
/// measured ones; none without such samples.
///
/// Ranges and orders: the damping is read again from points of eta(e) between other restitutions, and fitted
/// with polynomials of the second and third order. Laws that no reconstruction can be afforded for take the
/// relative change of their similar law, see Law::similar(). Diameter: density, E*, w and critical damping
/// are held.
/// @param samples the compared samples of the run, with what is reported of them
[[nodiscard]] std::optional<Reproduction> reproduction_of(const Run& run,
                                                          const std::vector<SampleComparison>& samples);

}  // namespace ashimpact
