// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/batch/tables/yield_velocities.hpp"

#include <array>
#include <cmath>
#include <limits>
#include <span>
#include <vector>

#include "solver/batch/tables/law_tables.hpp"
#include "solver/contact/jkr.hpp"
#include "solver/contact/thornton_ning.hpp"
#include "solver/motion/regime.hpp"
#include "solver/motion/scale.hpp"
#include "solver/numeric/interpolation.hpp"
#include "solver/numeric/number.hpp"

namespace ashimpact::batch {

namespace {

constexpr double nothing = std::numeric_limits<double>::quiet_NaN();

/// Contacts of one detachment and damping law that yield, in units of the length at which the adhesion number
/// is 1.
class YieldCapture {
  public:
    YieldCapture(Detachment detachment, DampingLaw damping_law)
        : table_(CriticalTable::of(Law::of<Jkr>(), detachment, damping_law, CriticalQuantity::overlap)),
          power_(std::log2(unit_at(damping_law, 2.0))) {
        RegisteredDampings::visit<void>(damping_law, [&]<class D>() {
            shape_ = [](double flattening) {
                return D::shapes(1.0, StaticForces<double>{flattening, 0.0})[0];
            };
        });
    }

    /// The least greatest contact, in u, that an impact leaves at rest: 0 if that is on the elastic branch,
    /// infinite if all are captured, NaN in doubt. @param farthest overlap up to which it is sought
    [[nodiscard]] double contact(double yield_number, double damping_number, double farthest) const {
        constexpr double ratio = 1.02;  // as that of critical_impacts()
        const YieldedContact<double> contact{1.0, yield_number};
        const PlasticLoading<double> loading = contact.loading();
        const double yield = contact.yield_point();
        const auto margin = [&](double u) {
            const double flattening = u > yield ? loading.flattening(u) : 1.0;
            const double number =
                damping_number * shape_(flattening) * std::pow(flattening, 4.0 / 3.0 * power_);
            return turn(number) / std::cbrt(flattening) / u - 1.0;
        };
        double lower = yield;
        const double first = margin(lower);
        if (!(first > 0.0)) return std::isnan(first) ? nothing : 0.0;
        while (loading.overlap(lower) < farthest) {
            const double step = (ratio - 1.0) * lower;
            const double next = margin(lower + step);
            if (std::isnan(next)) return nothing;
            if (next <= 0.0)
                return lower + sign_change<double>([&](double h) { return margin(lower + h); }, step);
            lower += step;
        }
        return std::numeric_limits<double>::infinity();
    }

  private:
    /// Damping coefficient of number 1 at a length, in units in which that at length 1 is 1.
    static double unit_at(DampingLaw law, double length) {
        const Scale scale{1.0, 1.0, std::pow(length, 1.25), length, std::sqrt(length)};
        return scale.damping_unit(law);
    }
    /// State u at the turn of the critical impact of an elastic contact; infinite if all are captured, NaN in
    /// doubt.
    [[nodiscard]] double turn(double damping_number) const {
        const double beta = CriticalTable::inside(damping_number);
        const CriticalPiece* const piece = table_.at(beta);
        if (piece == nullptr) return nothing;
        if (piece->state() == PieceState::captured) return std::numeric_limits<double>::infinity();
        if (piece->state() != PieceState::tabulated) return nothing;
        const double t = piece->local(0, beta);
        const auto& c = piece->content().coefficients;
        double sum = c.back();
        for (std::size_t k = c.size() - 1; k-- > 0;) sum = std::fma(sum, t, c[k]);
        const double overlap = std::exp(sum);
        double u = 1.0 + std::sqrt(std::sqrt(overlap));
        for (int i = 0; i < 8; ++i)  // Newton from above
            u -= (power<4>(u) - u - overlap) / (4.0 * power<3>(u) - 1.0);
        return u;
    }

    CriticalTable& table_;
    double power_;  ///< of length, in the unit of damping
    double (*shape_)(double flattening) = nullptr;
};

/// Problems of a batch in columns of their own, one after another.
class ColumnsOfImpacts {
  public:
    ColumnsOfImpacts(const Problems& problems, std::span<const std::size_t> places) : problems_(problems) {
        for (const std::size_t i : places) {
            const ContactPair contact = problems.contact(i);
            const std::array values{contact.mass,
                                    contact.effective_radius,
                                    contact.contact_modulus,
                                    contact.work_of_adhesion,
                                    contact.yield_pressure,
                                    problems.damping(i).coefficient};
            for (std::size_t k = 0; k < values.size(); ++k) inputs_[k].push_back(values[k]);
        }
    }
    /// Solves the impacts at these velocities.
    void solve(const std::vector<double>& velocity) {
        const std::size_t count = velocity.size();
        end_.resize(count);
        for (std::vector<double>* column : {&overlap, &restitution_, &contact_time_, &approach_time_})
            column->resize(count);
        const auto column = [count](const std::vector<double>& values) {
            return Input{values.data(), count};
        };
        kernels_of(problems_.law, problems_.damping_law)
            .impacts({.damping_law = problems_.damping_law,
                      .detachment = problems_.detachment,
                      .with_contact_time = false,
                      .turning_point = true,
                      .table = nullptr,
                      .count = count,
                      .inputs = {.mass = column(inputs_[0]),
                                 .effective_radius = column(inputs_[1]),
                                 .contact_modulus = column(inputs_[2]),
                                 .work_of_adhesion = column(inputs_[3]),
                                 .yield_pressure = column(inputs_[4]),
                                 .damping = column(inputs_[5]),
                                 .velocity = column(velocity)},
                      .end = end_.data(),
                      .restitution = restitution_.data(),
                      .contact_time = contact_time_.data(),
                      .approach_time = approach_time_.data(),
                      .maximum_overlap = overlap.data()});
    }

