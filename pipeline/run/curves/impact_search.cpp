// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/run/curves/impact_search.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "pipeline/run/curves/velocity_search.hpp"
#include "solver/batch/batch.hpp"

namespace ashimpact::curves {

namespace {

using Values = Eigen::ArrayXd;

/// The contact as columns of one value; they refer to it.
struct ContactValues {
    explicit ContactValues(const ContactPair& pair)
        : mass(Values::Constant(1, pair.mass)),
          radius(Values::Constant(1, pair.effective_radius)),
          modulus(Values::Constant(1, pair.contact_modulus)),
          adhesion(Values::Constant(1, pair.work_of_adhesion)),
          yield(Values::Constant(1, pair.yield_pressure)) {}

    Values mass, radius, modulus, adhesion, yield;
};

ImpactBatchResult impacts(const SearchedContact& searched, const Values& damping, const Values& velocity) {
    const BatchOptions options{.threads = 1, .turning_point = false};
    const ContactValues contact(searched.pair);
    return solve_impacts({.law = searched.choice.law,
                          .detachment = searched.choice.detachment,
                          .damping_law = searched.damping_law,
                          .contact = {contact.mass, contact.radius, contact.modulus, contact.adhesion,
                                      contact.yield, single_columns(searched.pair.parameters)},
                          .damping = damping,
                          .velocity = velocity},
                         options);
}

/// Contact times of the last two impacts of a search, over ln v: their line gives the one found.
struct ContactTimes {
    double place = 0, time = 0, slope = 0;

    void observe(double at, double observed) {
        if (time > 0 && observed > 0 && at != place) slope = (observed - time) / (at - place);
        place = at;
        time = observed;
    }
    [[nodiscard]] double at(double wanted) const { return time + slope * (wanted - place); }
};

}  // namespace

FoundImpacts impacts_with(const Values& e, const SearchedContact& contact, const Values& damping,
                          const Values& guess, double enough) {
    const Eigen::Index count = e.size();
    const bool adhesive = contact.pair.work_of_adhesion > 0 && contact.choice.law.is_adhesive();
    std::vector<VelocitySearch> searches;
    std::vector<ContactTimes> times(static_cast<std::size_t>(count));
    std::vector<Eigen::Index> open;
    for (Eigen::Index i = 0; i < count; ++i) {
        searches.emplace_back(e[i], std::log(guess[i]), adhesive, enough);
        open.push_back(i);
    }
    const auto search = [&](Eigen::Index i) -> VelocitySearch& {
        return searches[static_cast<std::size_t>(i)];
    };
    while (!open.empty()) {
        Values place(static_cast<Eigen::Index>(open.size()));
        for (Eigen::Index k = 0; k < place.size(); ++k)
            place[k] = search(open[static_cast<std::size_t>(k)]).place();
        const ImpactBatchResult found = impacts(contact, damping(open), place.exp());
        for (Eigen::Index k = 0; k < place.size(); ++k) {
            const auto i = open[static_cast<std::size_t>(k)];
            search(i).observe(found.restitution[k]);
            times[static_cast<std::size_t>(i)].observe(place[k], found.contact_time[k]);
        }
        open.erase(
            std::remove_if(open.begin(), open.end(), [&](Eigen::Index i) { return !search(i).is_open(); }),
            open.end());
    }
    const Values nothing = Values::Constant(count, std::numeric_limits<double>::quiet_NaN());
    FoundImpacts answer{nothing, nothing};
    for (Eigen::Index i = 0; i < count; ++i) {
        if (!search(i).is_found()) continue;
        answer.velocity[i] = std::exp(search(i).place());
        answer.contact_time[i] = times[static_cast<std::size_t>(i)].at(search(i).place());
    }
    return answer;
}

}  // namespace ashimpact::curves
