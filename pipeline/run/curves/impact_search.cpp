// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "pipeline/run/curves/model_curve.hpp"
#include "solver/numeric/interpolation.hpp"

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

constexpr double farthest_step = 0.5;  ///< of x where an end of the bracket is not known yet

/// Searches the velocity at which an impact of fixed damping has a wanted restitution. Works on x = ln v.
/// Each step interpolates x through the nearest impacts solved so far (Neville's scheme) and stays inside the
/// bracket that they give; restitution has to rise with velocity.
class VelocitySearch {
  public:
    VelocitySearch() = default;
    /// @param restitution wanted, above 0 [1]
    /// @param guess of x
    /// @param adhesive with adhesion e^2 is nearly linear in v above capture, without it e is
    /// @param enough change of x that ends the search
    VelocitySearch(double restitution, double guess, bool adhesive, double enough)
        : adhesive_(adhesive), enough_(enough), place_of_height_(height(restitution)), place_(guess) {}

    /// x to try next, or the answer.
    [[nodiscard]] double place() const { return place_; }
    [[nodiscard]] bool is_open() const { return state_ == State::open; }
    [[nodiscard]] bool is_found() const { return state_ == State::found; }

    /// Records the restitution at place(), 0 for a capture, and chooses the next place.
    void observe(double restitution) {
        const double wanted = place_of_height_.wanted();
        place_of_height_.bound(place_, restitution < (adhesive_ ? std::sqrt(wanted) : wanted));
        double next = std::numeric_limits<double>::quiet_NaN();
        if (restitution > 0) {
            place_of_height_.insert({.value = height(restitution), .x = place_});
            next = interpolated();
            // A point that is farther than all others may have been dropped: then next is only where it was.
            const bool met =
                place_of_height_.count() > 1
                    ? place_of_height_.nearest().x == place_ && std::abs(next - place_) <= enough_
                    : std::abs(place_of_height_.nearest().value - wanted) <= 1e-12 * wanted;
            if (met) {
                place_ = next;
                state_ = State::found;
                return;
            }
        }
        place_ = inside(next);
        if (++steps_ == most_steps) state_ = State::failed;
    }

  private:
    enum class State { open, found, failed };
    static constexpr int most_steps = 60;

    /// e, or e^2 with adhesion.
    [[nodiscard]] double height(double restitution) const {
        return adhesive_ ? restitution * restitution : restitution;
    }
    /// x at the wanted restitution through the points kept.
    [[nodiscard]] double interpolated() const {
        if (place_of_height_.count() > 1) return place_of_height_.interpolated();
        const double rise = adhesive_ ? 1.0 : 0.2;  // dh/dx, roughly
        const auto& [height, place] = place_of_height_.nearest();
        return place + (place_of_height_.wanted() - height) / rise;
    }
    /// The next x, from one outside of the bracket or not known.
    [[nodiscard]] double inside(double next) const {
        const double slow = place_of_height_.lower();
        const double fast = place_of_height_.upper();
        const bool possible = place_of_height_.contains(next);
        if (std::isinf(slow)) return possible ? std::max(next, fast - farthest_step) : fast - 0.2;
        if (std::isinf(fast)) return possible ? std::min(next, slow + farthest_step) : slow + 0.2;
        return possible ? next : (slow + fast) / 2;
    }

    bool adhesive_ = false;
    double enough_ = 0;  ///< change of x
    InverseInterpolation<4> place_of_height_;
    double place_ = 0;
    int steps_ = 0;
    State state_ = State::open;
};

}  // namespace

ImpactBatchResult impacts_at(const SearchedContact& searched, const Values& damping, const Values& velocity) {
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
        const ImpactBatchResult found = impacts_at(contact, damping(open), place.exp());
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
