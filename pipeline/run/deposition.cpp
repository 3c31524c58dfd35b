// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/run/deposition.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>

#include <fmt/format.h>

#include "core/plausibility.hpp"
#include "core/quantities/quantity.hpp"
#include "core/text/error.hpp"
#include "core/text/text.hpp"
#include "pipeline/run/rebounds.hpp"
#include "pipeline/run/sizes.hpp"
#include "solver/batch/parallel.hpp"
#include "solver/surrogate/rebound_table.hpp"

namespace ashimpact {

namespace {

constexpr int arcs_of_quarter = 18;        ///< of 5 degrees
constexpr double fine_particle = 2e-6;     ///< below, gas slips along particles [m]
constexpr double greatest_reynolds = 800;  ///< of the drag law
constexpr double interception = 0.05;      ///< particle over tube, from which its own size counts

/// A row with numbers that order: infinite if everything is captured, 0 if nothing is.
struct VelocityRow {
    double diameter, value, lower, upper;
    double outside;  ///< 1 where v_c is outside the model, else 0
};

std::vector<VelocityRow> rows_of(const std::vector<SizeVelocity>& all, SizeBasis basis) {
    std::vector<VelocityRow> rows;
    for (const SizeVelocity& row : all) {
        if (row.basis != basis || row.verdict == SizeVerdict::unknown) continue;
        const double otherwise =
            row.verdict == SizeVerdict::never_captured ? 0 : std::numeric_limits<double>::infinity();
        const double value = row.velocity.value_or(otherwise);
        const double outside = row.verdict == SizeVerdict::outside_model ? 1 : 0;
        rows.push_back({row.diameter, value, value, value, outside});
        if (row.interval && row.velocity) {
            rows.back().lower = row.interval->lower.value_or(0);
            rows.back().upper = row.interval->upper.value_or(std::numeric_limits<double>::infinity());
        }
    }
    std::ranges::sort(rows, {}, &VelocityRow::diameter);
    return rows;
}

bool is_finite(double velocity) {
    return velocity > 0 && std::isfinite(velocity);
}

/// On the power law of two rows, beyond them too; where one of them has none, that of the nearer.
double on_power_law(const VelocityRow& a, const VelocityRow& b, double VelocityRow::*member,
                    double diameter) {
    const double part =
        a.diameter == b.diameter ? 0 : std::log(diameter / a.diameter) / std::log(b.diameter / a.diameter);
    const double first = a.*member;
    const double second = b.*member;
    if (first == second || !is_finite(first) || !is_finite(second)) return part < 0.5 ? first : second;
    return first * std::pow(second / first, part);
}

/// The rows on both sides of a size; beyond all of them the last two.
std::pair<const VelocityRow&, const VelocityRow&> rows_around(const std::vector<VelocityRow>& rows,
                                                              double diameter) {
    const auto above = static_cast<std::size_t>(
        std::ranges::lower_bound(rows, diameter, {}, &VelocityRow::diameter) - rows.begin());
    const std::size_t upper =
        std::clamp<std::size_t>(above, std::min<std::size_t>(1, rows.size() - 1), rows.size() - 1);
    return {rows[upper == 0 ? 0 : upper - 1], rows[upper]};
}

VelocityRow row_at(const std::vector<VelocityRow>& rows, double diameter) {
    const auto& [a, b] = rows_around(rows, diameter);
    VelocityRow row{.diameter = diameter,
                    .value = on_power_law(a, b, &VelocityRow::value, diameter),
                    .lower = on_power_law(a, b, &VelocityRow::lower, diameter),
                    .upper = on_power_law(a, b, &VelocityRow::upper, diameter),
                    .outside = on_power_law(a, b, &VelocityRow::outside, diameter)};
    // One row has a finite v_c, the other none: the transition may lie anywhere between them.
    const bool between = a.diameter < diameter && diameter < b.diameter;
    const auto is_finite = [](const VelocityRow& each) {
        return each.value > 0 && std::isfinite(each.value);
    };
    if (between && is_finite(a) != is_finite(b)) {
        row.lower = std::min(a.lower, b.lower);
        row.upper = std::max(a.upper, b.upper);
    }
    // Intervals of rows with and without one do not mix into an interval without the value.
    row.lower = std::min(row.lower, row.value);
    row.upper = std::max(row.upper, row.value);
    return row;
}

/// Critical velocities [m/s] by size, solved with the constants of an assumption.
class SolvedSizes {
  public:
    SolvedSizes(const Run& run, SizeBasis basis, const std::vector<VelocityRow>& rows)
        : impact_of_(assumed_impacts(run, basis)),
          rows_(rows),
          reproduced_(in_parallel(rows, [this](const VelocityRow& row) { return int{reproduces(row)}; })) {}

