// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/run/sizes.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <limits>
#include <map>
#include <span>

#include <fmt/format.h>

#include "core/plausibility.hpp"
#include "core/quantities/quantity.hpp"
#include "core/text/error.hpp"
#include "core/text/text.hpp"
#include "materials/contact_properties.hpp"
#include "solver/batch/parallel.hpp"
#include "solver/contact/law.hpp"
#include "solver/motion/impact.hpp"
#include "solver/motion/scale.hpp"
#include "solver/statistics/interval.hpp"
#include "solver/surrogate/rebound_table.hpp"

namespace ashimpact {

namespace {

constexpr double smaller_sizes = 4;      ///< the grid begins at the smallest measured size over this
constexpr double larger_sizes = 4;       ///< it ends at the largest times this
constexpr double step_of_sizes = 1.25;   ///< about, from one size to the next
constexpr double least_distance = 1.06;  ///< of a grid size from a measured one

constexpr double widest_coefficient = 1e3;  ///< of a coefficient from that of order 1 in scaled units
constexpr double close_coefficient = 1.02;  ///< ends of a bracket from which secant steps converge
constexpr double usual_slope = 5;           ///< d ln v_c/d ln C, about
constexpr double least_slope = 0.1;
constexpr int most_corrections = 20;
/// Standard deviation of ln C between samples of one ash, beyond what their sizes and contacts do.
constexpr double scatter_of_samples = 0.1;
/// Standard uncertainty of the exponent of power-of-size above which the sizes are too close for it.
constexpr double most_uncertain_exponent = 2;

/// A sample with a velocity by the reported law.
struct MeasuredSize {
    double diameter;  ///< [m]
    VelocityEstimate velocity;
    double damping;  ///< critical [unit of the damping law of the case]
    ContactPair contact;
};

/// A number that a reader can type: two digits.
double rounded_size(double diameter) {
    return std::strtod(fmt::format("{:.1e}", diameter).c_str(), nullptr);
}

std::vector<MeasuredSize> measured_sizes(const SizeSources& sources) {
    std::vector<MeasuredSize> sizes;
    for (std::size_t i = 0; i < sources.contacts.samples.size(); ++i) {
        const LawCriticalVelocity* velocity = sources.velocities.samples[i].laws.find(sources.choice.law);
        if (velocity == nullptr || !velocity->velocity || velocity->velocity->value > fastest_in_model)
            continue;
        sizes.push_back({.diameter = 2 * sources.contacts.samples[i].radius.value,
                         .velocity = *velocity->velocity,
                         .damping = velocity->damping,
                         .contact = sources.contacts.samples[i].pair});
    }
    std::stable_sort(sizes.begin(), sizes.end(), [](const MeasuredSize& x, const MeasuredSize& y) {
        return std::pair(x.diameter, x.velocity.value) < std::pair(y.diameter, y.velocity.value);
    });
    return sizes;
}

/// Sizes of the rows, the measured ones among them.
std::vector<double> grid_of(const std::vector<MeasuredSize>& measured) {
    const double first = measured.front().diameter / smaller_sizes;
    const double last = measured.back().diameter * larger_sizes;
    const int steps = static_cast<int>(std::round(std::log(last / first) / std::log(step_of_sizes)));
    std::vector<double> sizes;
    for (const MeasuredSize& size : measured) sizes.push_back(size.diameter);
    for (int i = 0; i <= steps; ++i) {
        const double diameter = rounded_size(first * std::pow(last / first, static_cast<double>(i) / steps));
        const bool far = std::ranges::all_of(measured, [&](const MeasuredSize& size) {
            return std::max(diameter / size.diameter, size.diameter / diameter) >= least_distance;
        });
        if (far) sizes.push_back(diameter);
    }
    std::ranges::sort(sizes);
    const auto repeated = std::ranges::unique(sizes);
    sizes.erase(repeated.begin(), repeated.end());
    return sizes;
}

/// A value between those of two sizes; between positive ones on a power law.
double between_sizes(double lower, double upper, double share) {
    if (lower == upper) return lower;
    if (!(lower > 0 && upper > 0)) return (1 - share) * lower + share * upper;
    return lower * std::pow(upper / lower, share);
}

/// The coefficient of a damping law over the diameter, C = exp(level + exponent (ln d - centre)); without an
/// exponent where the sizes are too close for one.
struct PowerOfSize {
    double centre = 0;  ///< ln d
    double level = 0;   ///< ln C there
    double exponent = 0;
    double exponent_uncertainty = 0;  ///< standard

