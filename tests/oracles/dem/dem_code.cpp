// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/oracles/dem/dem_code.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <string_view>
#include <utility>

#include <Eigen/LU>

#include "materials/contact_properties.hpp"
#include "tests/oracles/dem/program.hpp"
#include "tests/oracles/time_domain.hpp"

namespace ashimpact::oracles {

namespace {

using std::numbers::pi;

bool hertz_or_dmt(const Impact& impact) {
    return (impact.law == Law::of<Hertz>() || impact.law == Law::of<Dmt>()) &&
           impact.detachment == Detachment::zero_overlap;
}

DeckValues wall_values(const Impact& impact) {
    return {{"radius", exact(impact.contact.effective_radius)},
            {"diameter", exact(2 * impact.contact.effective_radius)},
            {"velocity", exact(impact.velocity)},
            {"box", exact(10 * impact.contact.effective_radius)},
            {"skin", exact(0.1 * impact.contact.effective_radius)}};
}

// E = 2 E* and nu = 0 are right for a pair and for the wall, whose effective modulus this version of LAMMPS
// takes as E/(2 (1 - nu)); its surface energy is that of one surface, w/2.
std::string lammps_material(const Impact& impact) {
    return exact(2 * impact.contact.contact_modulus) + " " + exact(impact.damping.coefficient) + " 0 " +
           exact(impact.contact.work_of_adhesion / 2);
}

DemCode::Setup lammps_wall(const Impact& impact) {
    auto values = wall_values(impact);
    values["mass"] = exact(impact.contact.mass);
    values["normal_model"] = impact.law == Law::of<Dmt>()
                                 ? "dmt " + lammps_material(impact)
                                 : "hertz " + exact(4.0 / 3.0 * impact.contact.contact_modulus) + " " +
                                       exact(impact.damping.coefficient);
    return {deck_template("lammps_wall.in"), std::move(values)};
}

DemCode::Setup lammps_pair(const Impact& impact) {
    const double distance = 4 * impact.contact.effective_radius;
    DeckValues values{{"distance", exact(distance)},
                      {"within", exact(2 * std::numeric_limits<double>::epsilon() * distance)},
                      {"diameter", exact(distance)},
                      {"mass", exact(impact.contact.mass)},
                      {"velocity", exact(impact.velocity)},
                      {"normal_model", "jkr " + lammps_material(impact)},
                      {"box", exact(20 * impact.contact.effective_radius)},
                      {"skin", exact(0.1 * impact.contact.effective_radius)}};
    return {deck_template("lammps_pair.in"), std::move(values)};
}

DemCode::Setup liggghts_wall(const Impact& impact) {
    auto values = wall_values(impact);
    const double stiffness =
        4.0 / 3.0 * impact.contact.contact_modulus * std::sqrt(impact.contact.effective_radius);
    const double fraction = impact.damping.coefficient / (2 * std::sqrt(impact.contact.mass * stiffness));
    values["density"] = exact(impact.contact.mass / sphere_mass(impact.contact.effective_radius, 1));
    values["young_modulus"] = exact(2 * impact.contact.contact_modulus);
    values["damping_restitution"] = exact(std::exp(-pi * fraction / std::sqrt(1 - fraction * fraction)));
    values["pull_off_force"] =
        exact(-2 * pi * impact.contact.work_of_adhesion * impact.contact.effective_radius);
    return {deck_template("liggghts_wall.in"), std::move(values)};
}

/// One time step of a DEM run.
struct Sample {
    double overlap;   ///< [m]
    double velocity;  ///< rate of overlap [m/s]
};

/// A DEM run from first touch (sample 0) at a constant time step.
struct Track {
    double time_step = 0;  ///< [s]
    std::vector<Sample> samples;
};

/// One run of one impact.
struct DemRun {
    Impact impact{};
    double time_step = 0;          ///< [s]
    std::size_t steps = 0;         ///< from first touch
    std::size_t output_every = 1;  ///< steps between samples
};

struct Job {
    DemCode::Setup setup;
    const DemRun& run;
};

void write_deck(const std::vector<Job>& jobs, const std::filesystem::path& file) {
    std::ofstream deck(file);
    for (std::size_t i = 0; i < jobs.size(); ++i) {
        auto values = jobs[i].setup.values;
        values["index"] = std::to_string(i);
        values["time_step"] = exact(jobs[i].run.time_step);
        values["steps"] = std::to_string(jobs[i].run.steps);
        values["output_every"] = std::to_string(jobs[i].run.output_every);
        deck << fill(jobs[i].setup.deck, values) << '\n';
    }
    if (!deck.flush()) throw std::runtime_error("cannot write " + file.string());
}

std::string complaint(const std::filesystem::path& file) {
    std::ifstream log(file);
    for (std::string line; std::getline(log, line);)
        if (line.starts_with("ERROR")) return line;
    return "no error in its log";
}

// Reads the numbers a line begins with; false where there are fewer.
template <class... Number>
bool read_numbers(std::string_view line, Number&... numbers) {
    const char* const end = line.data() + line.size();
    const char* at = line.data();
    const auto read = [&](auto& number) {
        at = std::find_if(at, end, [](char c) { return c != ' '; });
        const auto [rest, error] = std::from_chars(at, end, number);
        at = rest;
        return error == std::errc{};
    };
    return (read(numbers) && ...);
}

// The log holds, for each run, its "impact <index>" line and then a table of step, position, speed.
std::vector<Track> read_log(const std::vector<Job>& jobs, const std::filesystem::path& file) {
    constexpr std::string_view title = "impact ";
    std::vector<Track> tracks(jobs.size());
    std::ifstream log(file);
    std::size_t index = 0;
    std::size_t step = 0;
    double position = 0;
    double speed = 0;
    for (std::string line; std::getline(log, line);) {
        if (line.starts_with(title) && read_numbers(std::string_view(line).substr(title.size()), index))
            continue;
        if (!read_numbers(line, step, position, speed)) continue;
        auto& samples = tracks.at(index).samples;
        if (step != samples.size() * jobs[index].run.output_every)
            throw std::runtime_error(file.string() + ": a step is missing in run " + std::to_string(index));
        samples.push_back({-position, -speed});
    }
    for (std::size_t i = 0; i < jobs.size(); ++i) {
        const DemRun& run = jobs[i].run;
        tracks[i].time_step = run.time_step * static_cast<double>(run.output_every);
        if (tracks[i].samples.size() != run.steps / run.output_every + 1)
            throw std::runtime_error(file.string() + ": run " + std::to_string(i) + " is not complete");
    }
    return tracks;
}

/// Runs them all in one call of the code; the decks and the log stay in the directory of the given name below
/// the build directory. Returns a track for each run, its time step being that between samples.
/// @throws std::runtime_error if the code is missing, fails, or prints anything but the samples asked for
std::vector<Track> run(const DemCode& code, std::span<const DemRun> runs, const std::string& directory) {
    const auto program = find_program(code.program, code.debian_package);
    const std::filesystem::path place = std::filesystem::path(ASHIMPACT_ORACLE_WORK) / directory;
    std::filesystem::remove_all(place);
    std::filesystem::create_directories(place);
    std::vector<Job> jobs;
    for (const DemRun& one : runs) jobs.push_back({code.setup(one.impact), one});
    write_deck(jobs, place / "deck.in");
    const int status = run_program(
        program, {"-in", "deck.in", "-log", "log", "-screen", "none", "-echo", "none", "-nocite"}, place);
    if (status != 0)
        throw std::runtime_error(program.string() + " ended with status " + std::to_string(status) + ": " +
                                 complaint(place / "log"));
    return read_log(jobs, place / "log");
}

/// What one run says, before any extrapolation in the time step.
struct Contact {
    bool separated = false;
    double restitution = 0;
    double contact_time = 0;     ///< [s]
    double maximum_overlap = 0;  ///< [m]
    double end_in_steps = 0;     ///< contact time in time steps: where between two samples the end fell
};

// Time is counted in steps here.
template <std::size_t points>
class Polynomial {
  public:
    Polynomial(const Track& track, std::size_t first, double Sample::*quantity) : first_(first) {
        for (std::size_t i = 0; i < points; ++i) values_[i] = track.samples[first + i].*quantity;
    }