    /// The solved velocity of a size, with the relative interval of the neighbouring rows. Interpolated
    /// between them if the constants do not reproduce them, as after an edit.
    [[nodiscard]] VelocityRow row_of(double diameter) const {
        VelocityRow row = row_at(rows_, diameter);
        const auto [first, last] = rows_around(rows_, diameter);
        if (!reproduced_[place_of(first)] || !reproduced_[place_of(last)]) return row;
        const auto value = velocity_of(diameter);
        if (!value) return row;
        const bool both_finite = is_finite(*value) && is_finite(row.value);
        row.lower = both_finite ? row.lower * *value / row.value : std::min(row.lower, *value);
        row.upper = both_finite ? row.upper * *value / row.value : std::max(row.upper, *value);
        row.value = *value;
        return row;
    }

  private:
    [[nodiscard]] std::optional<double> velocity_of(double diameter) const {
        if (!impact_of_) return std::nullopt;
        try {
            const Impact impact = impact_of_(diameter);
            const CriticalVelocity critical =
                quick_critical_velocity({impact.law, impact.detachment, impact.damping, impact.contact});
            if (critical.verdict == CaptureVerdict::never_captured) return 0;
            const double value = critical.value.value_or(std::numeric_limits<double>::infinity());
            return value > fastest_in_model ? std::numeric_limits<double>::infinity() : value;
        } catch (const ConvergenceError&) {
            return std::nullopt;
        }
    }
    /// Whether the constants give the velocity of a row.
    [[nodiscard]] bool reproduces(const VelocityRow& row) const {
        constexpr double rounding = 1e-3;
        const auto value = velocity_of(row.diameter);
        return value && (*value == row.value || std::abs(*value / row.value - 1) < rounding);
    }

    [[nodiscard]] std::size_t place_of(const VelocityRow& row) const {
        return static_cast<std::size_t>(&row - rows_.data());
    }

    std::function<Impact(double diameter)> impact_of_;
    const std::vector<VelocityRow>& rows_;
    std::vector<int> reproduced_;  ///< of each row, whether the constants reproduce it
};

constexpr double warmest_room = 323;  ///< [K]; of measurements without a stated temperature

constexpr std::array preferred{SizeBasis::contact_radius, SizeBasis::tsuji,         SizeBasis::hunt_crossley,
                               SizeBasis::brach_dunn,     SizeBasis::power_of_size, SizeBasis::constant,
                               SizeBasis::adhesion};

/// The assumptions that a run has rows of, that of the answer first.
std::vector<SizeBasis> assumptions_to_use(const std::vector<SizeVelocity>& rows,
                                          const std::optional<SizeBasis>& basis) {
    std::vector<SizeBasis> list;
    std::vector<std::string> names;
    for (const SizeBasis each : preferred) {
        if (rows_of(rows, each).empty()) continue;
        list.push_back(each);
        names.emplace_back(name_of(each));
    }
    if (list.empty())
        throw InputError("the run has critical velocities of its samples only",
                         "a law with adhesion or damping")
            .at("/result/by_size");
    if (!basis) return list;
    const auto named = std::ranges::find(list, *basis);
    if (named == list.end())
        throw InputError(fmt::format("the impacts of the run do not admit {}", name_of(*basis)),
                         joined(names))
            .at("--assumption");
    std::rotate(list.begin(), named, named + 1);
    return list;
}

/// Shares of all that flies at the tube which arrive and stay, under one assumption.
struct Staying {
    double arrives = 0, stays = 0, least = 0, greatest = 0;

