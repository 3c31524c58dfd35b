// SPDX-License-Identifier: GPL-3.0-or-later
#include "materials/glass/balance.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>
#include <utility>

#include "core/quantities/checks.hpp"
#include "core/text/error.hpp"
#include "core/text/text.hpp"
#include "materials/modulus.hpp"

namespace ashimpact {

namespace {

/// Sums of an analysis that are taken for rounding and oxides that were not determined.
constexpr double least_sum = 0.90;
constexpr double greatest_sum = 1.05;
/// A gap to 100 % that is worth a remark.
constexpr double remarkable_gap = 0.02;
/// Sums with and without the loss on ignition whose gaps to 100 % differ by less do not tell which is meant.
constexpr double undecided_gap = 0.01;

const double root_three = std::sqrt(3.0);

/// Sum of the oxides [1]; CO2 and water are part of a loss on ignition.
double sum_of(const OxideAnalysis& analysis) {
    double sum = 0;
    for (const OxideShare& each : analysis.oxides)
        if (!analysis.loss_on_ignition || !is_gas(each.oxide)) sum += each.fraction;
    return sum;
}

double listed_loss(const OxideAnalysis& analysis) {
    return analysis.loss_on_ignition ? analysis.loss_on_ignition->fraction : 0;
}

void require_share(const OxideShare& share) {
    if (!(share.fraction >= 0 && share.fraction <= 1))
        throw InputError("the amount of " + share.oxide + " is " + per_cent(share.fraction), "0 % to 100 %");
    if (share.standard_uncertainty)
        require_not_negative("uncertainty of " + share.oxide, *share.standard_uncertainty,
                             Dimension::fraction);
}

void require_valid_oxides(const OxideAnalysis& analysis) {
    if (analysis.oxides.empty()) throw InputError("there are no oxides", "at least SiO2 with its amount");
    std::set<std::string> names;
    for (const OxideShare& each : analysis.oxides) {
        static_cast<void>(oxide_index(each.oxide));
        require_share(each);
        if (!names.insert(each.oxide).second)
            throw InputError(each.oxide + " is listed twice", "each oxide once");
    }
    if (analysis.loss_on_ignition) require_share(*analysis.loss_on_ignition);
}

double oxide_uncertainty(const OxideShare& share) {
    return share.standard_uncertainty.value_or(
        std::max(assumed_oxide_uncertainty * share.fraction, least_oxide_uncertainty));
}

bool is_glass(const Component& component) {
    return component.phase.amorphous && component.phase.formula.empty();
}

/// Whether laboratories may leave an oxide out of a table of oxides: gases of carbonates, hydroxides and
/// sulfates, and halogens.
bool may_be_left_out(std::size_t oxide) {
    const std::string_view formula = oxides()[oxide].formula;
    return is_gas(formula) || formula == "SO3" || formula == "Cl" || formula == "F";
}

/// The balance as a function of independent inputs.
class Balance {
  public:
    Balance(const OxideAnalysis& analysis, const Composition& composition)
        : analysis_(analysis), composition_(composition) {
        find_glass();
        for (const Component& each : composition.components) add_phase(each);
        add_inputs();
    }

    [[nodiscard]] const std::vector<UncertainInput>& inputs() const { return inputs_; }
    [[nodiscard]] bool phase_uncertainties_assumed() const { return phases_assumed_; }

    /// Weight fractions of the components in the whole.
    [[nodiscard]] std::vector<double> component_weights(const std::vector<double>& values) const {
        FractionModel model = composition_.model;
        auto next = values.begin() + static_cast<std::ptrdiff_t>(analysis_.oxides.size()) + 1;
        for (double& amount : model.amounts) amount = *next++;
        model.parameter = *next;
        const std::vector<double> fractions = model.fractions();
        if (composition_.basis == FractionBasis::weight) return fractions;
        std::vector<double> densities;
        for (const Component& each : composition_.components) densities.push_back(each.phase.density.value);
        return weight_fractions(fractions, densities);
    }

    /// Oxides of the crystalline phases in the whole.
    [[nodiscard]] OxideAmounts of_phases(const std::vector<double>& weights) const {
        OxideAmounts amounts = no_oxides();
        for (std::size_t i = 0; i < weights.size(); ++i)
            for (std::size_t k = 0; k < amounts.size(); ++k) amounts[k] += weights[i] * phases_[i][k];
        return amounts;
    }

