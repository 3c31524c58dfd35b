// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/case/unused_statements.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <variant>

#include "core/text/text.hpp"
#include "solver/contact/law_parameters.hpp"

namespace ashimpact {

namespace {

/// Why a statement counts for nothing; none if it counts.
using Reason = std::optional<std::string>;

bool is_measured(const Sample& sample) {
    return sample.restitution && std::holds_alternative<MeasuredRestitution>(*sample.restitution);
}

template <class Test>
bool any_sample(const Case& data, const Test& test) {
    return std::ranges::any_of(data.samples, test);
}

Reason reason_if(bool applies, const char* reason) {
    return applies ? Reason(reason) : std::nullopt;
}

// Statements of the whole case.

Reason without_restitution(const Case& data) {
    return reason_if(!any_sample(data, [](const Sample& sample) { return sample.restitution.has_value(); }),
                     "no sample has restitution data");
}

Reason without_measured(const Case& data) {
    return reason_if(!any_sample(data, is_measured), "no sample has measured impacts");
}

/// Fits to measured impacts and the propagation into v_c are for constant damping.
Reason without_constant_damping(const Case& data) {
    return reason_if(data.damping_law != DampingLaw::constant, "that takes constant damping");
}

Reason of_extrapolation(const Case& data) {
    const Reason reason = without_measured(data);
    return reason ? reason : without_constant_damping(data);
}

Reason of_propagation(const Case& data) {
    const Reason reason = without_restitution(data);
    return reason ? reason : without_constant_damping(data);
}

Reason of_wall(const Case& data) {
    return reason_if(
        !any_sample(data, [](const Sample& sample) { return !sample.contact_modulus.has_value(); }),
        "every sample states its contact_modulus");
}

Reason of_camera(const Case& data) {
    if (const Reason reason = without_measured(data)) return reason;
    const auto takes = [](const Sample& sample) {
        return is_measured(sample) && std::get<MeasuredRestitution>(*sample.restitution).by_camera_of_case;
    };
    return reason_if(!any_sample(data, takes),
                     "the impacts of every sample state their uncertainty or a camera of their own");
}

Reason of_published(const Case& data) {
    return reason_if(!any_sample(data, [](const Sample& sample) { return sample.published.has_value(); }),
                     "it has values of none of the samples");
}

Reason of_detachments(const Case& data) {
    const bool all_default = std::ranges::all_of(data.laws, [](const LawChoice& choice) {
        return choice.detachment == choice.law.default_detachment();
    });
    return all_default ? std::nullopt : without_restitution(data);
}

struct CaseStatement {
    std::string_view object;
    std::string_view member;  ///< of the object; empty: the object itself
    Reason (*reason)(const Case& data);
    /// The default as JSON; empty: there is none.
    std::string_view otherwise{};
};

constexpr std::array case_statements{
    CaseStatement{"wall", "", of_wall},
    CaseStatement{"partner", "young_modulus", of_wall},
    CaseStatement{"partner", "poisson_ratio", of_wall},
    CaseStatement{"partner", "rigid", of_wall},
    CaseStatement{"partner", "contact_modulus", of_wall},
    CaseStatement{"camera", "", of_camera},
    CaseStatement{"published", "", of_published},
    CaseStatement{"detachments", "", of_detachments},
    CaseStatement{"friction", "", without_restitution},
    CaseStatement{"damping_law", "", without_restitution, "\"constant\""},
    CaseStatement{"paper_explicit", "", of_propagation},
    CaseStatement{"histories", "points", without_restitution, "49"},
    CaseStatement{"histories", "critical_excess", without_restitution, "0.001"},
    CaseStatement{"fit", "order", of_extrapolation, "2"},
    CaseStatement{"fit", "robust", of_extrapolation, "false"},
    CaseStatement{"fit", "size_scatter", of_extrapolation},
    CaseStatement{"fit", "velocity_scale_uncertainty", of_extrapolation},
    CaseStatement{"fit", "flatness", without_restitution, "0.25"},
    CaseStatement{"fit", "outlier", without_restitution, "4"},
    CaseStatement{"fit", "direct_order", [](const Case&) { return Reason("it is of earlier versions"); }},
    CaseStatement{"uncertainty", "samples", of_propagation, "128"},
    CaseStatement{"uncertainty", "replicates", of_propagation, "8"},
    CaseStatement{"uncertainty", "seed", of_propagation, "1"},
    CaseStatement{"uncertainty", "damping", of_extrapolation, "\"reread\""},
};

// Statements of a particle, for each sample.

Reason of_poisson_ratio(const Case& data, const Sample& sample) {
    if (sample.contact_modulus) return "the contact_modulus of the sample is stated";
    return reason_if(data.wall && std::holds_alternative<Stated>(*data.wall),
                     "the contact_modulus of both bodies is stated");
}

/// By the laws of the case. The yield pressure counts under each of them: a run reports where a contact
/// yields.
Reason of_laws(const Case& data, std::string_view name) {
    if (name == "yield_pressure") return std::nullopt;
    std::vector<Law> laws;
    for (const LawChoice& choice : data.laws) laws.push_back(choice.law);
    return idle_reason(laws, data.damping_law, name);
}

Reason of_particle(std::string_view key, const Case& data, const Sample& sample) {
    return key == "poisson_ratio" ? of_poisson_ratio(data, sample) : of_laws(data, key);
}

class UnusedStatements {
  public:
    UnusedStatements(const View& document, const Case& data) : document_(document), data_(data) {}

