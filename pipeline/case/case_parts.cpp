// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/case/case_parts.hpp"

#include <algorithm>
#include <cmath>
#include <regex>

#include "core/quantities/checks.hpp"
#include "core/quantities/quantity.hpp"
#include "core/text/text.hpp"
#include "materials/xrd/xrd.hpp"
#include "solver/motion/impact.hpp"

namespace ashimpact {

namespace {

constexpr double greatest_number = 1e40;  ///< of any number in SI, see is_computable()

/// A quantity that may be zero.
double not_negative(const View& node, std::string_view name, Dimension dimension) {
    const double value = node.number(dimension);
    at_place(node.pointer(), [&] { require_not_negative(name, value, dimension); });
    return value;
}

/// Refuses an uncertainty so large that the value is meaningless. @throws InputError
void require_uncertainty(const View& node, const Stated& stated, double most, const std::string& allowed) {
    if (stated.quantity.standard_uncertainty.value_or(0) > most)
        node.at("standard_uncertainty")
            .fail("is " + shortest(*stated.quantity.standard_uncertainty), allowed);
}

Law law_of(const View::Member& member) {
    return at_place(member.value.pointer(), [&] { return Law::named(member.key); });
}

/// How many of the keys an object has.
int count_of(const View& node, std::initializer_list<std::string_view> keys) {
    int count = 0;
    for (const std::string_view key : keys) count += node.has(key) ? 1 : 0;
    return count;
}

DampingPolynomial read_quadratic(const View& node) {
    const auto coefficient = [&](const char* key) {
        const double value = node.at(key).certain_number(
            Dimension::damping,
            "the coefficient alone; the uncertainty of all is coefficient_uncertainty, of "
            "published fits damping_fit_uncertainty");
        if (!(std::abs(value) <= greatest_number))
            node.at(key).fail("is " + shortest(value) + " kg/s", "up to 1e40 kg/s");
        return value;
    };
    const double a = coefficient("a");
    const double b = coefficient("b");
    return DampingPolynomial::quadratic(a, b, coefficient("c"));
}

LawMap<DampingPolynomial> read_quadratics(const View& node) {
    LawMap<DampingPolynomial> fits;
    for (const auto& member : node.members()) fits.set(law_of(member), read_quadratic(member.value));
    return fits;
}

/// The sample of an XRD file that the case names, or its only one.
XrdSample chosen_sample(const View& node, const XrdResult& result) {
    const auto name = node.find("xrd_sample");
    if (name) {
        const auto found = std::ranges::find(result.samples, name->text(), &XrdSample::name);
        if (found != result.samples.end()) return *found;
    } else if (result.samples.size() == 1) {
        return result.samples.front();
    }
    std::vector<std::string> names;
    for (const XrdSample& sample : result.samples) names.push_back(sample.name);
    if (name)
        name->fail("the XRD file has no such sample",
                   joined(names) + (names.size() == 1 ? ", or no xrd_sample" : ""));
    node.at("xrd").fail("the file holds " + std::to_string(names.size()) + " samples",
                        "xrd_sample, one of " + joined(names));
}

ReadAnalysis read_xrd_analysis(const View& node, const std::string& of_sample, InputFiles& files) {
    const View file = node.at("xrd");
    const std::string name = file.text();
    const XrdResult& result = at_place(file.pointer(), [&]() -> const XrdResult& {
        return files.xrd(name, read_table_options(node, "xrd_sheet", "xrd_decimal"));
    });
    XrdSample sample = chosen_sample(node, result);
    for (PhaseFraction& phase : sample.analysis.phases)
        if (!phase.place.empty()) phase.place.insert(0, files.shown(name) + ": ");
    ReadAnalysis read{.analysis = sample.analysis, .source = name, .warnings = result.warnings};
    read.warnings.insert(read.warnings.end(), sample.warnings.begin(), sample.warnings.end());
    if (!node.has("xrd_sample"))
        if (const auto other = other_sample_finding(xrd_code, "phases", sample.name, name, of_sample))
            read.warnings.push_back(*other);
    return read;
}

/// The sample of a file of oxides: the one that the case names, else the one of the sample's name, or its
/// only one.
OxideAnalysis read_oxide_file(const View& node, const View& file, const std::string& sample,
                              InputFiles& files, std::vector<Finding>& warnings) {
    return at_place(file.pointer(), [&] {
        const std::string name = file.text();
        const OxideResult& result =
            files.oxides(name, read_table_options(node, "oxides_sheet", "oxides_decimal"));
        const auto stated = node.find("oxides_sample");
        const OxideSample& chosen = at_place(FileName{files.shown(name)}, [&]() -> const OxideSample& {
            return oxide_sample(result, stated ? stated->text() : sample, stated.has_value());
        });
        for (const auto* list : {&result.warnings, &chosen.warnings})
            warnings.insert(warnings.end(), list->begin(), list->end());
        if (const auto other = stated ? std::nullopt : other_sample_finding(chosen, sample))
            warnings.push_back(*other);
        OxideAnalysis analysis = chosen.analysis;
        analysis.source = name;
        return analysis;
    });
}

Reconstruction read_reconstruction(const View& node, const std::optional<PublishedSample>& published) {
    Reconstruction plan{.from = node.at("from").certain_number(Dimension::fraction, "the restitution alone"),
                        .to = node.at("to").certain_number(Dimension::fraction, "the restitution alone"),
                        .points = node.at("points").integer(),
                        .reference = node.at("reference_law").text()};
    if (!(plan.from > 0 && plan.from < plan.to && plan.to < 1))
        node.fail("from is " + shortest(plan.from) + " and to is " + shortest(plan.to), "0 < from < to < 1");
    if (const auto fits = node.find("damping_fits")) {
        plan.damping_fits = read_quadratics(*fits);
        plan.source = node.has("source") ? node.at("source").text() : "fits of the case file";
        if (const auto u = node.find("coefficient_uncertainty"))
            plan.coefficient_uncertainty =
                not_negative(*u, "uncertainty of a coefficient", Dimension::damping);
    } else {
        if (!published || published->damping_fits.empty())
            node.fail("\"damping_fits\" is missing and nothing is published for this sample", "damping_fits");
        plan.damping_fits = published->damping_fits;
        plan.source = published->source;
        plan.coefficient_uncertainty = published->damping_fit_uncertainty;
    }
    if (plan.damping_fits.find(Law::named(plan.reference)) == nullptr)
        node.at("reference_law").fail("the reference law " + in_quotes(plan.reference) + " has no fit");
    return plan;
}

/// Published quantities of one kind.
class Printed {
  public:
    Printed(Dimension dimension, const std::optional<View>& rounding, const char* kind)
        : dimension_(dimension) {
        if (!rounding) return;
        if (const auto digit = rounding->find(kind)) digit_ = not_negative(*digit, "rounding", dimension);
    }
    [[nodiscard]] Quantity read(const View& node) const {
        Quantity quantity = node.quantity(dimension_);
        at_place(node.pointer(), [&] { require_possible(quantity.value); });
        if (!quantity.standard_uncertainty) quantity.standard_uncertainty = uncertainty();
        return quantity;
    }
    /// Standard uncertainty by the rounding alone.
    [[nodiscard]] std::optional<double> uncertainty() const {
        return digit_ ? std::optional(*digit_ / std::sqrt(12.0)) : std::nullopt;
    }
    [[nodiscard]] LawMap<Quantity> read_by_law(const View& parent, const char* key) const {
        LawMap<Quantity> values;
        if (const auto node = parent.find(key))
            for (const auto& member : node->members()) values.set(law_of(member), read(member.value));
        return values;
    }

