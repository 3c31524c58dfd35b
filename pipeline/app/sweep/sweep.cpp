// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/app/sweep/sweep.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <map>

#include <spdlog/spdlog.h>

#include "core/text/error.hpp"
#include "core/text/text.hpp"
#include "core/version.hpp"
#include "pipeline/app/sweep/bytes.hpp"
#include "pipeline/app/terminal.hpp"
#include "pipeline/files/file.hpp"

namespace ashimpact {

namespace {

using Clock = std::chrono::steady_clock;

/// Long enough that handing out blocks costs nothing, short enough that no one waits long for the last one.
constexpr double block_seconds = 0.1;
constexpr unsigned highest_level = 12;
/// A block's rows of the full table are held in memory, and sent, as one.
constexpr unsigned highest_level_with_table = 2;
constexpr std::chrono::milliseconds patience{50};
/// Share of the impacts that may fail to converge before the sweep does.
constexpr double tolerated_failures = 0.01;

/// What a checkpoint holds. A sweep continues from that of the same program and spec.
struct Checkpoint {
    std::string format = std::string(checkpoint_mark) + " 2";
    std::string version{program_version()};
    std::string revision{program_revision()};
    std::string spec;
    std::string digest{};
    std::string progress;  ///< packed

    void transfer(auto& archive) { archive(format, version, revision, spec, digest, progress); }
};

/// Replaces the checkpoint file atomically. @throws InputError if it cannot be written
void save_checkpoint(const std::filesystem::path& file, const SweepPlan& plan,
                     const SweepProgress& progress) {
    Checkpoint checkpoint{.spec = plan.hash(), .progress = packed(progress)};
    checkpoint.digest = sha256(checkpoint.progress);
    write_files(std::array{FileContent{file, packed(std::move(checkpoint))}});
}

/// Hands out the blocks of a sweep, merges and saves their results.
class SweepDriver {
  public:
    SweepDriver(SweepProgress& progress, const SweepPlan& plan, const SweepFiles& files, RowLog& rows,
                Workers& workers, const SweepCare& care)
        : progress_(progress),
          plan_(plan),
          files_(files),
          rows_(plan.spec().table.empty() ? nullptr : &rows),
          workers_(workers),
          care_(care),
          shown_(plan.impacts(), impacts_done(), care.show_progress),
          next_(progress.chunks) {
        if (rows_ != nullptr) rows_->resume(progress.row_bytes);
        if (next_ > 0)
            spdlog::info("{}: going on from chunk {} of {}", files.checkpoint.string(), next_, plan.chunks());
    }

    [[nodiscard]] bool run() {
        while (progress_.chunks < plan_.chunks()) {
            hand_out();
            collect();
            merge();
            shown_.update(impacts_done());
            if (care_.interrupted()) {
                save();
                return false;
            }
            if (is_due()) save();
        }
        save();
        return true;
    }

    void save() {
        if (rows_ != nullptr) rows_->sync();
        save_checkpoint(files_.checkpoint, plan_, progress_);
        saved_ = Clock::now();
        saved_chunks_ = progress_.chunks;
    }

    /// Leaves nothing behind where nothing was finished.
    void forget() const {
        std::error_code ignored;
        for (const auto& file : {files_.checkpoint, files_.rows}) std::filesystem::remove(file, ignored);
    }

  private:
    [[nodiscard]] std::uint64_t impacts_done() const {
        const std::uint64_t chunks = progress_.chunks;
        const std::uint64_t points =
            chunks == plan_.chunks() ? plan_.design().points() : plan_.first_point(chunks);
        return points * plan_.impacts_a_point() * plan_.spec().laws.size();
    }

    [[nodiscard]] bool is_due() const {
        return progress_.chunks > saved_chunks_ &&
               std::chrono::duration<double>(Clock::now() - saved_).count() >= care_.checkpoint_interval;
    }

    /// Assigns blocks to idle workers, but not far ahead of the merged ones: waiting results take memory.
    void hand_out() {
        const std::size_t most_waiting = 4 * workers_.capacity();
        while (next_ < plan_.chunks() && workers_.vacancies() > 0 &&
               in_flight_ + waiting_.size() < most_waiting) {
            const Block block{next_, level()};
            workers_.assign(block);
            next_ += block.chunks();
            ++in_flight_;
        }
    }