    [[nodiscard]] double coefficient(double diameter) const {
        return std::exp(level + exponent * (std::log(diameter) - centre));
    }
};

/// v_c of a sphere; none if nothing or everything is captured.
std::optional<double> critical_velocity_of(const SizeSources& sources, const Damping& damping,
                                           const ContactPair& contact) {
    return quick_critical_velocity({sources.choice.law, sources.choice.detachment, damping, contact}).value;
}

/// The coefficient with which a sample has its critical velocity; none if no damping by this law gives it.
/// Halving of ln C by whether that velocity is captured, then secant steps of ln v_c over ln C.
std::optional<double> coefficient_at_capture(const SizeSources& sources, const MeasuredSize& size,
                                             DampingLaw law) {
    if (law == sources.damping_law) return size.damping;
    const double wanted = size.velocity.value;
    const double unit = Scale::of(size.contact, wanted).damping_unit(law);
    const auto captures = [&](double coefficient) {
        return restitution_of({sources.choice.law,
                               sources.choice.detachment,
                               {law, coefficient},
                               size.contact,
                               wanted}) == 0;
    };
    double lower = unit / widest_coefficient;
    double upper = unit * widest_coefficient;
    if (captures(lower) || !captures(upper)) return std::nullopt;
    while (upper > close_coefficient * lower) {
        const double middle = std::sqrt(lower * upper);
        (captures(middle) ? upper : lower) = middle;
    }
    double coefficient = lower;
    double slope = usual_slope;
    double last = 0;
    for (int i = 0; i < most_corrections; ++i) {
        const auto velocity = critical_velocity_of(sources, {law, coefficient}, size.contact);
        if (!velocity) return std::nullopt;
        const double difference = std::log(*velocity / wanted);
        if (i > 0) slope = std::max(least_slope, slope * (last - difference) / last);
        coefficient *= std::exp(-difference / slope);
        // The error of a secant step is about the product of the last two.
        if (std::abs(difference) < 1e-11 || (i > 0 && std::abs(difference * last) < 1e-12)) break;
        last = difference;
    }
    return coefficient;
}

/// The coefficients that give the samples their critical velocities, by least squares of ln C over ln d; none
/// where a sample has no such coefficient.
std::optional<PowerOfSize> power_of_size(const SizeSources& sources, const std::vector<MeasuredSize>& sizes,
                                         DampingLaw law) {
    std::vector<std::pair<double, double>> constants;  // ln d, ln C
    try {
        for (const MeasuredSize& size : sizes) {
            const auto coefficient = coefficient_at_capture(sources, size, law);
            if (!(coefficient.value_or(0) > 0)) return std::nullopt;
            constants.emplace_back(std::log(size.diameter), std::log(*coefficient));
        }
    } catch (const ConvergenceError&) {
        return std::nullopt;
    }
    PowerOfSize power;
    const auto count = static_cast<double>(constants.size());
    for (const auto& [log_diameter, log_coefficient] : constants) {
        power.centre += log_diameter / count;
        power.level += log_coefficient / count;
    }
    double spread = 0;
    double product = 0;
    for (const auto& [log_diameter, log_coefficient] : constants) {
        const double distance = log_diameter - power.centre;
        spread += distance * distance;
        product += distance * (log_coefficient - power.level);
    }
    const double uncertainty = scatter_of_samples / std::sqrt(spread);
    if (!(uncertainty <= most_uncertain_exponent)) return power;
    power.exponent = product / spread;
    power.exponent_uncertainty = uncertainty;
    return power;
}

/// Whether a damping law with its constants gives every sample its critical velocity within agreement_factor.
bool gives_samples(const SizeSources& sources, const std::vector<MeasuredSize>& sizes,
                   const FittedDamping& fitted) {
    return std::ranges::all_of(sizes, [&](const MeasuredSize& size) {
        try {
            const ContactPair contact = contact_with(fitted, size.contact);
            // An orbit that escapes takes far longer than the impact that shows v_c to be too high.
            const double greatest = agreement_factor * size.velocity.value;
            if (is_cohesive(sources.choice.law, contact) &&
                restitution_of({sources.choice.law, sources.choice.detachment, fitted.damping(), contact,
                                greatest}) == 0)
                return false;
            const auto velocity = critical_velocity_of(sources, fitted.damping(), contact);
            return velocity &&
                   std::abs(std::log(*velocity / size.velocity.value)) <= std::log(agreement_factor);
        } catch (const ConvergenceError&) {
            return false;
        }
    });
}

/// The first verdicts of a size are those of a critical velocity, in the same order.
static_assert(std::ranges::equal(
    Names<CaptureVerdict>::all, std::span(Names<SizeVerdict>::all).first(Names<CaptureVerdict>::all.size())));

/// Critical velocities of one assumption over all sizes.
class AssumedVelocities {
  public:
    AssumedVelocities(const SizeSources& sources, SizeBasis basis) : sources_(sources), basis_(basis) {}

