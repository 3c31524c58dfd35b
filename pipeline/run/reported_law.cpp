// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/run/reported_law.hpp"

#include <algorithm>
#include <cmath>
#include <variant>

#include <fmt/format.h>

#include "core/quantities/quantity.hpp"
#include "solver/motion/regime.hpp"

namespace ashimpact {

namespace {

/// What is known of the contacts of a run before any velocity is computed.
struct KnownOfContacts {
    double least_tabor = 0, greatest_tabor = 0;  ///< of contacts with adhesion; 0: none has it [1]
    double mean_tabor = 0;                       ///< their geometric mean [1]
    bool yields = false;  ///< a contact yields in all of its rebounds, by a law of the case that includes it
};

/// The slowest measured rebound; 0 if there is none [m/s].
double slowest_rebound(const Sample& sample) {
    const auto* measured =
        sample.restitution ? std::get_if<MeasuredRestitution>(&*sample.restitution) : nullptr;
    double slowest = 0;
    if (measured != nullptr)
        for (const Measurement& impact : measured->impacts.points)
            if (!impact.captured() && (slowest == 0 || impact.velocity < slowest)) slowest = impact.velocity;
    return slowest;
}

/// Velocity from which a contact yields by a plastic law, without damping [m/s].
double yield_velocity_of(const LawChoice& choice, const ContactPair& contact) {
    const Regime regime = regime_of({.law = choice.law,
                                     .detachment = choice.detachment,
                                     .damping = {},
                                     .contact = contact,
                                     .velocity = 1},
                                    0);
    return regime.law_yield_velocity.value();
}

KnownOfContacts known_of(const Case& data, const ContactResult& contacts) {
    KnownOfContacts known;
    double logarithms = 0;
    int adhesive = 0;
    for (std::size_t i = 0; i < data.samples.size(); ++i) {
        const ContactPair& contact = contacts.samples[i].pair;
        if (const double tabor = tabor_parameter_of(contact); tabor > 0) {
            known.least_tabor = adhesive == 0 ? tabor : std::min(known.least_tabor, tabor);
            known.greatest_tabor = std::max(known.greatest_tabor, tabor);
            logarithms += std::log(tabor);
            ++adhesive;
        }
        for (const LawChoice& choice : data.laws)
            if (can_yield(choice.law, contact))
                known.yields =
                    known.yields || yield_velocity_of(choice, contact) <= slowest_rebound(data.samples[i]);
    }
    if (adhesive > 0) known.mean_tabor = std::exp(logarithms / adhesive);
    return known;
}

/// "Tabor parameter 2.02" or "Tabor parameters 2.01 to 2.04".
std::string tabor_words(const KnownOfContacts& known) {
    const std::string least = readable_number(known.least_tabor, 3);
    const std::string greatest = readable_number(known.greatest_tabor, 3);
    return least == greatest ? "Tabor parameter " + least : "Tabor parameters " + least + " to " + greatest;
}

/// Why one of the two limits is chosen.
std::string limit_reason(const KnownOfContacts& known) {
    if (known.greatest_tabor > 0 && known.greatest_tabor < dmt_limit)
        return fmt::format("the contact is hard, as dmt takes it ({}, below {})", tabor_words(known),
                           dmt_limit);
    if (known.least_tabor > jkr_limit)
        return fmt::format("the contact is soft, as jkr takes it ({}, above {})", tabor_words(known),
                           jkr_limit);
    return fmt::format(
        "the contact is neither hard as dmt takes it (Tabor parameter below {}) nor soft as jkr does (above "
        "{}): {} is closer to {}; maugis-dugdale holds for all",
        dmt_limit, jkr_limit, readable_number(known.mean_tabor, 3),
        nearer_to_jkr(known.mean_tabor) ? "soft" : "hard");
}

std::string reason_of(Trust trust, const KnownOfContacts& known) {
    switch (trust) {
        case Trust::describes_yield:
            return "the contact deforms plastically, which this law includes";
        case Trust::every_tabor:
            return known.mean_tabor > 0
                       ? fmt::format("it holds for hard and soft contacts alike ({})", tabor_words(known))
                       : "no adhesion is given, and without it this law is hertz";
        case Trust::no_adhesion:
            return "no adhesion is given, and it has none";
        case Trust::empirical:
        case Trust::empirical_parameters:
            return "its adhesion is a fit, not a theory";
        case Trust::leaves_adhesion_out:
            return "it leaves adhesion out";
        default:
            return limit_reason(known);
    }
}

/// Whether the contacts allow a law besides the reported one.
bool is_admissible(Law law, const KnownOfContacts& known) {
    switch (law.trust(known.mean_tabor, known.yields)) {
        case Trust::describes_yield:
            return true;
        case Trust::every_tabor:
            return !known.yields;
        case Trust::nearer_limit:
        case Trust::farther_limit:
            return !known.yields && known.mean_tabor > 0 &&
                   (law.limit() == AdhesionRegime::dmt ? known.least_tabor <= jkr_limit
                                                       : known.greatest_tabor >= dmt_limit);
        default:
            return false;
    }
}

std::vector<Law> by_preference(const Case& data, const KnownOfContacts& known) {
    std::vector<Law> laws;
    for (const LawChoice& choice : data.laws) laws.push_back(choice.law);
    std::stable_sort(laws.begin(), laws.end(), [&](Law x, Law y) {
        return x.trust(known.mean_tabor, known.yields) < y.trust(known.mean_tabor, known.yields);
    });
    return laws;
}

}  // namespace

std::vector<Law> laws_by_preference(const Case& data, const ContactResult& contacts) {
    return by_preference(data, known_of(data, contacts));
}

std::optional<ReportedLaw> reported_law(const Case& data, const ContactResult& contacts) {
    if (data.laws.empty() || data.samples.empty()) return std::nullopt;
    const KnownOfContacts known = known_of(data, contacts);
    const Law law = by_preference(data, known).front();
    ReportedLaw reported{law,
                         data.laws.size() == 1 ? std::string("the only law of the case")
                                               : reason_of(law.trust(known.mean_tabor, known.yields), known),
                         {}};
    for (const LawChoice& choice : data.laws)
        if (choice.law == law || is_admissible(choice.law, known)) reported.admissible.push_back(choice.law);
    return reported;
}

}  // namespace ashimpact