  private:
    /// Refuses a value that no measurement and no model can give. Only a damping may be zero.
    void require_possible(double value) const {
        const std::string name = "published " + std::string(dimension_name(dimension_));
        if (dimension_ == Dimension::fraction) return require_fraction(name, value);
        if (dimension_ == Dimension::damping) return require_not_negative(name, value, dimension_);
        require_positive(name, value, dimension_);
    }

    Dimension dimension_;
    std::optional<double> digit_;
};

}  // namespace

Stated read_stated(const View& node, Dimension dimension) {
    Stated stated{.quantity = node.quantity(dimension)};
    if (!node.is_object()) return stated;
    if (const auto origin = node.find("origin")) stated.origin = named<Origin>(origin->text());
    if (const auto source = node.find("source")) stated.source = source->text();
    return stated;
}

Stated read_positive(const View& node, std::string_view name, Dimension dimension) {
    Stated stated = read_stated(node, dimension);
    at_place(node.pointer(), [&] { require_positive(name, stated.value(), dimension); });
    require_uncertainty(node, stated, 10 * stated.value(), "ten times the value at most");
    return stated;
}

Stated read_diameter(const View& node, std::vector<Finding>& notes) {
    static const std::regex meshes(
        "^ *([0-9.]+) *([a-zA-Z\u00b5\u03bc]*) *(?:-|\u2013|to|bis) *([0-9.]+) *([a-zA-Z\u00b5\u03bc]*) *$");
    std::smatch match;
    const std::string text = node.json().is_string() ? node.text() : "";
    const auto end = [&](std::size_t number, std::size_t unit) {
        return parse_quantity(match.str(number) + " " + match.str(unit), Dimension::length);
    };
    try {
        Stated diameter = read_positive(node, "diameter", Dimension::length);
        constexpr double least = 2e-9;  // some molecules [m]
        if (diameter.value() < least)
            node.fail("the diameter " + readable(diameter.quantity) + " is that of a molecule, no particle",
                      readable(least, "m") + " or more");
        return diameter;
    } catch (const InputError&) {
        // Matching calls itself once a character: a longer text would end on the stack.
        if (text.size() > 100 || !std::regex_match(text, match, meshes)) throw;
    }
    return at_place(node.pointer(), [&] {
        if (match.length(4) == 0)
            throw InputError("the meshes " + in_quotes(text) + " have no unit", "\"80-100 um\"");
        const double from = end(1, match.length(2) > 0 ? 2 : 4);
        const double to = end(3, 4);
        require_positive("diameter", from, Dimension::length);
        if (!(from < to)) throw InputError("the meshes " + in_quotes(text) + " do not rise", "\"80-100 um\"");
        // Of an even distribution; source: JCGM 100:2008, 4.3.7.
        const Quantity diameter =
            make_quantity((from + to) / 2, Dimension::length, (to - from) / std::sqrt(12.0));
        const double scatter = *diameter.standard_uncertainty / diameter.value;
        notes.push_back({"sieve", Severity::remark,
                         "diameter " + in_quotes(text) + " is taken as " + readable(diameter) +
                             ", which sizes evenly distributed between the meshes have; \"size_scatter\" "
                             "under \"fit\" would be " +
                             readable_number(scatter, 2)});
        return Stated{.quantity = diameter, .source = "evenly distributed between the meshes " + text};
    });
}

TableOptions read_table_options(const View& node, std::string_view sheet, std::string_view decimal) {
    TableOptions options;
    if (const auto name = node.find(sheet)) options.sheet = name->text();
    if (const auto mark = node.find(decimal)) options.decimal = named<DecimalMark>(mark->text());
    return options;
}

Stated read_poisson_ratio(const View& node) {
    Stated stated = read_stated(node, Dimension::fraction);
    at_place(node.pointer(), [&] { require_poisson_ratio("Poisson's ratio", stated.value()); });
    require_uncertainty(node, stated, 0.5, "0 to 0.5");
    return stated;
}

Wall read_wall(const View& node) {
    constexpr auto allowed = "young_modulus and poisson_ratio, or \"rigid\": true, or contact_modulus";
    const bool elastic = count_of(node, {"young_modulus", "poisson_ratio"}) > 0;
    if (count_of(node, {"rigid", "contact_modulus"}) + (elastic ? 1 : 0) != 1)
        node.fail("its elasticity is given in more than one way, or in none", allowed);
    if (elastic) {
        if (count_of(node, {"young_modulus", "poisson_ratio"}) != 2)
            node.fail(
                node.has("young_modulus") ? "\"poisson_ratio\" is missing" : "\"young_modulus\" is missing",
                allowed);
        return ElasticWall{read_positive(node.at("young_modulus"), "Young's modulus", Dimension::pressure),
                           read_poisson_ratio(node.at("poisson_ratio"))};
    }
    if (node.has("contact_modulus"))
        return read_positive(node.at("contact_modulus"), "contact modulus", Dimension::pressure);
    if (!node.at("rigid").truth()) node.at("rigid").fail("what is not rigid needs its moduli", allowed);
    return RigidWall{};
}

PartnerSphere read_partner(const View& node) {
    if (count_of(node, {"density", "mass"}) != 1)
        node.fail("the density and the mass are both given, or neither", "one of the two");
    PartnerSphere partner{.diameter = read_positive(node.at("diameter"), "diameter", Dimension::length)};
    if (const auto density = node.find("density"))
        partner.density = read_positive(*density, "density", Dimension::density);
    if (const auto mass = node.find("mass")) partner.mass = read_positive(*mass, "mass", Dimension::mass);
    return partner;
}

Adhesion read_adhesion(const View& node) {
    if (!node.is_object() || node.has("value")) {
        if (node.is_object() && count_of(node, {"surface_energies", "rule"}) > 0)
            node.fail("a value and surface energies are both given", "one of the two");
        Stated stated = read_stated(node, Dimension::energy_per_area);
        at_place(node.pointer(), [&] {
            require_not_negative("work of adhesion", stated.value(), Dimension::energy_per_area);
        });
        return stated;
    }
    if (!node.has("rule"))
        node.fail("\"rule\" is missing, by which w follows from the surface energies",
                  joined(names_of<AdhesionRule>()));
    const View energies = node.at("surface_energies");
    const auto energy = [&](const char* key) {
        return energies.at(key).certain_number(Dimension::energy_per_area,
                                               "\"work_of_adhesion\" itself with its uncertainty");
    };
    if (count_of(energies, {"wall", "partner"}) != 1)
        energies.fail("the surface energy of the other body is given twice, or not at all",
                      "\"wall\", or \"partner\" for a second sphere");
    const double other = energy(energies.has("wall") ? "wall" : "partner");
    AdhesionFromSurfaces from{.energies = {.particle = energy("particle"), .wall = other},
                              .rule = named<AdhesionRule>(node.at("rule").text())};
    if (energies.has("interfacial")) from.energies.interfacial = energy("interfacial");
    at_place(node.pointer(), [&] { static_cast<void>(work_of_adhesion(from.rule, from.energies)); });
    return from;
}

Temperatures read_temperatures(const View& node) {
    const auto read = [](const View& each) {
        static_cast<void>(each.certain_number(Dimension::temperature, "the temperature alone"));
        return read_positive(each, "temperature", Dimension::temperature);
    };
    if (!node.is_object() || node.has("value")) {
        for (const auto* key : {"particle", "wall"})
            if (const auto stray = node.is_object() ? node.find(key) : std::nullopt)
                stray->fail("a value and one for particle or wall are both given", "one of the two");
        return {read(node), read(node)};
    }
    Temperatures temperatures;
    if (const auto particle = node.find("particle")) temperatures.particle = read(*particle);
    if (const auto wall = node.find("wall")) temperatures.wall = read(*wall);
    if (!temperatures.particle && !temperatures.wall)
        node.fail("no temperature is given", "a temperature, or \"particle\" and \"wall\"");
    return temperatures;
}

Porosity read_porosity(const View& node) {
    Porosity porosity{.law = named<PorosityLaw>(node.at("law").text())};
    if (const auto value = node.find("value")) {
        const Quantity quantity = value->quantity(Dimension::fraction);
        porosity.value = quantity.value;
        porosity.standard_uncertainty = quantity.standard_uncertainty;
    }
    if (const auto coefficient = node.find("coefficient"))
        porosity.coefficient = coefficient->certain_number(Dimension::fraction, "the coefficient alone");
    at_place(node.pointer(), [&] { require_valid(porosity); });
    return porosity;
}

ReadAnalysis read_analysis(const View& node, const std::string& sample, InputFiles& files) {
    const int inline_ways = count_of(node, {"weight_fractions", "volume_fractions", "phases", "peaks"});
    if (inline_ways + count_of(node, {"xrd"}) != 1)
        node.fail("the composition is given in more than one way, or in none",
                  "weight_fractions, volume_fractions, phases, peaks or xrd");
    ReadAnalysis read;
    if (node.has("xrd")) {
        read = read_xrd_analysis(node, sample, files);
    } else {
        read.analysis = xrd::read_fractions_json(node);
        for (PhaseFraction& phase : read.analysis.phases) phase.place.erase(0, node.pointer().size());
        for (const auto* key : {"xrd_sample", "xrd_sheet", "xrd_decimal"})
            if (const auto stray = node.find(key)) stray->fail("belongs to an XRD file", "xrd beside it");
    }
    const auto doubt = xrd::mark_standards(read.analysis, sample);
    if (doubt && !node.has("internal_standard") && !node.has("xrd"))  // else the file has said it
        read.warnings.push_back(*doubt);
    read.analysis = xrd::completed_by_json(std::move(read.analysis), node);
    if (const auto source = node.find("source")) read.source = source->text();
    return read;
}

GlassInputs read_glass(const View& node, const GlassDefaults& defaults, const std::string& sample,
                       InputFiles& files, std::vector<Finding>& warnings) {
    GlassInputs inputs;
    const auto own = node.find("oxides");
    const auto oxides = own ? own : defaults.oxides;
    if (oxides && oxides->is_string()) {
        const auto options = read_table_options(node, "oxides_sheet", "oxides_decimal");
        inputs.oxides = read_oxide_file(node, *oxides, sample, files, warnings);
        if (!own && defaults.of_many && files.oxides(oxides->text(), options).samples.size() == 1)
            warnings.push_back({glass_code, Severity::remark,
                                "the one analysis of " + oxides->text() + " counts for every sample"});
    } else if (oxides) {
        inputs.oxides = read_oxides_json(*oxides);
    }
    if (!oxides || !oxides->is_string())
        for (const auto* key : {"oxides_sample", "oxides_sheet", "oxides_decimal"})
            if (const auto stray = node.find(key))
                stray->fail("belongs to a file of oxides", "oxides beside it");
    const auto choice = node.find("glass") ? node.find("glass") : defaults.glass;
    if (choice) inputs.source = named<GlassSource>(choice->text());
    if (inputs.source == GlassSource::from_chemistry && !inputs.oxides)
        choice->fail(
            "the glass is to come from chemistry, and the sample " + in_quotes(sample) + " has no oxides",
            "\"oxides\" in its composition or in the case, or \"catalogue\"");
    const auto density = node.find("glass_density");
    if (!density) return inputs;
    if (!inputs.oxides) density->fail("belongs to a glass from chemistry", "oxides beside it");
    inputs.density = read_positive(*density, "density of the glass", Dimension::density).quantity;
    return inputs;
}

RestitutionSource read_restitution(const View& node, const std::optional<PublishedSample>& published,
                                   InputFiles& files, const std::optional<View>& camera) {
    constexpr auto allowed = "velocity with restitution or rebound_velocity, or file, or reconstruct";
    const bool points = node.has("velocity") && count_of(node, {"restitution", "rebound_velocity"}) == 1;
    const int others = count_of(node, {"file", "reconstruct"});
    const bool columns = count_of(node, {"velocity", "restitution", "rebound_velocity"}) > 0;
    if (others + (columns ? 1 : 0) != 1 || (columns && !points))
        node.fail("the restitution data are incomplete or given in more than one way", allowed);
    for (const auto* key : {"sheet", "decimal"})
        if (const auto stray = node.find(key); stray && !node.has("file"))
            stray->fail("belongs to a file of impacts", "file beside it");
    if (!columns)
        for (const auto* key : {"velocity_uncertainty", "rebound_uncertainty", "restitution_uncertainty",
                                "velocity_correlation", "rebound_resolution", "noted_capture",
                                "tangential_velocity", "impacts"})
            if (const auto stray = node.find(key))
                stray->fail("belongs to velocities of the case", "velocity");
    const auto plan = node.find("reconstruct");
    if (!plan) return read_measured(node, files, camera);
    for (const auto* key : {"camera", "binning"})
        if (const auto stray = node.find(key)) stray->fail("belongs to measured impacts", "file or velocity");
    return read_reconstruction(*plan, published);
}

PublishedSample read_published(const View& node, const std::string& source,
                               const std::optional<View>& rounding) {
    const Printed modulus(Dimension::pressure, rounding, "young_modulus");
    const Printed fraction(Dimension::fraction, rounding, "volume_fraction");
    const Printed damping(Dimension::damping, rounding, "critical_damping");
    const Printed velocity(Dimension::velocity, rounding, "critical_velocity");
    const Printed time(Dimension::time, rounding, "contact_time");

    PublishedSample published{.source = node.has("source") ? node.at("source").text() : source};
    if (const auto value = node.find("young_modulus")) published.young_modulus = modulus.read(*value);
    if (const auto fractions = node.find("volume_fractions"))
        for (const auto& [name, value] : fractions->members())
            published.volume_fractions.emplace_back(name, fraction.read(value));
    if (const auto fits = node.find("damping_fits")) published.damping_fits = read_quadratics(*fits);
    published.damping_fit_uncertainty = Printed(Dimension::damping, rounding, "damping_fit").uncertainty();
    if (const auto u = node.find("damping_fit_uncertainty"))
        published.damping_fit_uncertainty =
            not_negative(*u, "uncertainty of a coefficient", Dimension::damping);
    published.critical_damping = damping.read_by_law(node, "critical_damping");
    published.critical_velocity = velocity.read_by_law(node, "critical_velocity");
    if (const auto value = node.find("measured_critical_velocity"))
        published.measured_critical_velocity = velocity.read(*value);
    if (const auto times = node.find("contact_times"))
        for (const View& entry : times->elements())
            published.contact_times.push_back(
                {Law::named(entry.at("law").text()),
                 positive_quantity(entry.at("velocity"), "velocity", Dimension::velocity),
                 time.read(entry.at("contact_time"))});
    published.critical_contact_times = time.read_by_law(node, "critical_contact_times");
    return published;
}

void read_detachments(const std::optional<View>& node, std::vector<LawChoice>& choices,
                      const std::string& known_laws) {
    if (!node) return;
    for (const auto& [name, value] : node->members()) {
        const Law law = at_place(value.pointer(), [&key = name] { return Law::named(key); });
        const Detachment detachment = named<Detachment>(value.text());
        if (const auto reason = refusal(law, detachment)) value.fail(*reason, admissible_detachments(law));
        const auto chosen = std::find_if(choices.begin(), choices.end(),
                                         [&](const LawChoice& choice) { return choice.law == law; });
        if (chosen == choices.end()) value.fail("the law is not among \"laws\"", known_laws);
        chosen->detachment = detachment;
    }
}

}  // namespace ashimpact
