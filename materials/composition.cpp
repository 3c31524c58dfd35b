// SPDX-License-Identifier: GPL-3.0-or-later
#include "materials/composition.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numeric>

#include "core/plausibility.hpp"
#include "core/quantities/checks.hpp"
#include "core/tables/vocabulary.hpp"
#include "core/text/text.hpp"

namespace ashimpact {

namespace {

constexpr std::size_t most_phases = 1000;
constexpr std::string_view phases_code = "phases";  // of every finding here

double sum(std::span<const double> values) {
    return std::accumulate(values.begin(), values.end(), 0.0);
}

std::string to_tenths(double value) {
    return shortest(std::round(value * 10) / 10);
}

/// v_i x_i / sum v_j x_j
std::vector<double> normalised_products(std::span<const double> fractions, std::span<const double> factors) {
    assert(fractions.size() == factors.size());
    std::vector<double> products(fractions.size());
    for (std::size_t i = 0; i < products.size(); ++i) products[i] = fractions[i] * factors[i];
    const double total = sum(products);
    for (double& product : products) product /= total;
    return products;
}

void check_fraction(const PhaseFraction& phase) {
    if (!(phase.fraction >= 0) || !std::isfinite(phase.fraction))
        throw InputError("the fraction of " + in_quotes(phase.name) + " is " + shortest(phase.fraction),
                         "0 to 1 (0 % to 100 %)");
    if (phase.standard_uncertainty)
        require_not_negative("uncertainty of the fraction of " + phase.name, *phase.standard_uncertainty,
                             Dimension::fraction);
    if (phase.density) require_positive("density of " + phase.name, *phase.density, Dimension::density);
}

void check_fractions(const Analysis& analysis) {
    if (analysis.phases.empty()) throw InputError("no phases", "at least one phase with its fraction");
    if (analysis.phases.size() > most_phases)
        throw InputError("the sample has " + std::to_string(analysis.phases.size()) + " phases",
                         std::to_string(most_phases) + " or fewer")
            .at(analysis.phases[most_phases].place);
    for (const PhaseFraction& phase : analysis.phases) at_place(phase.place, [&] { check_fraction(phase); });
    for (const PhaseFraction& phase : analysis.phases)
        if (phase.is_standard)
            throw InputError(
                in_quotes(phase.name) +
                    " is called an internal standard: the fractions are those of the mixture with "
                    "it, or those of the sample beside it",
                "the weight fraction that was added, --internal-standard " + phase.name +
                    " --added-fraction \"10 %\" (in a case \"internal_standard\"); or a file without " +
                    phase.name)
                .at(phase.place);
}

/// Refuses an amorphous phase among fractions of the crystalline part. @throws InputError
void require_crystalline(const Analysis& analysis, const std::vector<Component>& components) {
    if (analysis.of_crystalline_part.empty()) return;
    for (std::size_t i = 0; i < components.size(); ++i)
        if (components[i].phase.amorphous)
            throw InputError(
                analysis.of_crystalline_part + " states fractions of the crystalline part, and " +
                    in_quotes(components[i].name) + " is none: it may be a fraction of the whole",
                "a file without \"crystalline\" there for fractions of the whole, or without " +
                    in_quotes(components[i].name))
                .at(analysis.phases[i].place);
}

/// Refuses crystalline phases behind a total without them. @throws InputError
void require_within_total(const Analysis& analysis, const std::vector<Component>& components) {
    for (std::size_t i = 0; i < components.size(); ++i)
        if (analysis.phases[i].behind_total && !components[i].phase.amorphous)
            throw InputError(in_quotes(components[i].name) + ", " + per_cent(analysis.phases[i].fraction) +
                                 ", stands behind a total of the phases before it: it may be in this total, "
                                 "or beside it",
                             "all crystalline phases before the total, or a file without it")
                .at(analysis.phases[i].place);
}

/// Refuses a row without amounts that names no phase, "XRF:", above others. @throws InputError
void refuse_headed_rows(const Analysis& analysis, const PhaseCatalogue& catalogue) {
    for (const PlacedName& row : analysis.blank_rows)
        if (row.name.ends_with(':') || !catalogue.knows(row.name))
            throw InputError(in_quotes(row.name) +
                                 " has no cells: it may head the rows below it, or be a phase without amount",
                             "a file without what such a row heads; \"n.d.\" in the cells of a phase")
                .at(row.place);
}

Component component(const PhaseFraction& line, ResolvedPhase resolved, std::vector<Finding>& notes) {
    Component result{.name = line.name, .phase = std::move(resolved.phase)};
    if (!resolved.note.empty()) notes.push_back({phases_code, Severity::remark, resolved.note});
    if (!line.density) return result;
    const double catalogue = result.phase.density.value;
    constexpr double rounding = 1e-9;
    constexpr double far = 0.2;  // more than porosity or a solid solution makes of a phase
    const double gap = std::abs(*line.density - catalogue);
    if (gap < rounding * catalogue) return result;
    notes.push_back({phases_code, gap > far * catalogue ? Severity::doubt : Severity::background,
                     "the file's density of " + in_quotes(line.name) + ", " + to_tenths(*line.density) +
                         " kg/m3, is used; the catalogue has " + to_tenths(catalogue) + " kg/m3 (" +
                         per_cent(*line.density / catalogue - 1) + ")"});
    result.phase.density = {.value = *line.density};
    if (auto doubt = implausible_at("density of " + in_quotes(line.name), *plausible_range("density"),
                                    {*line.density}))
        notes.push_back(*std::move(doubt));
    return result;
}

void refuse_repeated(const std::vector<Component>& components, const Analysis& analysis) {
    const auto place_of = [&](std::size_t i) {
        return i < analysis.phases.size() ? analysis.phases[i].place : std::string();
    };
    for (std::size_t i = 0; i < components.size(); ++i)
        for (std::size_t j = 0; j < i; ++j)
            if (components[i].phase.name == components[j].phase.name)
                throw InputError(in_quotes(components[j].name) + " and " + in_quotes(components[i].name) +
                                     " are the same phase, " + components[i].phase.name,
                                 "each phase once; add their fractions")
                    .at(place_of(i));
}

std::vector<ResolvedPhase> resolved_phases(const Analysis& analysis, const PhaseCatalogue& catalogue) {
    std::vector<PlacedName> names;
    for (const PhaseFraction& line : analysis.phases) names.push_back({line.name, line.place});
    return catalogue.resolve_all(names);
}

/// The listed fraction of amorphous phases; none where none is listed.
std::optional<double> amorphous_part(const std::vector<Component>& components, const Analysis& analysis) {
    std::optional<double> part;
    for (std::size_t i = 0; i < components.size(); ++i)
        if (components[i].phase.amorphous) part = part.value_or(0) + analysis.phases[i].fraction;
    return part;
}

/// Finds from their sum whether the listed amounts are fractions of the whole or of its crystalline part.
class Closing {
  public:
    Closing(const Analysis& analysis, std::optional<double> amorphous, const std::string& how_to_state)
        : analysis_(analysis),
          amorphous_(amorphous),
          how_to_state_(how_to_state),
          model_(listed(analysis)),
          total_(sum(model_.amounts)) {
        if (total_ > 1 + analysis.closure_tolerance)
            throw InputError("the fractions add up to " + per_cent(total_), "100 % or less");
        if (!(total_ > 0)) throw InputError("all fractions are zero", "at least one above zero");
    }

