// SPDX-License-Identifier: GPL-3.0-or-later
// What a page calls: functions on files in emscripten's file system in memory. The page writes the case
// and what it names there, and reads artifacts and report from there. Each function returns one JSON object,
// docs/web.md.
#include <algorithm>
#include <filesystem>
#include <functional>
#include <sstream>
#include <string_view>
#include <vector>

#include <emscripten/emscripten.h>
#include <fmt/format.h>
#include <spdlog/details/null_mutex.h>
#include <spdlog/sinks/base_sink.h>
#include <spdlog/sinks/ostream_sink.h>
#include <spdlog/spdlog.h>

#include "core/json/document.hpp"
#include "core/json/view.hpp"
#include "core/plausibility.hpp"
#include "core/text/error.hpp"
#include "core/text/text.hpp"
#include "interface/law_inputs.hpp"
#include "materials/xrd/xrd.hpp"
#include "pipeline/app/contact/single_contact.hpp"
#include "pipeline/app/deposit/deposit.hpp"
#include "pipeline/app/run_stages.hpp"
#include "pipeline/case/case_parts.hpp"
#include "pipeline/case/case_reader.hpp"
#include "pipeline/document/edits.hpp"
#include "pipeline/document/results_json.hpp"
#include "pipeline/files/file.hpp"
#include "pipeline/present/report/drawing/figure.hpp"
#include "pipeline/present/report/figures/figures.hpp"
#include "pipeline/present/report/page/page.hpp"
#include "pipeline/present/text/result_text.hpp"
#include "pipeline/run/stage.hpp"
#include "solver/contact/law_parameters.hpp"
#include "solver/contact/pair.hpp"
#include "solver/critical_velocity/critical_velocity.hpp"
#include "solver/inference/impacts/measurement.hpp"
#include "solver/motion/impact.hpp"
#include "solver/motion/scale.hpp"

// Tells the page a line while a computation goes on, if it listens.
EM_JS(void, tell_page, (const char* line), {
    if (Module["onProgress"]) Module["onProgress"](UTF8ToString(line));
});

namespace ashimpact {

namespace {

/// Columns of the summary in a page.
constexpr std::size_t text_width = 100;

/// Hands on what is logged below the level of messages: which stage is done.
class ProgressSink : public spdlog::sinks::base_sink<spdlog::details::null_mutex> {
    void sink_it_(const spdlog::details::log_msg& line) override {
        if (line.level < spdlog::level::info)
            tell_page(std::string(line.payload.data(), line.payload.size()).c_str());
    }
    void flush_() override {}
};

/// The lines that a computation logs.
class Messages {
  public:
    Messages() {
        auto text = std::make_shared<spdlog::sinks::ostream_sink_st>(text_);
        text->set_level(spdlog::level::info);
        auto logger = std::make_shared<spdlog::logger>(
            "ashimpact", spdlog::sinks_init_list{text, std::make_shared<ProgressSink>()});
        logger->set_pattern("%v");
        logger->set_level(spdlog::level::debug);
        spdlog::set_default_logger(logger);
    }

    [[nodiscard]] Json lines() const {
        Json all = Json::array();
        std::istringstream text(text_.str());
        for (std::string line; std::getline(text, line);) all.push_back(line);
        return all;
    }