    /// The next block's level: as slow as wanted, a node of the tree, small enough to share the rest.
    [[nodiscard]] unsigned level() const {
        const std::uint64_t left = plan_.chunks() - next_;
        const auto log2 = [](std::uint64_t number) {
            return static_cast<unsigned>(std::bit_width(number)) - 1;
        };
        const std::uint64_t share = std::max<std::uint64_t>(1, left / (2 * workers_.capacity()));
        const std::uint64_t wanted =
            seconds_a_chunk_ > 0 ? static_cast<std::uint64_t>(block_seconds / seconds_a_chunk_) : 1;
        const unsigned aligned = next_ == 0 ? highest_level : static_cast<unsigned>(std::countr_zero(next_));
        return std::min({log2(share),
                         log2(std::clamp<std::uint64_t>(wanted, 1, std::uint64_t{1} << highest_level)),
                         aligned, rows_ != nullptr ? highest_level_with_table : highest_level});
    }

    void collect() {
        auto done = workers_.finished(patience);
        if (!done) return;
        --in_flight_;
        const std::uint64_t first = done->block.first;
        waiting_.emplace(first, std::move(*done));
    }

    void merge() {
        for (auto first = waiting_.begin(); first != waiting_.end() && first->first == progress_.chunks;
             first = waiting_.erase(first)) {
            const FinishedBlock& done = first->second;
            auto result = unpacked<BlockResult>(done.bytes);
            if (rows_ != nullptr) {
                rows_->append(result.rows);
                progress_.row_bytes = rows_->size();
            }
            progress_.add(done.block, std::move(result));
            require_few_failures();
            seconds_a_chunk_ = done.seconds / static_cast<double>(done.block.chunks());
        }
    }

    /// @throws ConvergenceError with the first of them where too many impacts did not converge
    void require_few_failures() const {
        const FailedImpacts& failed = progress_.failed;
        const auto impacts = static_cast<double>(plan_.impacts());
        if (static_cast<double>(failed.total()) <= tolerated_failures * impacts) return;
        const FailedImpacts::Listed& first = failed.listed.front();
        throw ConvergenceError(std::to_string(failed.total()) + " impacts, more than " +
                               shortest(100 * tolerated_failures) + " % of the sweep: " + first.reason +
                               "; the first one: " + first.command);
    }

    SweepProgress& progress_;
    const SweepPlan& plan_;
    const SweepFiles& files_;
    RowLog* rows_;  ///< of the table; nullptr without one
    Workers& workers_;
    const SweepCare& care_;
    Progress shown_;
    std::uint64_t next_;  ///< chunk to hand out
    std::size_t in_flight_ = 0;
    std::map<std::uint64_t, FinishedBlock> waiting_;  ///< for blocks before them, by first chunk
    double seconds_a_chunk_ = 0;
    Clock::time_point saved_ = Clock::now();
    std::uint64_t saved_chunks_ = 0;
};

}  // namespace

SweepFiles SweepFiles::beside(const std::filesystem::path& result) {
    const auto with = [&](const char* suffix) { return std::filesystem::path(result.string() + suffix); };
    std::filesystem::path table = result;
    table.replace_extension(".h5");
    std::filesystem::path report = result;
    report.replace_extension(".html");
    return {result, table, with(".checkpoint"), with(".rows"), report};
}

std::optional<SweepProgress> load_checkpoint(const std::filesystem::path& file, const SweepPlan& plan) {
    std::error_code ignored;
    if (!std::filesystem::exists(file, ignored)) return std::nullopt;
    const auto refuse = [&](const char* problem) -> InputError {
        return InputError(problem, "--restart to begin anew, or another -o").at(FileName{file.string()});
    };
    try {
        const auto checkpoint = unpacked<Checkpoint>(read_file(file));
        if (checkpoint.format != Checkpoint{}.format || checkpoint.digest != sha256(checkpoint.progress))
            throw BrokenBytes();
        if (checkpoint.version != program_version() || checkpoint.revision != program_revision())
            throw refuse("is the checkpoint of another version of ashimpact");
        if (checkpoint.spec != plan.hash()) throw refuse("is the checkpoint of another sweep");
        return unpacked<SweepProgress>(checkpoint.progress);
    } catch (const BrokenBytes&) {
        throw refuse("is no checkpoint, or damaged");
    }
}

Work work_of(const SweepPlan& plan, ImpactSolver solver) {
    return [&plan, solver = std::move(solver)](const Block& block) {
        return packed(compute_block(plan, solver, block));
    };
}

bool complete(SweepProgress& progress, const SweepPlan& plan, const SweepFiles& files, RowLog& rows,
              Workers& workers, const SweepCare& care) {
    SweepDriver driver(progress, plan, files, rows, workers, care);
    try {
        return driver.run();
    } catch (const ConvergenceError&) {
        driver.save();
        throw;
    } catch (const InputError&) {
        if (progress.chunks == 0) driver.forget();
        throw;
    }
}

}  // namespace ashimpact