    FractionModel model() {
        std::visit([this](const auto& stated) { close(stated); }, analysis_.amorphous);
        return model_;
    }

  private:
    static FractionModel listed(const Analysis& analysis) {
        FractionModel model;
        for (const PhaseFraction& phase : analysis.phases) {
            model.amounts.push_back(phase.fraction);
            model.uncertainties.push_back(phase.standard_uncertainty);
        }
        return model;
    }

    [[nodiscard]] bool adds_up_to(double value) const {
        return std::abs(total_ - value) <= analysis_.closure_tolerance;
    }

    void require_sum(double value, const std::string& reason) const {
        if (!adds_up_to(value))
            throw InputError(
                "the fractions add up to " + per_cent(total_),
                per_cent(value) + " within " + per_cent(analysis_.closure_tolerance) + ", " + reason);
    }

    void refuse_second_statement() const {
        if (amorphous_)
            throw InputError("the amorphous part is listed among the phases and stated again",
                             "one of the two");
    }

    void close(const AmorphousNotStated&) const {
        if (!amorphous_)
            throw InputError("the amorphous fraction of the sample is not stated" + readings(),
                             how_to_state_);
        require_sum(1, "as the amorphous part is listed");
    }

    void close(const AmorphousNone&) const {
        refuse_second_statement();
        require_sum(1, "as there is no amorphous part");
    }

    void close(const AmorphousFraction& stated) {
        if (stated.basis != analysis_.basis)
            throw InputError(
                "the amorphous fraction and the phase fractions are not both by weight or by volume",
                "the same basis for both");
        require_fraction("amorphous fraction", stated.value);
        split(stated.value, "as the amorphous part is " + per_cent(stated.value));
        model_.parameter_uncertainty = stated.standard_uncertainty;
    }