    std::vector<SampleFinding> find() {
        for (const CaseStatement& statement : case_statements) add_of_case(statement);
        const std::vector<View> samples = document_.at("samples").elements();
        if (const auto particle = document_.find("particle"))
            for (const auto& [key, value] : particle->members()) add_of_all(key, value, samples);
        if (const auto adhesion = document_.find("work_of_adhesion"))
            add_of_all("work_of_adhesion", *adhesion, samples);
        if (const auto roughness = document_.find("roughness"))
            add(*roughness, "no impact", of_laws(data_, "work_of_adhesion"));
        for (std::size_t i = 0; i < samples.size(); ++i) add_of_sample(samples[i], data_.samples[i]);
        add_of_phases();
        return std::move(findings_);
    }

  private:
    void add(const View& statement, const char* what, const Reason& reason, const std::string& sample = {}) {
        if (reason)
            findings_.push_back({sample,
                                 {unused_code, Severity::remark,
                                  statement.pointer() + " changes " + what + ", as " + *reason}});
    }

    void add_of_case(const CaseStatement& statement) {
        const auto object = document_.find(statement.object);
        const auto node = object && !statement.member.empty() ? object->find(statement.member) : object;
        if (!node) return;
        if (statement.otherwise.empty() || node->json() != Json::parse(statement.otherwise))
            add(*node, "nothing", statement.reason(data_));
    }

    /// A statement for samples that do not have their own.
    void add_of_all(const std::string& key, const View& statement, const std::vector<View>& samples) {
        Reason last = "every sample states its own";
        for (std::size_t i = 0; i < samples.size(); ++i) {
            if (samples[i].find(key)) continue;
            last = of_particle(key, data_, data_.samples[i]);
            if (!last) break;
        }
        add(statement, "no impact", last);
    }

    void add_of_sample(const View& node, const Sample& sample) {
        for (const auto& [key, value] : node.members())
            add(value, "no impact", of_particle(key, data_, sample), sample.name);
    }

    void add_of_phases() {
        const auto phases = document_.find("phases");
        if (!phases) return;
        std::vector<std::string> names;
        for (const View& phase : phases->elements()) names.push_back(phase.at("name").text());
        std::erase_if(names, [&](const std::string& name) {
            return std::ranges::find(data_.phases, name, &Phase::name) != data_.phases.end();
        });
        if (!names.empty())
            findings_.push_back({{},
                                 {unused_code, Severity::remark,
                                  "phases of " + phases->pointer() + " that no sample has change nothing (" +
                                      joined(names) + ")"}});
    }

    const View& document_;
    const Case& data_;
    std::vector<SampleFinding> findings_;
};

}  // namespace

std::vector<SampleFinding> unused_statements(const View& document, const Case& data) {
    return UnusedStatements(document, data).find();
}

}  // namespace ashimpact
