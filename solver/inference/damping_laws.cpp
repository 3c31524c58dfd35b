// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/inference/damping_laws.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <tuple>

#include <Eigen/Dense>

#include "core/text/error.hpp"
#include "solver/batch/parallel.hpp"
#include "solver/motion/scale.hpp"
#include "solver/numeric/gsl/statistics.hpp"
#include "solver/statistics/interval.hpp"
#include "solver/surrogate/rebound_table.hpp"

namespace ashimpact {

namespace {

/// Constants of the search.
constexpr double usual_scatter = 0.03;  ///< of e between impacts beyond stated noise: no weight grows further
constexpr double octaves_searched = 5;  ///< of a coefficient, to both sides of that of the median impact
constexpr double octaves_a_step = 1;    ///< finer than the valleys of the misfit
constexpr std::array ratios_searched{0.0, 5.0, 60.0};  ///< of a second constant: attraction is weak
constexpr double hopeful_start = 4;        ///< squares of the best of a scan over those of the best of all
constexpr double nearly_everything = 0.8;  ///< of the squares that remain if every impact is captured
/// Relative change of a coefficient that a parabola of e^2 covers, and how often it is moved at most.
struct Reach {
    double relative;
    int moves;
    bool last = false;  ///< the impacts at the constants are those of the law itself, and fine
};
constexpr Reach first_reach{0.3, 6};
constexpr Reach middle_reach{0.1, 3};
constexpr Reach other_law_reach{0.15, 1, true};  ///< from the constants of a similar law
constexpr Reach last_reach{0.02, 6, true};       ///< the error, of third order, is below 1e-6 of a change
/// For two constants, whose impacts are solved one by one: slopes are computed once, then learned.
constexpr Reach learning_reach{0.05, 20, true};
constexpr double converged_shift = 0.01;      ///< of a learning reach; the next one would be below 1e-3 of it
constexpr double greatest_shift = 4;          ///< in learning reaches
constexpr double least_shift = 1e-3;          ///< likewise: below it squares fall by less than rounding
constexpr double strength_of_repulsion = 30;  ///< beside attraction, for the reach of a first constant near 0
constexpr int grid_of_one = 60;               ///< steps from end to end of the reach
constexpr int grid_of_two = 12;               ///< likewise, for each of two constants
constexpr ReboundTableOptions coarse{.yield_halvings = 6, .lane_degree = 15, .scalar_degree = 8};
constexpr ReboundTableOptions fine{.lane_degree = 47, .scalar_degree = 13};

/// Constants of the test for differences that are no scatter.
constexpr std::size_t impacts_a_block = 2;  ///< at least, of neighbouring velocity
constexpr std::size_t most_blocks = 40;     ///< of a sample
constexpr std::size_t fewest_of_scatter = 3;
constexpr double negligible_difference = 0.002;  ///< of e: what a model leaves out and a camera cannot see
constexpr double rejected_below = 1e-3;          ///< probability of such differences by scatter alone

using Constants = std::array<double, 2>;

struct ComparedImpact {
    std::size_t sample;
    double velocity;
    double restitution;
    bool captured;
    double weight;
    VelocityNoise noise;  ///< 0: not stated
};

/// Of relative noise that is small beside the scatter all impacts have the same weight.
double weight_of(const Measurement& impact) {
    const auto count = static_cast<double>(impact.count);
    if (!impact.noise) return count;
    const double e = impact.captured() ? 0 : impact.restitution();
    const double variance = std::max(0.0, impact.noise->rebound + e * e * impact.noise->incident -
                                              2 * e * impact.noise->covariance) /
                            (impact.velocity * impact.velocity);
    return count / (1 + variance / (usual_scatter * usual_scatter));
}

/// Samples and impacts in an order that their values determine, so that sums do not depend on the given one.
std::vector<ImpactsOfSample> in_canonical_order(std::span<const ImpactsOfSample> samples) {
    std::vector<ImpactsOfSample> sorted(samples.begin(), samples.end());
    const auto key = [](const Measurement& impact) { return impact.key(); };
    for (ImpactsOfSample& sample : sorted) std::ranges::sort(sample.impacts, {}, key);
    const auto before = [&](const ImpactsOfSample& x, const ImpactsOfSample& y) {
        const auto numbers = [](const ContactPair& pair) {
            return std::tuple(pair.effective_radius, pair.mass, pair.contact_modulus, pair.work_of_adhesion,
                              pair.yield_pressure);
        };
        if (numbers(x.contact) != numbers(y.contact)) return numbers(x.contact) < numbers(y.contact);
        return std::lexicographical_compare(
            x.impacts.begin(), x.impacts.end(), y.impacts.begin(), y.impacts.end(),
            [&](const Measurement& one, const Measurement& other) { return key(one) < key(other); });
    };
    std::sort(sorted.begin(), sorted.end(), before);
    return sorted;
}

/// The contact without the constants of its own damping law.
ContactPair without_damping_parameters(ContactPair contact) {
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

/// The parameter of a law of two constants that is the second: it has the dimension of the first.
const LawParameter& second_parameter(DampingLaw law) {
    return *std::ranges::find(parameters_of(law), dimension_of(law), &LawParameter::dimension);
}

/// e^2 of each impact near some constants: a parabola along each.
struct NearbyRatios {
    Eigen::ArrayXd centre{};
    std::vector<Eigen::ArrayXd> slope{}, curvature{};  ///< per reach and per its square

    [[nodiscard]] Eigen::ArrayXd at(const Eigen::VectorXd& shift) const {
        Eigen::ArrayXd ratio = centre;
        for (std::size_t k = 0; k < slope.size(); ++k) {
            const double d = shift[static_cast<Eigen::Index>(k)];
            ratio += d * slope[k] + d * d * curvature[k];
        }
        return ratio;
    }
    [[nodiscard]] Eigen::ArrayXd slope_at(const Eigen::VectorXd& shift, std::size_t k) const {
        return slope[k] + 2 * shift[static_cast<Eigen::Index>(k)] * curvature[k];
    }
    /// The same parabolas about a shifted place, at which the ratios are @p ratio.
    [[nodiscard]] NearbyRatios about(const Eigen::VectorXd& shift, const Eigen::ArrayXd& ratio) const {
        NearbyRatios other{.centre = ratio, .curvature = curvature};
        for (std::size_t k = 0; k < slope.size(); ++k) other.slope.push_back(slope_at(shift, k));
        return other;
    }
    /// Changes the slopes so that the parabolas pass through @p ratio at a shift (Broyden's update).
    void learn(const Eigen::VectorXd& shift, const Eigen::ArrayXd& ratio) {
        const Eigen::ArrayXd missed = (ratio - at(shift)) / shift.squaredNorm();
        for (std::size_t k = 0; k < slope.size(); ++k)
            slope[k] += shift[static_cast<Eigen::Index>(k)] * missed;
    }
};

/// The impacts of all samples beside one damping law.
class DampingLawFit {
  public:
    DampingLawFit(Law law, Detachment detachment, DampingLaw damping_law,
                  const std::vector<ImpactsOfSample>& samples)
        : law_(law), detachment_(detachment), damping_law_(damping_law), samples_(samples) {
        for (std::size_t i = 0; i < samples.size(); ++i)
            for (const Measurement& impact : samples[i].impacts)
                impacts_.push_back({i, impact.velocity, impact.captured() ? 0 : impact.restitution(),
                                    impact.captured(), weight_of(impact),
                                    impact.noise.value_or(VelocityNoise{})});
        weights_ = array_of([](const ComparedImpact& impact) { return impact.weight; });
        velocities_ = array_of([](const ComparedImpact& impact) { return impact.velocity; });
    }

    [[nodiscard]] FittedDamping fitted() const {
        const Law start_law = admits(law_.similar()) ? law_.similar() : law_;
        const std::size_t count = has_one_number(damping_law_) ? 1 : 2;
        Constants constants = best_of_starts(start_law, count);
        constants = corrected(start_law, constants, count, middle_reach);
        if (count == 2) return fitted_by_learning(start_law, constants);
        if (start_law != law_) constants = corrected(start_law, constants, count, other_law_reach);
        constants = corrected(start_law, constants, count, last_reach);
        const NearbyRatios nearby = ratios_near(start_law, constants, count, last_reach);
        const Eigen::VectorXd reach = reaches(constants, count, last_reach);
        const Eigen::VectorXd shift = best_shift(nearby, constants, reach);
        return result_at(start_law, moved(constants, shift, reach), nearby, shift, reach);
    }

  private:
    /// @param law itself or one like it @param nearby with their minimum at a shift, where the constants are
    [[nodiscard]] FittedDamping result_at(Law law, const Constants& constants, const NearbyRatios& nearby,
                                          const Eigen::VectorXd& shift, const Eigen::VectorXd& reach) const {
        FittedDamping result{.law = damping_law_};
        const Eigen::ArrayXd differences = differences_of(nearby.at(shift));
        result.misfit = std::sqrt((weights_ * differences.square()).sum() / weights_.sum());
        if (!std::isfinite(result.misfit))
            throw ConvergenceError("the misfit of a damping law is not finite");
        set_constants(nearby, shift, reach, constants, variances(law, constants, differences), result);
        if (!result.constants.empty())
            result.evidence = is_scatter(differences, nearby.slope.size()) ? DampingEvidence::explains
                                                                           : DampingEvidence::rejected;
        return result;
    }

    /// Minimum for two constants, from slopes of @p law that learn from the impacts of the law itself at each
    /// new place. Steps that do not descend are taken back and shortened.
    [[nodiscard]] FittedDamping fitted_by_learning(Law law, Constants constants) const {
        NearbyRatios nearby = parabolas_near(law, constants, 2, learning_reach);
        if (law != law_) nearby.centre = ratios(law_, constants, fine);
        const Eigen::VectorXd reach = reaches(constants, 2, learning_reach);
        Eigen::VectorXd shift;
        double limit = 1;
        double here = squares(nearby.centre);
        for (int i = 0;; ++i) {
            shift = best_shift(nearby, constants, reach, limit);
            const double length = shift.cwiseAbs().maxCoeff();
            if (length <= converged_shift) break;
            if (i == learning_reach.moves) {
                shift.setZero();  // the least squares so far
                break;
            }
            const Constants next = moved(constants, shift, reach);
            const Eigen::ArrayXd ratio = ratios(law_, next, fine);
            const double there = squares(ratio);
            nearby.learn(shift, ratio);
            if (there < here) {
                nearby = nearby.about(shift, ratio);
                constants = next;
                here = there;
                limit = std::min(2 * limit, greatest_shift);
            } else {
                limit = 0.25 * length;
                if (limit < least_shift) break;
            }
        }
        const Eigen::ArrayXd ratio = nearby.at(shift);
        constants = moved(constants, shift, reach);
        Constants centre = constants;
        const NearbyRatios last = parabolas_near(law, centre, 2, last_reach);
        const Eigen::VectorXd last_reaches = reaches(centre, 2, last_reach);
        Eigen::VectorXd back(2);
        for (Eigen::Index k = 0; k < 2; ++k) {
            const auto at = static_cast<std::size_t>(k);
            back[k] = (constants[at] - centre[at]) / last_reaches[k];
        }
        return result_at(law, constants, last.about(back, ratio), Eigen::VectorXd::Zero(2), last_reaches);
    }

    /// A number of each impact, in their order.
    template <class Function>
    [[nodiscard]] Eigen::ArrayXd array_of(const Function& function) const {
        Eigen::ArrayXd all(static_cast<Eigen::Index>(impacts_.size()));
        for (std::size_t i = 0; i < impacts_.size(); ++i)
            all[static_cast<Eigen::Index>(i)] = function(impacts_[i]);
        return all;
    }

    [[nodiscard]] bool admits(Law law) const {
        return std::ranges::all_of(samples_, [&](const ImpactsOfSample& sample) {
            return !refusal(law, sample.contact, detachment_);
        });
    }

    /// The coefficient that gives the rebound of median restitution its e without adhesion.
    [[nodiscard]] double typical_coefficient() const {
        std::vector<const ComparedImpact*> rebounds;
        for (const ComparedImpact& impact : impacts_)
            if (!impact.captured) rebounds.push_back(&impact);
        std::ranges::sort(rebounds, {}, [](const ComparedImpact* impact) {
            return std::tuple(impact->restitution, impact->velocity, impact->sample);
        });
        const ComparedImpact& median = *rebounds[rebounds.size() / 2];
        const double loss = std::clamp(1 - median.restitution, 0.01, 0.99);
        return Scale::of(samples_[median.sample].contact, median.velocity)
            .damping_coefficient(damping_law_, hertz_damping_number(damping_law_, loss));
    }

    /// e^2 of every impact; below 0 where the law captures it.
    [[nodiscard]] Eigen::ArrayXd ratios(Law law, const Constants& constants,
                                        const ReboundTableOptions& options) const {
        return ratios_at(velocities_, law, constants, options);
    }
    /// The same at other velocities, one an impact.
    [[nodiscard]] Eigen::ArrayXd ratios_at(const Eigen::ArrayXd& velocities, Law law,
                                           const Constants& constants,
                                           const ReboundTableOptions& options) const {
        std::vector<VelocityRange> ranges(samples_.size(), {std::numeric_limits<double>::infinity(), 0});
        for (std::size_t i = 0; i < impacts_.size(); ++i) {
            VelocityRange& range = ranges[impacts_[i].sample];
            const double velocity = velocities[static_cast<Eigen::Index>(i)];
            range = {std::min(range.lower, velocity), std::max(range.upper, velocity)};
        }
        std::vector<ReboundTable> tables;
        for (std::size_t i = 0; i < samples_.size(); ++i) {
            Impact impact{law,
                          detachment_,
                          {damping_law_, constants[0]},
                          without_damping_parameters(samples_[i].contact),
                          ranges[i].upper};
            if (!has_one_number(damping_law_))
                impact.contact.parameters.set(second_parameter(damping_law_).name, constants[1]);
            tables.emplace_back(impact, ranges[i], options);
        }
        Eigen::ArrayXd all(weights_.size());
        for (std::size_t i = 0; i < impacts_.size(); ++i) {
            const auto at = static_cast<Eigen::Index>(i);
            all[at] = tables[impacts_[i].sample].energy_ratio(std::log(velocities[at]));
        }
        if (!all.isFinite().all()) throw ConvergenceError("an impact has no finite restitution");
        return all;
    }

    /// Variance of each difference by the noise of both velocities, with the slope of v_r over v_in as
    /// computed, over a standard uncertainty to both sides. Where no noise is stated the differences decide
    /// between such noise, the same for all velocities, and scatter of e, the same for all impacts.
    [[nodiscard]] Eigen::ArrayXd variances(Law law, const Constants& constants,
                                           const Eigen::ArrayXd& differences) const {
        const auto of = [&](double VelocityNoise::*part) {
            return array_of([part](const ComparedImpact& impact) { return impact.noise.*part; });
        };
        const Eigen::ArrayXd rebound = of(&VelocityNoise::rebound);
        Eigen::ArrayXd incident = of(&VelocityNoise::incident);
        const bool is_stated = (incident != 0).any() || (rebound != 0).any();
        const auto told = static_cast<double>(std::max<Eigen::Index>(1, (differences != 0).count()));
        if (!is_stated) {
            const double scatter = differences.square().sum() / told;
            const double noise = (differences * velocities_).square().sum() / told;
            incident = (scatter * velocities_.square()).min(noise);
        }
        constexpr double least_share = 0.01;
        constexpr double greatest_share = 0.8;
        const Eigen::ArrayXd steps =
            incident.sqrt().max(least_share * velocities_).min(greatest_share * velocities_);
        const auto rebound_at = [&](double sign) -> Eigen::ArrayXd {
            const Eigen::ArrayXd velocities = velocities_ + sign * steps;
            return velocities * ratios_at(velocities, law, constants, coarse).max(0.0).sqrt();
        };
        const Eigen::ArrayXd slope = (rebound_at(1) - rebound_at(-1)) / (2 * steps);
        if (is_stated)
            return (rebound + slope.square() * incident - 2 * slope * of(&VelocityNoise::covariance))
                       .max(0.0) /
                   velocities_.square();
        return likeliest_variances(differences, (1 + slope.square()) / velocities_.square());
    }

    /// A mixture of equal variances and those of noise, of greatest normal likelihood; noise alone unless
    /// that is far less likely, since it leaves more open.
    /// @param by_noise variances by noise of one unit
    [[nodiscard]] static Eigen::ArrayXd likeliest_variances(const Eigen::ArrayXd& differences,
                                                            const Eigen::ArrayXd& by_noise) {
        constexpr int steps = 20;
        constexpr double margin = 8;                                    // of twice the logarithm
        const Eigen::ArrayXd told = (differences != 0).cast<double>();  // not captures that the law captures
        Eigen::ArrayXd likeliest = Eigen::ArrayXd::Zero(differences.size());
        if (!(told.sum() > 0)) return likeliest;
        const double unit = (told * by_noise).sum() / (told * by_noise.square()).sum();  // as the steep ones
        double greatest = -std::numeric_limits<double>::infinity();
        for (int i = 0; i <= steps; ++i) {
            const double share = static_cast<double>(i) / steps;
            const Eigen::ArrayXd form = (1 - share) + share * unit * by_noise;
            const double variance = (told * differences.square() / form).sum() / told.sum();
            const double likelihood = (share < 1 ? -margin : 0) - (told * (variance * form).log()).sum();
            if (!(likelihood > greatest)) continue;
            greatest = likelihood;
            likeliest = variance * form;
        }
        return likeliest;
    }

    /// e as measured less e as computed. A capture that the law captures, too, makes none.
    [[nodiscard]] Eigen::ArrayXd differences_of(const Eigen::ArrayXd& ratio) const {
        Eigen::ArrayXd differences = -ratio.max(0.0).sqrt();
        for (std::size_t i = 0; i < impacts_.size(); ++i)
            differences[static_cast<Eigen::Index>(i)] += impacts_[i].restitution;
        return differences;
    }
    [[nodiscard]] double squares(const Eigen::ArrayXd& ratio) const {
        return (weights_ * differences_of(ratio).square()).sum();
    }

    /// Constants with the squares of their misfit.
    struct Start {
        Constants constants{};
        double squares = std::numeric_limits<double>::infinity();
    };

    /// Corrects the best constants of each scanned ratio and returns those of least misfit: the best of the
    /// scan alone may lead to a local minimum.
    [[nodiscard]] Constants best_of_starts(Law law, std::size_t count) const {
        if (count == 1) return corrected(law, best_of_scan(law, 0).constants, count, first_reach);
        std::vector<Start> starts;
        for (const double ratio : ratios_searched) starts.push_back(best_of_scan(law, ratio));
        const double least = std::ranges::min_element(starts, {}, &Start::squares)->squares;
        Start best{starts.front().constants};
        for (const Start& start : starts) {
            if (start.squares > hopeful_start * least) continue;
            const Constants reached = corrected(law, start.constants, count, first_reach);
            const double here = squares_or_infinite(law, reached);
            if (here < best.squares) best = {reached, here};
        }
        return best.constants;
    }

    /// The least misfit of a grid of constants of that ratio, up to damping that captures nearly everything.
    [[nodiscard]] Start best_of_scan(Law law, double ratio) const {
        const double typical = typical_coefficient();
        const double all_captured = squares(Eigen::ArrayXd::Constant(weights_.size(), -1.0));
        Start best{{typical, ratio * typical}};
        for (double octave = -octaves_searched; octave <= octaves_searched; octave += octaves_a_step) {
            const double coefficient = typical * std::exp2(octave);
            const Constants constants{coefficient, ratio * coefficient};
            const double here = squares_or_infinite(law, constants);
            if (here < best.squares) best = {constants, here};
            if (here > 2 * best.squares && here > nearly_everything * all_captured) break;
        }
        return best;
    }
    [[nodiscard]] double squares_or_infinite(Law law, const Constants& constants) const {
        try {
            return squares(ratios(law, constants, coarse));
        } catch (const ConvergenceError&) {  // damping far beyond what the impacts have
            return std::numeric_limits<double>::infinity();
        }
    }

    /// How far a parabola reaches along each constant.
    [[nodiscard]] static Eigen::VectorXd reaches(const Constants& constants, std::size_t count,
                                                 const Reach& reach) {
        Eigen::VectorXd reaches(static_cast<Eigen::Index>(count));
        reaches[0] = reach.relative * std::max(constants[0], constants[1] / strength_of_repulsion);
        if (count == 2) reaches[1] = reach.relative * std::max(constants[0], constants[1]);
        return reaches;
    }

    /// Of the law itself, with the slopes of @p law, which may be a similar one of cheaper impacts; before
    /// the last reach of that law alone. @param constants a second one below its reach is raised to it, since
    /// none may be negative
    [[nodiscard]] NearbyRatios ratios_near(Law law, Constants& constants, std::size_t count,
                                           const Reach& reach) const {
        NearbyRatios nearby = parabolas_near(law, constants, count, reach);
        if (reach.last && law != law_) nearby.centre = ratios(law_, constants, fine);
        return nearby;
    }

    /// Of @p law alone.
    [[nodiscard]] NearbyRatios parabolas_near(Law law, Constants& constants, std::size_t count,
                                              const Reach& reach) const {
        const Eigen::VectorXd reaches = DampingLawFit::reaches(constants, count, reach);
        for (std::size_t k = 0; k < count; ++k)
            constants[k] = std::max(constants[k], reaches[static_cast<Eigen::Index>(k)]);
        const ReboundTableOptions& options = reach.last ? fine : coarse;
        NearbyRatios nearby{.centre = ratios(law, constants, options)};
        for (std::size_t k = 0; k < count; ++k) {
            Constants lower = constants;
            Constants upper = constants;
            lower[k] = std::max(0.0, lower[k] - reaches[static_cast<Eigen::Index>(k)]);
            upper[k] += reaches[static_cast<Eigen::Index>(k)];
            const Eigen::ArrayXd below = ratios(law, lower, options);
            const Eigen::ArrayXd above = ratios(law, upper, options);
            nearby.slope.emplace_back(0.5 * (above - below));
            nearby.curvature.emplace_back(0.5 * (above + below) - nearby.centre);
        }
        return nearby;
    }

    /// Derivatives of e as computed along each constant, in units of its reach.
    [[nodiscard]] Eigen::MatrixXd slopes(const NearbyRatios& nearby, const Eigen::VectorXd& shift) const {
        const Eigen::ArrayXd ratio = nearby.at(shift);
        // Just above capture e has no slope; the bound leaves the position of the minimum as it is.
        constexpr double least_restitution = 1e-3;
        const Eigen::ArrayXd acts = (ratio > 0.0).cast<double>();
        const Eigen::ArrayXd by_ratio = acts * 0.5 / ratio.max(0.0).sqrt().max(least_restitution);
        Eigen::MatrixXd slopes(ratio.size(), shift.size());
        for (Eigen::Index k = 0; k < shift.size(); ++k)
            slopes.col(k) = (by_ratio * nearby.slope_at(shift, static_cast<std::size_t>(k))).matrix();
        return slopes;
    }

    /// The best of a grid within the reach: where an impact passes into capture the squares have a local
    /// minimum.
    [[nodiscard]] Eigen::VectorXd best_of_grid(const NearbyRatios& nearby, const Eigen::VectorXd& least,
                                               double greatest) const {
        const int last = least.size() == 1 ? grid_of_one : grid_of_two;
        Eigen::VectorXd best = Eigen::VectorXd::Zero(least.size());
        double least_squares = squares(nearby.at(best));
        Eigen::VectorXd shift = best;
        for (int i = 0; i <= last; ++i)
            for (int j = 0; j <= (least.size() == 1 ? 0 : last); ++j) {
                shift[0] = least[0] + (greatest - least[0]) * i / last;
                if (least.size() == 2) shift[1] = least[1] + (greatest - least[1]) * j / last;
                const double here = squares(nearby.at(shift));
                if (here >= least_squares) continue;
                least_squares = here;
                best = shift;
            }
        return best;
    }

    /// The minimum of the squares within the reach of the parabolas, in units of the reach: Gauss-Newton
    /// steps, damped where they do not descend.
    /// @param limit of the shifts, in units of the reach
    [[nodiscard]] Eigen::VectorXd best_shift(const NearbyRatios& nearby, const Constants& constants,
                                             const Eigen::VectorXd& reach, double limit = 1) const {
        const auto count = static_cast<Eigen::Index>(nearby.slope.size());
        Eigen::VectorXd least(count);
        for (Eigen::Index k = 0; k < count; ++k)
            least[k] = std::max(-limit, -constants[static_cast<std::size_t>(k)] / reach[k]);
        Eigen::VectorXd shift = best_of_grid(nearby, least, limit);
        double here = squares(nearby.at(shift));
        double damping = 0;
        for (int i = 0; i < 200; ++i) {
            const Eigen::MatrixXd slope = slopes(nearby, shift);
            Eigen::VectorXd downhill =
                slope.transpose() * (weights_ * differences_of(nearby.at(shift))).matrix();
            Eigen::MatrixXd normal = slope.transpose() * weights_.matrix().asDiagonal() * slope;
            normal.diagonal() *= 1 + damping;
            for (Eigen::Index k = 0; k < count; ++k) {
                const bool held =
                    (shift[k] <= least[k] && downhill[k] < 0) || (shift[k] >= limit && downhill[k] > 0);
                if (!held && normal(k, k) > 0) continue;
                normal.row(k).setZero();
                normal.col(k).setZero();
                normal(k, k) = 1;
                downhill[k] = 0;
            }
            const Eigen::VectorXd next =
                (shift + normal.ldlt().solve(downhill)).cwiseMax(least).cwiseMin(limit);
            const double there = squares(nearby.at(next));
            // Near the minimum squares change by rounding alone; steps go on, so that it is found to
            // rounding.
            if (!(there <= here * (1 + 1e-12))) {
                damping = std::max(1e-3, 4 * damping);
                if (damping > 1e12) break;
                continue;
            }
            const double step = (next - shift).cwiseAbs().maxCoeff();
            if (there < here * (1 - 1e-9)) damping *= 0.25;
            shift = next;
            here = there;
            if (step < 1e-15) break;
        }
        return shift;
    }

    [[nodiscard]] static Constants moved(Constants constants, const Eigen::VectorXd& shift,
                                         const Eigen::VectorXd& reach) {
        constexpr double rounding = 1e-12;  // of a reach: a constant below it is the rounding error of 0
        for (Eigen::Index k = 0; k < shift.size(); ++k) {
            double& constant = constants[static_cast<std::size_t>(k)];
            constant += shift[k] * reach[k];
            if (constant < rounding * reach[k]) constant = 0;
        }
        return constants;
    }

    /// Moves the constants downhill until the minimum is within reach.
    [[nodiscard]] Constants corrected(Law law, Constants constants, std::size_t count,
                                      const Reach& reach) const {
        for (int i = 0; i < reach.moves; ++i) {
            const NearbyRatios nearby = ratios_near(law, constants, count, reach);
            const Eigen::VectorXd extent = reaches(constants, count, reach);
            const Eigen::VectorXd shift = best_shift(nearby, constants, extent);
            constants = moved(constants, shift, extent);
            bool within = true;
            for (Eigen::Index k = 0; k < shift.size(); ++k)
                within =
                    within && (std::abs(shift[k]) < 1 - 1e-9 || constants[static_cast<std::size_t>(k)] == 0);
            if (within) break;
        }
        return constants;
    }

    /// Standard uncertainties of the constants from the variances of the differences, which are not the same
    /// for all: the error of a measured velocity counts most where e is steep. None is smaller than that of
    /// equal scatter, with Student's t.
    /// @param slope of e as computed, a row an impact and a column a constant
    [[nodiscard]] Eigen::VectorXd uncertainties(const Eigen::MatrixXd& slope,
                                                const Eigen::ArrayXd& differences,
                                                const Eigen::ArrayXd& variances) const {
        const Eigen::MatrixXd weighted = weights_.matrix().asDiagonal() * slope;
        const Eigen::MatrixXd inverse = (slope.transpose() * weighted).inverse();
        const Eigen::ArrayXd by_noise =
            (inverse * weighted.transpose()).array().square().matrix() * variances.matrix();
        // A capture that the law captures, too, is no scatter of 0.
        const auto told = ((slope.array() != 0).rowwise().any() || differences != 0).count();
        const int freedom = static_cast<int>(std::max<Eigen::Index>(1, told - slope.cols()));
        const double wider = gsl::student_quantile(0.5 + 0.5 * confidence, freedom) / confidence_quantile();
        const Eigen::ArrayXd equal =
            (weights_ * differences.square()).sum() / freedom * wider * wider * inverse.diagonal().array();
        return by_noise.max(equal).sqrt().matrix();
    }

    /// Changes of e as computed over a width to both sides of each constant, per its reach: e rises
    /// vertically where capture ends, and a derivative there holds for no change that the impacts leave open.
    [[nodiscard]] static Eigen::MatrixXd secants(const NearbyRatios& nearby, const Eigen::VectorXd& shift,
                                                 const Eigen::VectorXd& widths) {
        Eigen::MatrixXd secants(nearby.centre.size(), shift.size());
        for (Eigen::Index k = 0; k < shift.size(); ++k) {
            const auto e_at = [&](double width) -> Eigen::ArrayXd {
                Eigen::VectorXd there = shift;
                there[k] += width;
                return nearby.at(there).max(0.0).sqrt();
            };
            secants.col(k) = ((e_at(widths[k]) - e_at(-widths[k])) / (2 * widths[k])).matrix();
        }
        return secants;
    }

    /// Standard uncertainties of the constants in units of their reaches, which are the widths of their
    /// secants, too.
    [[nodiscard]] Eigen::VectorXd uncertainties_near(const NearbyRatios& nearby, const Eigen::VectorXd& shift,
                                                     const Eigen::ArrayXd& variances) const {
        constexpr int most = 8;
        constexpr double narrowest = 1e-6;
        constexpr double widest = 4;  // beyond it e is no parabola
        const Eigen::ArrayXd differences = differences_of(nearby.at(shift));
        Eigen::VectorXd found = Eigen::VectorXd::Ones(shift.size());
        for (int i = 0; i <= most && found.allFinite(); ++i) {
            const Eigen::VectorXd widths = found.cwiseMax(narrowest).cwiseMin(widest);
            found = uncertainties(secants(nearby, shift, widths), differences, variances);
        }
        return found;
    }

    void set_constants(const NearbyRatios& nearby, const Eigen::VectorXd& shift, const Eigen::VectorXd& reach,
                       const Constants& constants, const Eigen::ArrayXd& variances,
                       FittedDamping& result) const {
        const Eigen::MatrixXd slope = slopes(nearby, shift);
        const Eigen::MatrixXd information = slope.transpose() * weights_.matrix().asDiagonal() * slope;
        if (!(information(0, 0) > 0)) return;
        if (shift.size() == 2) {
            const double product = information(0, 0) * information(1, 1);
            result.correlation = product > 0 ? -information(0, 1) / std::sqrt(product) : -1;
            if (std::abs(*result.correlation) > greatest_correlation) return;
        }
        const Eigen::VectorXd uncertainties = uncertainties_near(nearby, shift, variances);
        if (!uncertainties.allFinite()) return;
        const auto add = [&](std::string_view name, Eigen::Index k) {
            result.constants.push_back({name, constants[static_cast<std::size_t>(k)],
                                        uncertainties[k] * reach[k], dimension_of(damping_law_)});
        };
        add("damping", 0);
        if (shift.size() == 1) return;
        add(second_parameter(damping_law_).name, 1);
    }

    /// Sums of an analysis of variance over blocks of impacts.
    struct BlockSums {
        double between = 0;
        double within = 0;
        std::size_t blocks = 0;
        std::size_t counted = 0;  ///< impacts of all blocks
    };

    /// @param members indices of the impacts of one block
    void add_block(std::span<const std::size_t> members, const Eigen::ArrayXd& differences,
                   BlockSums& sums) const {
        double sum = 0;
        double sum_of_squares = 0;
        double weight = 0;
        for (const std::size_t member : members) {
            const auto j = static_cast<Eigen::Index>(member);
            sum += weights_[j] * differences[j];
            sum_of_squares += weights_[j] * differences[j] * differences[j];
            weight += weights_[j];
        }
        sums.between += sum * sum / weight;
        sums.within += std::max(0.0, sum_of_squares - sum * sum / weight);
        ++sums.blocks;
        sums.counted += members.size();
    }

    /// Divides the impacts of a sample into blocks; impacts of one velocity are in one block.
    void add_blocks(std::span<const std::size_t> members, const Eigen::ArrayXd& differences,
                    BlockSums& sums) const {
        const std::size_t number = std::clamp<std::size_t>(members.size() / impacts_a_block, 1, most_blocks);
        std::size_t to = 0;
        for (std::size_t k = 0; k < number && to < members.size(); ++k) {
            const std::size_t from = to;
            to = std::max(from + 1, (k + 1) * members.size() / number);
            while (to < members.size() &&
                   impacts_[members[to]].velocity == impacts_[members[to - 1]].velocity)
                ++to;
            add_block(members.subspan(from, to - from), differences, sums);
        }
    }

    /// Whether differences of neighbouring impacts are as far apart as those of distant ones: analysis of
    /// variance over blocks of each sample, by velocity. Captures that the law captures, too, do not count.
    [[nodiscard]] bool is_scatter(const Eigen::ArrayXd& differences, std::size_t constants) const {
        BlockSums sums;
        std::size_t first = 0;
        while (first < impacts_.size()) {
            std::vector<std::size_t> members;
            std::size_t end = first;
            for (; end < impacts_.size() && impacts_[end].sample == impacts_[first].sample; ++end)
                if (!impacts_[end].captured || differences[static_cast<Eigen::Index>(end)] != 0)
                    members.push_back(end);
            add_blocks(members, differences, sums);
            first = end;
        }
        const auto& [between, within, blocks, counted] = sums;
        if (counted < blocks + fewest_of_scatter || blocks + 1 <= constants) return true;
        const double freedom = static_cast<double>(counted - blocks);
        const double scatter =
            within / freedom + negligible_difference * negligible_difference * weights_.mean();
        const double groups = static_cast<double>(blocks);
        return gsl::variance_ratio_exceedance(between / groups / scatter, groups, freedom) >= rejected_below;
    }

    Law law_;
    Detachment detachment_;
    DampingLaw damping_law_;
    const std::vector<ImpactsOfSample>& samples_;
    std::vector<ComparedImpact> impacts_{};
    Eigen::ArrayXd weights_{};
    Eigen::ArrayXd velocities_{};
};

}  // namespace

ContactPair contact_with(const FittedDamping& fitted, const ContactPair& given) {
    ContactPair contact = without_damping_parameters(given);
    for (std::size_t k = 1; k < fitted.constants.size(); ++k)
        contact.parameters.set(fitted.constants[k].name, fitted.constants[k].value);
    return contact;
}

std::vector<FittedDamping> fit_damping_laws(Law law, Detachment detachment,
                                            std::span<const ImpactsOfSample> samples) {
    std::vector<ImpactsOfSample> sorted = in_canonical_order(samples);
    std::erase_if(sorted, [](const ImpactsOfSample& sample) { return sample.impacts.empty(); });
    std::size_t impacts = 0;
    bool rebounds = false;
    for (const ImpactsOfSample& sample : sorted) {
        impacts += sample.impacts.size();
        rebounds = rebounds || !std::ranges::all_of(sample.impacts, &Measurement::captured);
    }
    if (impacts < fewest_compared || !rebounds) return {};
    const std::vector<DampingLaw> laws(all_values<DampingLaw>.begin(), all_values<DampingLaw>.end());
    const auto attempts = in_parallel(laws, [&](DampingLaw damping_law) -> std::optional<FittedDamping> {
        try {
            return DampingLawFit(law, detachment, damping_law, sorted).fitted();
        } catch (const ConvergenceError&) {
            return std::nullopt;
        }
    });
    std::vector<FittedDamping> all;
    for (const auto& attempt : attempts)
        if (attempt) all.push_back(*attempt);
    return all;
}

}  // namespace ashimpact
