// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/run/comparison/reported_velocity.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "core/quantities/readable.hpp"
#include "core/text/text.hpp"
#include "solver/motion/regime.hpp"

namespace ashimpact {

namespace {

/// A law that gives a finite velocity, with its rank.
struct Candidate {
    Law law;
    const LawCriticalVelocity* velocity = nullptr;
    Trust trust{};       ///< the least is taken
    std::string reason;  ///< of that trust
    bool contradicted = false;
};

bool is_contradicted(const LawCriticalVelocity& velocity) {
    return velocity.check && (velocity.check->verdict == CriticalVelocityVerdict::model_too_low ||
                              velocity.check->verdict == CriticalVelocityVerdict::model_too_high);
}

std::string tabor_reason(double tabor) {
    const std::string parameter = "Tabor parameter " + readable_number(tabor, 3);
    if (tabor < dmt_limit) return parameter + ": hard contact, DMT holds";
    if (tabor > jkr_limit) return parameter + ": soft contact, JKR holds";
    return fmt::format("{}: between DMT (below {}) and JKR (above {}), nearer to {}", parameter, dmt_limit,
                       jkr_limit, nearer_to_jkr(tabor) ? "JKR" : "DMT");
}

std::string reason_of(Trust trust, double tabor) {
    switch (trust) {
        case Trust::describes_yield:
            return "the contact yields";
        case Trust::every_tabor:
            return "holds for every Tabor parameter, here " + readable_number(tabor, 3);
        case Trust::no_adhesion:
            return "there is no adhesion";
        case Trust::empirical:
        case Trust::empirical_parameters:
            return "its adhesion is empirical";
        case Trust::leaves_adhesion_out:
            return "leaves adhesion out";
        default:
            return tabor_reason(tabor);
    }
}

Candidate candidate_of(Law law, const LawCriticalVelocity& velocity, const ContactPair& contact) {
    const double tabor = tabor_parameter_of(contact);
    const Trust trust = law.trust(tabor, velocity.plastic > 0);
    return {law, &velocity, trust, reason_of(trust, tabor), is_contradicted(velocity)};
}

/// "jkr and dmt contradict"; empty if none does.
std::string contradiction(const std::vector<Candidate>& passed_over) {
    std::vector<std::string> names;
    for (const Candidate& each : passed_over)
        if (each.contradicted && each.law.is_adhesive()) names.emplace_back(each.law.name());
    if (names.empty()) return {};
    std::string text = names.front();
    for (std::size_t i = 1; i < names.size(); ++i)
        text += (i + 1 == names.size() ? " and " : ", ") + names[i];
    return text + (names.size() == 1 ? " contradicts" : " contradict");
}

std::string measured_words(const std::optional<MeasuredCriticalVelocity>& measured) {
    if (!measured || !measured->value) return "the measured velocity";
    return fmt::format("the measured {:#.3g} m/s", *measured->value);
}

/// The measured velocity or bounds, if no law gives a velocity.
ReportedVelocity measured_alone(const LawEvidence& evidence) {
    std::string verdict = evidence.no_damping;
    for (const LawChoice& choice : evidence.laws)
        if (const LawCriticalVelocity* velocity = evidence.velocities.find(choice.law))
            verdict = "no law gives a finite velocity: " + std::string(name_of(velocity->verdict));
    if (!evidence.measured) return {.reason = verdict};
    const MeasuredCriticalVelocity& measured = *evidence.measured;
    ReportedVelocity reported{.interval = Bounds{measured.lower, measured.upper}};
    if (measured.value) {
        reported.velocity = estimate_of(measured);
        reported.reason = "as measured; " + verdict;
    } else {
        reported.reason = measured.note + "; " + verdict;
    }
    return reported;
}

}  // namespace

ReportedVelocity reported_velocity(const LawEvidence& evidence) {
    std::vector<Candidate> candidates;
    for (const LawChoice& choice : evidence.laws) {
        const LawCriticalVelocity* velocity = evidence.velocities.find(choice.law);
        if (velocity != nullptr && velocity->velocity)
            candidates.push_back(candidate_of(choice.law, *velocity, evidence.contact));
    }
    if (candidates.empty()) return measured_alone(evidence);

    const bool all_contradicted = std::all_of(candidates.begin(), candidates.end(), [](const Candidate& c) {
        return c.contradicted || !c.law.is_adhesive();
    });
    std::stable_sort(candidates.begin(), candidates.end(), [&](const Candidate& x, const Candidate& y) {
        if (!all_contradicted && x.contradicted != y.contradicted) return y.contradicted;
        return x.trust < y.trust;
    });
    const Candidate& chosen = candidates.front();
    std::string reason = candidates.size() == 1 ? "the only law with a velocity" : chosen.reason;
    if (chosen.contradicted)
        reason += "; contradicts " + measured_words(evidence.measured) +
                  (candidates.size() > 1 ? ", as every law with adhesion does" : "");
    else if (const std::string others = contradiction({candidates.begin() + 1, candidates.end()});
             !others.empty())
        reason += fmt::format("; {} {}", others, measured_words(evidence.measured));
    return {chosen.law, chosen.velocity->velocity, chosen.velocity->velocity->interval, reason};
}

}  // namespace ashimpact
