// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/app/sweep/command.hpp"

#include <csignal>
#include <ostream>

#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include "core/json/writer.hpp"
#include "core/text/error.hpp"
#include "core/text/text.hpp"
#include "pipeline/app/sweep/outputs.hpp"
#include "pipeline/app/sweep/result_json.hpp"
#include "pipeline/app/sweep/spec/capture_fraction.hpp"
#include "pipeline/app/sweep/sweep.hpp"
#include "pipeline/app/sweep/table/table_file.hpp"
#include "pipeline/app/sweep/workers/rank_workers.hpp"
#include "pipeline/app/sweep/workers/thread_workers.hpp"
#include "pipeline/app/terminal/help.hpp"
#include "pipeline/files/file.hpp"
#include "pipeline/files/sha256.hpp"
#include "pipeline/present/report/page/html.hpp"
#include "pipeline/present/report/sweep/sweep_page.hpp"
#include "pipeline/present/text/artifact_text.hpp"
#include "pipeline/present/text/progress.hpp"

namespace ashimpact {

namespace {

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
    std::vector<std::filesystem::path> left;
    for (const auto& entry : std::filesystem::directory_iterator(folder, ignored)) {
        const std::string name = entry.path().filename().string();
        if (name.starts_with(own) && name.ends_with(".tmp")) left.push_back(entry.path());
    }
    for (const auto& file : left) std::filesystem::remove(file, ignored);
}

/// One line of results for each law, and the files written.
std::string summary(const Json& artifact, const SweepFiles& files, const SweepPlan& plan) {
    std::string text;
    for (const Json& law : artifact.at("result").at("laws"))
        text += fmt::format("{}: {} impacts, {} captured ({:.4g} %)\n", law.at("law").get<std::string>(),
                            law.at("impacts").get<std::uint64_t>(), law.at("captured").get<std::uint64_t>(),
                            100 * law.at("capture_fraction").at("value").get<double>());
    text += files.result.string();
    if (!plan.spec().table.empty()) text += fmt::format(", {}: {} rows", files.table.string(), plan.rows());
    return text +
           fmt::format("; as tables:\n  {} inspect {}\n", program_word(), shell_word(files.result.string()));
}

/// Writes the report beside the result, or removes that of an earlier sweep. A failure is only a warning, so
/// that the result is kept.
/// @returns whether there is a report
bool write_report(const SweepOptions& options, const Json& artifact, const SweepFiles& files) {
    if (!options.no_report) {
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
bool lead(const SweepOptions& options, const SweepPlan& plan, const SpecFile& spec, Workers& workers,
          std::ostream& out) {
    const SweepFiles files = SweepFiles::beside(options.output);
    make_folder(files.result.parent_path());
    RowLog rows(files.rows);
    if (options.restart) {
        remove_leftovers(files);
        rows.clear();
    }
    Checkpoint state = load_checkpoint(files.checkpoint, plan).value_or(Checkpoint{});
    const SweepCare care{.checkpoint_interval = options.checkpoint_interval,
                         .show_progress = options.progress || on_terminal(),
                         .interrupted = [] { return interrupting_signal != 0; }};
    if (!complete(state, plan, files, rows, workers, care)) return false;
    if (!plan.spec().table.empty()) write_table(files.table, plan, files.rows);
    const Json artifact = sweep_artifact(plan, state.progress, spec);
    write_file(files.result, write_json(artifact));
    remove_leftovers(files);
    rows.clear();
    out << summary(artifact, files, plan);
    if (write_report(options, artifact, files)) out << "Report: " << files.report.string() << '\n';
    return true;
}

}  // namespace

void run_sweep_command(const SweepOptions& options, MpiSession& session, const ImpactSolver& solver,
                       std::ostream& out) {
    session.join();
    std::string text;
    if (session.rank() == 0) {
        text = read_file(options.spec);
        const SweepPlan checked = at_place(FileName{options.spec}, [&] { return SweepPlan(text); });
        for (const std::string& warning : checked.spec().warnings) spdlog::warn("warning: {}", warning);
        check_outputs(SweepFiles::beside(options.output), options.spec, checked, !options.no_report);
    }
    text = session.broadcast(text);
    const SweepPlan plan(text);
    const int threads = options.threads > 0 ? options.threads : default_threads(session.size_here());
    const auto of_spec = [&](const ImpactModel& model, const ImpactColumns& impacts,
                             const WantedResults& wanted) {
        return at_place(FileName{options.spec}, [&] { return solver(model, impacts, wanted); });
    };
    ThreadWorkers own(threads, work_of(plan, of_spec));
    if (session.rank() != 0) {
        serve(own, session);
        return;
    }
    stop_on_signals();
    const SpecFile spec{options.spec, sha256(text)};
    RankWorkers workers(own, session);
    const bool done = lead(options, plan, spec, workers, out);
    workers.dismiss();
    if (done) return;
    spdlog::info("interrupted; the same command goes on from here");
    session.leave(128 + interrupting_signal);
    end_by_signal();
}

}  // namespace ashimpact
