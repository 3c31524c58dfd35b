// SPDX-License-Identifier: GPL-3.0-or-later
// What a page calls: functions on files in emscripten's file system in memory. The page writes the case
// and what it names there, and reads artifacts and report from there. Each function returns one JSON object,
// docs/web.md.
#include <algorithm>
#include <filesystem>
#include <functional>
#include <sstream>

#include <emscripten/emscripten.h>
#include <spdlog/details/null_mutex.h>
#include <spdlog/sinks/base_sink.h>
#include <spdlog/sinks/ostream_sink.h>
#include <spdlog/spdlog.h>

#include "core/json/document.hpp"
#include "core/text/error.hpp"
#include "interface/web/single_contact.hpp"
#include "materials/xrd/xrd.hpp"
#include "pipeline/app/run_stages.hpp"
#include "pipeline/case/case_reader.hpp"
#include "pipeline/document/artifact.hpp"
#include "pipeline/document/results_json.hpp"
#include "pipeline/files/file.hpp"
#include "pipeline/present/report/drawing/figure.hpp"
#include "pipeline/present/report/figures/figures.hpp"
#include "pipeline/present/report/page/page.hpp"
#include "pipeline/present/text/result_text.hpp"
#include "pipeline/run/stage.hpp"
#include "solver/inference/impacts/measurement.hpp"

// Tells the page a line while a computation goes on, if it listens.
EM_JS(void, tell_page, (const char* line), {
    if (Module["onProgress"]) Module["onProgress"](UTF8ToString(line));
});