    [[nodiscard]] SpannedShare share() const {
        if (!(arrives > 0)) return {};
        return {stays / arrives, {least / arrives, greatest / arrives}};
    }
};

Staying staying_under(const ClassVelocities& velocities, const std::vector<ClassImpaction>& classes,
                      double gas_velocity) {
    Staying sum;
    for (std::size_t i = 0; i < classes.size(); ++i) {
        const double arrives = classes[i].size.share * classes[i].impaction.efficiency();
        const auto stays = [&](double critical) {
            return arrives * classes[i].stick_fraction(critical, gas_velocity);
        };
        sum.arrives += arrives;
        sum.stays += stays(velocities.value[i]);
        sum.least += stays(velocities.lower[i]);
        sum.greatest += stays(velocities.upper[i]);
    }
    return sum;
}

/// Means of rebounds as a result states them.
ReboundMeans rebound_means(const Rebounds& rebounds) {
    if (!(rebounds.share > 0) || !std::isfinite(rebounds.restitution)) return {};
    return {rebounds.restitution, rebounds.velocity};
}

/// The assumptions that span the answer: those on damping, else adhesion alone.
bool spans(const DepositingAsh& ash, const ClassVelocities& velocities) {
    return velocities.basis != SizeBasis::adhesion || ash.assumptions.size() == 1 ||
           velocities.basis == ash.assumptions.front().basis;
}

/// One class from its parts: means over what arrives; what belongs to one size is that of the part in the
/// middle.
DepositedSize whole_class(std::span<const DepositedSize> parts) {
    DepositedSize whole = parts[parts.size() / 2];
    whole.from = parts.front().from;
    whole.to = parts.back().to;
    whole.mass_fraction = 0;
    double arrives = 0;
    double normal = 0;
    double rebounds = 0;
    SpannedShare stays;
    ReboundMeans means{.restitution = 0, .velocity = 0};
    for (const DepositedSize& part : parts) {
        whole.mass_fraction += part.mass_fraction;
        const double arriving = part.mass_fraction * part.impaction_efficiency;
        if (!(arriving > 0)) continue;
        arrives += arriving;
        normal += arriving * part.normal_velocity.value_or(0);
        stays.value += arriving * part.stick_fraction.value;
        stays.span.least += arriving * part.stick_fraction.span.least;
        stays.span.greatest += arriving * part.stick_fraction.span.greatest;
        if (!part.rebound.restitution || !part.rebound.velocity) continue;
        const double rebounding = arriving * (1 - part.stick_fraction.value);
        rebounds += rebounding;
        *means.restitution += rebounding * *part.rebound.restitution;
        *means.velocity += rebounding * *part.rebound.velocity;
    }
    if (!(arrives > 0)) return whole;
    whole.impaction_efficiency = arrives / whole.mass_fraction;
    whole.normal_velocity = normal / arrives;
    whole.stick_fraction = {stays.value / arrives,
                            {stays.span.least / arrives, stays.span.greatest / arrives}};
    whole.rebound = {};
    if (rebounds > 0) whole.rebound = {*means.restitution / rebounds, *means.velocity / rebounds};
    for (auto member : {&DepositedSize::arrival_flux, &DepositedSize::deposition_flux}) {
        if (!(whole.*member)) continue;
        (whole.*member)->value = 0;
        for (const DepositedSize& part : parts) (whole.*member)->value += (part.*member)->value;
    }
    return whole;
}

std::vector<DepositedSize> deposited_sizes(const TubeConditions& tube, const DepositingAsh& ash,
                                           const std::vector<ClassImpaction>& classes, double mean_flux) {
    std::vector<DepositedSize> sizes;
    const ClassVelocities& answer = ash.assumptions.front();
    for (std::size_t i = 0; i < classes.size(); ++i) {
        const ClassImpaction& each = classes[i];
        const auto stick = [&](double critical) { return each.stick_fraction(critical, tube.velocity); };
        DepositedSize size{.diameter = each.size.diameter(),
                           .from = each.size.from,
                           .to = each.size.to,
                           .mass_fraction = each.size.share,
                           .density = each.density,
                           .stokes = each.particle.stokes,
                           .effective_stokes = each.particle.effective_stokes(),
                           .impaction_efficiency = each.impaction.efficiency()};
        if (answer.value[i] > 0 && std::isfinite(answer.value[i])) size.critical_velocity = answer.value[i];
        SpannedShare& stays = size.stick_fraction;
        stays.value = stick(answer.value[i]);
        stays.span = {stays.value, stays.value};
        if (each.impaction.any()) {
            size.normal_velocity = tube.velocity * each.mean_normal();
            size.rebound = rebound_means(each.rebounds(answer.value[i], tube.velocity, ash.restitutions[i]));
            for (const ClassVelocities& other : ash.assumptions) {
                if (!spans(ash, other)) continue;
                stays.span.least = std::min(stays.span.least, stick(other.lower[i]));
                stays.span.greatest = std::max(stays.span.greatest, stick(other.upper[i]));
            }
        }
        if (tube.load) {
            const double arrives = mean_flux * each.size.share * each.impaction.efficiency();
            size.arrival_flux = Quantity{arrives, std::string(mass_flux_unit)};
            size.deposition_flux = Quantity{arrives * stays.value, std::string(mass_flux_unit)};
        }
        sizes.push_back(std::move(size));
    }
    if (ash.parts == 1) return sizes;
    std::vector<DepositedSize> whole;
    for (std::size_t first = 0; first < sizes.size(); first += ash.parts)
        whole.push_back(whole_class(std::span(sizes).subspan(first, ash.parts)));
    return whole;
}

std::vector<DepositedArc> deposited_arcs(const TubeConditions& tube, const std::vector<ArcImpaction>& arcs) {
    std::vector<DepositedArc> list;
    for (const ArcImpaction& arc : arcs) {
        DepositedArc each{.from = arc.from, .to = arc.to, .arrives = arc.arrives, .stays = arc.stays};
        if (arc.arrives > 0) {
            each.normal_velocity = arc.normal * tube.velocity;
            each.incidence = arc.incidence;
            each.rebound = rebound_means(arc.rebounds);
        }
        if (tube.load) {  // on both sides, over a surface of D (to - from) per length
            const double flux = *tube.load * tube.velocity / (arc.to - arc.from);
            each.arrival_flux = Quantity{flux * arc.arrives, std::string(mass_flux_unit)};
            each.deposition_flux = Quantity{flux * arc.stays, std::string(mass_flux_unit)};
        }
        list.push_back(std::move(each));
    }
    return list;
}

/// The angle within which half of what stays lies; 0 if nothing stays [rad].
double half_angle(const std::vector<ArcImpaction>& arcs) {
    double sum = 0;
    for (const ArcImpaction& arc : arcs) sum += arc.stays;
    double below = 0;
    for (const ArcImpaction& arc : arcs) {
        if (arc.stays > 0 && below + arc.stays >= sum / 2)
            return arc.from + (sum / 2 - below) / arc.stays * (arc.to - arc.from);
        below += arc.stays;
    }
    return 0;
}

void note_limits(const TubeConditions& tube, const std::vector<ClassImpaction>& classes,
                 StageRecord& record) {
    const auto share_of = [&](auto&& holds) {
        double share = 0;
        double arrives = 0;
        for (const ClassImpaction& each : classes) {
            const double mass = each.size.share * each.impaction.efficiency();
            arrives += mass;
            if (holds(each)) share += mass;
        }
        return arrives > 0 ? share / arrives : 0;
    };
    const auto note = [&](double share, const std::string& text) {
        if (share > 1e-3)
            record.note(Finding{"deposition", share > 0.1 ? Severity::doubt : Severity::remark,
                                fmt::format("{:.3g} % of the mass that arrives {}", 100 * share, text)});
    };
    note(share_of([](const ClassImpaction& each) { return each.size.diameter() < fine_particle; }),
         "is finer than 2 um, where the gas slips along particles and turbulence and heat move them");
    note(share_of([](const ClassImpaction& each) { return each.particle.reynolds > greatest_reynolds; }),
         "may exceed the Reynolds number of 800 up to which the drag law holds");
    note(share_of(
             [&](const ClassImpaction& each) { return each.size.diameter() > interception * tube.diameter; }),
         "is of particles above 5 % of the tube, which meet it by their own size");
}

}  // namespace

bool is_outside_model(double critical_velocity) {
    return critical_velocity > fastest_in_model;
}

std::string outside_model_words(double share) {
    return fmt::format("of {:.3g} % of the mass that arrives v_c is {}; that it stays is no result",
                       100 * share, outside_model_text());
}

DepositingAsh ash_of_run(const Run& run, std::vector<SizeClass> classes,
                         const std::optional<SizeBasis>& basis, double fastest) {
    const ComparisonResult& comparison = run.comparison;
    if (!comparison.sizes || comparison.by_size.empty())
        throw InputError("the run has no critical velocities by size",
                         "a run with one, or the options of an impact")
            .at("/result/by_size");
    DepositingAsh ash{.law = comparison.sizes->law, .measured = comparison.sizes->measured};
    const std::vector<VelocityRow> measured = rows_of(comparison.by_size, SizeBasis::measured);
    for (const SizeBasis each : assumptions_to_use(comparison.by_size, basis)) {
        const std::vector<VelocityRow> rows = rows_of(comparison.by_size, each);
        ClassVelocities velocities{.basis = each};
        const SolvedSizes solved(run, each, rows);
        const auto found = in_parallel(classes, [&](const SizeClass& size) {
            const double diameter = size.diameter();
            const bool known = diameter >= ash.measured->from && diameter <= ash.measured->to;
            return known && !measured.empty() ? row_at(measured, diameter) : solved.row_of(diameter);
        });
        for (const VelocityRow& row : found) {
            velocities.value.push_back(row.value);
            velocities.lower.push_back(row.lower);
            velocities.upper.push_back(row.upper);
            velocities.outside.push_back(row.outside > 0 || is_outside_model(row.value));
        }
        ash.assumptions.push_back(std::move(velocities));
    }
    ReboundingSizes rebounding{
        .diameters = {}, .critical = ash.assumptions.front().value, .fastest = fastest};
    for (const SizeClass& size : classes) {
        rebounding.diameters.push_back(size.diameter());
        ash.densities.push_back(contact_of_size(run.contact, size.diameter()).density.value());
    }
    ash.restitutions = restitutions_of_run(run, ash.assumptions.front().basis, rebounding);
    ash.fastest_impact = fastest_impact(run);
    ash.classes = std::move(classes);
    return ash;
}

std::optional<Finding> temperature_finding(const Run& run, Law law, double gas_temperature) {
    std::optional<double> least;
    for (const SampleComparison& sample : run.comparison.samples) {
        const ContactTemperatures* of = sample.temperature ? sample.temperature->laws.find(law) : nullptr;
        if (of == nullptr || !of->giordano2008.elastic_up_to) continue;
        least = std::min(least.value_or(*of->giordano2008.elastic_up_to), *of->giordano2008.elastic_up_to);
    }
    const auto& stated = run.data.temperature.particle;
    constexpr double same = 1;  // [K]
    const bool is_colder = stated && gas_temperature < stated->value() - same;
    if (is_colder || (!least && gas_temperature > (stated ? stated->value() + same : warmest_room)))
        return Finding{
            "deposition", Severity::remark,
            fmt::format("the gas has {}, and v_c is that of contacts {}: {} surfaces are not in it",
                        readable(gas_temperature, "K"),
                        stated ? "at " + readable(stated->value(), "K") : "at room temperature",
                        is_colder ? "harder, less sticky" : "softer or sticky")};
    if (!least || gas_temperature <= *least) return std::nullopt;
    return Finding{
        "deposition", Severity::doubt,
        fmt::format("the gas has {}, and contacts of this glass stay elastic up to {}: hotter particles "
                    "stick at higher velocities than v_c",
                    readable(gas_temperature, "K"), readable(*least, "K"))};
}

DepositionResult deposition_on(const TubeConditions& tube, const DepositingAsh& ash, StageRecord& record) {
    const std::vector<ClassImpaction> classes = impactions_on(crossed_tube(tube), ash.classes, ash.densities);
    const ClassVelocities& answer = ash.assumptions.front();
    const std::vector<ArcImpaction> arcs =
        arcs_of(classes, answer.value, ash.restitutions, tube.velocity, arcs_of_quarter);
    // What flies at a length of tube, load U D, over its circumference, pi D.
    const double mean_flux = tube.load.value_or(0) * tube.velocity / std::numbers::pi;
    const auto flux = [&](double share) -> std::optional<Quantity> {
        if (!tube.load) return std::nullopt;
        return Quantity{mean_flux * share, std::string(mass_flux_unit)};
    };

    DepositionResult result{.tube = tube,
                            .law = ash.law,
                            .basis = answer.basis,
                            .measured = ash.measured,
                            .sizes = deposited_sizes(tube, ash, classes, mean_flux),
                            .angles = deposited_arcs(tube, arcs)};
    DepositionTotal& total = result.total;
    DepositionSpan span{std::numeric_limits<double>::infinity(), 0};
    for (const ClassVelocities& each : ash.assumptions) {
        const Staying staying = staying_under(each, classes, tube.velocity);
        result.assumptions.push_back({each.basis, staying.share(), flux(staying.stays)});
        if (each.basis == answer.basis) {
            total.impaction_efficiency = staying.arrives;
            total.stick_fraction = staying.share();
            total.deposition_flux = flux(staying.stays);
            if (tube.load)
                total.deposition_rate = Quantity{*tube.load * tube.velocity * tube.diameter * staying.stays,
                                                 std::string(mass_rate_unit)};
        }
        if (!spans(ash, each)) continue;
        span.least = std::min(span.least, staying.share().span.least);
        span.greatest = std::max(span.greatest, staying.share().span.greatest);
    }
    total.stick_fraction.span = span;
    total.least_flux = flux(total.impaction_efficiency * span.least);
    total.greatest_flux = flux(total.impaction_efficiency * span.greatest);
    total.half_angle = half_angle(arcs);
    double outside = 0;
    for (std::size_t i = 0; i < classes.size(); ++i)
        if (answer.outside[i]) outside += classes[i].size.share * classes[i].impaction.efficiency();
    if (outside > 0) {
        total.outside_model = outside / total.impaction_efficiency;
        record.note({outside_model_code, Severity::doubt, outside_model_words(*total.outside_model)});
    }
    Rebounds rebounds;
    for (const ArcImpaction& arc : arcs) rebounds.add(arc.rebounds, 1);
    total.rebound = rebound_means(rebounds);
    for (const DepositedSize& size : result.sizes)
        if (ash.measured && size.diameter >= ash.measured->from && size.diameter <= ash.measured->to &&
            total.impaction_efficiency > 0)
            total.supported_fraction +=
                size.mass_fraction * size.impaction_efficiency / total.impaction_efficiency;
    if (ash.measured && total.impaction_efficiency > 0 && total.supported_fraction < enough_supported)
        record.note(
            {"deposition", Severity::doubt,
             fmt::format("{:.3g} % of the mass that arrives is of sizes that were not measured: for it v_c "
                         "rests on the assumption {}",
                         100 * (1 - total.supported_fraction), name_of(answer.basis))});
    if (ash.fastest_impact && tube.velocity > *ash.fastest_impact)
        record.note(
            {"deposition", Severity::remark,
             fmt::format("particles meet the tube with up to {}, and the fastest impact of the run has "
                         "{}: that faster ones rebound with its restitution is an assumption",
                         readable(tube.velocity, "m/s"), readable(*ash.fastest_impact, "m/s"))});
    note_limits(tube, classes, record);
    record.citations = {"Serafini 1954, NACA Report 1159 (drag beyond Stokes)",
                        "Israel & Rosner 1982, doi 10.1080/02786828308958612 (effective Stokes number)",
                        "U.S. Standard Atmosphere 1976 (viscosity of air)"};
    return result;
}

}  // namespace ashimpact
