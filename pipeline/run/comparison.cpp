// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/run/comparison.hpp"

#include <algorithm>
#include <limits>

#include <fmt/format.h>

#include "pipeline/document/case_json.hpp"
#include "pipeline/document/quantity_json.hpp"
#include "pipeline/present/text/readable.hpp"
#include "pipeline/run/analytic.hpp"
#include "pipeline/run/comparison/equal_velocities.hpp"
#include "pipeline/run/comparison/reported_velocity.hpp"
#include "pipeline/run/contact.hpp"
#include "pipeline/run/critical_velocity.hpp"
#include "pipeline/run/damping.hpp"
#include "pipeline/run/fit.hpp"
#include "pipeline/run/histories.hpp"
#include "pipeline/run/modulus.hpp"
#include "pipeline/run/read_case_artifact.hpp"
#include "solver/damping/damping.hpp"

namespace ashimpact {

namespace {

/// Results of one sample from the artifacts.
struct SampleResults {
    const Sample& sample;
    const SampleModulus& modulus;
    const LawMap<LawFit>& fits;
    const LawMap<LawCriticalVelocity>& velocities;
    const std::vector<ContactTimeAt>& contact_times;
    const std::vector<std::pair<std::string, double>>& volume_fractions;
};

/// Range of the ratio of dynamic to analytic velocities, over all samples and laws.
struct Gap {
    double least_ratio = std::numeric_limits<double>::infinity();
    double greatest_ratio = 0;
    double least_share = std::numeric_limits<double>::infinity();  ///< of damping in the energy lost at v_c
    double greatest_share = 0;

    void take(const LawCriticalVelocity& dynamic, double analytic) {
        if (!dynamic.value || !(analytic > 0)) return;
        const double ratio = dynamic.value->value / analytic;
        least_ratio = std::min(least_ratio, ratio);
        greatest_ratio = std::max(greatest_ratio, ratio);
        const double share = dynamic.dissipated / (dynamic.dissipated + dynamic.plastic +
                                                   std::max(0.0, dynamic.detachment_energy));
        least_share = std::min(least_share, share);
        greatest_share = std::max(greatest_share, share);
    }

    [[nodiscard]] bool known() const { return greatest_ratio > 0; }

    /// "least to greatest", or the one number that both are.
    [[nodiscard]] static std::string range(const std::string& least, const std::string& greatest) {
        return least == greatest ? least : least + " to " + greatest;
    }

