// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <csignal>
#include <ostream>
#include <variant>

#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include "core/json/document.hpp"
#include "core/json/view.hpp"
#include "core/text/error.hpp"
#include "core/text/text.hpp"
#include "core/version.hpp"
#include "pipeline/app/sweep/spec/impacts.hpp"
#include "pipeline/app/sweep/sweep.hpp"
#include "pipeline/app/sweep/workers.hpp"
#include "pipeline/app/terminal.hpp"
#include "pipeline/document/artifact.hpp"
#include "pipeline/files/file.hpp"
#include "pipeline/files/schema.hpp"
#include "pipeline/present/report/page/page.hpp"
#include "pipeline/present/report/sweep/sweep_page.hpp"
#include "pipeline/present/text/result_text.hpp"

namespace ashimpact {

namespace {

constexpr auto another = "another -o";

[[noreturn]] void refuse(const std::filesystem::path& file, const char* problem, const char* allowed) {
    throw InputError(problem, allowed).at(FileName{file.string()});
}

void check_result(const std::filesystem::path& result) {
    if (result.extension() == ".h5")
        refuse(result, "would be the full table", "a JSON file, such as sweep.json; -o");
    if (result.extension() == ".html")
        refuse(result, "would be the report", "a JSON file, such as sweep.json; -o");
    const auto status = std::filesystem::status(result);
    if (std::filesystem::is_directory(status)) refuse(result, "is a folder", "a file; -o");
    if (std::filesystem::exists(status) && !std::filesystem::is_regular_file(status))
        refuse(result, "is no regular file, and others are written beside it", "a file; -o");
    const auto folder = result.parent_path();
    require_writable_folder(folder.empty() ? "." : folder);
}

/// A sweep may replace its own table, even after an edit of its spec, but not that of another result.
void check_table(const SweepFiles& files, const SweepPlan& plan) {
    if (!std::filesystem::exists(files.table)) return;
    const auto spec = spec_of_table(files.table);
    if (!spec) refuse(files.table, "is there already and is no table of a sweep", another);
    if (*spec != plan.hash() && !std::filesystem::exists(files.result))
        refuse(files.table, "is there already and is the table of another sweep", another);
}

/// Refuses a table that the disk has no room for: 6.5 bytes for each random number, which does not compress,
/// 0.08 for others; rows stand beside the table until it is written.
void check_room(const SweepFiles& files, const SweepPlan& plan) {
    double random = 0;
    for (const SweepVariable& variable : plan.spec().variables)
        random += std::holds_alternative<Choice>(variable.distribution) ? 0 : 1;
    const auto columns = static_cast<double>(plan.table_columns().size());
    const double row = 6.5 * random + 0.08 * (columns - random);
    const double needed = 2 * row * static_cast<double>(plan.rows());
    std::error_code failure;
    const auto folder = std::filesystem::absolute(files.table, failure).parent_path();
    const auto space = std::filesystem::space(folder, failure);
    if (failure || needed <= static_cast<double>(space.available)) return;
    const auto gigabytes = [](double bytes) { return shortest(std::round(bytes / 1e8) / 10) + " GB"; };
    throw InputError("a table of " + std::to_string(plan.rows()) + " rows takes " + gigabytes(needed) +
                         " or more, and " + gigabytes(static_cast<double>(space.available)) + " are free",
                     "fewer samples, no \"table\", or a larger disk; -o")
        .at(FileName{files.table.string()});
}

/// Whether a file is there and does not begin as a sweep's own do. Another sweep that ends meanwhile removes
/// its own.
bool is_foreign(const std::filesystem::path& file, std::string_view mark) {
    constexpr std::size_t enough = 64;
    if (!std::filesystem::exists(file)) return false;
    try {
        const std::string start = read_start(file, enough);
        return start.find(mark) == std::string::npos && !mark.starts_with(start);
    } catch (const InputError&) {
        if (!std::filesystem::exists(file)) return false;
        throw;
    }
}

/// Checks that outputs can be written and replace only files of this sweep. @throws InputError naming the
/// file
void check_outputs(const SweepFiles& files, const std::filesystem::path& spec, const SweepPlan& plan,
                   bool with_report) {
    const bool with_table = !plan.spec().table.empty();
    check_result(files.result);
    for (const auto& file : {files.result, files.checkpoint, files.rows, files.table})
        if ((with_table || file != files.table) && is_same_file(file, spec))
            refuse(file, "is the spec, which would be lost", another);
    require_replaceable(files.result, R"({"schema": "sweep-result"})");
    if (with_report && std::filesystem::exists(files.report) && !report::is_own_page(files.report))
        refuse(files.report, "is there already and is no report of ours", "another -o, or --no-report");
    if (with_table) check_table(files, plan);
    if (with_table) check_room(files, plan);
    if (is_foreign(files.rows, row_log_mark))
        refuse(files.rows, "is there already and holds no rows of a sweep", another);
    if (is_foreign(files.checkpoint, checkpoint_mark))
        refuse(files.checkpoint, "is there already and is no checkpoint", another);
}

volatile std::sig_atomic_t interrupting_signal = 0;

/// Makes SIGINT and SIGTERM request a stop, so that finished work is saved; a second signal ends the program.
void stop_on_signals() {
    struct sigaction action {};
    action.sa_handler = [](int signal) { interrupting_signal = signal; };
    action.sa_flags = static_cast<int>(SA_RESETHAND);
    for (const int signal : {SIGINT, SIGTERM}) sigaction(signal, &action, nullptr);
}

/// Ends the program by the signal that interrupted it, so that the shell sees that signal.
[[noreturn]] void end_by_signal() {
    std::signal(interrupting_signal, SIG_DFL);
    std::raise(interrupting_signal);
    std::abort();
}

/// Removes the checkpoint of a sweep, and temporary files that it left when it was killed.
void remove_leftovers(const SweepFiles& files) {
    std::error_code ignored;
    std::filesystem::remove(files.checkpoint, ignored);
    const std::string own = "." + files.result.filename().string() + ".";
    const auto folder = std::filesystem::absolute(files.result, ignored).parent_path();
    for (const auto& entry : std::filesystem::directory_iterator(folder, ignored)) {
        const std::string name = entry.path().filename().string();
        if (name.starts_with(own) && name.ends_with(".tmp")) std::filesystem::remove(entry.path(), ignored);
    }
}

/// One line of results for each law, and the files written.
std::string summary(const Json& artifact, const SweepFiles& files, const SweepPlan& plan) {
    std::string text;
    for (const Json& law : artifact.at("result").at("laws"))
        text += fmt::format("{}: {} impacts, {} captured ({:.4g} %{})\n", law.at("law").get<std::string>(),
                            law.at("impacts").get<std::uint64_t>(), law.at("captured").get<std::uint64_t>(),
                            100 * law.at("capture_fraction").at("value").get<double>(),
                            report::captures_words(law));
    text += files.result.string();
    if (!plan.spec().table.empty()) text += fmt::format(", {}: {} rows", files.table.string(), plan.rows());
    return text +
           fmt::format("; as tables:\n  {} inspect {}\n", program_word(), shell_word(files.result.string()));
}

/// Writes the report or removes an old one; a failure is only a warning. @returns whether there is a report
bool write_report(const CommandOptions& options, const Json& artifact, const SweepFiles& files) {
    if (!options.has("--no-report")) {
        try {
            write_file(files.report, report::sweep_page(artifact, capture_fractions(artifact),
                                                        files.result.filename().string()));
            return true;
        } catch (const InputError& error) {
            spdlog::warn("warning: no report: {}", error.what());
        } catch (const ConvergenceError& error) {
            spdlog::warn("warning: no report: {}", error.what());
        }
    }
    std::error_code ignored;
    if (report::is_own_page(files.report)) std::filesystem::remove(files.report, ignored);
    return false;
}

/// Rank 0: everything but the blocks other ranks compute. @returns whether all is done
bool lead(const CommandOptions& options, const SweepPlan& plan, const InputFile& spec, Workers& workers,
          std::ostream& out) {
    const SweepFiles files = SweepFiles::beside(options["--output"]);
    make_folder(files.result.parent_path());
    RowLog rows(files.rows);
    if (options.has("--restart")) {
        remove_leftovers(files);
        rows.clear();
    }
    SweepProgress progress = load_checkpoint(files.checkpoint, plan).value_or(SweepProgress{});
    const SweepCare care{.checkpoint_interval = options.number("--checkpoint", Dimension::fraction),
                         .show_progress = options.has("--progress") || on_terminal(),
                         .interrupted = [] { return interrupting_signal != 0; }};
    if (!complete(progress, plan, files, rows, workers, care)) return false;
    if (!plan.spec().table.empty()) write_table(files.table, plan, files.rows);
    const Json artifact = sweep_artifact(plan, progress, spec);
    write_file(files.result, write_json(artifact));
    remove_leftovers(files);
    rows.clear();
    out << summary(artifact, files, plan);
    if (write_report(options, artifact, files)) out << "Report: " << files.report.string() << '\n';
    return true;
}

/// A quantity with its standard uncertainty, where there is one.
Json with_error(double value, Dimension dimension, const std::optional<double>& error) {
    Json json = quantity_json(value, dimension);
    if (error) json["standard_uncertainty"] = *error;
    return json;
}

/// One law's results as JSON.
class LawResult {
  public:
    LawResult(const SweepPlan& plan, const LawSums& sums, const std::vector<Histogram>& counts,
              std::uint64_t failed)
        : plan_(plan), sums_(sums), counts_(counts), failed_(failed) {}