    void close(const CrystallineTotal& stated) {
        require_fraction("crystalline total", stated.value);
        if (amorphous_ && adds_up_to(1)) {
            if (std::abs(1 - *amorphous_ - stated.value) > analysis_.closure_tolerance)
                throw InputError("the crystalline total is stated as " + per_cent(stated.value) +
                                     ", and the amorphous part is listed as " + per_cent(*amorphous_),
                                 "100 % together");
            return;
        }
        split(1 - stated.value, "as the crystalline total is " + per_cent(stated.value));
        model_.parameter_uncertainty = stated.standard_uncertainty;
    }

    void close(const AmorphousRemainder& stated) {
        refuse_second_statement();
        require_positive("scale of the fractions", stated.scale, Dimension::fraction);
        const double crystalline = stated.scale * total_;
        if (crystalline > 1 + analysis_.closure_tolerance)
            throw InputError("the phases make up " + per_cent(crystalline) + " of the sample",
                             "100 % or less");
        if (crystalline > 1) return;  // nothing remains, within the tolerance
        model_.kind = FractionModel::Kind::remainder;
        model_.parameter = stated.scale;
        model_.parameter_uncertainty = stated.standard_uncertainty;
    }

    /// The readings of a text on the crystalline part, "100 % crystalline"; empty without one.
    [[nodiscard]] std::string readings() const {
        const std::string& text = analysis_.of_crystalline_part;
        return text.empty() ? text
                            : ": by " + text +
                                  " the fractions are those of the crystalline part, or there is "
                                  "no amorphous one";
    }

    /// The listed fractions are either of the crystalline part (sum 1) or of the whole (sum 1 - amorphous).
    void split(double amorphous, const std::string& reason) {
        refuse_second_statement();
        if (!adds_up_to(1)) require_sum(1 - amorphous, reason + " (or 100 % of the crystalline part)");
        if (amorphous == 1)
            throw InputError("the sample is wholly amorphous", "an amorphous part below 100 %");
        model_.kind = FractionModel::Kind::split;
        model_.parameter = amorphous;
    }

