// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "core/quantities/names.hpp"
#include "solver/contact/pair.hpp"
#include "solver/critical_velocity/critical_velocity.hpp"
#include "solver/damping/damping.hpp"
#include "solver/inference/impacts/measurement.hpp"

namespace ashimpact {

/// The impacts of one sample.
struct ImpactsOfSample {
    ContactPair contact;
    std::vector<Measurement> impacts;
};

/// A constant of a damping law.
struct DampingConstant {
    std::string_view name;   ///< "damping", or that of a parameter of the law
    double value = 0;        ///< [SI unit of its dimension]
    double uncertainty = 0;  ///< standard, from the noise of velocities or the scatter [SI]
    Dimension dimension = Dimension::fraction;
};

/// Whether the impacts admit a damping law with the same constants for all samples.
enum class DampingEvidence {
    explains,  ///< the differences that remain look like scatter
    rejected,  ///< they depend on velocity or sample
    untold,    ///< the impacts do not determine the constants
};

template <>
struct Names<DampingEvidence> {
    static constexpr std::string_view kind = "evidence";
    static constexpr std::array<std::string_view, 3> all{"explains", "rejected", "undetermined"};
};

/// A damping law with those constants, the same for all samples, that are closest to the impacts.
struct FittedDamping {
    DampingLaw law = DampingLaw::constant;
    std::vector<DampingConstant> constants{};  ///< empty: undetermined
    std::optional<double> correlation{};       ///< of two constants [1]
    double misfit = 0;                         ///< root mean square of e as measured less e as computed [1]
    DampingEvidence evidence = DampingEvidence::untold;

    /// Coefficient of the first term [unit of the law]. @pre the constants are determined
    [[nodiscard]] Damping damping() const { return {law, constants.front().value}; }
};

/// Fewest impacts that are compared with damping laws.
inline constexpr std::size_t fewest_compared = 3;

/// Two constants with a greater correlation are undetermined [1].
inline constexpr double greatest_correlation = 0.98;

/// Every damping law with the constants that minimise the weighted squares of e as measured less e as
/// computed, over all impacts of all samples. A capture bounds e: it counts where the law lets the particle
/// rebound. The weight of an impact is the number that it is the mean of, less where its stated noise is
/// large. The sums run over the impacts in an order of their own, so that no result depends on theirs.
/// @return in the order of DampingLaw, without those that do not converge; none at all for fewer than
/// fewest_compared impacts, or without a rebound
[[nodiscard]] std::vector<FittedDamping> fit_damping_laws(Law law, Detachment detachment,
                                                          std::span<const ImpactsOfSample> samples);

/// The contact of a sample with the parameters that the fitted damping law has, and those of no other one.
[[nodiscard]] ContactPair contact_with(const FittedDamping& fitted, const ContactPair& contact);

}  // namespace ashimpact
