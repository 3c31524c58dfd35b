// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "core/json/view.hpp"
#include "core/text/text.hpp"
#include "materials/contact_properties.hpp"
#include "pipeline/case/case_parts.hpp"
#include "pipeline/case/case_reader.hpp"
#include "pipeline/document/fields.hpp"
#include "pipeline/document/results_json.hpp"
#include "pipeline/files/file.hpp"
#include "pipeline/run/stage.hpp"
#include "solver/motion/impact.hpp"

namespace ashimpact {

namespace {

/// Puts the samples of a result into the order of the case, and drops those that it does not have.
template <class Sample>
void follow_case(const Case& data, std::vector<Sample>& samples) {
    std::vector<Sample> ordered;
    for (const ashimpact::Sample& wanted : data.samples) {
        const auto found = std::ranges::find(samples, wanted.name, &Sample::name);
        if (found == samples.end())
            throw InputError("the sample " + in_quotes(wanted.name) + " is missing",
                             "every sample of 0-case.json")
                .at("/result/samples");
        ordered.push_back(std::move(*found));
    }
    if (!data.samples.empty()) samples = std::move(ordered);
}

template <class Result>
Result read_result(const View& document, const Case& data) {
    Result result = from_json<Result>(document.at("result"), data.damping_law);
    follow_case(data, result.samples);
    return result;
}

void read_case_document(const View& document, Run& run) {
    InputFiles none = InputFiles::beside({});
    run.data = read_case(document.at("result"), PhaseCatalogue({}), none);
    const View provenance = document.at("provenance");
    run.version = provenance.at("version").text();
    run.revision = provenance.at("revision").text();
    for (const View& input : provenance.at("inputs").elements()) {
        run.inputs.push_back({input.at("file").text(), input.at("sha256").text()});
        if (const auto readings = input.find("read_as"))
            for (const View& reading : readings->elements())
                run.inputs.back().readings.push_back(reading.text());
    }
}

/// How an artifact is written, and read into a run.
struct Part {
    std::string_view file;
    Json (*write)(const Run&);
    void (*read)(const View& document, Run&);
};

template <auto Member>
Part part(std::string_view file) {
    return {file, [](const Run& run) { return to_json(run.*Member, run.data.damping_law); },
            [](const View& document, Run& run) {
                using Result = std::decay_t<decltype(run.*Member)>;
                run.*Member = read_result<Result>(document, run.data);
            }};
}

const std::vector<Part>& parts() {
    static const std::vector<Part> all{
        {case_artifact, [](const Run& run) { return case_json(run.data); }, read_case_document},
        part<&Run::modulus>(modulus_artifact),
        part<&Run::contact>(contact_artifact),
        part<&Run::analytic>(analytic_artifact),
        part<&Run::restitution>(restitution_artifact),
        part<&Run::damping>(damping_artifact),
        part<&Run::fit>(fit_artifact),
        part<&Run::critical_velocity>(critical_velocity_artifact),
        part<&Run::histories>(histories_artifact),
        part<&Run::comparison>(comparison_artifact)};
    return all;
}

const Part& part_of(std::string_view file) {
    const auto found = std::ranges::find(parts(), file, &Part::file);
    if (found == parts().end()) throw std::logic_error("no artifact of a run: " + std::string(file));
    return *found;
}

/// Where the contact of each law of the case ends, and the ends that it is refused, with the reason.
Json detachments_json(const Case& data) {
    Json laws = Json::object();
    for (const LawChoice& choice : data.laws) {
        Json refused = Json::object();
        for (const Detachment detachment : all_values<Detachment>)
            if (const auto reason = refusal(choice.law, detachment))
                refused[std::string(name_of(detachment))] = *reason;
        laws[std::string(choice.law.name())] = {{"ends_at", name_of(choice.detachment)},
                                                {"refused", std::move(refused)}};
    }
    return laws;
}

Json own_options_json(const Case& data, std::string_view file) {
    if (file == modulus_artifact) return {{"mixture_rule", name_of(data.mixture_rule)}};
    if (file == contact_artifact)
        return {{"geometry", data.partner ? "two spheres: 1/R* = 1/r1 + 1/r2, 1/m* = 1/m1 + 1/m2"
                                          : "sphere on a flat wall: R* = r, m* = m"}};
    if (file == analytic_artifact)
        return {{"separation", "pull-off"},
                {"energy_constant", separation_energy_constant(Separation::pull_off)},
                {"velocity_constant", separation_velocity_constant(Separation::pull_off)},
                {"modulus", "contact modulus E* (the paper prints Young's modulus)"},
                {"adhesion", "work of adhesion w (the paper prints a surface energy)"}};
    if (file == damping_artifact)
        return {{"damping_law", name_of(data.damping_law)},
                {"flatness", data.fit.parts.flatness},
                {"outlier", data.fit.parts.outlier}};
    if (file == fit_artifact)
        return {{"order", data.fit.extrapolated.order},
                {"robust", data.fit.extrapolated.robust},
                {"measured",
                 "closest curve in the plane of both velocities; the estimate from all impacts beside it"},
                {"reconstructed", "least squares, quadratic, equal weights"}};
    if (file == critical_velocity_artifact) {
        const PropagationOptions& propagation = data.uncertainty.propagation;
        return {{"damping", "critical damping of 6-fit.json: the estimate from all impacts, else eta(0)"},
                {"samples", propagation.samples},
                {"replicates", propagation.replicates},
                {"seed", propagation.seed},
                {"inputs",
                 "taken as independent, but inferred constants follow the contact modulus they were "
                 "calibrated at"}};
    }
    if (file == histories_artifact)
        return {{"points", data.histories.points}, {"critical_excess", data.histories.critical_excess}};
    return Json::object();
}

Quantity fraction_of(double value, const std::optional<double>& uncertainty) {
    return make_quantity(value, Dimension::fraction, uncertainty);
}

Json property_json(const PhaseProperty& property, Dimension dimension) {
    Json json = make_quantity(property.value, dimension, property.standard_uncertainty);
    if (property.range) json["range"] = {property.range->first, property.range->second};
    if (property.assumed) json["assumed"] = true;
    if (!property.citations.empty()) json["citations"] = property.citations;
    return json;
}

Json adhesion_json(const Adhesion& adhesion) {
    if (const auto* stated = std::get_if<Stated>(&adhesion))
        return value_json(*stated, Dimension::energy_per_area);
    const auto& from = std::get<AdhesionFromSurfaces>(adhesion);
    FieldWriter energies(DampingLaw::constant);
    energies("particle", from.energies.particle, Dimension::energy_per_area);
    energies("wall", from.energies.wall, Dimension::energy_per_area);
    energies.unless_empty("interfacial", from.energies.interfacial, Dimension::energy_per_area);
    return {{"surface_energies", std::move(energies).json()}, {"rule", name_of(from.rule)}};
}

struct AmorphousWriter {
    FractionBasis basis;  ///< of the fractions beside it