    const Analysis& analysis_;
    std::optional<double> amorphous_;  ///< as listed among the phases
    const std::string& how_to_state_;
    FractionModel model_;
    double total_;
};

void note_rescaling(const FractionModel& model, std::vector<Finding>& notes) {
    const double total = sum(model.amounts);
    const bool of_the_whole = model.kind == FractionModel::Kind::split &&
                              std::abs(total - (1 - model.parameter)) < std::abs(total - 1);
    const double expected = of_the_whole ? 1 - model.parameter : 1;
    if (model.kind == FractionModel::Kind::remainder || std::abs(total - expected) < 1e-9) return;
    notes.push_back(
        {phases_code, Severity::remark,
         "the fractions add up to " + per_cent(total) + " and were scaled to " + per_cent(expected)});
}

/// A refinement without an amorphous phase adds up to one; the remainder to 100 % is then no measurement.
void note_small_remainder(const Analysis& analysis, const FractionModel& model, std::vector<Finding>& notes) {
    const auto* const stated = std::get_if<AmorphousRemainder>(&analysis.amorphous);
    if (!stated) return;
    const double rest = 1 - stated->scale * sum(model.amounts);
    if (rest > analysis.closure_tolerance) return;
    notes.push_back({phases_code, Severity::remark,
                     "the phases leave " + per_cent(rest) +
                         " for the amorphous part: are the fractions of the whole sample?"});
}

/// Notes statements on the amorphous part that count for nothing, since it is listed among the phases.
void note_listed_amorphous(const Analysis& analysis, const FractionModel& model,
                           std::vector<Finding>& notes) {
    if (model.kind != FractionModel::Kind::closed) return;
    const auto* const total = std::get_if<CrystallineTotal>(&analysis.amorphous);
    if (total && total->standard_uncertainty)
        notes.push_back({phases_code, Severity::doubt,
                         "the uncertainty of the crystalline total is not used, as the amorphous part is "
                         "listed"});
    if (analysis.amorphous_phase != Analysis{}.amorphous_phase)
        notes.push_back({phases_code, Severity::doubt,
                         "the amorphous phase " + in_quotes(analysis.amorphous_phase) +
                             " is not used, as none is left to it by the phases listed"});
}

/// Notes phases that laboratories weigh in as internal standards and nothing calls so: no reader knows all
/// ways to name one.
void note_likely_standards(Composition& composition) {
    static const WordLists standards("internal standards");
    constexpr double least_added = 0.03;
    for (const Component& c : composition.components)
        if (c.weight_fraction >= least_added && (standards.holds(c.name) || standards.holds(c.phase.name)))
            composition.notes.push_back(
                {phases_code, Severity::remark,
                 in_quotes(c.name) +
                     " counts as a phase of the ash: no text that is read calls it an internal standard"});
}

/// Notes the remark of the catalogue on the glass, whose modulus is the least certain input.
void note_glass(Composition& composition) {
    for (const Component& c : composition.components)
        if (c.phase.amorphous && !c.phase.remark.empty())
            composition.notes.push_back(
                {phases_code, Severity::background,
                 in_quotes(c.name) + " is taken as " + c.phase.name + ": " + c.phase.remark});
}

void fill_fractions(Composition& composition) {
    const std::vector<double> fractions = composition.model.fractions();
    std::vector<double> densities;
    for (const Component& c : composition.components) densities.push_back(c.phase.density.value);
    const bool by_weight = composition.basis == FractionBasis::weight;
    const auto weights = by_weight ? fractions : weight_fractions(fractions, densities);
    const auto volumes = by_weight ? volume_fractions(fractions, densities) : fractions;
    for (std::size_t i = 0; i < composition.components.size(); ++i) {
        composition.components[i].weight_fraction = weights[i];
        composition.components[i].volume_fraction = volumes[i];
    }
    composition.density = mixture_density(volumes, densities);
}

}  // namespace

void Analysis::state_amorphous(Amorphous stated) {
    if (!std::holds_alternative<AmorphousNotStated>(amorphous))
        throw InputError("the file states the amorphous part, and it is stated again", "one of the two");
    amorphous = std::move(stated);
}

std::string per_cent(double fraction) {
    return shortest(std::round(fraction * 1e6) / 1e4) + " %";
}

std::vector<double> FractionModel::fractions() const {
    std::vector<double> result = amounts;
    const double total = sum(amounts);
    const double crystalline = kind == Kind::remainder ? parameter * total
                               : kind == Kind::split   ? 1 - parameter
                                                       : 1;
    for (double& fraction : result) fraction *= crystalline / total;
    if (kind != Kind::closed) result.push_back(1 - crystalline);
    return result;
}

Composition compose(const Analysis& given, const PhaseCatalogue& catalogue, const std::string& how_to_state) {
    check_fractions(given);
    refuse_headed_rows(given, catalogue);
    auto resolved = resolved_phases(given, catalogue);

    Composition composition{.components = {}, .basis = given.basis};
    for (std::size_t i = 0; i < resolved.size(); ++i) {
        composition.components.push_back(
            component(given.phases[i], std::move(resolved[i]), composition.notes));
        composition.components.back().place = i;
    }
    std::stable_sort(composition.components.begin(), composition.components.end(),
                     [](const Component& a, const Component& b) { return a.phase.name > b.phase.name; });
    Analysis analysis = given;
    for (std::size_t i = 0; i < resolved.size(); ++i)
        analysis.phases[i] = given.phases[composition.components[i].place];
    require_crystalline(analysis, composition.components);
    require_within_total(analysis, composition.components);
    composition.model =
        Closing(analysis, amorphous_part(composition.components, analysis), how_to_state).model();
    if (composition.model.kind != FractionModel::Kind::closed) {
        const PhaseFraction rest{.name = analysis.amorphous_phase};
        composition.components.push_back(
            component(rest, catalogue.resolve(analysis.amorphous_phase), composition.notes));
        composition.components.back().place = resolved.size();
    }
    refuse_repeated(composition.components, analysis);
    note_glass(composition);
    note_rescaling(composition.model, composition.notes);
    note_small_remainder(analysis, composition.model, composition.notes);
    note_listed_amorphous(analysis, composition.model, composition.notes);
    fill_fractions(composition);
    note_likely_standards(composition);
    return composition;
}

std::vector<Component> Composition::listed() const {
    std::vector<Component> list = components;
    std::ranges::sort(list, {}, &Component::place);
    return list;
}

std::vector<double> volume_fractions(std::span<const double> weight_fractions,
                                     std::span<const double> densities) {
    std::vector<double> specific_volumes;
    for (const double density : densities) specific_volumes.push_back(1 / density);
    return normalised_products(weight_fractions, specific_volumes);
}

std::vector<double> weight_fractions(std::span<const double> volume_fractions,
                                     std::span<const double> densities) {
    return normalised_products(volume_fractions, densities);
}

double mixture_density(std::span<const double> volume_fractions, std::span<const double> densities) {
    assert(volume_fractions.size() == densities.size());
    return std::inner_product(volume_fractions.begin(), volume_fractions.end(), densities.begin(), 0.0);
}

}  // namespace ashimpact