    [[nodiscard]] SizeVelocity of_damping(double diameter, const Damping& damping,
                                          const ContactPair& contact) const {
        SizeVelocity row{.diameter = diameter, .basis = basis_};
        const auto critical = attempted(damping, contact);
        if (!critical) {
            row.verdict = SizeVerdict::unknown;
            return row;
        }
        row.verdict = static_cast<SizeVerdict>(critical->verdict);
        if (!critical->value) return row;
        if (*critical->value > fastest_in_model)
            row.verdict = SizeVerdict::outside_model;
        else
            row.velocity = critical->value;
        return row;
    }

    /// Sets the interval of a row from standard uncertainties of ln v_c.
    static void set_interval(SizeVelocity& row, double uncertainty) {
        if (!row.velocity || !std::isfinite(uncertainty)) return;
        const double factor = std::exp(confidence_quantile() * uncertainty);
        row.interval = Bounds{*row.velocity / factor, *row.velocity * factor};
        if (*row.interval->upper > fastest_in_model) row.interval->upper = std::nullopt;
    }

    /// By a fitted damping law, with the interval that its constants give.
    [[nodiscard]] SizeVelocity of_fit(double diameter, const FittedDamping& fitted) const {
        const ContactPair contact = contact_of_size(sources_.contacts, diameter).pair;
        SizeVelocity row = of_damping(diameter, fitted.damping(), contact_with(fitted, contact));
        if (!row.velocity) return row;
        std::vector<double> changes;  // of ln v_c, by a standard uncertainty of each constant
        for (std::size_t k = 0; k < fitted.constants.size(); ++k) {
            FittedDamping moved = fitted;
            moved.constants[k].value += moved.constants[k].uncertainty;
            const auto other = attempted(moved.damping(), contact_with(moved, contact));
            if (!other || !other->value) return row;
            changes.push_back(std::log(*other->value / *row.velocity));
        }
        double variance = 0;
        for (const double change : changes) variance += change * change;
        if (changes.size() == 2) variance += 2 * fitted.correlation.value_or(0) * changes[0] * changes[1];
        set_interval(row, std::sqrt(std::max(0.0, variance)));
        return row;
    }

    /// By a coefficient that follows from the critical velocities of the samples; the assumption is its
    /// error.
    [[nodiscard]] SizeVelocity of_coefficient(double diameter, const Damping& damping) const {
        return of_damping(diameter, damping, contact_of_size(sources_.contacts, diameter).pair);
    }

  private:
    [[nodiscard]] std::optional<CriticalVelocity> attempted(const Damping& damping,
                                                            const ContactPair& contact) const {
        try {
            return quick_critical_velocity(
                {sources_.choice.law, sources_.choice.detachment, damping, contact});
        } catch (const ConvergenceError&) {
            return std::nullopt;
        }
    }