    /// What is left of each listed oxide [1, of the whole]; CO2 and water are not part of a glass.
    [[nodiscard]] OxideAmounts remainders(const std::vector<double>& values) const {
        const OxideAmounts crystalline = of_phases(component_weights(values));
        const double gap = values[analysis_.oxides.size()];
        OxideAmounts rest = no_oxides();
        for (std::size_t i = 0; i < analysis_.oxides.size(); ++i) {
            const std::size_t oxide = oxide_index(analysis_.oxides[i].oxide);
            if (!is_gas(analysis_.oxides[i].oxide)) rest[oxide] = values[i] * gap - crystalline[oxide];
        }
        return rest;
    }

    [[nodiscard]] double amorphous(const std::vector<double>& values) const {
        return component_weights(values)[glass_];
    }

  private:
    void find_glass() {
        std::size_t count = 0;
        for (std::size_t i = 0; i < composition_.components.size(); ++i) {
            if (!is_glass(composition_.components[i])) continue;
            glass_ = i;
            ++count;
        }
        if (count != 1)
            throw InputError(count == 0 ? "the sample has no glass, whose chemistry the oxides would give"
                                        : "the sample has two glasses, of which the oxides give the sum",
                             "an XRD result with one amorphous part");
    }

    void add_phase(const Component& component) {
        const std::size_t i = phases_.size();
        if (i == glass_) {
            phases_.push_back(no_oxides());
            return;
        }
        if (component.phase.formula.empty())
            throw InputError("the formula of the phase " + in_quotes(component.phase.name) +
                                 " is not known, so that its oxides cannot be subtracted",
                             "\"formula\" of that phase, under \"phases\" of a case or in --phases");
        phases_.push_back(
            at_place("phase " + component.phase.name, [&] { return oxides_of(component.phase.formula); }));
        if (component.weight_fraction > 0) require_listed(component, phases_.back());
    }

    /// Refuses a phase with an oxide that the analysis does not list.
    void require_listed(const Component& component, const OxideAmounts& amounts) const {
        for (std::size_t k = 0; k < amounts.size(); ++k) {
            if (amounts[k] == 0 || may_be_left_out(k)) continue;
            const std::string formula(oxides()[k].formula);
            if (std::ranges::find(analysis_.oxides, formula, &OxideShare::oxide) != analysis_.oxides.end())
                continue;
            throw InputError("the oxides do not list " + formula + ", which " + component.name + " contains",
                             formula + " among the oxides, 0 if none was found");
        }
    }

    void add_inputs() {
        for (const OxideShare& each : analysis_.oxides)
            inputs_.push_back({each.oxide, each.fraction, oxide_uncertainty(each)});
        const double gap = 1 - (sum_of(analysis_) + listed_loss(analysis_));
        inputs_.push_back({"sum of the oxides", 1, std::abs(gap) / root_three});
        const FractionModel& model = composition_.model;
        const bool stated = model.parameter_uncertainty ||
                            std::ranges::any_of(model.uncertainties, [](const auto& u) { return !!u; });
        phases_assumed_ = !stated;
        for (std::size_t i = 0; i < model.amounts.size(); ++i) {
            const double assumed =
                std::max(assumed_phase_uncertainty * model.amounts[i], least_phase_uncertainty);
            inputs_.push_back({composition_.components[i].name, model.amounts[i],
                               model.uncertainties[i].value_or(stated ? 0 : assumed)});
        }
        inputs_.push_back({"amorphous part", model.parameter, model.parameter_uncertainty.value_or(0)});
    }

