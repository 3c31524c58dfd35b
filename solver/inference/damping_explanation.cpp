// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/inference/damping_explanation.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>
#include <string>

#include "core/text/error.hpp"
#include "solver/batch/batch.hpp"
#include "solver/batch/parallel.hpp"
#include "solver/motion/scale.hpp"
#include "solver/numeric/gsl/solvers.hpp"

namespace ashimpact {

namespace {

/// Most groups of neighbouring impacts that are averaged, a sphere. Impacts with a cohesive zone or a history
/// of yield take a hundred times as long.
constexpr std::size_t most_groups = 24;
constexpr std::size_t most_costly_groups = 8;
constexpr std::size_t fewest_groups = 3;  ///< two constants have two of their own
constexpr double octaves_searched = 8;    ///< of a coefficient, to both sides of that of the median impact
constexpr double octaves_a_step = 2;
constexpr double relative_step = 1e-4;  ///< of a coefficient, for derivatives

/// Impacts that are counted as one.
struct Group {
    std::size_t sphere;
    double velocity = 0;
    double restitution = 0;
    double count = 0;
};

/// The impacts by rising velocity, averaged in at most @p most groups of equal numbers.
void add_groups(std::vector<const Measurement*> impacts, std::size_t sphere, std::size_t most,
                std::vector<Group>& groups) {
    const auto key = [](const Measurement* each) { return each->key(); };
    std::ranges::sort(impacts, {}, key);
    const std::size_t number = std::min(most, impacts.size());
    for (std::size_t k = 0; k < number; ++k) {
        Group group{.sphere = sphere};
        const std::size_t end = (k + 1) * impacts.size() / number;
        for (std::size_t i = k * impacts.size() / number; i < end; ++i) {
            const auto count = static_cast<double>(impacts[i]->count);
            group.velocity += count * impacts[i]->velocity;
            group.restitution += count * (impacts[i]->captured() ? 0 : impacts[i]->restitution());
            group.count += count;
        }
        group.velocity /= group.count;
        group.restitution /= group.count;
        groups.push_back(group);
    }
}

/// The contact without the constants of its own damping law.
ContactPair undamped(ContactPair contact) {
    const auto is_of_damping = [](std::string_view name) {
        return std::ranges::any_of(all_values<DampingLaw>, [&](DampingLaw law) {
            return std::ranges::find(parameters_of(law), name, &LawParameter::name) !=
                   parameters_of(law).end();
        });
    };
    ParameterValues<double> kept;
    for (const auto& [name, value] : contact.parameters)
        if (!is_of_damping(name)) kept.set(name, value);
    contact.parameters = kept;
    return contact;
}

/// Differences of e over the constants of one damping law.
class DampingMisfit {
  public:
    DampingMisfit(Law law, Detachment detachment, DampingLaw damping_law,
                  std::span<const ImpactsOfSphere> spheres, const std::vector<Group>& groups)
        : law_(law), detachment_(detachment), damping_law_(damping_law), spheres_(spheres), groups_(groups) {}

    [[nodiscard]] bool has_two_constants() const { return !has_one_number(damping_law_); }
    /// The parameter that is the coefficient of the second term: it has the dimension of the first.
    [[nodiscard]] const LawParameter& second() const {
        return *std::ranges::find(parameters_of(damping_law_), dimension_of(damping_law_),
                                  &LawParameter::dimension);
    }

    /// e as computed less e as measured [1]. @param second constant of the law, if it has two
    [[nodiscard]] Eigen::ArrayXd differences(double coefficient, double second) const {
        std::vector<Impact> impacts;
        impacts.reserve(groups_.size());
        for (const Group& group : groups_) impacts.push_back(impact_of(group, coefficient, second));
        Eigen::ArrayXd difference = restitutions(impacts);
        for (std::size_t i = 0; i < groups_.size(); ++i)
            difference[static_cast<Eigen::Index>(i)] -= groups_[i].restitution;
        return difference;
    }
    [[nodiscard]] double mean_square(double coefficient, double second) const {
        const Eigen::ArrayXd counts = this->counts();
        return (counts * differences(coefficient, second).square()).sum() / counts.sum();
    }
    [[nodiscard]] Eigen::ArrayXd counts() const {
        Eigen::ArrayXd counts(std::ssize(groups_));
        for (std::size_t i = 0; i < groups_.size(); ++i)
            counts[static_cast<Eigen::Index>(i)] = groups_[i].count;
        return counts;
    }
    /// The coefficient that gives the rebound of median restitution its e without adhesion.
    [[nodiscard]] double typical_coefficient() const {
        std::vector<const Group*> rebounds;
        for (const Group& group : groups_)
            if (group.restitution > 0) rebounds.push_back(&group);
        std::ranges::sort(rebounds, {},
                          [](const Group* g) { return std::pair(g->restitution, g->velocity); });
        const Group& median = *rebounds[rebounds.size() / 2];
        const double loss = std::clamp(1 - median.restitution, 0.01, 0.99);
        return Scale::of(spheres_[median.sphere].contact, median.velocity)
            .damping_coefficient(damping_law_, hertz_damping_number(damping_law_, loss));
    }