    Json operator()(const AmorphousNotStated&) const { return nullptr; }
    Json operator()(const AmorphousNone&) const { return "none"; }
    Json operator()(const AmorphousFraction& part) const {
        Json fraction = fraction_of(part.value, part.standard_uncertainty);
        if (part.basis == basis) return fraction;
        return {{part.basis == FractionBasis::weight ? "weight_fraction" : "volume_fraction", fraction}};
    }
    Json operator()(const CrystallineTotal& part) const {
        return {{"crystalline_total", fraction_of(part.value, part.standard_uncertainty)}};
    }
    Json operator()(const AmorphousRemainder& part) const {
        if (part.scale == 1 && !part.standard_uncertainty) return "remainder";
        return {{"remainder_scale", fraction_of(part.scale, part.standard_uncertainty)}};
    }
};

/// The keys of a composition that concern its glass.
void add_glass(const GlassInputs& glass, Json& composition) {
    if (!glass.oxides) return;
    Json oxides = Json::object();
    for (const OxideShare& each : glass.oxides->oxides)
        oxides[each.oxide] = fraction_of(each.fraction, each.standard_uncertainty);
    if (const auto& loss = glass.oxides->loss_on_ignition)
        oxides[loss->oxide] = fraction_of(loss->fraction, loss->standard_uncertainty);
    composition["oxides"] = std::move(oxides);
    composition["glass"] = name_of(glass.source);
    if (glass.density) composition["glass_density"] = *glass.density;
}

Json composition_json(const Analysis& analysis, const std::string& source, const GlassInputs& glass) {
    Json fractions = Json::object();
    Json densities = Json::object();
    for (const PhaseFraction& phase : analysis.phases) {
        fractions[phase.name] = fraction_of(phase.fraction, phase.standard_uncertainty);
        if (phase.density) densities[phase.name] = quantity_json(*phase.density, Dimension::density);
    }
    Json json{{analysis.basis == FractionBasis::weight ? "weight_fractions" : "volume_fractions", fractions}};
    if (!densities.empty()) json["densities"] = densities;
    const Json amorphous = std::visit(AmorphousWriter{analysis.basis}, analysis.amorphous);
    if (!amorphous.is_null()) json["amorphous"] = amorphous;
    json["amorphous_phase"] = analysis.amorphous_phase;
    if (!source.empty()) json["source"] = source;
    add_glass(glass, json);
    return json;
}

Json porosity_json(const Porosity& porosity, bool from_density) {
    Json json{{"law", name_of(porosity.law)}};
    if (!from_density) json["value"] = fraction_of(porosity.value, porosity.standard_uncertainty);
    if (porosity.coefficient) json["coefficient"] = *porosity.coefficient;
    return json;
}

}  // namespace

Json result_json(const Run& run, std::string_view file) {
    return part_of(file).write(run);
}

Json options_json(const Case& data, std::string_view file) {
    Json options = own_options_json(data, file);
    if (file != analytic_artifact) options["detachments"] = detachments_json(data);
    return options;
}

void read_artifact(const Artifacts& artifacts, std::string_view file, Run& run) {
    const Artifact& artifact = artifacts.at(file);
    at_place(FileName{artifacts.place_of(file)}, [&] {
        const View document(*artifact.document);
        part_of(file).read(document, run);
        run.records.push_back({.stage = document.at("stage").text(),
                               .file = artifact.file,
                               .sha256 = sha256(artifact.bytes),
                               .citations = document.at("citations").texts(),
                               .notes = read_notes(document),
                               .edited = artifact.edited});
    });
}

Run read_run(const Artifacts& artifacts) {
    Run run;
    for (const Part& each : parts())
        if (artifacts.has(each.file)) read_artifact(artifacts, each.file, run);
    return run;
}

static void fields(FieldWriter& io, const Phase& phase) {
    io("name", phase.name);
    io.unless_empty("formula", phase.formula);
    io.unless_empty("group", phase.group);
    if (phase.amorphous) io("amorphous", true);
    io.json("density", property_json(phase.density, Dimension::density));
    io.json("young_modulus", property_json(phase.young_modulus, Dimension::pressure));
    if (phase.poisson_ratio)
        io.json("poisson_ratio", property_json(*phase.poisson_ratio, Dimension::fraction));
    io.unless_empty("synonyms", phase.synonyms);
    io.unless_empty("bgmn", phase.bgmn);
    io.unless_empty("remark", phase.remark);
}

static void fields(FieldWriter& io, const Wall& wall) {
    if (const auto* elastic = std::get_if<ElasticWall>(&wall)) {
        io("young_modulus", elastic->young_modulus, Dimension::pressure);
        io("poisson_ratio", elastic->poisson_ratio, Dimension::fraction);
    } else if (const auto* modulus = std::get_if<Stated>(&wall)) {
        io("contact_modulus", *modulus, Dimension::pressure);
    } else {
        io("rigid", true);
    }
}

static void fields(FieldWriter& io, const DampingPolynomial& fit) {
    io("a", fit.coefficients[2], Dimension::damping);
    io("b", fit.coefficients[1], Dimension::damping);
    io("c", fit.coefficients[0], Dimension::damping);
}

static void fields(FieldWriter& io, const Reconstruction& plan) {
    io("damping_fits", plan.damping_fits);
    io("from", plan.from, Dimension::fraction);
    io("to", plan.to, Dimension::fraction);
    io("points", plan.points);
    io("reference_law", plan.reference);
    io("source", plan.source);
    io.unless_empty("coefficient_uncertainty", plan.coefficient_uncertainty, Dimension::damping);
}

/// Impacts with the velocities of their rebounds, which read back exactly.
static void rebound_fields(FieldWriter& io, const MeasurementSet& impacts) {
    const ListedImpacts columns = columns_of(impacts);
    std::vector<double> rebound;
    for (const Measurement& point : impacts.points) rebound.push_back(point.rebound);
    io("velocity", columns.velocity, Dimension::velocity);
    io("rebound_velocity", rebound, Dimension::velocity);
    noise_fields(io, columns);
}

static void fields(FieldWriter& io, const RestitutionSource& data) {
    if (const auto* plan = std::get_if<Reconstruction>(&data)) return io("reconstruct", *plan);
    const auto& measured = std::get<MeasuredRestitution>(data);
    rebound_fields(io, measured.impacts);
    io("source", measured.source);
}

static void fields(FieldWriter& io, const PublishedSample::ContactTime& time) {
    io("law", time.law);
    io("velocity", time.velocity, Dimension::velocity);
    io("contact_time", time.contact_time, Dimension::time);
}

static void fields(FieldWriter& io, const PublishedSample& published) {
    io("source", published.source);
    io.unless_empty("young_modulus", published.young_modulus, Dimension::pressure);
    io.unless_empty("volume_fractions", published.volume_fractions, Dimension::fraction);
    io.unless_empty("damping_fits", published.damping_fits);
    io.unless_empty("damping_fit_uncertainty", published.damping_fit_uncertainty, Dimension::damping);
    io.unless_empty("critical_damping", published.critical_damping, Dimension::damping);
    io.unless_empty("critical_velocity", published.critical_velocity, Dimension::velocity);
    io.unless_empty("measured_critical_velocity", published.measured_critical_velocity, Dimension::velocity);
    io.unless_empty("contact_times", published.contact_times);
    io.unless_empty("critical_contact_times", published.critical_contact_times, Dimension::time);
}

static void fields(FieldWriter& io, const Sample& sample) {
    io("name", sample.name);
    io("diameter", sample.diameter, Dimension::length);
    io.json("composition", composition_json(sample.analysis, sample.analysis_source, sample.glass));
    if (sample.porosity) io.json("porosity", porosity_json(*sample.porosity, sample.porosity_from_density));
    io.unless_empty("poisson_ratio", sample.poisson_ratio, Dimension::fraction);
    io.unless_empty("density", sample.density, Dimension::density);
    io.unless_empty("contact_modulus", sample.contact_modulus, Dimension::pressure);
    io.unless_empty("yield_pressure", sample.yield_pressure, Dimension::pressure);
    for (const auto& [parameter, stated] : sample.parameters) io(parameter.name, stated, parameter.dimension);
    if (sample.work_of_adhesion) io.json("work_of_adhesion", adhesion_json(*sample.work_of_adhesion));
    io.unless_empty("measured_critical_velocity", sample.measured_critical_velocity, Dimension::velocity);
    io.unless_empty("restitution", sample.restitution);
    io.unless_empty("published", sample.published);
}

static void fields(FieldWriter& io, const FreeConstant& constant) {
    io("quantity", constant.quantity);
    io("per_sample", constant.per_sample);
}

static void fields(FieldWriter& io, const Case& data) {
    io("name", data.name);
    io("mixture_rule", data.mixture_rule);
    io.unless_empty("roughness", data.roughness, Dimension::length);
    io.unless_empty("friction", data.friction, Dimension::fraction);
    if (data.temperature.particle || data.temperature.wall)
        io.object("temperature", [&](FieldWriter& temperature) {
            temperature.unless_empty("particle", data.temperature.particle, Dimension::temperature);
            temperature.unless_empty("wall", data.temperature.wall, Dimension::temperature);
        });
    if (data.partner)
        io.object("partner", [&](FieldWriter& partner) {
            if (data.wall) fields(partner, *data.wall);
            partner("diameter", data.partner->diameter, Dimension::length);
            partner.unless_empty("density", data.partner->density, Dimension::density);
            partner.unless_empty("mass", data.partner->mass, Dimension::mass);
        });
    else
        io.unless_empty("wall", data.wall);
    std::vector<Law> laws;
    LawMap<Detachment> detachments;
    for (const LawChoice& choice : data.laws) {
        laws.push_back(choice.law);
        detachments.set(choice.law, choice.detachment);
    }
    io("laws", laws);
    io.unless_empty("detachments", detachments);
    io("damping_law", data.damping_law);
    if (data.paper_time_step)
        io.object("paper_explicit",
                  [&](FieldWriter& scheme) { scheme("time_step", *data.paper_time_step, Dimension::time); });
    io.object("histories", [&](FieldWriter& histories) {
        histories("points", data.histories.points);
        histories("critical_excess", data.histories.critical_excess);
    });
    io.object("fit", [&](FieldWriter& fit) {
        fit("order", data.fit.extrapolated.order);
        fit("robust", data.fit.extrapolated.robust);
        fit("flatness", data.fit.parts.flatness);
        fit("outlier", data.fit.parts.outlier);
        fit.unless_empty("size_scatter", data.fit.estimate.size_scatter);
        if (data.fit.estimate.scale_uncertainty > 0)
            fit("velocity_scale_uncertainty", data.fit.estimate.scale_uncertainty, Dimension::fraction);
    });
    io.object("uncertainty", [&](FieldWriter& uncertainty) {
        uncertainty("samples", data.uncertainty.propagation.samples);
        uncertainty("replicates", data.uncertainty.propagation.replicates);
        uncertainty("seed", data.uncertainty.propagation.seed);
        uncertainty("damping", std::string(data.uncertainty.reread ? "reread" : "held"));
    });
    if (!data.calibration.empty())
        io.object("calibration", [&](FieldWriter& inner) { inner("free", data.calibration); });
    io.unless_empty("phases", data.phases);
    io.unless_empty("samples", data.samples);
}

Json quadratic_json(const DampingPolynomial& fit) {
    return to_json(fit, DampingLaw::constant);
}

Json measurement_columns(const MeasurementSet& set) {
    FieldWriter columns(DampingLaw::constant);
    rebound_fields(columns, set);
    return std::move(columns).json();
}

Json case_json(const Case& data) {
    return to_json(data, DampingLaw::constant);
}

}  // namespace ashimpact