    /// @param outside share of the captures whose v_c is outside the model
    [[nodiscard]] Json json(const LawChoice& choice, const OutsideShare& outside) const {
        Json law{{"law", choice.law.name()},
                 {"detachment", name_of(choice.detachment)},
                 {"method", name_of(plan_.wanted(choice.law).method)},
                 {"impacts", counts_.front().total()},
                 {"captured", counts_.front().total() - counts_.front().zeros()},
                 {"not_converged", failed_},
                 {"capture_fraction", with_error(whole(0).mean, Dimension::fraction, error_of_mean(0))},
                 {"observables", Json::array()}};
        if (outside.fraction > 0) {
            const double captured = whole(0).mean;
            law["captured_outside_model"] = with_error(
                outside.fraction * captured, Dimension::fraction,
                outside.uncertainty > 0 ? std::optional(outside.uncertainty * captured) : std::nullopt);
        }
        for (std::size_t i = 1; i < plan_.spec().statistics.size(); ++i)
            law["observables"].push_back(observable(i));
        if (plan_.with_sensitivity()) law["sensitivity"] = sensitivity();
        return law;
    }

  private:
    /// Moments of an observable over all groups.
    [[nodiscard]] Moments whole(std::size_t i) const {
        Moments moments;
        for (const Moments& group : sums_.observables[i]) moments.merge(group);
        return moments;
    }