  private:
    /// By the vector kernels where they have the law; else in double precision, which they would not take.
    [[nodiscard]] Eigen::ArrayXd restitutions(const std::vector<Impact>& impacts) const {
        if (!has_two_constants())
            return solve_impacts(ImpactList(impacts).batch(), {.turning_point = false, .contact_time = false})
                .restitution;
        Eigen::ArrayXd e(std::ssize(impacts));
        std::transform(impacts.begin(), impacts.end(), e.begin(), restitution_of);
        return e;
    }
    [[nodiscard]] Impact impact_of(const Group& group, double coefficient, double second) const {
        Impact impact{law_,
                      detachment_,
                      {damping_law_, coefficient},
                      undamped(spheres_[group.sphere].contact),
                      group.velocity};
        if (has_two_constants()) impact.contact.parameters.set(this->second().name, second);
        return impact;
    }

    Law law_;
    Detachment detachment_;
    DampingLaw damping_law_;
    std::span<const ImpactsOfSphere> spheres_;
    const std::vector<Group>& groups_;
};

/// The coefficient of least misfit along @p mean_square(C): the best of one an octave, refined.
template <class MeanSquare>
double best_coefficient(const MeanSquare& mean_square, double typical) {
    const auto at = [&](double octave) { return mean_square(typical * std::exp2(octave)); };
    double best = -octaves_searched;
    double least = std::numeric_limits<double>::infinity();
    for (double octave = -octaves_searched; octave <= octaves_searched; octave += octaves_a_step) {
        const double here = at(octave);
        if (here < least) {
            least = here;
            best = octave;
        }
    }
    return typical *
           std::exp2(gsl::minimise_between(at, best - octaves_a_step, best, best + octaves_a_step, 1e-6));
}

/// Both constants of a law of two, none below 0: from the best of some, by least squares over their roots.
std::array<double, 2> best_two(const DampingMisfit& misfit, double typical) {
    Eigen::Vector2d best(typical, 0);
    double least = std::numeric_limits<double>::infinity();
    for (double octave = -octaves_searched / 2; octave <= octaves_searched / 2; octave += octaves_a_step)
        for (const double ratio : {0.1, 3.0, 30.0}) {  // attraction is weak beside repulsion
            const double first = typical * std::exp2(octave) / (1 + ratio / 10);
            const double here = misfit.mean_square(first, ratio * first);
            if (here < least) {
                least = here;
                best = {first, ratio * first};
            }
        }
    const Eigen::ArrayXd roots_of_counts = misfit.counts().sqrt();
    const auto residuals = [&](const Eigen::VectorXd& roots) -> Eigen::VectorXd {
        return (roots_of_counts * misfit.differences(roots[0] * roots[0], roots[1] * roots[1])).matrix();
    };
    const auto fit =
        gsl::fit_nonlinear({residuals}, best.cwiseSqrt(), {.parameter_tolerance = 1e-7, .smooth = false});
    return {fit.parameters[0] * fit.parameters[0], fit.parameters[1] * fit.parameters[1]};
}

std::array<double, 2> best_constants(const DampingMisfit& misfit) {
    const double typical = misfit.typical_coefficient();
    if (misfit.has_two_constants()) return best_two(misfit, typical);
    return {best_coefficient([&](double c) { return misfit.mean_square(c, 0); }, typical), 0};
}

DampingConstant first_constant(DampingLaw law, double value, double variance) {
    return {"damping", value, std::sqrt(variance), dimension_of(law)};
}

/// The constants with their uncertainties; those of two that the impacts do not tell apart are left out.
void set_constants(const DampingMisfit& misfit, const std::array<double, 2>& best,
                   DampingExplanation& explanation) {
    const Eigen::ArrayXd weights = misfit.counts() / misfit.counts().mean();
    const bool two = misfit.has_two_constants();
    const double step = relative_step * (best[0] + best[1]);
    const auto slope = [&](double first, double second) -> Eigen::VectorXd {
        // One-sided, since no constant is below 0.
        return ((misfit.differences(best[0] + first, best[1] + second) -
                 misfit.differences(best[0], best[1])) /
                step * weights.sqrt())
            .matrix();
    };
    Eigen::MatrixXd slopes(weights.size(), two ? 2 : 1);
    slopes.col(0) = slope(step, 0);
    if (two) slopes.col(1) = slope(0, step);
    const Eigen::MatrixXd information = slopes.transpose() * slopes;
    const auto freedom = std::max<double>(1, static_cast<double>(weights.size() - slopes.cols()));
    const double variance =
        explanation.misfit * explanation.misfit * static_cast<double>(weights.size()) / freedom;
    if (!(information(0, 0) > 0)) return;  // e does not depend on it
    if (!two) {
        explanation.constants = {first_constant(explanation.law, best[0], variance / information(0, 0))};
        return;
    }
    const double product = information(0, 0) * information(1, 1);
    const double correlation = product > 0 ? -information(0, 1) / std::sqrt(product) : -1;
    explanation.correlation = correlation;
    if (std::abs(correlation) > greatest_correlation) return;
    const double remaining = 1 - correlation * correlation;
    const LawParameter& second = misfit.second();
    explanation.constants = {
        first_constant(explanation.law, best[0], variance / (information(0, 0) * remaining)),
        {second.name, best[1], std::sqrt(variance / (information(1, 1) * remaining)), second.dimension}};
}

std::optional<CriticalVelocity> velocity_with(const DampingExplanation& explanation, Law law,
                                              Detachment detachment, const ContactPair& contact) {
    if (explanation.constants.empty()) return std::nullopt;
    try {
        return critical_velocity({law,
                                  detachment,
                                  {explanation.law, explanation.constants.front().value},
                                  contact_with(explanation, contact)});
    } catch (const InputError&) {
        return std::nullopt;
    } catch (const ConvergenceError&) {
        return std::nullopt;
    }
}

}  // namespace

ContactPair contact_with(const DampingExplanation& explanation, const ContactPair& given) {
    ContactPair contact = undamped(given);
    for (std::size_t k = 1; k < explanation.constants.size(); ++k)
        contact.parameters.set(explanation.constants[k].name, explanation.constants[k].value);
    return contact;
}

std::vector<DampingExplanation> explain_by_damping(Law law, Detachment detachment,
                                                   std::span<const ImpactsOfSphere> spheres) {
    std::vector<Group> groups;
    for (std::size_t i = 0; i < spheres.size(); ++i) {
        const bool costly = is_cohesive(law, spheres[i].contact) || can_yield(law, spheres[i].contact);
        std::vector<const Measurement*> rebounds;
        std::vector<const Measurement*> captures;
        for (const Measurement& impact : spheres[i].impacts)
            (impact.captured() ? captures : rebounds).push_back(&impact);
        const std::size_t most = costly ? most_costly_groups : most_groups;
        add_groups(std::move(rebounds), i, most, groups);
        add_groups(std::move(captures), i, most / 4, groups);
    }
    if (groups.size() < fewest_groups)
        throw InputError(std::to_string(groups.size()) + " impacts of different kinds",
                         "at least " + std::to_string(fewest_groups));
    const std::vector<DampingLaw> laws(all_values<DampingLaw>.begin(), all_values<DampingLaw>.end());
    return in_parallel(laws, [&](DampingLaw damping_law) {
        const DampingMisfit misfit(law, detachment, damping_law, spheres, groups);
        DampingExplanation explanation{.law = damping_law};
        const std::array<double, 2> best = best_constants(misfit);
        explanation.misfit = std::sqrt(misfit.mean_square(best[0], best[1]));
        set_constants(misfit, best, explanation);
        for (const ImpactsOfSphere& sphere : spheres)
            explanation.velocities.push_back(velocity_with(explanation, law, detachment, sphere.contact));
        return explanation;
    });
}

}  // namespace ashimpact