    const SizeSources& sources_;
    SizeBasis basis_;
};

/// A damping law needs an assumption of its name, in the same order.
static_assert(std::ranges::equal(Names<DampingLaw>::all,
                                 std::span(Names<SizeBasis>::all)
                                     .subspan(static_cast<std::size_t>(SizeBasis::constant),
                                              all_values<DampingLaw>.size())));

SizeBasis basis_of(DampingLaw law) {
    return static_cast<SizeBasis>(static_cast<int>(SizeBasis::constant) + static_cast<int>(law));
}

/// The damping laws with one constant.
std::vector<DampingLaw> one_number_laws() {
    std::vector<DampingLaw> laws;
    for (const DampingLaw law : all_values<DampingLaw>)
        if (has_one_number(law)) laws.push_back(law);
    return laws;
}

/// Merges samples of the same diameter: v_c is their geometric mean, and the interval spans all of theirs.
/// @param sizes by rising diameter and velocity
std::vector<MeasuredSize> one_of_each(const std::vector<MeasuredSize>& sizes) {
    std::vector<MeasuredSize> merged;
    for (auto first = sizes.begin(); first != sizes.end();) {
        const auto last = std::find_if(
            first, sizes.end(), [&](const MeasuredSize& size) { return size.diameter != first->diameter; });
        MeasuredSize all = *first;
        if (last - first > 1) {
            double sum = 0;
            std::optional<double> lower = first->velocity.value;
            std::optional<double> upper = lower;
            for (auto each = first; each != last; ++each) {
                const VelocityEstimate& velocity = each->velocity;
                const Bounds own = velocity.interval.value_or(Bounds{velocity.value, velocity.value});
                sum += std::log(velocity.value);
                lower = lower && own.lower ? std::optional(std::min(*lower, *own.lower)) : std::nullopt;
                upper = upper && own.upper ? std::optional(std::max(*upper, *own.upper)) : std::nullopt;
            }
            all.velocity = {.value = std::exp(sum / static_cast<double>(last - first)),
                            .interval = Bounds{lower, upper}};
        }
        merged.push_back(all);
        first = last;
    }
    return merged;
}

/// As measured, between two sizes on a power law.
std::vector<SizeVelocity> measured_rows(const std::vector<MeasuredSize>& samples,
                                        const std::vector<double>& sizes) {
    const std::vector<MeasuredSize> measured = one_of_each(samples);
    std::vector<SizeVelocity> rows;
    for (const double diameter : sizes) {
        const auto upper = std::ranges::lower_bound(measured, diameter, {}, &MeasuredSize::diameter);
        if (upper == measured.end() || diameter < measured.front().diameter) continue;
        const MeasuredSize& above = *upper;
        const MeasuredSize& below =
            upper == measured.begin() || above.diameter == diameter ? above : upper[-1];
        const double share = above.diameter == below.diameter ? 1
                                                              : std::log(diameter / below.diameter) /
                                                                    std::log(above.diameter / below.diameter);
        SizeVelocity row{.diameter = diameter,
                         .velocity = between_sizes(below.velocity.value, above.velocity.value, share)};
        if (below.velocity.interval && above.velocity.interval) {
            const auto end = [&](std::optional<double> Bounds::*bound) -> std::optional<double> {
                const std::optional<double>& own = (*below.velocity.interval).*bound;
                const std::optional<double>& other = (*above.velocity.interval).*bound;
                if (!own || !other) return std::nullopt;
                return between_sizes(*own, *other, share);
            };
            row.interval = Bounds{end(&Bounds::lower), end(&Bounds::upper)};
        }
        rows.push_back(row);
    }
    return rows;
}

/// Velocity of a size by one assumption; none where it says nothing.
using SizeRule = std::function<std::optional<SizeVelocity>(double diameter)>;

/// Logarithm of the greatest over the least velocity of a size; infinite where an assumption gives none.
double spread_of(const std::vector<SizeRule>& rules, double diameter) {
    double least = std::numeric_limits<double>::infinity();
    double greatest = 0;
    for (const SizeRule& rule : rules) {
        const std::optional<SizeVelocity> row = rule(diameter);
        if (!row) continue;
        least = std::min(least, row->velocity.value_or(0));
        greatest = std::max(greatest, row->velocity.value_or(0));
    }
    return least > 0 ? std::log(greatest / least) : std::numeric_limits<double>::infinity();
}

/// The last size in an agreement, to three digits, between a size in it and one outside.
double end_of_agreement(const std::vector<SizeRule>& rules, double inside, double outside) {
    const double first = inside;
    constexpr int halvings = 8;
    for (int i = 0; i < halvings; ++i) {
        const double middle = std::sqrt(inside * outside);
        (spread_of(rules, middle) <= std::log(agreement_factor) ? inside : outside) = middle;
    }
    const double unit = std::pow(10.0, std::floor(std::log10(inside)) - 2);
    const double digits = outside < inside ? std::ceil(inside / unit) : std::floor(inside / unit);
    const double rounded = std::strtod(fmt::format("{:.2e}", digits * unit).c_str(), nullptr);
    return outside < inside ? std::min(rounded, first) : std::max(rounded, first);
}

/// Where the assumptions agree, without a gap, around the measured sizes.
std::optional<SizeRange> agreement_of(const std::vector<SizeRule>& rules, const std::vector<double>& sizes,
                                      const SizeRange& measured) {
    std::vector<double> spread;
    for (const double diameter : sizes) spread.push_back(spread_of(rules, diameter));
    const double most = std::log(agreement_factor);
    std::optional<SizeRange> best;
    for (std::size_t first = 0; first < sizes.size(); ++first) {
        if (!(spread[first] <= most)) continue;
        std::size_t last = first;
        while (last + 1 < sizes.size() && spread[last + 1] <= most) ++last;
        const bool holds_measured = sizes[first] <= measured.to && sizes[last] >= measured.from;
        SizeRange run{sizes[first], sizes[last]};
        if (first > 0) run.from = end_of_agreement(rules, sizes[first], sizes[first - 1]);
        if (last + 1 < sizes.size()) run.to = end_of_agreement(rules, sizes[last], sizes[last + 1]);
        if (holds_measured && (!best || run.to / run.from >= best->to / best->from)) best = run;
        first = last;
    }
    return best;
}

}  // namespace

std::vector<std::string> shared_sizes(const ComparisonResult& comparison) {
    std::map<double, std::vector<std::string>> samples;
    for (const SampleComparison& sample : comparison.samples)
        if (sample.diameter && sample.reported && sample.reported->velocity)
            samples[*sample.diameter].push_back(in_quotes(sample.name));
    std::vector<std::string> sentences;
    for (const auto& [diameter, names] : samples)
        if (names.size() > 1)
            sentences.push_back(
                fmt::format("{} samples are of {}, {}: of that size their geometric mean counts, "
                            "with an interval that holds all of theirs",
                            names.size(), readable(diameter, "m"), joined(names)));
    return sentences;
}

SampleContact contact_of_size(const ContactResult& contacts, double diameter) {
    const double radius = diameter / 2;
    const SampleContact* below = nullptr;
    const SampleContact* above = nullptr;
    for (const SampleContact& each : contacts.samples) {
        const double own = each.radius.value;
        if (own <= radius && (below == nullptr || own > below->radius.value)) below = &each;
        if (own >= radius && (above == nullptr || own < above->radius.value)) above = &each;
    }
    if (below == nullptr) below = above;
    if (above == nullptr) above = below;
    const double own = below->radius.value;
    const double other = above->radius.value;
    const double share = other > own ? std::log(radius / own) / std::log(other / own) : 0;
    // Samples of the same size are averaged.
    const auto mean = [&](const SampleContact* of, const auto& value_of) {
        double sum = 0;
        double count = 0;
        for (const SampleContact& each : contacts.samples) {
            if (each.radius.value != of->radius.value) continue;
            sum += value_of(each);
            ++count;
        }
        return sum / count;
    };
    const auto between = [&](const auto& value_of) {
        return between_sizes(mean(below, value_of), mean(above, value_of), share);
    };
    SampleContact contact = share > 0.5 ? *above : *below;
    const double cubed = std::pow(radius / contact.radius.value, 3);
    const double density = between([](const SampleContact& of) { return of.density.value(); });
    contact.mass.value *= cubed * (density / contact.density.value());
    contact.density.quantity.value = density;
    contact.radius.value = radius;
    contact.contact_modulus.quantity.value =
        between([](const SampleContact& of) { return of.contact_modulus.value(); });
    const auto left_by_roughness = [](const SampleContact& of, double sphere) {
        return of.roughness ? roughness_reduction(sphere, {.rms = of.roughness->value()}) : 1.0;
    };
    contact.work_of_adhesion.quantity.value =
        left_by_roughness(contact, radius) * between([&](const SampleContact& of) {
            return of.work_of_adhesion.value() / left_by_roughness(of, of.radius.value);
        });
    contact.pair = pair_of(contact);
    return contact;
}

std::optional<Finding> kept_properties_finding(const ContactResult& contacts) {
    const auto has_tabor = [](const SampleContact& sample) {
        return std::ranges::any_of(sample.parameters,
                                   [](const auto& each) { return each.first.name == "tabor"; });
    };
    if (!std::ranges::any_of(contacts.samples, has_tabor)) return std::nullopt;
    return Finding{
        "kept-over-sizes", Severity::doubt,
        "other sizes have the Tabor parameter of the nearest sample, although it goes with the size"};
}

std::optional<VelocitiesBySize> velocities_by_size(const SizeSources& sources) {
    const std::vector<MeasuredSize> measured = measured_sizes(sources);
    if (measured.empty()) return std::nullopt;
    const std::vector<double> sizes = grid_of(measured);
    VelocitiesBySize all{.rows = measured_rows(measured, sizes),
                         .summary = {.law = sources.choice.law,
                                     .measured = {measured.front().diameter, measured.back().diameter}}};
    const auto add_rows = [&](const auto& row_of) {
        const auto rows = in_parallel(sizes, row_of);
        all.rows.insert(all.rows.end(), rows.begin(), rows.end());
        return rows;
    };
    std::vector<SizeRule> rules;  // of the assumptions
    const auto add_assumption = [&](const auto& row_of) {
        rules.emplace_back([row_of, rows = add_rows(row_of)](double diameter) {
            const auto known = std::ranges::find(rows, diameter, &SizeVelocity::diameter);
            return known != rows.end() ? *known : row_of(diameter);
        });
    };
    bool explained = false;
    for (const FittedDamping& fitted : sources.dampings) {
        if (fitted.evidence != DampingEvidence::explains || !gives_samples(sources, measured, fitted))
            continue;
        explained = true;
        const DampingConstant& first = fitted.constants.front();
        all.summary.coefficients.emplace_back(std::string(name_of(fitted.law)),
                                              make_quantity(first.value, first.dimension, first.uncertainty));
        const AssumedVelocities assumed(sources, basis_of(fitted.law));
        add_assumption([assumed, &fitted](double diameter) { return assumed.of_fit(diameter, fitted); });
    }
    if (!explained) {
        all.summary.constants = ConstantsFrom::capture;
        const auto constants = in_parallel(one_number_laws(), [&](DampingLaw law) -> std::optional<Damping> {
            const auto power = power_of_size(sources, measured, law);
            if (!power) return std::nullopt;
            const FittedDamping constant{
                .law = law, .constants = {{"damping", std::exp(power->level), 0, dimension_of(law)}}};
            if (!gives_samples(sources, measured, constant)) return std::nullopt;
            return constant.damping();
        });
        for (const auto& damping : constants) {
            if (!damping) continue;
            all.summary.coefficients.emplace_back(
                std::string(name_of(damping->law)),
                make_quantity(damping->coefficient, dimension_of(damping->law)));
            const AssumedVelocities assumed(sources, basis_of(damping->law));
            add_assumption([assumed, damping = *damping](double diameter) {
                return assumed.of_coefficient(diameter, damping);
            });
        }
    }
    if (has_one_number(sources.damping_law))
        if (const auto power = power_of_size(sources, measured, sources.damping_law);
            power && power->exponent_uncertainty > 0) {
            const AssumedVelocities assumed(sources, SizeBasis::power_of_size);
            add_assumption([assumed, power = *power, law = sources.damping_law](double diameter) {
                return assumed.of_coefficient(diameter, {law, power.coefficient(diameter)});
            });
            all.summary.power = PowerOfDiameter{
                make_quantity(power->exponent, Dimension::fraction, power->exponent_uncertainty),
                make_quantity(std::exp(power->level), dimension_of(sources.damping_law)),
                std::exp(power->centre)};
        }
    const AssumedVelocities adhesion(sources, SizeBasis::adhesion);
    if (sources.choice.law.is_adhesive())
        add_rows([&](double diameter) {
            return adhesion.of_damping(diameter, {}, contact_of_size(sources.contacts, diameter).pair);
        });
    if (rules.size() < 2) return all;
    rules.emplace_back([&](double diameter) -> std::optional<SizeVelocity> {
        const auto rows = measured_rows(measured, {diameter});
        return rows.empty() ? std::nullopt : std::optional(rows.front());
    });
    all.summary.agreement = agreement_of(rules, sizes, all.summary.measured);
    return all;
}

}  // namespace ashimpact
