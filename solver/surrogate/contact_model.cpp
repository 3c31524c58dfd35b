// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/surrogate/contact_model.hpp"

#include <array>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "core/text/error.hpp"
#include "solver/batch/batch.hpp"
#include "solver/contact/law_parameters.hpp"
#include "solver/contact/pair.hpp"
#include "solver/critical_velocity/critical_velocity.hpp"
#include "solver/motion/follow.hpp"
#include "solver/motion/impact.hpp"
#include "solver/motion/regime.hpp"
#include "solver/motion/scaled_impact.hpp"
#include "solver/numeric/gsl/solvers.hpp"

namespace ashimpact {

namespace {

/// The pair that represents all others: mass, effective radius, Hertz stiffness (4/3) E* sqrt(R*) and work of
/// adhesion are 1.
constexpr ContactPair unit_pair{
    .mass = 1.0, .effective_radius = 1.0, .contact_modulus = 0.75, .work_of_adhesion = 1.0};

/// The unit pair with typical parameters of the law. Any would do: beta(e, x) does not depend on them.
ContactPair unit_pair_of(Law law) {
    ContactPair pair = unit_pair;
    pair.parameters = typical_parameters(law);
    return pair;
}

Impact impact_at(const RestitutionMap& map, double damping_number, double velocity) {
    const Scale scale = Scale::of(unit_pair, velocity);
    const double coefficient = scale.damping_coefficient(DampingLaw::constant, damping_number);
    return {.law = map.law(),
            .detachment = map.detachment(),
            .damping = {DampingLaw::constant, coefficient},
            .contact = unit_pair_of(map.law()),
            .velocity = velocity};
}

CriticalVelocity critical_of(const Impact& impact, Precision precision = Precision::extended) {
    return critical_velocity({impact.law, impact.detachment, impact.damping, impact.contact}, precision);
}

/// Start of a search for a damping number.
struct SearchStart {
    double centre;
    double half_width;  ///< of the first bracket, which is cut off at 0
    double slope;       ///< of the function at the centre, roughly; 0 where it is not known
};

/// A damping number that a search found.
struct FoundNumber {
    double value;
    double slope;  ///< of the function, by the last secant; that of the start where there was none
};

/// Zero of a decreasing function of the damping number, by secants, which take two or three values where the
/// function is smooth, else by Brent's method in a bracket that is widened until the sign changes.
FoundNumber zero_of_decreasing(const std::function<double(double)>& function, const SearchStart& first) {
    constexpr double tolerance = 1e-10;
    double before = first.centre;
    double miss_before = function(before);
    double move = (first.centre > first.half_width ? -0.1 : 0.1) * first.half_width;
    const double newton = -miss_before / first.slope;
    if (std::abs(newton) <= first.half_width && before + newton >= 0.0) move = newton;
    if (std::abs(move) <= tolerance) return {before + move, first.slope};
    double at = before + move;
    double farther = before - move;  // the place before the last two
    for (int i = 0; i < 8; ++i) {
        const double miss = function(at);
        const double slope = (miss - miss_before) / (at - before);
        const double step = -miss / slope;
        if (!(std::abs(step) <= 4.0 * first.half_width && at + step >= 0.0)) break;
        // Each error of secants is about the last two times a constant.
        const double next_step = step * step / (at + step - farther);
        farther = before;
        before = std::exchange(at, at + step);
        miss_before = miss;
        if (std::abs(step) <= tolerance || std::abs(next_step) <= 0.1 * tolerance) return {at, slope};
    }
    double lower = std::max(0.0, first.centre - first.half_width);
    double upper = first.centre + first.half_width;
    for (double width = first.half_width; lower > 0.0 && function(lower) <= 0.0; width *= 4.0) {
        upper = lower;
        lower = std::max(0.0, lower - 4.0 * width);
    }
    for (double width = first.half_width; function(upper) > 0.0; width *= 4.0) {
        if (!(upper < 1e6)) throw ConvergenceError("restitution does not fall with damping");
        lower = upper;
        upper += 4.0 * width;
    }
    return {gsl::brent(function, lower, upper, {.relative = 0.0, .absolute = tolerance}).root, first.slope};
}

double solved_restitution(const RestitutionMap& map, double damping_number, double x) {
    return restitution_of(impact_at(map, damping_number, map.unit_velocity(x)));
}

/// Damping number that gives a restitution above 0 [1].
/// @param power of the restitution in which the damping number is about linear from capture to there
FoundNumber solved_damping_number(const RestitutionMap& map, double restitution, double x, double power,
                                  const SearchStart& first) {
    return zero_of_decreasing(
        [&](double number) {
            return std::pow(solved_restitution(map, number, x) / restitution, power) - 1.0;
        },
        first);
}

/// The smallest damping number that captures [1].
FoundNumber solved_capturing_number(const RestitutionMap& map, double x, const SearchStart& first) {
    const double velocity = map.unit_velocity(x);
    return zero_of_decreasing(
        [&](double number) {
            const CriticalVelocity critical =
                critical_of(impact_at(map, number, velocity), Precision::standard);
            return critical.value ? std::log(velocity / *critical.value) : 1.0;
        },
        first);
}

ImpactList impacts_at(const RestitutionMap& map, const Eigen::ArrayXd& damping_number,
                      const Eigen::ArrayXd& x) {
    std::vector<Impact> impacts;
    for (Eigen::Index i = 0; i < x.size(); ++i)
        impacts.push_back(impact_at(map, damping_number[i], map.unit_velocity(x[i])));
    return ImpactList(impacts);
}

/// Damping numbers of many impacts by the batch solver, to its accuracy: all digits at e above about 0.02.
/// @param restitution 0 < e <= greatest_restitution(x) [1]; @param x of the same length
Eigen::ArrayXd batch_damping_numbers(const RestitutionMap& map, const Eigen::ArrayXd& restitution,
                                     const Eigen::ArrayXd& x) {
    const ImpactList list_of_ones = impacts_at(map, Eigen::ArrayXd::Ones(x.size()), x);
    const ImpactBatch ones = list_of_ones.batch();
    const auto found = dampings_from_restitutions(
        {map.law(), map.detachment(), ones.damping_law, ones.contact, ones.velocity, restitution});
    return found.damping / ones.damping;
}

/// Contact times of many impacts that rebound, in units of L/v [1].
Eigen::ArrayXd batch_contact_times(const RestitutionMap& map, const Eigen::ArrayXd& damping_number,
                                   const Eigen::ArrayXd& x) {
    const auto solved = solve_impacts(impacts_at(map, damping_number, x).batch(), {.turning_point = false});
    return solved.contact_time /
           x.unaryExpr([&](double each) { return Scale::of(unit_pair, map.unit_velocity(each)).time(); });
}

// The tables run along root = cbrt(e/e_greatest) and x.
constexpr int root_degree = 26;          ///< of the damping numbers, root from 0 to 1
constexpr int time_degree = 14;          ///< of the contact times, root from least_timed to 1
constexpr double least_timed = 0.3;      ///< root below which contact times are solved, not tabulated
constexpr double least_in_batch = 0.3;   ///< root below which damping numbers are solved one by one
constexpr double least_solved = 1e-6;    ///< e below which rounding of e^2 hides the damping number
constexpr double capture_margin = 0.05;  ///< distance in x from where every impact is captured

/// Degree along x, by the length of the range: the tables are smooth over factors of velocity.
int degree_for(VelocityRange range) {
    const double wanted = 6.0 + 2.0 * (range.upper - range.lower);
    return static_cast<int>(std::clamp(wanted, 8.0, 30.0));
}

double cube(double x) {
    return x * x * x;
}

/// Nodes of a table: for each x of the axis @p along, the roots @p first_root to @p end_root - 1.
struct NodePlaces {
    Eigen::ArrayXd root;
    Eigen::ArrayXd x;

