// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/document/case_json.hpp"

#include "core/json/view.hpp"
#include "pipeline/case/measurement_json.hpp"

namespace ashimpact {

namespace {

template <class Value, class Write>
Json by_law(const LawMap<Value>& values, Write&& write) {
    Json json = Json::object();
    for (const auto& [law, value] : values) json[std::string(law.name())] = write(value);
    return json;
}

Json quantity(const Quantity& value) {
    return value;
}

Json fraction_json(double value, const std::optional<double>& uncertainty) {
    return Quantity{.value = value, .unit = "1", .standard_uncertainty = uncertainty};
}

Json property_json(const PhaseProperty& property, Dimension dimension) {
    Json json = make_quantity(property.value, dimension, property.standard_uncertainty);
    if (property.range) json["range"] = {property.range->first, property.range->second};
    if (property.assumed) json["assumed"] = true;
    if (!property.citations.empty()) json["citations"] = property.citations;
    return json;
}

Json phase_json(const Phase& phase) {
    Json json{{"name", phase.name}};
    const auto add = [&](const char* key, const auto& value) {
        if (!value.empty()) json[key] = value;
    };
    add("formula", phase.formula);
    add("group", phase.group);
    if (phase.amorphous) json["amorphous"] = true;
    json["density"] = property_json(phase.density, Dimension::density);
    json["young_modulus"] = property_json(phase.young_modulus, Dimension::pressure);
    if (phase.poisson_ratio) json["poisson_ratio"] = property_json(*phase.poisson_ratio, Dimension::fraction);
    add("synonyms", phase.synonyms);
    add("bgmn", phase.bgmn);
    add("remark", phase.remark);
    return json;
}

Json wall_json(const Wall& wall) {
    if (const auto* elastic = std::get_if<ElasticWall>(&wall))
        return {{"young_modulus", stated_json(elastic->young_modulus)},
                {"poisson_ratio", stated_json(elastic->poisson_ratio)}};
    if (const auto* modulus = std::get_if<Stated>(&wall)) return {{"contact_modulus", stated_json(*modulus)}};
    return {{"rigid", true}};
}

Json partner_json(const PartnerSphere& partner, const std::optional<Wall>& elasticity) {
    Json json = elasticity ? wall_json(*elasticity) : Json::object();
    json["diameter"] = stated_json(partner.diameter);
    if (partner.density) json["density"] = stated_json(*partner.density);
    if (partner.mass) json["mass"] = stated_json(*partner.mass);
    return json;
}

Json adhesion_json(const Adhesion& adhesion) {
    if (const auto* stated = std::get_if<Stated>(&adhesion)) return stated_json(*stated);
    const auto& from = std::get<AdhesionFromSurfaces>(adhesion);
    const auto energy = [](double value) { return quantity_json(value, Dimension::energy_per_area); };
    Json energies{{"particle", energy(from.energies.particle)}, {"wall", energy(from.energies.wall)}};
    if (from.energies.interfacial) energies["interfacial"] = energy(*from.energies.interfacial);
    return {{"surface_energies", energies}, {"rule", name_of(from.rule)}};
}

struct AmorphousWriter {
    FractionBasis basis;  ///< of the fractions beside it