namespace {

using ashimpact::Json;

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

/// Runs a function of the page; its exit status and errors are those of the program.
/// @return JSON text, valid until the next call
const char* answered(const std::function<Json()>& work) {
    static std::string answer;
    const Messages messages;
    Json result;
    try {
        result = work();
        result["status"] = 0;
    } catch (const ashimpact::InputError& error) {
        result = failure(2, error);
        result["error"].update(
            {{"place", error.place()}, {"problem", error.problem()}, {"allowed", error.allowed()}});
    } catch (const ashimpact::ConvergenceError& error) {
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
Json shown(const ashimpact::RunSummary& run) {
    Json result{{"files", Json::array()}, {"samples", run.samples}, {"remarks", Json::array()}};
    for (const ashimpact::Artifact& artifact : run.written) {
        result["files"].push_back(artifact.file);
        if (artifact.file == ashimpact::comparison_artifact)
            result["text"] = ashimpact::comparison_text(artifact.document.at("result"), text_width);
    }
    if (!run.report.empty()) result["files"].push_back(ashimpact::report::report_file);
    for (const ashimpact::RemarkLine& line : ashimpact::remark_lines(run.remarks, run.samples))
        result["remarks"].push_back({{"text", line.text}, {"decides", line.decides}});
    return result;
}

/// What was read of the impacts of each sample: how many rebounds, captures and unknown ones, the least and
/// the greatest velocity [m/s]; null where a sample has none.
Json impacts_read(const ashimpact::Case& data) {
    Json all = Json::array();
    for (const ashimpact::Sample& sample : data.samples) {
        all.push_back(nullptr);
        if (!sample.restitution) continue;
        const auto* measured = std::get_if<ashimpact::MeasuredRestitution>(&*sample.restitution);
        if (measured == nullptr || measured->impacts.points.empty()) continue;
        const ashimpact::MeasurementSet& impacts = measured->impacts;
        const auto [slowest, fastest] =
            std::ranges::minmax_element(impacts.points, {}, &ashimpact::Measurement::velocity);
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
    Json document = ashimpact::at_place(ashimpact::FileName{file},
                                        [&] { return ashimpact::parse_json(ashimpact::read_file(file)); });
    if (document.is_object() && document.contains("samples") && document.at("samples").is_array())
        for (Json& sample : document.at("samples"))
            if (sample.is_object()) sample.erase("restitution");
    const auto beside = std::filesystem::path(file).parent_path() / "without-impacts.json";
    ashimpact::write_file(beside, document.dump());
    return beside.string();
}

/// Why a reader does not take a file; none if it does.
std::optional<std::string> refusal(const std::function<void()>& reader) {
    try {
        reader();
        return std::nullopt;
    } catch (const ashimpact::InputError& error) {
        return error.what();
    }
}

}  // namespace

extern "C" {

/// All stages of a case, as `ashimpact run`; an empty @p case_file is the built-in case.
const char* ashimpact_run(const char* case_file, const char* folder) {
    return answered(
        [&] { return shown(ashimpact::run_stages({.case_file = case_named(case_file), .folder = folder})); });
}

/// What needs no measured impacts: modulus, contact, analytic critical velocity. No report.
const char* ashimpact_evaluate(const char* case_file, const char* folder) {
    return answered([&] {
        const ashimpact::LoadedCase loaded = ashimpact::load_case(case_file);  // whose messages name the case
        Json result = shown(ashimpact::run_stages(
            {.case_file = without_impacts(case_file), .folder = folder, .report = false}));
        result["impacts"] = impacts_read(loaded.data);
        return result;
    });
}

/// Reads and checks a case and every file that it names.
const char* ashimpact_validate(const char* case_file) {
    return answered([&] {
        const ashimpact::LoadedCase loaded = ashimpact::load_case(case_named(case_file));
        Json samples = Json::array();
        for (const auto& sample : loaded.data.samples) samples.push_back(sample.name);
        Json warnings = Json::array();
        for (const ashimpact::SampleFinding& each : loaded.findings)
            warnings.push_back(ashimpact::text_of({.sample = each.sample, .text = each.finding.text}));
        return Json{{"name", loaded.data.name}, {"samples", samples}, {"warnings", warnings}};
    });
}

/// What a table is, told by the reader that takes it: "impacts" or "xrd". Where none does, "unknown", and the
/// message of each reader.
const char* ashimpact_kind(const char* file) {
    return answered([&] {
        const std::string bytes = ashimpact::read_file(file);
        const auto as_impacts =
            refusal([&] { static_cast<void>(ashimpact::read_measurements(bytes, file)); });
        if (!as_impacts) return Json{{"kind", "impacts"}};
        const auto as_xrd = refusal([&] { static_cast<void>(ashimpact::read_xrd(bytes, file)); });
        if (!as_xrd) return Json{{"kind", "xrd"}};
        return Json{{"kind", "unknown"}, {"impacts", *as_impacts}, {"xrd", *as_xrd}};
    });
}

/// The impacts of a table as columns of a case, velocity and rebound_velocity in m/s.
const char* ashimpact_impacts(const char* file) {
    return answered([&] {
        return ashimpact::measurement_columns(ashimpact::read_measurements(ashimpact::read_file(file), file),
                                              true);
    });
}

/// Restitution and critical velocity of one contact, JSON in and out; single_contact.hpp has the keys.
const char* ashimpact_curve(const char* contact) {
    return answered([&] { return ashimpact::curve_json(ashimpact::parse_json(contact)); });
}

/// What each law takes; single_contact.hpp has the keys.
const char* ashimpact_laws() {
    return answered(ashimpact::laws_json);
}

/// One impact, JSON in and out; single_contact.hpp has the keys.
const char* ashimpact_impact(const char* contact) {
    return answered([&] { return ashimpact::single_impact_json(ashimpact::parse_json(contact)); });
}

/// One figure of a finished run as SVG, @p width "single" or "double".
const char* ashimpact_figure(const char* folder, const char* name, const char* width) {
    return answered([&] {
        namespace report = ashimpact::report;
        const report::RunData run(
            ashimpact::read_run(ashimpact::load_artifacts(folder, report::report_artifacts())), "");
        const report::Figure figure = report::figure_named(name, run);
        const auto wide = std::string_view(width) == "single" ? report::Width::narrow : report::Width::wide;
        return Json{{"svg", figure.panels.empty() ? "" : report::svg_of(figure, wide)},
                    {"title", figure.title},
                    {"caption", figure.caption}};
    });
}
}