    /// From the variance of random points, the spread of quasi-random copies; none of a grid. Copies that
    /// hold the same number of captures still leave an error of one impact among all of them.
    [[nodiscard]] std::optional<double> error_of_mean(std::size_t i) const {
        if (plan_.spec().sampling.method == SamplingMethod::random) {
            const Moments moments = whole(i);
            if (moments.count < 2) return std::nullopt;
            return std::sqrt(moments.variance() / static_cast<double>(moments.count));
        }
        std::vector<double> means;
        for (const Moments& group : sums_.observables[i])
            if (group.count > 0) means.push_back(group.mean);
        if (means.size() < 2) return std::nullopt;
        const double spread = std::sqrt(Moments::of(means).variance() / static_cast<double>(means.size()));
        const double one_impact = 1 / static_cast<double>(whole(i).count);
        return i == 0 ? std::max(spread, one_impact) : spread;
    }

    [[nodiscard]] Json observable(std::size_t i) const {
        const ObservableStatistics& statistics = plan_.spec().statistics[i];
        const Dimension dimension = dimension_of(statistics.observable);
        const Bins& bins = statistics.bins;
        const Moments moments = whole(i);
        const bool any = moments.count > 0;
        const bool spread = moments.count > 1;
        const bool shaped = spread && moments.second > 0;
        Json json{
            {"name", name_of(statistics.observable)},
            {"of", captures_count(statistics.observable) ? "all impacts" : "rebounds"},
            {"count", moments.count},
            {"mean", any ? with_error(moments.mean, dimension, error_of_mean(i)) : Json()},
            {"standard_deviation", spread ? quantity_json(std::sqrt(moments.variance()), dimension) : Json()},
            {"skewness", shaped ? Json(moments.skewness()) : Json()},
            {"excess_kurtosis", shaped ? Json(moments.excess_kurtosis()) : Json()},
            {"minimum", any ? quantity_json(moments.minimum, dimension) : Json()},
            {"maximum", any ? quantity_json(moments.maximum, dimension) : Json()},
            {"resolution",
             {{"kind", bins.is_relative() ? "relative" : "absolute"},
              {"value", bins.resolution()},
              {"unit", "1"}}},
            {"quantiles", Json::array()}};
        if (counts_[i].total() == 0) return json;
        for (const double probability : statistics.quantiles) {
            const auto [lower, upper] = counts_[i].quantile(bins, probability);
            json["quantiles"].push_back({{"probability", probability},
                                         {"lower", quantity_json(lower, dimension)},
                                         {"upper", quantity_json(upper, dimension)}});
        }
        json["histogram"] = histogram(counts_[i], bins, dimension);
        return json;
    }