    Json operator()(const AmorphousNotStated&) const { return nullptr; }
    Json operator()(const AmorphousNone&) const { return "none"; }
    Json operator()(const AmorphousFraction& part) const {
        Json fraction = fraction_json(part.value, part.standard_uncertainty);
        if (part.basis == basis) return fraction;
        return {{part.basis == FractionBasis::weight ? "weight_fraction" : "volume_fraction", fraction}};
    }
    Json operator()(const CrystallineTotal& part) const {
        return {{"crystalline_total", fraction_json(part.value, part.standard_uncertainty)}};
    }
    Json operator()(const AmorphousRemainder& part) const {
        if (part.scale == 1 && !part.standard_uncertainty) return "remainder";
        return {{"remainder_scale", fraction_json(part.scale, part.standard_uncertainty)}};
    }
};

Json analysis_json(const Analysis& analysis, const std::string& source) {
    Json fractions = Json::object();
    Json densities = Json::object();
    for (const PhaseFraction& phase : analysis.phases) {
        fractions[phase.name] = fraction_json(phase.fraction, phase.standard_uncertainty);
        if (phase.density) densities[phase.name] = quantity_json(*phase.density, Dimension::density);
    }
    Json json{{analysis.basis == FractionBasis::weight ? "weight_fractions" : "volume_fractions", fractions}};
    if (!densities.empty()) json["densities"] = densities;
    const Json amorphous = std::visit(AmorphousWriter{analysis.basis}, analysis.amorphous);
    if (!amorphous.is_null()) json["amorphous"] = amorphous;
    json["amorphous_phase"] = analysis.amorphous_phase;
    if (!source.empty()) json["source"] = source;
    return json;
}

Json porosity_json(const Porosity& porosity, bool from_density) {
    Json json{{"law", name_of(porosity.law)}};
    if (!from_density) json["value"] = fraction_json(porosity.value, porosity.standard_uncertainty);
    if (porosity.coefficient) json["coefficient"] = *porosity.coefficient;
    return json;
}

struct RestitutionWriter {
    Json operator()(const MeasuredRestitution& data) const {
        Json json = measurement_columns(data.impacts, true);
        json["source"] = data.source;
        return json;
    }
    Json operator()(const Reconstruction& plan) const {
        Json json{{"damping_fits", by_law(plan.damping_fits, quadratic_json)},
                  {"from", quantity_json(plan.from, Dimension::fraction)},
                  {"to", quantity_json(plan.to, Dimension::fraction)},
                  {"points", plan.points},
                  {"reference_law", plan.reference},
                  {"source", plan.source}};
        if (plan.coefficient_uncertainty)
            json["coefficient_uncertainty"] =
                quantity_json(*plan.coefficient_uncertainty, Dimension::damping);
        return {{"reconstruct", json}};
    }
};

Json sample_json(const Sample& sample) {
    Json json{{"name", sample.name},
              {"diameter", stated_json(sample.diameter)},
              {"composition", analysis_json(sample.analysis, sample.analysis_source)}};
    const auto add = [&](const char* key, const std::optional<Stated>& value) {
        if (value) json[key] = stated_json(*value);
    };
    if (sample.porosity) json["porosity"] = porosity_json(*sample.porosity, sample.porosity_from_density);
    add("poisson_ratio", sample.poisson_ratio);
    add("density", sample.density);
    add("contact_modulus", sample.contact_modulus);
    add("yield_pressure", sample.yield_pressure);
    for (const auto& [parameter, stated] : sample.parameters)
        json[std::string(parameter.name)] = stated_json(stated);
    if (sample.work_of_adhesion) json["work_of_adhesion"] = adhesion_json(*sample.work_of_adhesion);
    add("measured_critical_velocity", sample.measured_critical_velocity);
    if (sample.restitution) json["restitution"] = std::visit(RestitutionWriter{}, *sample.restitution);
    if (sample.published) json["published"] = published_json(*sample.published);
    return json;
}

Json calibration_json(const std::vector<FreeConstant>& free) {
    Json list = Json::array();
    for (const FreeConstant& constant : free)
        list.push_back({{"quantity", name_of(constant.quantity)}, {"per_sample", constant.per_sample}});
    return {{"free", list}};
}

}  // namespace

Json stated_json(const Stated& stated) {
    Json json = stated.quantity;
    json["origin"] = name_of(stated.origin);
    if (!stated.source.empty()) json["source"] = stated.source;
    return json;
}

Json quadratic_json(const DampingPolynomial& fit) {
    const auto coefficient = [&](int power) {
        return quantity_json(fit.coefficients[power], Dimension::damping);
    };
    return {{"a", coefficient(2)}, {"b", coefficient(1)}, {"c", coefficient(0)}};
}

Json published_json(const PublishedSample& published) {
    Json json{{"source", published.source}};
    if (published.young_modulus) json["young_modulus"] = *published.young_modulus;
    for (const auto& [name, fraction] : published.volume_fractions) json["volume_fractions"][name] = fraction;
    const auto add = [&](const char* key, const auto& values, const auto& write) {
        if (!values.empty()) json[key] = by_law(values, write);
    };
    add("damping_fits", published.damping_fits, quadratic_json);
    if (published.damping_fit_uncertainty)
        json["damping_fit_uncertainty"] =
            quantity_json(*published.damping_fit_uncertainty, Dimension::damping);
    add("critical_damping", published.critical_damping, quantity);
    add("critical_velocity", published.critical_velocity, quantity);
    if (published.measured_critical_velocity)
        json["measured_critical_velocity"] = *published.measured_critical_velocity;
    for (const auto& time : published.contact_times)
        json["contact_times"].push_back(
            {{"law", time.law.name()}, {"velocity", time.velocity}, {"contact_time", time.contact_time}});
    add("critical_contact_times", published.critical_contact_times, quantity);
    return json;
}

Json case_json(const Case& data) {
    Json json{{"name", data.name}, {"mixture_rule", name_of(data.mixture_rule)}};
    if (data.roughness) json["roughness"] = stated_json(*data.roughness);
    if (data.partner)
        json["partner"] = partner_json(*data.partner, data.wall);
    else if (data.wall)
        json["wall"] = wall_json(*data.wall);
    json["laws"] = Json::array();
    for (const LawChoice& choice : data.laws) {
        json["laws"].push_back(choice.law.name());
        json["detachments"][std::string(choice.law.name())] = name_of(choice.detachment);
    }
    json["damping_law"] = name_of(data.damping_law);
    json["histories"] = {{"points", data.histories.points},
                         {"critical_excess", data.histories.critical_excess}};
    json["fit"] = {{"order", data.fit.order},
                   {"robust", data.fit.robust},
                   {"flatness", data.fit.flatness},
                   {"outlier", data.fit.outlier}};
    if (data.fit.size_scatter) json["fit"]["size_scatter"] = *data.fit.size_scatter;
    json["uncertainty"] = {{"samples", data.uncertainty.propagation.samples},
                           {"replicates", data.uncertainty.propagation.replicates},
                           {"seed", data.uncertainty.propagation.seed},
                           {"damping", data.uncertainty.reread ? "reread" : "held"}};
    if (!data.calibration.empty()) json["calibration"] = calibration_json(data.calibration);
    for (const Phase& phase : data.phases) json["phases"].push_back(phase_json(phase));
    for (const Sample& sample : data.samples) json["samples"].push_back(sample_json(sample));
    return json;
}

}  // namespace ashimpact