    std::vector<double> overlap{};  ///< greatest [m]; NaN in doubt

  private:
    const Problems& problems_;
    std::array<std::vector<double>, 6> inputs_{};
    std::vector<LaneEnd> end_{};
    std::vector<double> restitution_{}, contact_time_{}, approach_time_{};
};

/// A search of the velocity at which an impact reaches a greatest overlap, both in logarithms.
struct VelocitySearch {
    std::size_t place;
    InverseInterpolation<5> velocity_of_overlap;
    double velocity;

    /// @return whether it goes on: it has not converged, nor is in doubt
    bool observe(double overlap) {
        constexpr double converged = 1e-6;  // the next change would be far below 1e-12
        const double value = std::log(overlap);
        velocity_of_overlap.insert({.value = value, .x = velocity});
        const double next = velocity_of_overlap.count() > 1
                                ? velocity_of_overlap.interpolated()
                                : velocity + 0.9 * (velocity_of_overlap.wanted() - value);
        const bool far = std::abs(next - velocity) > converged;
        velocity = next;
        return far && std::isfinite(next);
    }
};

/// Searches the velocities that reach their overlaps. NaN where that fails.
void search(const Problems& problems, std::vector<VelocitySearch> searches, double* value) {
    constexpr int most_trials = 16;
    for (int trial = 0; trial < most_trials && !searches.empty(); ++trial) {
        std::vector<std::size_t> places;
        std::vector<double> velocity;
        for (const VelocitySearch& search : searches) {
            places.push_back(search.place);
            velocity.push_back(std::exp(search.velocity));
        }
        ColumnsOfImpacts impacts(problems, places);
        impacts.solve(velocity);
        std::vector<VelocitySearch> open;
        for (std::size_t k = 0; k < searches.size(); ++k) {
            VelocitySearch& search = searches[k];
            if (search.observe(impacts.overlap[k]))
                open.push_back(search);
            else
                value[search.place] = std::exp(search.velocity);
        }
        searches = std::move(open);
    }
}

}  // namespace

void find_yield_velocities(const Problems& problems, PieceState* state, double* value) {
    constexpr double least_ratio = 0.51;  // the kernels leave contacts that adhesion alone yields in doubt
    const YieldCapture capture(problems.detachment, problems.damping_law);
    std::vector<VelocitySearch> searches;
    std::vector<std::size_t> places;
    for (std::size_t i = 0; i < problems.count; ++i) {
        state[i] = PieceState::undecided;
        value[i] = nothing;
        const ContactPair contact = problems.contact(i);
        const double unit = velocity_of_adhesion(problems.law, contact);
        if (!(unit > 0.0)) continue;
        const Scale scale = Scale::of(contact, unit);
        const double yield_number = ThorntonNing<double>::yield_number(contact, scale.length);
        if (!(yield_number > least_ratio)) continue;
        const double u = std::isinf(yield_number)
                             ? 0.0
                             : capture.contact(yield_number, scale.damping_number(problems.damping(i)),
                                               contact.effective_radius / scale.length);
        if (u == std::numeric_limits<double>::infinity()) state[i] = PieceState::captured;
        if (u == 0.0) {
            const auto elastic = critical_velocity_without_integration(
                {Law::of<Jkr>(), problems.detachment, problems.damping(i), contact});
            if (!elastic || !elastic->value) continue;
            state[i] = PieceState::tabulated;
            value[i] = *elastic->value;
            continue;
        }
        if (!std::isfinite(u)) continue;
        const double overlap = power<4>(u) - u;
        const double hertz =
            std::sqrt(0.8 * std::sqrt(overlap)) * overlap;  // more than a softer contact takes
        searches.push_back(
            {i, InverseInterpolation<5>(std::log(overlap * scale.length)), std::log(hertz * scale.velocity)});
        places.push_back(i);
    }
    search(problems, std::move(searches), value);
    for (const std::size_t i : places)
        if (std::isfinite(value[i])) state[i] = PieceState::tabulated;
}

}  // namespace ashimpact::batch