    static Json histogram(const Histogram& histogram, const Bins& bins, Dimension dimension) {
        std::vector<double> edges;
        if (!histogram.counts().empty())
            for (std::size_t bin = 0; bin <= histogram.counts().size(); ++bin)
                edges.push_back(bins.edge(histogram.first() + static_cast<std::uint32_t>(bin)));
        return {{"zeros", histogram.zeros()},
                {"edges", column_json(edges, dimension)},
                {"counts", histogram.counts()}};
    }

    [[nodiscard]] Json sensitivity() const {
        Json list = Json::array();
        for (std::size_t i = 0; i < plan_.spec().sensitivity.size(); ++i) {
            const auto indices = sobol_indices(sums_.sensitivity[i]);
            Json json{{"of", name_of(plan_.spec().sensitivity[i])}, {"indices", Json::array()}};
            for (std::size_t variable = 0; variable < indices.size(); ++variable)
                json["indices"].push_back({{"variable", name_of(plan_.spec().variables[variable].input)},
                                           {"first", with_error(indices[variable].first, Dimension::fraction,
                                                                indices[variable].first_error)},
                                           {"total", with_error(indices[variable].total, Dimension::fraction,
                                                                indices[variable].total_error)}});
            list.push_back(std::move(json));
        }
        return list;
    }