  private:
    std::ostringstream text_;
};

Json failure(int status, const std::exception& error) {
    return {{"status", status}, {"error", {{"message", error.what()}}}};
}

/// Runs a function of the page, with the exit status of the program. @return JSON, valid until the next call
const char* answered(const std::function<Json()>& work) {
    static std::string answer;
    const Messages messages;
    Json result;
    try {
        result = work();
        result["status"] = 0;
    } catch (const InputError& error) {
        result = failure(2, error);
        result["error"].update(
            {{"place", error.place()}, {"problem", error.problem()}, {"allowed", error.allowed()}});
    } catch (const ConvergenceError& error) {
        result = failure(3, error);
    } catch (const std::exception& error) {
        result = failure(1, error);
    }
    result["messages"] = messages.lines();
    answer = result.dump(-1, ' ', false, Json::error_handler_t::replace);
    return answer.c_str();
}

std::optional<std::string> case_named(const char* file) {
    return *file == '\0' ? std::nullopt : std::optional<std::string>(file);
}

/// What a page shows of a run before it opens an artifact.
Json shown(const RunSummary& run) {
    Json result{{"files", Json::array()}, {"samples", run.samples}, {"remarks", Json::array()}};
    for (const Artifact& artifact : run.written) {
        result["files"].push_back(artifact.file);
        if (artifact.file == comparison_artifact)
            result["text"] = comparison_text(artifact.document->at("result"), text_width, run.scope);
    }
    if (!run.report.empty()) result["files"].push_back(report::report_file);
    for (const RemarkLine& line : remark_lines(run.remarks, run.samples))
        result["remarks"].push_back({{"text", line.text}, {"decides", line.decides}});
    return result;
}

/// What was read of the impacts of each sample: how many rebounds, captures and unknown ones, the least and
/// the greatest velocity [m/s]; null where a sample has none.
Json impacts_read(const Case& data) {
    Json all = Json::array();
    for (const Sample& sample : data.samples) {
        all.push_back(nullptr);
        if (!sample.restitution) continue;
        const auto* measured = std::get_if<MeasuredRestitution>(&*sample.restitution);
        if (measured == nullptr || measured->impacts.points.empty()) continue;
        const MeasurementSet& impacts = measured->impacts;
        const auto [slowest, fastest] =
            std::ranges::minmax_element(impacts.points, {}, &Measurement::velocity);
        all.back() = {{"rebounds", impacts.rebounds()},
                      {"captures", impacts.captures()},
                      {"unknown", impacts.unknown},
                      {"from", slowest->velocity},
                      {"to", fastest->velocity}};
    }
    return all;
}

/// The case without its measured impacts, as a file beside it.
std::string without_impacts(const std::string& file) {
    Json document = at_place(FileName{file}, [&] { return parse_json(read_file(file)); });
    if (document.is_object() && document.contains("samples") && document.at("samples").is_array())
        for (Json& sample : document.at("samples"))
            if (sample.is_object()) sample.erase("restitution");
    const auto beside = std::filesystem::path(file).parent_path() / "without-impacts.json";
    write_file(beside, document.dump());
    return beside.string();
}

/// Why a reader does not take a file; none if it does.
std::optional<std::string> refusal(const std::function<void()>& reader) {
    try {
        reader();
        return std::nullopt;
    } catch (const InputError& error) {
        return error.what();
    }
}

/// The text of an option, a number as JSON has it. @throws InputError
std::string option_text(const std::string& key, const Json& value) {
    if (!value.is_number() && !value.is_string())
        throw InputError(key + " is " + value.dump(), "a number in SI, or a text");
    return value.is_string() ? value.get<std::string>() : fmt::format("{}", value.get<double>());
}

/// The options of `ashimpact impact` that are the keys of an object: contact_modulus is --contact-modulus.
CommandOptions options_of(const Json& contact) {
    std::vector<std::string> known{
        "--law",       "--detachment",      "--radius",           "--diameter",        "--density",
        "--mass",      "--partner-radius",  "--partner-diameter", "--partner-density", "--partner-mass",
        "--roughness", "--contact-modulus", "--work-of-adhesion", "--yield-pressure",  "--damping-law",
        "--damping",   "--velocity"};
    for (const LawParameter& parameter : law_parameters()) known.push_back(option_of(parameter));
    CommandOptions options;
    for (const auto& [key, value] : contact.items()) {
        if (key == "velocities" || key == "dampings") continue;
        std::string name = "--" + key;
        std::ranges::replace(name, '_', '-');
        if (std::ranges::find(known, name) == known.end()) throw InputError("unknown key " + in_quotes(key));
        options.text_of(name) = option_text(key, value);
    }
    return options;
}

Impact impact_of(const CommandOptions& options, double velocity) {
    const ContactChoice choice = read_contact(options);
    return choice.impact(read_damping(options, choice.contact), velocity);
}

/// Where no damping is stated, its scaled coefficient is 1 at this velocity [m/s].
constexpr double guess_velocity = 1;

/// One impact, as `ashimpact impact --json`. Keys are the options of that command, numbers in SI.
Json single_impact_json(const Json& contact) {
    const CommandOptions options = options_of(contact);
    const Impact impact = impact_of(options, options.positive("--velocity", Dimension::velocity));
    return impact_json(impact, solve_impact(impact));
}

/// The registered laws: `laws`, by name `title`, `by_default` (of a case that names none) and `parameters`,
/// each with `name`, `unit` (SI), `description`, `example` and `choice` (one of those with the same number,
/// not 0, is given); `damping_laws`, by name the `unit` (SI) of the coefficient.
Json laws_json() {
    const std::vector<Law> by_default = default_laws();
    Json laws = Json::object();
    for (std::size_t i = 0; i < Law::count(); ++i) {
        const Law law = Law::at(i);
        Json parameters = Json::array();
        for (const LawParameter& parameter : inputs_of(law))
            parameters.push_back({{"name", parameter.name},
                                  {"unit", si_unit(parameter.dimension)},
                                  {"description", parameter.description},
                                  {"example", parameter.example},
                                  {"choice", parameter.choice}});
        laws[law.name()] = {{"title", report::display_name(law.name())},
                            {"by_default", std::ranges::find(by_default, law) != by_default.end()},
                            {"parameters", parameters}};
    }
    Json dampings = Json::object();
    for (const DampingLaw law : all_values<DampingLaw>) dampings[name_of(law)] = {{"unit", unit_of(law)}};
    return {{"laws", laws}, {"damping_laws", dampings}};
}

/// Restitution at `velocities` [m/s] and critical velocity of one contact; other keys as above. `dampings`,
/// one for each velocity, replace `damping` in restitutions. Without `damping` a guess does: scaled
/// coefficient 1 at 1 m/s.
/// @return `restitution`, `critical_velocity` (null if there is none), `outside_model` (words in its place,
/// or null), `always_captured`, `damping`
Json curve_json(const Json& contact) {
    Impact impact = impact_of(options_of(contact), 1);
    if (!contact.contains("damping"))
        impact.damping.coefficient =
            Scale::of(impact.contact, guess_velocity).damping_coefficient(impact.damping.law, 1);
    const CriticalVelocity critical = critical_velocity({.law = impact.law,
                                                         .detachment = impact.detachment,
                                                         .damping = impact.damping,
                                                         .contact = impact.contact});
    Json curve{{"restitution", Json::array()},
               {"critical_velocity", critical.value ? Json(*critical.value) : Json(nullptr)},
               {"outside_model", critical.value && outside_model(*critical.value)
                                     ? Json(critical_velocity_text(*critical.value, ""))
                                     : Json(nullptr)},
               {"damping", impact.damping.coefficient},
               {"always_captured", critical.verdict == CaptureVerdict::always_captured}};
    const auto velocities = View(contact).at("velocities").column(Dimension::velocity);
    const auto stated = View(contact).find("dampings");
    const auto dampings = stated ? stated->column(dimension_of(impact.damping.law)) : std::vector<double>{};
    if (stated && dampings.size() != velocities.size())
        throw InputError("dampings are not as many as velocities", "one for each");
    for (std::size_t i = 0; i < velocities.size(); ++i) {
        impact.velocity = velocities[i];
        if (stated) impact.damping.coefficient = dampings[i];
        validate(impact);
        curve["restitution"].push_back(restitution_of(impact));
    }
    return curve;
}

}  // namespace

extern "C" {

/// All stages of a case, as `ashimpact run`; an empty @p case_file is the built-in case.
const char* ashimpact_run(const char* case_file, const char* folder) {
    return answered(
        [&] { return shown(run_stages({.case_file = case_named(case_file), .folder = folder})); });
}

/// What needs no measured impacts: modulus, contact, analytic critical velocity. No report.
const char* ashimpact_evaluate(const char* case_file, const char* folder) {
    return answered([&] {
        const LoadedCase loaded = load_case(case_file);  // whose messages name the case
        Json result =
            shown(run_stages({.case_file = without_impacts(case_file), .folder = folder, .report = false}));
        result["impacts"] = impacts_read(loaded.data);
        return result;
    });
}

/// Reads and checks a case and every file that it names.
const char* ashimpact_validate(const char* case_file) {
    return answered([&] {
        const LoadedCase loaded = load_case(case_named(case_file));
        Json samples = Json::array();
        for (const auto& sample : loaded.data.samples) samples.push_back(sample.name);
        Json warnings = Json::array();
        for (const SampleFinding& each : loaded.findings)
            warnings.push_back(text_of({.sample = each.sample, .text = each.finding.text}));
        return Json{{"name", loaded.data.name}, {"samples", samples}, {"warnings", warnings}};
    });
}

/// Which reader takes a table: "impacts" or "xrd" and how it was read, or "unknown" with the message of each
/// reader.
const char* ashimpact_kind(const char* file) {
    return answered([&] {
        const std::string bytes = read_file(file);
        std::string reading;
        const auto as_impacts = refusal([&] { reading = read_impacts(bytes, file).reading; });
        if (!as_impacts) return Json{{"kind", "impacts"}, {"read_as", reading}};
        const auto as_xrd = refusal([&] { reading = read_xrd(bytes, file).reading; });
        if (!as_xrd) return Json{{"kind", "xrd"}, {"read_as", reading}};
        return Json{{"kind", "unknown"}, {"impacts", *as_impacts}, {"xrd", *as_xrd}};
    });
}

/// The impacts of a table as columns of a case, velocity and rebound_velocity in m/s.
const char* ashimpact_impacts(const char* file) {
    return answered([&] { return measurement_columns(read_impacts(read_file(file), file)); });
}

/// Restitution and critical velocity of one contact, JSON in and out; see curve_json().
const char* ashimpact_curve(const char* contact) {
    return answered([&] { return curve_json(parse_json(contact)); });
}

/// What each law takes; see laws_json().
const char* ashimpact_laws() {
    return answered(laws_json);
}

/// One impact, JSON in and out; see single_impact_json().
const char* ashimpact_impact(const char* contact) {
    return answered([&] { return single_impact_json(parse_json(contact)); });
}

/// What stays on a tube, as `ashimpact deposit RUN_DIR -o folder`: @p options has the command's options by
/// their names and the folder of the run as "run".
const char* ashimpact_deposit(const char* options, const char* folder) {
    return answered([&] {
        const Json given = parse_json(options);
        CommandOptions typed;
        for (const auto& [key, value] : given.items()) typed.text_of(key) = option_text(key, value);
        typed.text_of("--output") = folder;
        Json files = Json::array();
        for (const auto& file : write_deposition(typed, {}).files) files.push_back(file.filename().string());
        return Json{{"files", files}};
    });
}

/// One figure of a finished run as SVG, @p width "single" or "double".
const char* ashimpact_figure(const char* folder, const char* name, const char* width) {
    return answered([&] {
        const report::RunData run(read_run(load_artifacts(folder, report::report_artifacts())), "");
        const report::Figure figure = report::figure_named(name, run);
        const auto wide = std::string_view(width) == "single" ? report::Width::narrow : report::Width::wide;
        return Json{{"svg", figure.panels.empty() ? "" : report::svg_of(figure, wide)},
                    {"title", figure.title},
                    {"caption", figure.caption}};
    });
}
}

}  // namespace ashimpact