    [[nodiscard]] std::string sentence() const {
        if (!known())
            return "No sample has both a dynamic critical velocity and one of adhesion alone (Eq. 30), so "
                   "there is none to compare.";
        const std::string ratios =
            fmt::format("The dynamic critical velocities are {} times the analytic ones of Eq. 30",
                        range(readable_number(least_ratio, 3), readable_number(greatest_ratio, 3)));
        const std::string share =
            range(readable_number(100 * least_share, 4), readable_number(100 * greatest_share, 4)) + " %";
        if (least_ratio > 2)
            return fmt::format(
                "{}: the first-contact adhesive loss W_s does not explain capture here, viscous "
                "dissipation does, which takes {} of the energy lost at v_c.",
                ratios, share);
        return fmt::format(
            "{}; viscous dissipation takes {} of the energy lost at v_c, breaking the contact the rest.",
            ratios, share);
    }
};

Json beside(double ours, const Quantity& published) {
    return {{"ours", quantity_json(ours, published.unit)},
            {"published", published},
            {"relative_difference", ours / published.value - 1}};
}

/// Our values beside the published ones, for every law that has both.
template <class Ours, class Value>
Json beside_by_law(const LawMap<Quantity>& published, const LawMap<Ours>& ours, Value&& value) {
    Json json = Json::object();
    for (const auto& [law, printed] : published) {
        const Ours* own = ours.find(law);
        if (own == nullptr) continue;
        const std::optional<double> number = value(*own);
        if (number) json[std::string(law.name())] = beside(*number, printed);
    }
    return json;
}

Json published_beside_json(const PublishedSample& published, const SampleResults& of) {
    Json json{{"source", published.source}};
    if (published.young_modulus)
        json["young_modulus"] = beside(of.modulus.young_modulus.value, *published.young_modulus);
    for (const auto& [name, printed] : published.volume_fractions)
        for (const auto& [own_name, fraction] : of.volume_fractions)
            if (own_name == name) json["volume_fractions"][name] = beside(fraction, printed);
    const auto add = [&](const char* key, Json values) {
        if (!values.empty()) json[key] = std::move(values);
    };
    add("critical_damping", beside_by_law(published.critical_damping, of.fits, [](const LawFit& fit) {
            return std::optional(fit.critical_damping);
        }));
    add("critical_velocity",
        beside_by_law(published.critical_velocity, of.velocities, [](const LawCriticalVelocity& velocity) {
            return velocity.value ? std::optional(velocity.value->value) : std::nullopt;
        }));
    add("critical_contact_times", beside_by_law(published.critical_contact_times, of.velocities,
                                                [](const LawCriticalVelocity& v) { return v.contact_time; }));
    for (const auto& printed : published.contact_times)
        for (const ContactTimeAt& own : of.contact_times) {
            if (!(own.law == printed.law) || own.velocity != printed.velocity.value) continue;
            Json entry{{"law", own.law.name()}, {"velocity", printed.velocity}};
            entry.update(beside(own.contact_time, printed.contact_time));
            json["contact_times"].push_back(std::move(entry));
        }
    return json;
}

std::vector<std::pair<std::string, double>> read_volume_fractions(const View& result,
                                                                  const std::string& name) {
    std::vector<std::pair<std::string, double>> fractions;
    for (const View& sample : result.at("samples").elements()) {
        if (sample.at("name").text() != name) continue;
        for (const View& phase : sample.at("phases").elements())
            fractions.emplace_back(phase.at("name").text(),
                                   phase.at("volume_fraction").number(Dimension::fraction));
    }
    return fractions;
}

/// Dynamic critical velocities with their intervals and verdicts, each by law.
struct DynamicColumns {
    Json velocity = Json::object();
    Json extrapolated = Json::object();
    Json interval = Json::object();
    Json interval_note = Json::object();
    Json verdict = Json::object();
    Json check = Json::object();
};

DynamicColumns dynamic_columns(const SampleResults& of, const std::vector<LawChoice>& laws) {
    DynamicColumns columns;
    for (const LawChoice& choice : laws) {
        const LawCriticalVelocity* velocity = of.velocities.find(choice.law);
        const std::string name(choice.law.name());
        const bool finite = velocity != nullptr && velocity->value;
        columns.velocity[name] = finite ? velocity->headline : Json(nullptr);
        if (finite && !velocity->extrapolated.is_null()) columns.extrapolated[name] = velocity->extrapolated;
        columns.interval[name] = finite ? velocity->interval : Json(nullptr);
        if (finite && !velocity->interval_note.is_null())
            columns.interval_note[name] = velocity->interval_note;
        columns.check[name] = finite ? velocity->check : Json(nullptr);
        columns.verdict[name] = velocity != nullptr     ? velocity->verdict
                                : of.sample.restitution ? "no fit"
                                                        : "no damping data";
    }
    return columns;
}

/// The measured critical velocity: reported, or else as the outcomes of the impacts show it.
Json measured_json(const Sample& sample, const Json& measured) {
    if (sample.measured_critical_velocity) return stated_json(*sample.measured_critical_velocity);
    if (measured.is_null() || measured.at("critical_velocity").is_null()) return nullptr;
    Json json = measured.at("critical_velocity");
    json["origin"] = "measured";
    json["source"] = measured.at("note");
    return json;
}

/// "cohesion range"
std::string parameter_words(const LawParameter& parameter) {
    std::string words(parameter.name);
    std::replace(words.begin(), words.end(), '_', ' ');
    return words;
}

/// Properties of the contact of a sample, the wall's among them, that were not measured: {"quantity",
/// "value", "origin", "why"}.
Json assumed_json(const Sample& sample, const SampleContact& contact, const std::optional<Wall>& wall) {
    Json list = Json::array();
    const auto add = [&](const char* name, const Quantity& value, const std::string& origin,
                         const std::string& why) {
        if (origin == "assumed" || origin == "inferred" || origin == "literature" || origin == "computed")
            list.push_back({{"quantity", name}, {"value", value}, {"origin", origin}, {"why", why}});
    };
    add("diameter", sample.diameter.quantity, sample.diameter.origin, "");
    if (sample.density)
        add("density", contact.density, sample.density->origin, "");
    else
        add("density", contact.density, "computed",
            sample.porosity ? "not given: that of the phases and the porosity"
                            : "not given: that of the phases without any pores");
    if (const auto* stated =
            sample.work_of_adhesion ? std::get_if<Stated>(&*sample.work_of_adhesion) : nullptr)
        add("work of adhesion", contact.work_of_adhesion, stated->origin, "");
    else if (sample.work_of_adhesion)
        add("work of adhesion", contact.work_of_adhesion, "computed", "from surface energies");
    for (const auto& [parameter, stated] : sample.parameters)
        add(parameter_words(parameter).c_str(), stated.quantity, stated.origin, "");
    if (const auto* elastic = wall ? std::get_if<ElasticWall>(&*wall) : nullptr) {
        add("Young's modulus of the wall", elastic->young_modulus.quantity, elastic->young_modulus.origin,
            "");
        add("Poisson ratio of the wall", elastic->poisson_ratio.quantity, elastic->poisson_ratio.origin, "");
    }
    return list;
}

/// Which of diameter, density, work of adhesion and parameters of contact laws state no uncertainty, so that
/// none goes into intervals.
Json exact_json(const SampleContact& contact) {
    Json list = Json::array();
    if (!contact.radius.standard_uncertainty) list.push_back("diameter");
    if (!contact.density.standard_uncertainty) list.push_back("density");
    if (contact.work_of_adhesion.value > 0 && !contact.work_of_adhesion.standard_uncertainty)
        list.push_back("work of adhesion");
    for (const auto& [parameter, value] : contact.parameters)
        if (!value.standard_uncertainty) list.push_back(parameter_words(parameter));
    return list;
}

/// Why laws have no damping from which a velocity would follow: the first remark of the fit on this sample,
/// or of the reading of its dampings.
std::string no_damping_reason(const Artifacts& before, const Sample& sample) {
    if (!sample.restitution) return "no impacts were given";
    for (const std::string_view file : {fit_artifact, damping_artifact})
        for (const Json& warning : before.at(file).document.at("warnings")) {
            const auto& text = warning.get_ref<const std::string&>();
            const auto colon = text.find(": ", sample.name.size());
            if (text.starts_with(sample.name + ", ") && colon != std::string::npos)
                return text.substr(colon + 2);
        }
    return "no damping follows from the impacts";
}

}  // namespace

StageOutput comparison_stage(const Artifacts& before) {
    const Case data = read_case_artifact(before);
    const Dimension dimension = dimension_of(data.damping_law);
    const auto moduli = before.read(modulus_artifact, read_moduli);
    const auto contacts = before.read(contact_artifact, read_contacts);
    const auto analytic = before.read(analytic_artifact, read_analytic);
    const auto dampings =
        before.read(damping_artifact, [&](const View& v) { return read_dampings(v, dimension); });
    const auto fits = before.read(fit_artifact, [&](const View& v) { return read_fits(v, dimension); });
    const auto velocities = before.read(critical_velocity_artifact, read_critical_velocities);
    const auto histories = before.read(histories_artifact, read_histories);

    StageOutput output{.citations = {"dong2013, Tables 1, 3 and 4, Eq. 30"}};
    output.result["case"] = data.name;
    output.result["samples"] = Json::array();
    Gap gap;
    for (const Sample& sample : data.samples) {
        const auto fractions = before.read(
            modulus_artifact, [&](const View& view) { return read_volume_fractions(view, sample.name); });
        const SampleResults of{sample,
                               entry_named(moduli, sample.name, before, modulus_artifact),
                               entry_named(fits, sample.name, before, fit_artifact).laws,
                               entry_named(velocities, sample.name, before, critical_velocity_artifact).laws,
                               entry_named(histories, sample.name, before, histories_artifact).contact_times,
                               fractions};
        const SampleAnalytic& simple = entry_named(analytic, sample.name, before, analytic_artifact);
        const SampleContact& contact = entry_named(contacts, sample.name, before, contact_artifact);
        for (const auto& [law, velocity] : of.velocities) gap.take(velocity, simple.critical_velocity);
        const DynamicColumns dynamic = dynamic_columns(of, data.laws);
        const Json& measured =
            entry_named(velocities, sample.name, before, critical_velocity_artifact).measured;
        const std::string no_damping = no_damping_reason(before, sample);
        Json json{
            {"name", sample.name},
            {"reported", reported_json({data.laws, of.velocities, contact.pair, measured, no_damping})},
            {"diameter", quantity_json(2 * contact.radius.value, Dimension::length)},
            {"density", contact.density},
            {"work_of_adhesion", contact.work_of_adhesion},
            {"assumed", assumed_json(sample, contact, data.wall)},
            {"taken_as_exact", exact_json(contact)},
            {"young_modulus", of.modulus.young_modulus},
            {"contact_modulus", quantity_json(contact.pair.contact_modulus, Dimension::pressure)},
            {"separation_energy", quantity_json(simple.separation_energy, Dimension::energy)},
            {"analytic_critical_velocity", quantity_json(simple.critical_velocity, Dimension::velocity)},
            {"dynamic_critical_velocity", dynamic.velocity},
            {"interval", dynamic.interval},
            {"verdict", dynamic.verdict},
            {"measured_critical_velocity", measured_json(sample, measured)},
            {"check", dynamic.check}};
        if (measured.is_object() && measured.contains("interval"))
            json["measured_interval"] = measured.at("interval");
        if (!dynamic.extrapolated.empty()) json["extrapolated_critical_velocity"] = dynamic.extrapolated;
        if (!dynamic.interval_note.empty()) json["interval_note"] = dynamic.interval_note;
        if (sample.published) json["published"] = published_beside_json(*sample.published, of);
        output.result["samples"].push_back(std::move(json));
    }
    if (Json equal = equal_velocities_json(data, contacts, dampings); !equal.empty())
        output.result["equal_velocities"] = std::move(equal);
    if (gap.known())
        output.result["dynamic_over_analytic"] = {{"least", gap.least_ratio},
                                                  {"greatest", gap.greatest_ratio}};
    output.result["conclusion"] = gap.sentence();
    return output;
}

}  // namespace ashimpact