    const SweepPlan& plan_;
    const LawSums& sums_;
    const std::vector<Histogram>& counts_;
    std::uint64_t failed_;
};

/// The first impacts that did not converge, each with the command that computes it alone.
Json failures_json(const SweepPlan& plan, const FailedImpacts& failed) {
    Json list = Json::array();
    for (const FailedImpacts::Listed& each : failed.listed)
        list.push_back({{"law", plan.spec().laws[each.law].law.name()},
                        {"row", each.row},
                        {"reason", each.reason},
                        {"command", each.command}});
    return {{"count", failed.total()}, {"listed", std::move(list)}};
}

Json citations_of(const SweepPlan& plan) {
    Json citations = Json::array();
    const SamplingMethod method = plan.spec().sampling.method;
    if (method == SamplingMethod::random)
        citations.push_back("Salmon, Moraes, Dror & Shaw 2011, doi 10.1145/2063384.2063405 (random points)");
    if (method == SamplingMethod::quasi_random)
        citations.push_back(
            plan.spec().sampling.sequence == QuasiRandomSequence::sobol
                ? "Joe & Kuo 2008, doi 10.1137/070709359 (quasi-random points)"
                : "Bratley, Fox & Niederreiter 1994, doi 10.1145/198429.198436 (quasi-random points)");
    if (plan.with_sensitivity())
        citations.push_back(
            "Saltelli et al. 2010, doi 10.1016/j.cpc.2009.09.018; Jansen 1999, doi "
            "10.1016/S0010-4655(98)00154-4 (Sobol indices)");
    return citations;
}

}  // namespace

void run_sweep_command(const CommandOptions& options, MpiSession& session, const ImpactSolver& solver,
                       std::ostream& out) {
    session.join();
    std::string text;
    if (session.rank() == 0) {
        text = read_file(options["spec"]);
        const SweepPlan checked = at_place(FileName{options["spec"]}, [&] { return SweepPlan(text); });
        for (const std::string& warning : checked.spec().warnings) spdlog::warn("warning: {}", warning);
        for (const std::string& warning :
             warnings_of_impacts(checked.spec(), captures_outside_model(checked.spec())))
            spdlog::warn("warning: {}", warning);
        check_outputs(SweepFiles::beside(options["--output"]), options["spec"], checked,
                      !options.has("--no-report"));
    }
    text = session.broadcast(text);
    const SweepPlan plan(text);
    const int threads =
        options.whole("--threads") > 0 ? options.whole("--threads") : default_threads(session.size_here());
    const auto of_spec = [&](const ImpactModel& model, const ImpactColumns& impacts,
                             const WantedResults& wanted) {
        return at_place(FileName{options["spec"]}, [&] { return solver(model, impacts, wanted); });
    };
    ThreadWorkers own(threads, work_of(plan, of_spec));
    if (session.rank() != 0) {
        serve(own, session);
        return;
    }
    stop_on_signals();
    const InputFile spec{options["spec"], sha256(text)};
    RankWorkers workers(own, session);
    const bool done = lead(options, plan, spec, workers, out);
    workers.dismiss();
    if (done) return;
    spdlog::info("interrupted; the same command goes on from here");
    session.leave(128 + interrupting_signal);
    end_by_signal();
}

Json sweep_artifact(const SweepPlan& plan, const SweepProgress& progress, const InputFile& spec) {
    const SweepSums sums = progress.sums.total();
    const std::vector<OutsideShare> outside = captures_outside_model(plan.spec());
    Json result{{"points", plan.design().points()},
                {"impacts", plan.impacts()},
                {"damping_law", name_of(plan.spec().damping_law)},
                {"laws", Json::array()}};
    for (std::size_t i = 0; i < plan.spec().laws.size(); ++i)
        result["laws"].push_back(
            LawResult(plan, sums.laws[i], progress.counts[i], progress.failed.counts.at(i))
                .json(plan.spec().laws[i], outside[i]));
    result["not_converged"] = failures_json(plan, progress.failed);
    std::vector<std::string> warnings = plan.spec().warnings;
    for (std::string& warning : warnings_of_impacts(plan.spec(), outside))
        warnings.push_back(std::move(warning));
    if (progress.failed.total() > 0)
        warnings.push_back(std::to_string(progress.failed.total()) + " of " + std::to_string(plan.impacts()) +
                           " impacts did not converge; they are left out, see /result/not_converged");
    Json document{{"schema", "sweep-result"},
                  {"schema_version", schema_version},
                  {"stage", "sweep"},
                  {"provenance",
                   {{"program", "ashimpact"},
                    {"version", program_version()},
                    {"revision", program_revision()},
                    {"inputs", Json::array({{{"file", spec.file}, {"sha256", spec.sha256}}})},
                    {"options", parse_json(plan.canonical())}}},
                  {"citations", citations_of(plan)},
                  {"warnings", warnings},
                  {"result", std::move(result)}};
    seal_result(document);
    return document;
}

}  // namespace ashimpact
