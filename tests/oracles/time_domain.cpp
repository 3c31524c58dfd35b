// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/oracles/time_domain.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <stdexcept>

#include "core/text/error.hpp"
#include "materials/contact_properties.hpp"
#include "tests/support/ode.hpp"

namespace ashimpact::oracles {

using std::numbers::pi;

namespace {

constexpr double relative_tolerance = 1e-13;
constexpr double loss = 100 * relative_tolerance;  // over the some hundred steps of an impact
constexpr double patience = 400;                   // in Hertz times

enum class Clock { time, velocity, root_of_overlap_left, net_force };

// time [s], overlap [m], velocity [m/s]
struct Motion {
    using State = std::array<double, 3>;

    const ContactForce& force;
    double mass;
    double damping;
    const Clock& clock;

    [[nodiscard]] double net_force(const State& y) const { return force(y[1]) + damping * y[2]; }

    // dt / d(clock)
    [[nodiscard]] double pace(double x, const State& y, double acceleration) const {
        switch (clock) {
            case Clock::time:
                return 1;
            case Clock::velocity:
                return 1 / acceleration;
            case Clock::root_of_overlap_left:
                return 2 * x / y[2];
            case Clock::net_force:
                return 1 / (force.hertz_slope(y[1]) * y[2] + damping * acceleration);
        }
        return std::nan("");
    }

    State operator()(double x, const State& y) const {
        const double acceleration = -net_force(y) / mass;
        const double rate = pace(x, y, acceleration);
        return {rate, rate * y[2], rate * acceleration};
    }
};

class Integration {
  public:
    using State = Motion::State;

    explicit Integration(const Impact& impact)
        : force_(impact),
          motion_{force_, impact.contact.mass, impact.damping.coefficient, clock_},
          ode_(motion_,
               {relative_tolerance,
                {relative_tolerance * force_.time_scale(), relative_tolerance * force_.overlap_scale(),
                 relative_tolerance * impact.velocity}}),
          zero_force_(impact.detachment == Detachment::zero_force),
          incident_velocity_(impact.velocity) {}

    OracleResult run() {
        State now{0, 0, incident_velocity_};
        const double horizon = patience * force_.time_scale();
        double t = 0;
        double stride = 1e-3 * force_.time_scale();
        std::optional<State> turned;
        while (t < horizon) {
            const State before = now;
            ode_.step(t, horizon, stride, now);
            now[0] = t;
            if (!turned) {
                if (now[2] > 0) continue;
                if (at_rest(before)) break;  // so damped that it never turned
                turned = until(Clock::velocity, before[2], 0, before);
                now = *turned;
                t = now[0];
                ode_.restart();
                continue;
            }
            if (const auto end = end_of_contact(before, now)) return rebound(*turned, *end);
            if (now[2] > 0) break;
        }
        return capture(turned.value_or(now)[1]);
    }

  private:
    State until(Clock clock, double from, double to, State state) {
        clock_ = clock;
        ode_.integrate(from, to, state);
        clock_ = Clock::time;
        return state;
    }

    std::optional<State> end_of_contact(const State& before, const State& now) {
        if (zero_force_) {
            if (motion_.net_force(now) > 0) return std::nullopt;
            return until(Clock::net_force, motion_.net_force(before), 0, before);
        }
        const double end = force_.end_overlap();
        if (least_overlap(before, now) > end) return std::nullopt;
        return until(Clock::root_of_overlap_left, std::sqrt(before[1] - end), 0, before);
    }

    // In equilibrium, where the sign of the velocity is noise.
    [[nodiscard]] bool at_rest(const State& state) const {
        const double little = 1e-9 * incident_velocity_;
        return std::abs(state[2]) < little &&
               std::abs(motion_.net_force(state) / motion_.mass) * force_.time_scale() < little;
    }

