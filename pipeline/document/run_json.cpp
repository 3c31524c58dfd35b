// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/document/run_json.hpp"

#include <algorithm>

#include "core/text/text.hpp"
#include "materials/separation_energy.hpp"
#include "pipeline/case/case_reader.hpp"
#include "pipeline/document/case_json.hpp"
#include "pipeline/document/results_json.hpp"
#include "pipeline/files/sha256.hpp"
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
    for (const View& input : provenance.at("inputs").elements())
        run.inputs.push_back({input.at("file").text(), input.at("sha256").text()});
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
                {"flatness", data.fit.flatness},
                {"outlier", data.fit.outlier}};
    if (file == fit_artifact)
        return {{"order", data.fit.order},
                {"robust", data.fit.robust},
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
        const View document(artifact.document);
        part_of(file).read(document, run);
        run.records.push_back({.stage = document.at("stage").text(),
                               .file = artifact.file,
                               .sha256 = sha256(artifact.bytes),
                               .citations = document.at("citations").texts(),
                               .notes = read_notes(document)});
    });
}

Run read_run(const Artifacts& artifacts) {
    Run run;
    for (const Part& each : parts())
        if (artifacts.has(each.file)) read_artifact(artifacts, each.file, run);
    return run;
}

}  // namespace ashimpact