    const OxideAnalysis& analysis_;
    const Composition& composition_;
    std::size_t glass_ = 0;
    std::vector<OxideAmounts> phases_{};  ///< of each component, per its weight
    std::vector<UncertainInput> inputs_{};
    bool phases_assumed_ = false;
};

OxideAmounts not_negative(OxideAmounts amounts) {
    for (double& amount : amounts) amount = std::max(amount, 0.0);
    return amounts;
}

double total_amount(const OxideAmounts& amounts) {
    return std::accumulate(amounts.begin(), amounts.end(), 0.0);
}

/// Results of the balance in one list: the remainders, their shares in the glass, then single numbers.
struct Listed {
    static std::vector<double> of(const Balance& balance, const std::vector<double>& values, double density) {
        const OxideAmounts rest = balance.remainders(values);
        const OxideAmounts glass = not_negative(rest);
        const double total = total_amount(glass);
        std::vector<double> list = rest;
        for (const double amount : rest) list.push_back(total > 0 ? amount / total : 0);
        list.push_back(total);
        list.push_back(balance.amorphous(values));
        list.push_back(total > 0 ? makishima_mackenzie(glass, density).young_modulus : 0);
        return list;
    }
    static std::size_t share(std::size_t oxide) { return no_oxides().size() + oxide; }
    static std::size_t total() { return 2 * no_oxides().size(); }
    static std::size_t amorphous() { return total() + 1; }
    static std::size_t modulus() { return total() + 2; }
};

/// "4.2(1) %" for messages, as "4.2 +- 0.1 %".
std::string with_error(double fraction, double uncertainty) {
    return readable_number(100 * fraction, 3) + " +- " + readable_number(100 * uncertainty, 2) + " %";
}

void refuse_negative(const OxideAmounts& rest, const std::vector<PropagatedUncertainty>& uncertainties,
                     const OxideAmounts& crystalline, std::vector<Finding>& notes) {
    std::vector<std::string> below;
    for (std::size_t i = 0; i < rest.size(); ++i) {
        if (rest[i] >= 0) continue;
        const double u = uncertainties[i].standard_uncertainty;
        const std::string formula(oxides()[i].formula);
        if (rest[i] < -negative_remainder_limit * u)
            throw InputError("the phases contain " + per_cent(crystalline[i]) + " " + formula +
                                 ", more than the whole sample by " + with_error(-rest[i], u),
                             "oxides and XRD result of the same sample, with phases of the right formulas");
        below.push_back(formula);
    }
    if (!below.empty())
        notes.push_back({glass_code, Severity::remark,
                         "the phases take all " + joined(below) +
                             " and, within its uncertainty, somewhat more: the glass gets none"});
}

/// Notes what ignition drives off beyond the gases of the phases: XRD counts it among the amorphous part.
void note_loss(const OxideAnalysis& analysis, double volatiles, std::vector<Finding>& notes) {
    constexpr double remarkable_loss = 0.02;
    const double loss = listed_loss(analysis) - volatiles;
    if (loss > remarkable_loss)
        notes.push_back({glass_code, Severity::remark,
                         "a loss on ignition of " + per_cent(loss) +
                             ", unburnt carbon and water, is counted among the glass by XRD"});
}

void note_oxides_without_coefficients(const std::vector<OxideShare>& oxides, std::vector<Finding>& notes) {
    const OxideAmounts amounts = amounts_of(oxides);
    const double share = share_without_coefficients(amounts);
    if (share == 0) return;
    std::vector<std::string> names;
    for (const OxideShare& each : oxides)
        if (share_without_coefficients(amounts_of({each})) > 0) names.push_back(each.oxide);
    notes.push_back(
        {glass_code, share > 0.05 ? Severity::doubt : Severity::background,
         joined(names) + ", " + per_cent(share) + " of the glass, " + (names.size() == 1 ? "has" : "have") +
             " no coefficients in Makishima & Mackenzie: the modulus is that of the other oxides"});
}

void note_assumptions(const OxideAnalysis& analysis, const Balance& balance, std::vector<Finding>& notes) {
    std::vector<std::string> assumed;
    for (const OxideShare& each : analysis.oxides)
        if (!each.standard_uncertainty && each.fraction > 0) assumed.push_back(each.oxide);
    if (!assumed.empty())
        notes.push_back({glass_code, Severity::background,
                         "no uncertainty of " + joined(assumed) +
                             " is stated: 2 % of the amount is assumed, at "
                             "least 0.1 % of the sample"});
    if (balance.phase_uncertainties_assumed())
        notes.push_back({glass_code, Severity::background,
                         "no uncertainty of the phases is stated: for the glass 5 % of each is assumed, at "
                         "least 0.5 % of the sample"});
}

/// The glass of a composition: its amorphous component without a formula.
const Component& glass_of(const Composition& composition) {
    return *std::ranges::find_if(composition.components, is_glass);
}

/// The glass in the XRD file; null if the file does not list it.
PhaseFraction* glass_in(Analysis& analysis, const Composition& composition) {
    const auto glass = std::ranges::find_if(composition.components, is_glass);
    const bool listed = glass != composition.components.end() && glass->place < analysis.phases.size();
    return listed ? &analysis.phases[glass->place] : nullptr;
}

/// Takes the density of the glass out of an analysis, as that of its chemistry counts for modulus and volume.
/// @param stated of the glass [kg/m3] @throws InputError if both are given and differ
std::optional<double> take_density(PhaseFraction& glass, const std::optional<Quantity>& stated) {
    const auto of_file = std::exchange(glass.density, std::nullopt);
    constexpr double rounding = 1e-9;
    if (of_file && stated && std::abs(*of_file / stated->value - 1) > rounding)
        throw InputError("the density of the glass is stated as " + shortest(stated->value) +
                             " kg/m3, and the XRD result has " + shortest(*of_file) + " kg/m3",
                         "one of the two")
            .at(glass.place);
    return of_file;
}

/// The phase of this glass, under every name of that of the catalogue.
Phase chemical_phase(const ChemicalGlass& glass, const Composition& composition) {
    const Component& catalogue = glass_of(composition);
    Phase phase{.name = "glass-from-chemistry", .amorphous = true};
    phase.density = {.value = glass.density.value,
                     .standard_uncertainty = glass.density.standard_uncertainty,
                     .assumed = glass.density_assumed};
    phase.young_modulus = {.value = glass.young_modulus.value,
                           .standard_uncertainty = glass.young_modulus.standard_uncertainty,
                           .citations = {"makishima1973"}};
    phase.poisson_ratio = PhaseProperty{.value = glass.poisson_ratio, .citations = {"makishima1975"}};
    phase.follows_density = true;
    phase.synonyms = {catalogue.name, catalogue.phase.name};
    phase.synonyms.insert(phase.synonyms.end(), catalogue.phase.synonyms.begin(),
                          catalogue.phase.synonyms.end());
    return phase;
}

Quantity fraction(double value, double uncertainty) {
    return make_quantity(value, Dimension::fraction, uncertainty);
}

}  // namespace

OxideAmounts amounts_of(const std::vector<OxideShare>& oxides) {
    OxideAmounts amounts = no_oxides();
    for (const OxideShare& each : oxides) amounts[oxide_index(each.oxide)] += each.fraction;
    return amounts;
}

OxideAnalysis as_received(const OxideAnalysis& analysis, std::vector<Finding>& notes) {
    require_valid_oxides(analysis);
    const double oxides = sum_of(analysis);
    const double loss = listed_loss(analysis);
    const double excess = std::abs(oxides - 1) - std::abs(oxides + loss - 1);  // above 0: LOI is among 100 %
    if (!analysis.ignited.empty() && excess > undecided_gap)
        throw InputError(analysis.ignited + " states oxides of the ignited sample, and they add up to " +
                             per_cent(oxides) + " without the LOI, to " + per_cent(oxides + loss) +
                             " with it",
                         "100 % without the LOI, or a file without this text");
    if (!analysis.ignited.empty() && loss == 0)
        notes.push_back({glass_code, Severity::remark,
                         analysis.ignited +
                             " states oxides of the ignited sample, and no LOI is given: they are "
                             "taken as those of the sample"});
    const bool ignited = loss > 0 && (!analysis.ignited.empty() || excess < 0);
    const double sum = ignited ? oxides : oxides + loss;
    const std::string what = ignited || loss == 0 ? "the oxides add up to " : "oxides and LOI add up to ";
    if (!(sum >= least_sum && sum <= greatest_sum))
        throw InputError(what + per_cent(sum), "90 % to 105 %, in % by weight of oxides (not of elements)");
    if (std::abs(sum - 1) > remarkable_gap)
        notes.push_back(
            {glass_code, Severity::remark,
             what + per_cent(sum) + ": the gap to 100 % counts as an error common to all of them"});
    const bool either = analysis.ignited.empty() && loss > remarkable_gap && std::abs(excess) < undecided_gap;
    if (either)
        notes.push_back({glass_code, Severity::doubt,
                         "the oxides add up to " + per_cent(oxides) + " without the LOI and to " +
                             per_cent(oxides + loss) +
                             " with it: whether they are those of the ignited sample is not certain, and "
                             "changes all of them by " +
                             per_cent(loss)});
    if (!ignited) return analysis;
    notes.push_back(
        {glass_code, Severity::remark,
         "the oxides add up to " + per_cent(oxides) +
             " without the LOI: they are taken as those of the ignited sample, and multiplied by " +
             per_cent(1 - loss)});
    OxideAnalysis result = analysis;
    for (OxideShare& each : result.oxides) {
        each.fraction *= 1 - loss;
        if (each.standard_uncertainty) *each.standard_uncertainty *= 1 - loss;
    }
    return result;
}

ChemicalGlass glass_from_chemistry(const OxideAnalysis& given, const Composition& composition,
                                   const std::optional<Quantity>& density) {
    ChemicalGlass glass;
    const auto received = [&] { return as_received(given, glass.notes); };
    const OxideAnalysis analysis =
        given.source.empty() ? received() : at_place(FileName{given.source}, received);
    const Balance balance(analysis, composition);
    glass.density_assumed = !density;
    glass.density =
        density ? *density
                : make_quantity(assumed_glass_density, Dimension::density, assumed_glass_density_uncertainty);
    require_positive("density of the glass", glass.density.value, Dimension::density);

    std::vector<double> values;
    for (const UncertainInput& input : balance.inputs()) values.push_back(input.value);
    const OxideAmounts rest = balance.remainders(values);
    const OxideAmounts crystalline = balance.of_phases(balance.component_weights(values));
    if (!(total_amount(not_negative(rest)) > 0))
        throw InputError("the phases leave no oxides for the glass", "oxides of the whole sample");
    const auto function = [&](const std::vector<double>& x) {
        return Listed::of(balance, x, glass.density.value);
    };
    const std::vector<double> list = function(values);
    const auto uncertainties = propagate_linearly(function, balance.inputs());
    const auto uncertainty_of = [&](std::size_t i) { return uncertainties[i].standard_uncertainty; };
    refuse_negative(rest, uncertainties, crystalline, glass.notes);

    for (std::size_t i = 0; i < rest.size(); ++i)
        if (rest[i] > 0)
            glass.oxides.push_back(
                {std::string(oxides()[i].formula), list[Listed::share(i)], uncertainty_of(Listed::share(i))});
    glass.weight_fraction = fraction(list[Listed::total()], uncertainty_of(Listed::total()));
    glass.amorphous_fraction = fraction(list[Listed::amorphous()], uncertainty_of(Listed::amorphous()));
    const double volatiles = crystalline[oxide_index("CO2")] + crystalline[oxide_index("H2O")];
    note_loss(analysis, volatiles, glass.notes);

    const ElasticBody body = makishima_mackenzie(amounts_of(glass.oxides), glass.density.value);
    const double of_composition = uncertainty_of(Listed::modulus()) / body.young_modulus;
    const double relative = std::hypot(makishima_mackenzie_uncertainty, of_composition,
                                       glass.density.standard_uncertainty.value_or(0) / glass.density.value);
    glass.young_modulus =
        make_quantity(body.young_modulus, Dimension::pressure, relative * body.young_modulus);
    glass.poisson_ratio = body.poisson_ratio;
    note_oxides_without_coefficients(glass.oxides, glass.notes);
    note_assumptions(analysis, balance, glass.notes);
    if (glass.density_assumed)
        glass.notes.push_back({glass_code, Severity::background,
                               "the density of the glass is not stated: 2.5 +- 0.1 g/cm3 is assumed, and its "
                               "modulus is proportional to it"});
    constexpr double counts = 0.01;  // of E; the uncertainty of a mixture's is then off by some per cent
    if (of_composition > counts)
        glass.notes.push_back(
            {glass_code, Severity::background,
             "the modulus of the glass follows from the fractions of the phases: its errors "
             "are counted as independent of theirs"});
    return glass;
}

GlassInSample compose_with_glass(const Analysis& analysis, const PhaseCatalogue& catalogue,
                                 const GlassInputs& inputs, const std::string& how_to_state) {
    GlassInSample sample{.composition = compose(analysis, catalogue, how_to_state)};
    const bool from_chemistry = inputs.source == GlassSource::from_chemistry;
    if (!inputs.oxides) {
        if (from_chemistry)
            throw InputError("the glass is to come from chemistry, and no oxides are given",
                             "the oxides of the sample");
        return sample;
    }
    std::optional<Quantity> density = inputs.density;
    Analysis by_chemistry = analysis;
    if (PhaseFraction* glass = glass_in(by_chemistry, sample.composition))
        if (const auto of_file = take_density(*glass, density); of_file && !density)
            density = make_quantity(*of_file, Dimension::density);
    const auto take_glass_of = [&](const Composition& composition) {
        sample.glass = glass_from_chemistry(*inputs.oxides, composition, density);
        PhaseSet set{.name = "chemistry", .phases = {chemical_phase(*sample.glass, sample.composition)}};
        sample.other = compose(by_chemistry, catalogue.overridden_by(std::move(set)), how_to_state);
    };
    take_glass_of(sample.composition);
    // Of volumes the weights, which the balance needs, follow from the density of this glass.
    if (analysis.basis == FractionBasis::volume) take_glass_of(Composition(*sample.other));
    if (from_chemistry) std::swap(sample.composition, *sample.other);
    return sample;
}

}  // namespace ashimpact