    // A sphere may leave and be pulled back within one step.
    double least_overlap(const State& before, const State& now) {
        return now[2] > 0 && !at_rest(before) ? until(Clock::velocity, before[2], 0, before)[1] : now[1];
    }

    [[nodiscard]] OracleResult rebound(const State& turned, const State& end) const {
        const double restitution = -end[2] / incident_velocity_;
        return {.rebound = true,
                .restitution = {restitution, loss},
                .contact_time = {end[0], loss * end[0]},
                .maximum_overlap = {turned[1], loss * turned[1]}};
    }

    static OracleResult capture(double maximum_overlap) {
        OracleResult result;
        result.maximum_overlap = {maximum_overlap, loss * maximum_overlap};
        return result;
    }

    Clock clock_ = Clock::time;
    ContactForce force_;
    Motion motion_;
    test::Ode<3, Motion> ode_;
    bool zero_force_;
    double incident_velocity_;
};

double stretch(const Impact& impact) {
    return std::sqrt(2 * pi * impact.contact.work_of_adhesion / impact.contact.contact_modulus);
}

double jkr_overlap(const Impact& impact, double contact_radius) {
    return contact_radius * contact_radius / impact.contact.effective_radius -
           stretch(impact) * std::sqrt(contact_radius);
}

// dx/da = 0
double fold_contact_radius(const Impact& impact) {
    return std::cbrt(std::pow(stretch(impact) * impact.contact.effective_radius / 4, 2));
}

// F = -(3/2) pi w R, where a controlled load would pull the surfaces apart
double load_controlled_contact_radius(const Impact& impact) {
    return std::cbrt(9 * pi * impact.contact.work_of_adhesion * impact.contact.effective_radius *
                     impact.contact.effective_radius / (8 * impact.contact.contact_modulus));
}

double end_of_contact(const Impact& impact) {
    switch (impact.detachment) {
        case Detachment::zero_overlap:
        case Detachment::zero_force:
            return 0;
        case Detachment::pull_off:
            return jkr_overlap(impact, fold_contact_radius(impact));
        case Detachment::load_controlled:
            return jkr_overlap(impact, load_controlled_contact_radius(impact));
    }
    throw std::logic_error("unknown detachment");
}

}  // namespace

OracleResult time_domain_impact(const Impact& impact) {
    return Integration(impact).run();
}

double time_domain_critical_velocity(const Impact& impact) {
    double captured = 1e-6;
    double rebounds = 1e3;
    const auto rebound_at = [&](double velocity) {
        return time_domain_impact(at_velocity(impact, velocity)).rebound;
    };
    if (rebound_at(captured) || !rebound_at(rebounds))
        throw ConvergenceError("no critical velocity in 1e-6..1e3 m/s");
    while (rebounds > captured * (1 + 1e-9)) {
        const double middle = std::sqrt(captured * rebounds);
        (rebound_at(middle) ? rebounds : captured) = middle;
    }
    return std::sqrt(captured * rebounds);
}

ContactForce::ContactForce(const Impact& impact)
    : law_(impact.law),
      radius_(impact.contact.effective_radius),
      contact_modulus_(impact.contact.contact_modulus),
      work_of_adhesion_(impact.contact.work_of_adhesion),
      stiffness_(4.0 / 3.0 * impact.contact.contact_modulus * std::sqrt(impact.contact.effective_radius)),
      constant_pull_(2 * pi * impact.contact.work_of_adhesion * impact.contact.effective_radius),
      radius_pull_(2 * pi * std::sqrt(impact.contact.effective_radius) *
                   std::cbrt(6 * impact.contact.work_of_adhesion * impact.contact.work_of_adhesion *
                             impact.contact.effective_radius * impact.contact.contact_modulus / pi)),
      stretch_(stretch(impact)),
      fold_overlap_(jkr_overlap(impact, fold_contact_radius(impact))),
      end_overlap_(end_of_contact(impact)),
      overlap_scale_(std::pow(impact.contact.mass * impact.velocity * impact.velocity / stiffness_, 0.4)),
      time_scale_(overlap_scale_ / impact.velocity) {}

double ContactForce::operator()(double overlap) const {
    if (law_ == Law::of<Jkr>()) return jkr_force(overlap);
    const double x = std::max(overlap, 0.0);
    const double hertz = stiffness_ * x * std::sqrt(x);
    if (law_ == Law::of<Dmt>()) return hertz - constant_pull_;
    if (law_ == Law::of<BrachDunn>()) return hertz - radius_pull_ * std::sqrt(x);
    return hertz;
}

double ContactForce::hertz_slope(double overlap) const {
    return 1.5 * stiffness_ * std::sqrt(std::max(overlap, 0.0));
}

double ContactForce::jkr_force(double overlap) const {
    const double a = jkr_contact_radius(std::max(overlap, fold_overlap_));
    const double cube = a * a * a;
    return 4.0 / 3.0 * contact_modulus_ * cube / radius_ -
           std::sqrt(8 * pi * work_of_adhesion_ * contact_modulus_ * cube);
}

// Newton from above: x(a) is convex and rising on the stable branch, so the iterates fall to the root.
double ContactForce::jkr_contact_radius(double overlap) const {
    double a = std::sqrt(radius_ * std::max(overlap, 0.0)) + std::cbrt(std::pow(stretch_ * radius_, 2));
    for (int i = 0; i < 100; ++i) {
        const double root = std::sqrt(a);
        const double excess = a * a / radius_ - stretch_ * root - overlap;
        const double slope = 2 * a / radius_ - stretch_ / (2 * root);
        const double next = a - excess / slope;
        if (!(next < a) || slope <= 0) break;
        a = next;
    }
    return a;
}

Impact at_velocity(Impact impact, double velocity) {
    impact.velocity = velocity;
    return impact;
}

namespace {

struct GridPoint {
    Law law;
    double radius;            // [m]
    double density;           // [kg/m3]
    double contact_modulus;   // [Pa]
    double work_of_adhesion;  // [J/m2]
    double damping;           // [kg/s]
    double velocity;          // [m/s]
};

constexpr Law hertz = Law::of<Hertz>();
constexpr Law dmt = Law::of<Dmt>();
constexpr Law jkr = Law::of<Jkr>();

constexpr GridPoint rows[] = {
    {hertz, 4.4e-05, 2600, 9e+10, 0, 0, 2},         {hertz, 4.4e-05, 2600, 9e+10, 0, 0.00538, 2},
    {hertz, 4.4e-05, 2600, 9e+10, 0, 0.0161, 2},    {hertz, 4.4e-05, 2600, 9e+10, 0, 0.00613, 0.3},
    {hertz, 4.8e-05, 2300, 7.5e+10, 0, 0.0178, 10}, {hertz, 5.2e-05, 2200, 1e+11, 0, 0.00374, 20},
    {hertz, 5e-06, 1000, 1e+09, 0, 5.9e-06, 0.3},   {hertz, 5e-06, 2650, 7e+10, 0, 0.000216, 5},
    {hertz, 1e-05, 8000, 2e+11, 0, 0.000793, 20},   {hertz, 0.0001, 8000, 2e+11, 0, 0.154, 0.3},
    {hertz, 0.0001, 8000, 2e+11, 0, 0.238, 20},     {hertz, 0.0001, 1000, 1e+09, 0, 0.00375, 1},
    {hertz, 2e-05, 4000, 2e+10, 0, 0, 3},           {hertz, 2e-05, 4000, 2e+10, 0, 0.00228, 3},
    {dmt, 4.4e-05, 2600, 9e+10, 0.05, 0, 2},        {dmt, 4.4e-05, 2600, 9e+10, 0.05, 0.00533, 2},
    {dmt, 4.4e-05, 2600, 9e+10, 1, 0.0146, 2},      {dmt, 4.4e-05, 2600, 9e+10, 0.3, 0.00496, 0.3},
    {dmt, 4.8e-05, 2300, 7.5e+10, 0.3, 0.0176, 10}, {dmt, 5.2e-05, 2200, 1e+11, 0.05, 0.00374, 20},
    {dmt, 5e-06, 1000, 1e+09, 0.02, 8.39e-06, 3},   {dmt, 5e-06, 2650, 7e+10, 1, 0.000173, 5},
    {dmt, 1e-05, 8000, 2e+11, 0.3, 0.000788, 20},   {dmt, 0.0001, 8000, 2e+11, 1, 0.134, 0.3},
    {dmt, 0.0001, 8000, 2e+11, 0.05, 0.238, 20},    {dmt, 0.0001, 1000, 1e+09, 0.05, 0.00353, 1},
    {dmt, 2e-05, 4000, 2e+10, 0.3, 0, 3},           {dmt, 2e-05, 4000, 2e+10, 0.3, 0.00214, 3},
    {dmt, 5e-06, 1000, 1e+09, 0.05, 8.02e-06, 2},   {dmt, 5e-06, 1000, 1e+09, 0.05, 1.12e-05, 1.5},
    {jkr, 4.4e-05, 2600, 9e+10, 0.05, 0, 2},        {jkr, 4.4e-05, 2600, 9e+10, 0.05, 0.00531, 2},
    {jkr, 4.4e-05, 2600, 9e+10, 1, 0.0146, 2},      {jkr, 4.4e-05, 2600, 9e+10, 0.3, 0.00498, 0.3},
    {jkr, 4.8e-05, 2300, 7.5e+10, 0.3, 0.0176, 10}, {jkr, 5.2e-05, 2200, 1e+11, 0.05, 0.00374, 20},
    {jkr, 5e-06, 1000, 1e+09, 0.02, 8.36e-06, 3},   {jkr, 5e-06, 2650, 7e+10, 1, 0.000173, 5},
    {jkr, 1e-05, 8000, 2e+11, 0.3, 0.000786, 20},   {jkr, 0.0001, 8000, 2e+11, 1, 0.134, 0.3},
    {jkr, 0.0001, 8000, 2e+11, 0.05, 0.238, 20},    {jkr, 0.0001, 1000, 1e+09, 0.05, 0.00351, 1},
    {jkr, 2e-05, 4000, 2e+10, 0.3, 0, 3},           {jkr, 2e-05, 4000, 2e+10, 0.3, 0.00213, 3},
    {jkr, 5e-06, 1000, 1e+09, 0.05, 0, 3.3},        {jkr, 5e-06, 1000, 1e+09, 0.05, 1.13e-05, 5},
};

}  // namespace

std::vector<Impact> grid() {
    std::vector<Impact> impacts;
    for (const GridPoint& row : rows)
        impacts.push_back(
            {.law = row.law,
             .detachment = row.law == jkr ? Detachment::load_controlled : Detachment::zero_overlap,
             .damping = {DampingLaw::constant, row.damping},
             .contact = {.mass = sphere_mass(row.radius, row.density),
                         .effective_radius = row.radius,
                         .contact_modulus = row.contact_modulus,
                         .work_of_adhesion = row.work_of_adhesion},
             .velocity = row.velocity});
    return impacts;
}

std::vector<Impact> grid_beyond_dem_codes() {
    std::vector<Impact> impacts;
    for (Impact impact : grid()) {
        const auto add = [&](Law law, Detachment detachment) {
            impact.law = law;
            impact.detachment = detachment;
            impacts.push_back(impact);
        };
        if (impact.law == hertz) {
            add(hertz, Detachment::zero_force);
        } else if (impact.law == jkr) {
            add(jkr, Detachment::pull_off);
            add(jkr, Detachment::zero_overlap);
        } else {
            add(Law::of<BrachDunn>(), Detachment::zero_overlap);
        }
    }
    return impacts;
}

}  // namespace ashimpact::oracles