    NodePlaces(const ChebyshevAxis& roots, const ChebyshevAxis& along, int first_root, int end_root) {
        const int rows = end_root - first_root;
        root.resize(static_cast<Eigen::Index>(rows) * (along.degree + 1));
        x.resize(root.size());
        for (int j = 0; j <= along.degree; ++j) {
            for (int i = 0; i < rows; ++i) {
                root[j * rows + i] = roots.node(first_root + i);
                x[j * rows + i] = along.node(j);
            }
        }
    }
};

/// What a row of a table missed at the last two places, for a guess at the next one.
class RowMisses {
  public:
    /// Linear through both.
    [[nodiscard]] double at(double x) const { return last_ + slope_ * (x - place_); }
    void add(double x, double miss) {
        slope_ = count_++ > 0 ? (miss - last_) / (x - place_) : 0.0;
        place_ = x;
        last_ = miss;
    }

    /// Slope of the search over the reciprocal of its distance from capture.
    double steepness = -1.0;

  private:
    int count_ = 0;
    double place_ = 0.0;
    double last_ = 0.0;
    double slope_ = 0.0;
};

/// The value at @p x of the parabola through three points.
double parabola(double x, const std::array<double, 3>& places, const std::array<double, 3>& values) {
    double sum = 0.0;
    for (std::size_t i = 0; i < 3; ++i) {
        const double one = places[(i + 1) % 3];
        const double other = places[(i + 2) % 3];
        sum += values[i] * (x - one) * (x - other) / ((places[i] - one) * (places[i] - other));
    }
    return sum;
}

constexpr int most_iterations = 60;

void require_memoryless(Law law, const ContactPair& contact) {
    if (is_self_similar(law, contact)) return;
    if (!law.self_similar())
        throw InputError("no map of impacts is made for law '" + std::string(law.name()) +
                             "', whose adhesion has a range of its own",
                         law_names([](Law other) { return other.self_similar(); }) +
                             "; a run of a case, and single impacts, give their damping by this law, too");
    throw InputError("law '" + std::string(law.name()) + "' with a finite yield pressure has a history",
                     "a law without one for fits of damping");
}

}  // namespace

RestitutionMap::RestitutionMap(Law law, Detachment detachment, VelocityRange range)
    : law_(law),
      detachment_(detachment),
      adhesion_velocity_(velocity_of_adhesion(law, unit_pair_of(law))),
      range_(range) {
    constexpr double infinite = std::numeric_limits<double>::infinity();
    validate(impact_at(*this, 0.1, 1.0));
    if (critical_of(impact_at(*this, 0.1, 1.0)).verdict == CaptureVerdict::never_captured)
        throw InputError("law '" + std::string(law.name()) + "' with " + std::string(name_of(detachment)) +
                             " detachment never captures",
                         std::string(name_of(Detachment::zero_overlap)));
    const CriticalVelocity undamped = critical_of(impact_at(*this, 0.0, 1.0));
    if (undamped.value) lowest_ = std::log(*undamped.value / adhesion_velocity_);
    if (adhesive())
        range_.lower = std::max(range.lower, lowest_ + capture_margin);
    else
        range_ = {-infinite, infinite};
    if (!(range_.lower < range_.upper)) throw InputError("every impact is captured at these velocities");
    tabulate_damping();
    tabulate_times();
    check();
}

double RestitutionMap::unit_velocity(double x) const {
    return adhesive() ? adhesion_velocity_ * std::exp(x) : 1.0;
}

double RestitutionMap::greatest_restitution(double x) const {
    return std::sqrt(std::max(0.0, -std::expm1(2.0 * (lowest_ - x))));
}

double RestitutionMap::root_of_share(double restitution, double x) const {
    return std::cbrt(std::max(0.0, restitution) / greatest_restitution(x));
}

ChebyshevAxis RestitutionMap::axis_of_x() const {
    if (!adhesive()) return {0.0, 0.0, 0};
    return {range_.lower, range_.upper, degree_for(range_)};
}

void RestitutionMap::tabulate_damping() {
    const ChebyshevAxis root{0.0, 1.0, root_degree};
    const ChebyshevAxis along = axis_of_x();
    int weak = 0;  // roots whose rebounds are too slow for the batch solver's accuracy
    while (root.node(weak) < least_in_batch) ++weak;
    // The last row, root = 1, stays 0: undamped.
    Eigen::MatrixXd numbers = Eigen::MatrixXd::Zero(root.degree + 1, along.degree + 1);
    const NodePlaces places(root, along, weak, root.degree);
    const Eigen::ArrayXd restitution = places.root.binaryExpr(
        places.x, [&](double each, double x) { return cube(each) * greatest_restitution(x); });
    numbers.middleRows(weak, root.degree - weak) = batch_damping_numbers(*this, restitution, places.x)
                                                       .reshaped(root.degree - weak, along.degree + 1)
                                                       .matrix();
    // From fast to slow impacts. Towards e = 0 the numbers rise to that of capture, about with a power of the
    // root that varies slowly: the power of the next roots continues, and what that misses continues what it
    // missed at the faster impacts.
    std::vector<RowMisses> rows(static_cast<std::size_t>(weak));
    double slope_at_capture = 0.0;
    for (int j = along.degree; j >= 0; --j) {
        const double x = along.node(j);
        const double rise = j == along.degree ? 0.0 : numbers(0, j + 1) - numbers(weak, j + 1);
        const FoundNumber capturing =
            solved_capturing_number(*this, x, {numbers(weak, j) + rise, 0.1, slope_at_capture});
        numbers(0, j) = capturing.value;
        slope_at_capture = capturing.slope;
        const auto log_root = [&](int row) { return std::log(root.node(row)); };
        const auto log_fall = [&](int row) { return std::log(numbers(0, j) - numbers(row, j)); };
        for (int i = weak - 1; i > 0; --i) {
            RowMisses& row = rows[static_cast<std::size_t>(i)];
            const double miss = row.at(x);
            const double continued =
                parabola(log_root(i), {log_root(i + 1), log_root(i + 2), log_root(i + 3)},
                         {log_fall(i + 1), log_fall(i + 2), log_fall(i + 3)});
            // Nearer to capture the numbers are greater, so the guess is less than the fall before.
            const double log_guess = std::min(continued + miss, log_fall(i + 1) - 1e-3);
            const double guess = std::exp(log_guess);
            numbers(i, j) = numbers(0, j) - guess;
            const double e = cube(root.node(i)) * greatest_restitution(x);
            if (e < least_solved) continue;
            const double power = (log_guess - log_fall(i + 1)) / (log_root(i) - log_root(i + 1)) / 3.0;
            const FoundNumber found = solved_damping_number(
                *this, e, x, power, {numbers(i, j), 0.3 * guess, row.steepness / guess});
            numbers(i, j) = found.value;
            row.steepness = found.slope * guess;
            row.add(x, log_fall(i) - continued);
        }
    }
    damping_ = ChebyshevSurface(root, along, numbers);
    capture_ = ChebyshevSurface({0.0, 0.0, 0}, along, numbers.topRows(1));
}

void RestitutionMap::tabulate_times() {
    const ChebyshevAxis root{least_timed, 1.0, time_degree};
    const ChebyshevAxis along = axis_of_x();
    const NodePlaces places(root, along, 0, root.degree + 1);
    const Eigen::ArrayXd numbers = places.root.binaryExpr(
        places.x, [&](double each, double x) { return std::max(0.0, damping_.value(each, x)); });
    time_ = ChebyshevSurface(
        root, along,
        batch_contact_times(*this, numbers, places.x).reshaped(root.degree + 1, along.degree + 1).matrix());
}

void RestitutionMap::check() {
    constexpr std::array shares{0.004, 0.05, 0.31, 0.77};
    constexpr std::array places{0.07, 0.36, 0.88};
    accuracy_ = 0.0;
    for (const double place : places) {
        const double x = adhesive() ? range_.lower + place * (range_.upper - range_.lower) : 0.0;
        for (const double share : shares) {
            const double e = share * greatest_restitution(x);
            const double found = solved_restitution(*this, damping_number(e, x).value, x);
            accuracy_ = std::max(accuracy_, std::abs(found - e));
        }
    }
}

/// Derivative along x at fixed restitution of what is tabulated over the root.
double RestitutionMap::along_x(const SurfacePoint& at, double root, double x) const {
    const double greatest = greatest_restitution(x);
    if (!(greatest < 1.0)) return at.by_y;
    return at.by_y - at.by_x * root / 3.0 * (1.0 - greatest * greatest) / (greatest * greatest);
}

DampingNumber RestitutionMap::damping_number(double restitution, double x) const {
    const double root = root_of_share(restitution, x);
    const SurfacePoint at = damping_(root, x);
    // d(root)/de = 1/(3 root^2 e_greatest) diverges at e = 0: below root = 0.01 the slope there replaces it.
    const double safe = std::max(root, 1e-2);
    const double slope = root < safe ? damping_(safe, x).by_x : at.by_x;
    return {at.value, slope / (3.0 * safe * safe * greatest_restitution(x)), along_x(at, root, x)};
}

NumberAlongX RestitutionMap::number_along_x(double restitution, double x) const {
    if (restitution == 0.0) {
        const SurfacePoint at = capture_(0.0, x);
        return {at.value, at.by_y};
    }
    const double root = root_of_share(restitution, x);
    const SurfacePoint at = damping_(root, x);
    return {at.value, along_x(at, root, x)};
}

double RestitutionMap::number(double restitution, double x) const {
    return restitution == 0.0 ? capture_.value(0.0, x) : damping_.value(root_of_share(restitution, x), x);
}

double RestitutionMap::contact_time(double restitution, double x) const {
    const double root = root_of_share(restitution, x);
    if (root >= least_timed) return time_.value(root, x);
    const Impact impact = impact_at(*this, damping_.value(root, x), unit_velocity(x));
    const auto motion = scaled_motion<double>(impact, Scale::of(unit_pair, impact.velocity));
    return follow<double>(motion, 1.0).end.time;
}

ContactModel::ContactModel(std::shared_ptr<const RestitutionMap> map, const ContactPair& contact)
    : map_(std::move(map)), contact_(contact) {
    validate(contact);
    require_memoryless(map_->law(), contact);
    velocity_unit_ = map_->adhesive() ? velocity_of_adhesion(map_->law(), contact) : 1.0;
    if (!(velocity_unit_ > 0.0)) throw InputError("work_of_adhesion is 0 J/m2", "> 0 for an adhesive law");
    log_velocity_unit_ = std::log(velocity_unit_);
    damping_unit_ = std::pow(contact.mass, 0.6) * std::pow(hertz_stiffness(contact), 0.4);
}

VelocityRange ContactModel::range() const {
    return {velocity_unit_ * std::exp(map_->range().lower), velocity_unit_ * std::exp(map_->range().upper)};
}

double ContactModel::greatest_restitution(double velocity) const {
    return map_->greatest_restitution(x_of(velocity));
}

DampingAt ContactModel::damping(double velocity, double restitution) const {
    const DampingNumber number = map_->damping_number(restitution, x_of(velocity));
    const double unit = damping_unit_ * std::pow(velocity, 0.2);
    return {.value = unit * number.value,
            .by_restitution = unit * number.by_restitution,
            .by_velocity = unit / velocity * (0.2 * number.value + number.by_x)};
}

double ContactModel::damping_coefficient(double velocity, double restitution) const {
    return damping_unit_ * std::pow(velocity, 0.2) * map_->number(restitution, x_of(velocity));
}

std::optional<VelocityAt> ContactModel::velocity(double restitution, double damping,
                                                 std::optional<double> guess) const {
    return found_velocity(restitution, damping, guess,
                          [&](double x) { return map_->number_along_x(restitution, x); });
}

std::optional<VelocityAt> ContactModel::velocity(const RestitutionSection& section, double damping,
                                                 std::optional<double> guess) const {
    return found_velocity(section.restitution(), damping, guess,
                          [&](double x) { return section.number_along_x(x); });
}

template <class NumberAt>
std::optional<VelocityAt> ContactModel::found_velocity(double restitution, double damping,
                                                       std::optional<double> guess,
                                                       const NumberAt& number_at) const {
    // ln eta(v, e) rises with ln v: Newton's method, kept within a bracket that only shrinks.
    double lower = map_->range().lower;
    double upper = map_->range().upper;
    // Even an undamped impact reaches this restitution only from this velocity on.
    if (restitution > 0.0 && restitution < 1.0)
        lower = std::max(lower, map_->lowest() - 0.5 * std::log1p(-restitution * restitution));
    if (lower > upper) return std::nullopt;  // std::clamp requires lower <= upper
    const double wanted = std::log(damping / damping_unit_) - 0.2 * log_velocity_unit_;
    double x = std::isfinite(lower) ? 0.5 * (lower + upper) : 0.0;
    if (guess) x = std::clamp(x_of(*guess), lower, upper);
    for (int i = 0; i < most_iterations; ++i) {
        const NumberAlongX number = number_at(x);
        const bool positive = number.value > 0.0;
        const double miss = positive ? 0.2 * x + std::log(number.value) - wanted : -1.0;
        const double slope = 0.2 + number.by_x / number.value;
        if (std::abs(miss) < 1e-7) {  // one more Newton step leaves an error of its square
            const double value = velocity_unit_ * std::exp(x - miss / slope);
            return VelocityAt{value, value / (damping * slope)};
        }
        (miss < 0.0 ? lower : upper) = x;
        const double newton = x - miss / slope;
        x = positive && newton > lower && newton < upper ? newton : 0.5 * (lower + upper);
        if (!(x > lower && x < upper)) break;
    }
    return std::nullopt;
}

std::optional<double> ContactModel::critical_velocity_anywhere(double damping,
                                                               std::optional<double> guess) const {
    if (!(damping > 0.0)) return std::nullopt;
    if (const auto tabulated = velocity(0.0, damping, guess)) return tabulated->value;
    return ashimpact::critical_velocity(
               {map_->law(), map_->detachment(), {DampingLaw::constant, damping}, contact_})
        .value;
}

double ContactModel::restitution(double velocity, double damping) const {
    if (damping >= damping_coefficient(velocity, 0.0)) return 0.0;
    return rebound_restitution(velocity, damping,
                               {.guess = 0.5 * greatest_restitution(velocity), .tolerance = 1e-14});
}

double ContactModel::rebound_restitution(double velocity, double damping, const Search& search) const {
    double lower = 0.0;
    double upper = greatest_restitution(velocity);
    double e = std::min(std::max(search.guess, 1e-9), 0.999999 * upper);
    for (int i = 0; i < most_iterations; ++i) {
        const DampingAt at = this->damping(velocity, e);
        (at.value > damping ? lower : upper) = e;
        const double newton = e - (at.value - damping) / at.by_restitution;
        const double next = newton > lower && newton < upper ? newton : 0.5 * (lower + upper);
        if (std::abs(next - e) <= search.tolerance) return next;
        e = next;
    }
    return e;
}

double ContactModel::contact_time(double velocity, double restitution) const {
    const double length = std::pow(contact_.mass * velocity * velocity / hertz_stiffness(contact_), 0.4);
    return map_->contact_time(restitution, x_of(velocity)) * length / velocity;
}

std::shared_ptr<const RestitutionMap> make_restitution_map(Law law, Detachment detachment,
                                                           const ContactPair& contact,
                                                           VelocityRange velocities) {
    validate(contact);
    require_memoryless(law, contact);
    const double unit = velocity_of_adhesion(law, contact);
    if (unit == 0.0)
        return std::make_shared<RestitutionMap>(
            Law::without_attraction(),
            detachment == Detachment::zero_force ? detachment : Detachment::zero_overlap, velocities);
    return std::make_shared<RestitutionMap>(
        law, detachment, VelocityRange{std::log(velocities.lower / unit), std::log(velocities.upper / unit)});
}

ContactModel make_contact_model(Law law, Detachment detachment, const ContactPair& contact,
                                VelocityRange velocities) {
    return {make_restitution_map(law, detachment, contact, velocities), contact};
}

}  // namespace ashimpact
