// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/run/laws_by_size.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/plausibility.hpp"
#include "core/text/error.hpp"
#include "pipeline/run/sizes.hpp"
#include "solver/batch/parallel.hpp"
#include "solver/surrogate/rebound_table.hpp"

namespace ashimpact {

namespace {

constexpr int smallest_power = -8;  ///< of ten [m]
constexpr int field_decades = 5;
constexpr int sizes_a_decade = 4;

/// v_c where it is finite, in the model and within the law; else none [m/s].
std::optional<double> velocity_within_law(const CriticalVelocityProblem& problem) {
    try {
        const CriticalVelocity critical = quick_critical_velocity(problem);
        if (critical.value && *critical.value <= fastest_in_model) return critical.value;
    } catch (const ConvergenceError&) {
    } catch (const InputError&) {  // such as a closure that does not hold
    }
    return std::nullopt;
}

/// Sets the exponents from the neighbours of each size.
void set_exponents(std::vector<VelocityOfSize>& curve) {
    for (std::size_t i = 0; i < curve.size() && curve.size() > 1; ++i) {
        const VelocityOfSize& below = curve[i == 0 ? 0 : i - 1];
        const VelocityOfSize& above = curve[std::min(i + 1, curve.size() - 1)];
        curve[i].exponent =
            std::log(above.velocity / below.velocity) / std::log(above.diameter / below.diameter);
    }
}

}  // namespace

const std::vector<double>& sizes_of_the_field() {
    static const std::vector<double> sizes = [] {
        std::vector<double> all;
        for (int i = 0; i <= field_decades * sizes_a_decade; ++i)
            all.push_back(std::pow(10.0, smallest_power + static_cast<double>(i) / sizes_a_decade));
        return all;
    }();
    return sizes;
}

LawBySize law_by_size(Law law, const std::function<CriticalVelocityProblem(double)>& problem_of) {
    const std::vector<double>& sizes = sizes_of_the_field();
    const auto velocities =
        in_parallel(sizes, [&](double diameter) { return velocity_within_law(problem_of(diameter)); });
    LawBySize by_size{.law = law};
    for (std::size_t i = 0; i < sizes.size(); ++i)
        if (velocities[i] && *velocities[i] > 0) by_size.curve.push_back({sizes[i], *velocities[i]});
    set_exponents(by_size.curve);
    return by_size;
}

std::vector<LawBySize> laws_by_size(const std::vector<LawChoice>& laws, const ContactResult& contacts) {
    std::vector<LawChoice> all = laws;
    const Law jkr = Law::named("jkr");
    if (std::ranges::find(all, jkr, &LawChoice::law) == all.end())
        all.push_back({jkr, jkr.default_detachment()});
    std::vector<LawBySize> found;
    for (const LawChoice& choice : all) {
        LawBySize by_size = law_by_size(choice.law, [&](double diameter) {
            return CriticalVelocityProblem{
                choice.law, choice.detachment, {}, contact_of_size(contacts, diameter).pair};
        });
        if (by_size.curve.size() > 1) found.push_back(std::move(by_size));
    }
    return found;
}

}  // namespace ashimpact
