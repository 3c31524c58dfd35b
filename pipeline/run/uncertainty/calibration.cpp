// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/run/uncertainty/calibration.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>
#include <variant>

#include <fmt/format.h>

#include "core/text/text.hpp"
#include "materials/contact_properties.hpp"

namespace ashimpact {

namespace {

constexpr double assumed_uncertainty = 1e-3;  ///< of a published number without one, relative

CalibrationSample start_of(const Case& data, const Sample& sample, const SampleModulus& modulus,
                           const SampleContact& contact) {
    CalibrationSample start{.diameter = 2 * contact.radius.value,
                            .density = contact.density.value(),
                            .work_of_adhesion = contact.pair.work_of_adhesion,
                            .particle = {.young_modulus = modulus.young_modulus.value},
                            .wall = {},
                            .contact_modulus = {}};
    if (sample.poisson_ratio)
        start.particle.poisson_ratio = sample.poisson_ratio->value();
    else
        start.particle.poisson_ratio = modulus.poisson_ratio ? modulus.poisson_ratio->value : 0;
    const auto* elastic = data.wall ? std::get_if<ElasticWall>(&*data.wall) : nullptr;
    if (elastic != nullptr) start.wall = {elastic->young_modulus.value(), elastic->poisson_ratio.value()};
    // The contact modulus is free to follow from both bodies if it does, and was not edited in an artifact.
    const double given = contact.pair.contact_modulus;
    if (elastic == nullptr || sample.contact_modulus ||
        std::abs(contact_modulus(start.particle, start.wall) / given - 1) > 1e-9)
        start.contact_modulus = given;
    return start;
}

void add_observations(const PublishedSample& published, std::size_t index, CalibrationProblem& problem) {
    for (const auto& [law, velocity] : published.critical_velocity) {
        const Quantity* damping = published.critical_damping.find(law);
        if (damping == nullptr) continue;
        problem.critical_velocities.push_back(
            {.sample = index,
             .law = law,
             .critical_damping = damping->value,
             .critical_damping_uncertainty = damping->standard_uncertainty.value_or(0),
             .value = velocity.value,
             .standard_uncertainty =
                 velocity.standard_uncertainty.value_or(assumed_uncertainty * velocity.value)});
    }
    auto times = published.contact_times;
    std::ranges::sort(times, {}, [](const auto& time) {
        return std::tuple(time.law.index(), time.velocity.value, time.contact_time.value);
    });
    for (const auto& time : times) {
        const DampingPolynomial* fit = published.damping_fits.find(time.law);
        if (fit == nullptr) continue;
        problem.contact_times.push_back(
            {.sample = index,
             .law = time.law,
             .damping_fit = *fit,
             .velocity = time.velocity.value,
             .velocity_uncertainty = time.velocity.standard_uncertainty.value_or(0),
             .value = time.contact_time.value,
             .standard_uncertainty = time.contact_time.standard_uncertainty.value_or(assumed_uncertainty *
                                                                                     time.contact_time.value),
             .damping_fit_uncertainty = published.damping_fit_uncertainty.value_or(0)});
    }
}

/// The samples of a calibration: those of the case in the order of calibration_key().
std::vector<std::size_t> samples_in_order(const Case& data) {
    std::vector<std::size_t> order(data.samples.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::ranges::sort(order, {}, [&](std::size_t i) { return calibration_key(data.samples[i]); });
    return order;
}

bool is_free(const Case& data, CalibrationQuantity quantity) {
    return std::any_of(data.calibration.begin(), data.calibration.end(),
                       [&](const FreeConstant& free) { return free.quantity == quantity; });
}

/// A wall acts through the contact modulus alone: if that is free or given, no observation depends on the
/// modulus of the wall.
void require_wall_to_matter(const Case& data) {
    if (!is_free(data, CalibrationQuantity::wall_young_modulus)) return;
    if (is_free(data, CalibrationQuantity::contact_modulus))
        throw InputError(
            "contact_modulus and wall_young_modulus are both free, and the wall acts through "
            "the contact modulus alone",
            "one of the two")
            .at("/calibration");
    const bool all_given = std::all_of(data.samples.begin(), data.samples.end(), [](const Sample& sample) {
        return sample.contact_modulus.has_value();
    });
    if (all_given)
        throw InputError("wall_young_modulus is free, but every sample states its contact modulus",
                         "a sample without contact_modulus")
            .at("/samples");
}

bool is_inferred(const Stated& stated) {
    return stated.origin == Origin::inferred;
}

bool has_inferred_density(const Sample& sample) {
    return sample.density && is_inferred(*sample.density);
}

bool has_inferred_adhesion(const Sample& sample) {
    const auto* stated = sample.work_of_adhesion ? std::get_if<Stated>(&*sample.work_of_adhesion) : nullptr;
    return stated != nullptr && is_inferred(*stated);
}

}  // namespace

std::vector<Finding> doubts_of_published(const Case& data) {
    std::size_t assumed = 0;
    std::vector<std::string> unused;
    for (const Sample& sample : data.samples) {
        if (!sample.published) continue;
        const auto take = [&](const Quantity& number, Law law, const char* name, const char* needs,
                              bool used) {
            if (used)
                assumed += number.standard_uncertainty ? 0 : 1;
            else
                unused.push_back(fmt::format("{} of {} by {} is not used, without its {}", name,
                                             in_quotes(sample.name), law.name(), needs));
        };
        for (const auto& [law, velocity] : sample.published->critical_velocity)
            take(velocity, law, "the critical velocity", "critical_damping",
                 sample.published->critical_damping.find(law) != nullptr);
        for (const auto& time : sample.published->contact_times)
            take(time.contact_time, time.law, "a contact time", "damping_fits",
                 sample.published->damping_fits.find(time.law) != nullptr);
    }
    std::vector<Finding> doubts;
    for (std::string& each : unused) doubts.push_back({"unused", Severity::doubt, std::move(each)});
    if (assumed > 0)
        doubts.push_back({"assumed", Severity::doubt,
                          fmt::format("{} published {} no uncertainty: {} % is assumed", assumed,
                                      assumed == 1 ? "number states" : "numbers state",
                                      shortest(100 * assumed_uncertainty))});
    return doubts;
}

CalibrationProblem calibration_problem(const Case& data, const ModulusResult& moduli,
                                       const ContactResult& contacts) {
    CalibrationProblem problem{
        .samples = {}, .free = data.calibration, .critical_velocities = {}, .contact_times = {}};
    const bool elastic = data.wall && std::holds_alternative<ElasticWall>(*data.wall);
    for (const FreeConstant& free : problem.free) {
        if (is_of_sizes(free.quantity))
            throw InputError(std::string(name_of(free.quantity)) + " is free, and no case determines it",
                             "calibrate --sizes, from critical velocities of several sizes")
                .at("/calibration");
        if (free.quantity == CalibrationQuantity::wall_young_modulus && !elastic)
            throw InputError("wall_young_modulus is free, but the wall has none",
                             "a wall with young_modulus and "
                             "poisson_ratio, to start from")
                .at("/wall");
    }
    if (data.partner)
        throw InputError("a calibration is of particles on a flat wall, not of two spheres", "\"wall\"")
            .at("/partner");
    if (data.roughness && data.roughness->value() > 0)
        throw InputError("a calibration finds the work of adhesion that acts, which roughness has reduced",
                         "a case without \"roughness\"")
            .at("/roughness");
    require_wall_to_matter(data);
    std::ranges::sort(problem.free, std::ranges::greater(),
                      [](const FreeConstant& free) { return name_of(free.quantity); });
    for (const std::size_t i : samples_in_order(data)) {
        const Sample& sample = data.samples[i];
        problem.samples.push_back(start_of(data, sample, moduli.samples[i], contacts.samples[i]));
        if (sample.published) add_observations(*sample.published, problem.samples.size() - 1, problem);
    }
    return problem;
}

std::vector<CalibrationResponse> calibrated_constants(const Case& data, const ModulusResult& moduli,
                                                      const ContactResult& contacts, StageRecord& record) {
    std::vector<CalibrationResponse> independent(data.samples.size());
    const bool inferred = std::ranges::any_of(data.samples, [](const Sample& sample) {
        return has_inferred_density(sample) || has_inferred_adhesion(sample);
    });
    if (!inferred || data.calibration.empty()) return independent;
    std::vector<Finding> findings;
    auto responses =
        attempt("response of the inferred constants to the contact modulus", "no-calibration-response",
                Severity::doubt, findings,
                [&] { return response_to_contact_modulus(calibration_problem(data, moduli, contacts)); });
    record.note(findings, {});
    if (!responses) return independent;
    const auto order = samples_in_order(data);
    for (std::size_t i = 0; i < order.size(); ++i) {
        const Sample& sample = data.samples[order[i]];
        if (has_inferred_density(sample)) independent[order[i]].density = (*responses)[i].density;
        if (has_inferred_adhesion(sample))
            independent[order[i]].work_of_adhesion = (*responses)[i].work_of_adhesion;
    }
    return independent;
}

}  // namespace ashimpact