    [[nodiscard]] double operator()(double time) const {  // Neville
        auto p = values_;
        const double t = time - static_cast<double>(first_);
        for (std::size_t level = 1; level < points; ++level)
            for (std::size_t i = 0; i + level < points; ++i)
                p[i] += (t - static_cast<double>(i)) / static_cast<double>(level) * (p[i + 1] - p[i]);
        return p[0];
    }

    // where the polynomial falls through a level, between two times
    [[nodiscard]] double time_at(double level, double above, double below) const {
        for (int i = 0; i < 100; ++i) {
            const double middle = 0.5 * (above + below);
            ((*this)(middle) > level ? above : below) = middle;
        }
        return 0.5 * (above + below);
    }

  private:
    std::size_t first_;
    std::array<double, points> values_;
};

constexpr std::size_t turn_points = 8;
constexpr std::size_t end_points = 5;

/// Reads turning point and end of contact between the samples, by polynomials through samples of the contact
/// alone: the first one outside has felt the jump of the force.
/// @param end_overlap the overlap at which the contact ends [m]
Contact read_contact(const Track& track, double end_overlap) {
    const auto& samples = track.samples;
    const auto turned =
        std::find_if(samples.begin(), samples.end(), [](const Sample& s) { return s.velocity <= 0; });
    const auto left =
        std::find_if(turned, samples.end(), [&](const Sample& s) { return s.overlap <= end_overlap; });
    const auto turn = static_cast<std::size_t>(turned - samples.begin());
    const auto end = static_cast<std::size_t>(left - samples.begin());

    Contact contact;
    if (turn < turn_points || turn + turn_points > samples.size()) return contact;
    const std::size_t first = turn - turn_points / 2;
    const double turn_time = Polynomial<turn_points>(track, first, &Sample::velocity)
                                 .time_at(0, static_cast<double>(turn - 1), static_cast<double>(turn));
    contact.maximum_overlap = Polynomial<turn_points>(track, first, &Sample::overlap)(turn_time);
    if (left == samples.end()) return contact;

    const Polynomial<end_points> overlap(track, end - end_points, &Sample::overlap);
    const Polynomial<end_points> velocity(track, end - end_points, &Sample::velocity);
    contact.separated = true;
    contact.end_in_steps =
        overlap.time_at(end_overlap, static_cast<double>(end - 1), static_cast<double>(end) + 1);
    contact.contact_time = contact.end_in_steps * track.time_step;
    contact.restitution = -velocity(contact.end_in_steps) / samples.front().velocity;
    return contact;
}

/// Returns the coefficients c0, c1, ... of c0 + c1 h^p1 + ... through all points.
std::vector<double> fit_powers(std::span<const double> steps, std::span<const double> values,
                               std::span<const double> powers) {
    assert(steps.size() == values.size() && steps.size() == powers.size() + 1);
    const auto count = static_cast<Eigen::Index>(steps.size());
    const long double unit = steps.front();
    Eigen::Matrix<long double, Eigen::Dynamic, Eigen::Dynamic> matrix(count, count);
    Eigen::Vector<long double, Eigen::Dynamic> right(count);
    for (Eigen::Index i = 0; i < count; ++i) {
        const auto row = static_cast<std::size_t>(i);
        right[i] = values[row];
        matrix(i, 0) = 1;
        for (Eigen::Index j = 1; j < count; ++j)
            matrix(i, j) = std::pow(steps[row] / unit,
                                    static_cast<long double>(powers[static_cast<std::size_t>(j - 1)]));
    }
    const Eigen::Vector<long double, Eigen::Dynamic> solution = matrix.partialPivLu().solve(right);
    std::vector<double> coefficients(steps.size());
    for (std::size_t j = 0; j < coefficients.size(); ++j)
        coefficients[j] =
            static_cast<double>(solution[static_cast<Eigen::Index>(j)] /
                                (j == 0 ? 1 : std::pow(unit, static_cast<long double>(powers[j - 1]))));
    return coefficients;
}

/// Richardson extrapolation to step zero: fits value(h) = c0 + c1 h^p1 + c2 h^p2 + ... through all points and
/// returns c0, in the unit of the values. The error is the distance to the same without the largest step and
/// the highest power, so it belongs to the lower order and is on the safe side.
/// @param steps five or so step sizes in any unit, largest first
/// @param powers ascending, one fewer than there are steps
Estimate extrapolate(std::span<const double> steps, std::span<const double> values,
                     std::span<const double> powers) {
    const double best = fit_powers(steps, values, powers).front();
    const auto lower = powers.first(powers.size() - 1);
    const double fine = fit_powers(steps.subspan(1), values.subspan(1), lower).front();
    const double coarse =
        fit_powers(steps.first(lower.size() + 1), values.first(lower.size() + 1), lower).front();
    return {best, std::max(std::abs(best - fine), std::abs(best - coarse))};
}

constexpr double hertz_contact_time = 3.21806546;  // undamped, in time scales

constexpr std::array coarse_steps{200, 280, 400};                // a Hertz contact
constexpr int coarse_horizon = 6;                                // in Hertz contacts
constexpr std::array fine_steps{2000, 3000, 4500, 6750, 10000};  // a contact

// What double precision leaves of an extrapolated result, relative: the overlap is known to the digits of the
// distance between the centres, some 1e-13 of it, and the extrapolation multiplies that by some ten.
constexpr double rounding = 1e-11;

constexpr std::size_t verdict_steps = 20000;  // a Hertz contact
constexpr std::size_t verdict_horizon = 12;   // in Hertz contacts

double hertz_time(const Impact& impact) {
    return hertz_contact_time * ContactForce(impact).time_scale();
}

std::vector<double> error_powers(const Impact& impact) {
    const bool smooth = impact.law == Law::of<Jkr>();
    const bool damped = impact.damping.coefficient > 0;
    if (smooth) return damped ? std::vector{1., 2., 3., 4.} : std::vector{2., 4., 6., 8.};
    return damped ? std::vector{1., 2., 2.5, 3.} : std::vector{2., 2.5, 3.5, 4.};
}

std::vector<Contact> contacts(const DemCode& code, const std::vector<DemRun>& runs,
                              const std::string& directory) {
    const auto tracks = run(code, runs, directory);
    std::vector<Contact> result;
    for (std::size_t i = 0; i < runs.size(); ++i) {
        result.push_back(read_contact(tracks[i], ContactForce(runs[i].impact).end_overlap()));
        if (!result.back().separated)
            throw std::runtime_error(code.name + ": the spheres did not separate, see run " +
                                     std::to_string(i) + " in " + directory);
    }
    return result;
}

// The time step with which the contact ends in the middle of step `steps`.
double mid_step_end(std::span<const double> contact_time_fit, int steps) {
    double step = 0;
    for (int i = 0; i < 30; ++i)
        step = (contact_time_fit[0] + contact_time_fit[1] * step + contact_time_fit[2] * step * step) /
               (steps - 0.5);
    return step;
}

std::vector<DemRun> coarse_runs(std::span<const Impact> impacts) {
    std::vector<DemRun> runs;
    for (const Impact& impact : impacts)
        for (const int steps : coarse_steps)
            runs.push_back(
                {impact, hertz_time(impact) / steps, static_cast<std::size_t>(coarse_horizon * steps)});
    return runs;
}

std::vector<DemRun> fine_runs(std::span<const Impact> impacts, std::span<const Contact> coarse) {
    std::vector<DemRun> runs;
    for (std::size_t i = 0; i < impacts.size(); ++i) {
        std::array<double, coarse_steps.size()> steps{};
        std::array<double, coarse_steps.size()> times{};
        for (std::size_t j = 0; j < coarse_steps.size(); ++j) {
            steps[j] = hertz_time(impacts[i]) / coarse_steps[j];
            times[j] = coarse[i * coarse_steps.size() + j].contact_time;
        }
        const auto fit = fit_powers(steps, times, std::array{1., 2.});
        for (const int fine : fine_steps)
            runs.push_back({impacts[i], mid_step_end(fit, fine), static_cast<std::size_t>(fine) + 3});
    }
    return runs;
}

OracleResult extrapolated(std::span<const DemRun> runs, std::span<const Contact> found) {
    std::array<double, fine_steps.size()> step{};
    std::array<double, fine_steps.size()> restitution{};
    std::array<double, fine_steps.size()> contact_time{};
    std::array<double, fine_steps.size()> maximum_overlap{};
    for (std::size_t i = 0; i < fine_steps.size(); ++i) {
        if (std::abs(found[i].end_in_steps - (fine_steps[i] - 0.5)) > 0.1)
            throw std::runtime_error("the contact does not end in the middle of a step: at " +
                                     std::to_string(found[i].end_in_steps));
        step[i] = runs[i].time_step;
        restitution[i] = found[i].restitution;
        contact_time[i] = found[i].contact_time;
        maximum_overlap[i] = found[i].maximum_overlap;
    }
    const auto powers = error_powers(runs.front().impact);
    const auto at_zero_step = [&](const auto& values) {
        Estimate estimate = extrapolate(step, values, powers);
        estimate.error += rounding * estimate.value;
        return estimate;
    };
    return {.rebound = true,
            .restitution = at_zero_step(restitution),
            .contact_time = at_zero_step(contact_time),
            .maximum_overlap = at_zero_step(maximum_overlap)};
}

}  // namespace

DemCode lammps() {
    return {.name = "LAMMPS",
            .program = "lmp",
            .debian_package = "lammps",
            .covers =
                [](const Impact& impact) {
                    return hertz_or_dmt(impact) ||
                           (impact.law == Law::of<Jkr>() && impact.detachment == Detachment::load_controlled);
                },
            .setup =
                [](const Impact& impact) {
                    return impact.law == Law::of<Jkr>() ? lammps_pair(impact) : lammps_wall(impact);
                }};
}

DemCode liggghts() {
    return {.name = "LIGGGHTS",
            .program = "liggghts",
            .debian_package = "liggghts",
            .covers = hertz_or_dmt,
            .setup = liggghts_wall};
}

std::vector<OracleResult> dem_impacts(const DemCode& code, std::span<const Impact> impacts) {
    const auto coarse = contacts(code, coarse_runs(impacts), code.program + "-coarse");
    const auto runs = fine_runs(impacts, coarse);
    const auto found = contacts(code, runs, code.program + "-fine");
    std::vector<OracleResult> results;
    for (std::size_t i = 0; i < runs.size(); i += fine_steps.size())
        results.push_back(extrapolated(std::span(runs).subspan(i, fine_steps.size()),
                                       std::span(found).subspan(i, fine_steps.size())));
    return results;
}

std::vector<bool> dem_rebounds(const DemCode& code, std::span<const Impact> impacts) {
    std::vector<DemRun> runs;
    for (const Impact& impact : impacts) {
        constexpr std::size_t steps = verdict_steps * verdict_horizon;
        runs.push_back({impact, hertz_time(impact) / verdict_steps, steps, steps});
    }
    const auto tracks = run(code, runs, code.program + "-verdicts");
    std::vector<bool> rebounds;
    for (std::size_t i = 0; i < runs.size(); ++i)
        rebounds.push_back(tracks[i].samples.back().overlap < ContactForce(impacts[i]).end_overlap());
    return rebounds;
}

}  // namespace ashimpact::oracles
