// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/present/export/impact_table.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include <fmt/format.h>

#include "core/quantities/quantity.hpp"
#include "core/text/error.hpp"
#include "solver/batch/batch.hpp"
#include "solver/batch/parallel.hpp"
#include "solver/contact/cohesive_zone.hpp"
#include "solver/motion/regime.hpp"
#include "solver/motion/trajectory.hpp"

namespace ashimpact {

namespace {

constexpr double aim = 0.6 * table_accuracy;  // at the places looked at, so that it holds between them
constexpr double threshold_aim = 0.5 * table_threshold_accuracy;
constexpr double threshold_progress = 0.25;  // of the error left by twice the sizes; 1/16 where v_c is smooth
constexpr double largest_decades = 6;        // of the diameter
constexpr std::size_t smallest_sizes = 9;
constexpr std::size_t smallest_nodes = 65;
constexpr std::size_t largest_cells = 400'000;
constexpr double velocity_span = 1e3;   // of a table without captures
constexpr double least_velocity = 10;   // default end of a table [m/s]
constexpr double beyond_critical = 10;  // times the largest v_c that it reaches

/// How finely a table is divided.
struct Division {
    std::size_t sizes;
    std::size_t nodes;
};

std::vector<double> even(double from, double to, std::size_t count) {
    std::vector<double> values(count, from);
    for (std::size_t i = 1; i < count; ++i)
        values[i] = from + (to - from) * static_cast<double>(i) / static_cast<double>(count - 1);
    return values;
}

/// A place in the table along the sizes: a diameter and the piece whose formulas hold there.
struct SizePlace {
    double diameter;
    std::size_t piece;
};

/// The sizes at which pieces of the range begin and end, with the numbers of the pieces after them.
std::vector<SizePlace> piece_ends(const ExportSubject& subject) {
    std::vector<SizePlace> ends{{subject.from_diameter, piece_of(subject.sizes, subject.from_diameter)}};
    if (subject.sizes.size() > 1)
        for (std::size_t i = 0; i < subject.sizes.size(); ++i)
            if (const double d = subject.sizes[i].diameter;
                d > subject.from_diameter && d < subject.to_diameter)
                ends.push_back({d, i + 1});
    ends.push_back({subject.to_diameter, ends.back().piece});
    return ends;
}

/// The sizes of a table, @p count for each piece. Two at a known size, for either side of the kink.
std::vector<SizePlace> places_of(const ExportSubject& subject, std::size_t count) {
    if (subject.one_size()) return {{subject.from_diameter, piece_of(subject.sizes, subject.from_diameter)}};
    std::vector<SizePlace> places;
    const auto ends = piece_ends(subject);
    for (std::size_t i = 1; i < ends.size(); ++i) {
        const double from = ends[i - 1].diameter;
        const bool last = i + 1 == ends.size();
        const double to = last ? ends[i].diameter : ends[i].diameter * (1 - kink_width);
        const auto logarithms = even(std::log(from), std::log(to), count);
        for (std::size_t k = 0; k < count; ++k)
            places.push_back({k == 0           ? from
                              : k + 1 == count ? to
                                               : std::exp(logarithms[k]),
                              ends[i - 1].piece});
    }
    return places;
}

/// v_c of a verdict; 0 for a size that is never captured.
double finite_value(const CriticalVelocity& critical, double diameter) {
    if (critical.verdict == CaptureVerdict::always_captured)
        throw InputError(fmt::format("spheres of {} are captured at every velocity", readable(diameter, "m")),
                         "impacts of which some rebound; a wall that keeps all particles needs no table");
    return critical.value.value_or(0);
}

/// v_c; 0 for a size that is never captured.
double finite_threshold(const ExportSubject& subject, const SizePlace& place) {
    const bool known =
        std::ranges::find(subject.sizes, place.diameter, &AshSize::diameter) != subject.sizes.end();
    return finite_value(
        known ? threshold_at(subject, place.diameter) : threshold_at(subject, place.diameter, place.piece),
        place.diameter);
}

/// d ln v_c / d ln d by a central difference of fourth order, by the formulas of the piece [1].
double slope_at(const ExportSubject& subject, const SizePlace& place) {
    constexpr double step = 2e-3;
    const auto logarithm = [&](double shift) {
        const double diameter = place.diameter * std::exp(shift);
        return std::log(finite_value(threshold_at(subject, diameter, place.piece), diameter));
    };
    return (8 * (logarithm(step) - logarithm(-step)) - (logarithm(2 * step) - logarithm(-2 * step))) /
           (12 * step);
}

void set_thresholds(const ExportSubject& subject, const std::vector<SizePlace>& places, ImpactTable& table) {
    std::size_t captures = 0;
    for (const SizePlace& place : places) {
        table.diameter.push_back(place.diameter);
        table.start_velocity.push_back(finite_threshold(subject, place));
        if (table.start_velocity.back() > 0) ++captures;
    }
    table.captures = captures > 0;
    if (captures != 0 && captures != table.diameter.size())
        throw InputError("some sizes have a critical velocity and others are never captured",
                         "a range of diameters with one verdict");
    const double largest = *std::ranges::max_element(table.start_velocity);
    table.to_velocity = subject.to_velocity.value_or(std::max(least_velocity, beyond_critical * largest));
    if (!table.captures) {
        table.from_velocity = table.to_velocity / velocity_span;
        std::ranges::fill(table.start_velocity, table.from_velocity);
        table.slope.assign(table.diameter.size(), 0.0);
        return;
    }
    if (table.to_velocity <= *std::ranges::min_element(table.start_velocity))
        throw InputError(fmt::format("no size rebounds up to {}", readable(table.to_velocity, "m/s")),
                         "a velocity above the critical one")
            .at("--to-velocity");
    for (const SizePlace& place : places)
        table.slope.push_back(subject.one_size() ? 0.0 : slope_at(subject, place));
}

ImpactBatchResult solve(const std::vector<Impact>& impacts) {
    return solve_impacts(ImpactList(impacts).batch(), {.threads = 0, .turning_point = false});
}

/// The attraction at each node. @param impacts of the nodes, row by row
Eigen::ArrayXXd attraction_at_nodes(const std::vector<Impact>& impacts, const ImpactTable& table) {
    const auto columns = static_cast<std::size_t>(table.t.size());
    std::vector<std::size_t> places(impacts.size());
    std::iota(places.begin(), places.end(), 0);
    const std::vector<double> values = in_parallel(places, [&](std::size_t i) {
        const std::size_t place = i % columns == 0 && table.captures ? i + 1 : i;
        const Impact& impact = impacts[place];
        const double captured = table.restitution(static_cast<Eigen::Index>(place / columns),
                                                  static_cast<Eigen::Index>(place % columns));
        return captured > 0
                   ? attraction_impulse(impact, Precision::standard) / (impact.contact.mass * impact.velocity)
                   : 0;
    });
    using RowMajor = Eigen::Array<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
    return Eigen::Map<const RowMajor>(values.data(), table.velocity.rows(), table.velocity.cols());
}

/// The impacts at the nodes, row by row.
std::vector<Impact> impacts_at_nodes(const ExportSubject& subject, const ImpactTable& table) {
    std::vector<Impact> impacts;
    for (Eigen::Index i = 0; i < table.velocity.rows(); ++i) {
        const auto size = static_cast<std::size_t>(i);
        for (Eigen::Index j = 0; j < table.velocity.cols(); ++j)
            impacts.push_back(impact_above(subject, table.diameter[size], table.velocity(i, j),
                                           table.start_velocity[size]));
    }
    return impacts;
}

void fill_nodes(const ExportSubject& subject, ImpactTable& table) {
    const auto rows = static_cast<Eigen::Index>(table.diameter.size());
    const auto columns = static_cast<Eigen::Index>(table.t.size());
    table.velocity.resize(rows, columns);
    for (Eigen::Index i = 0; i < rows; ++i)
        for (Eigen::Index j = 0; j < columns; ++j)
            table.velocity(i, j) = velocity_at_place(table.t[static_cast<std::size_t>(j)],
                                                     table.start_velocity[static_cast<std::size_t>(i)]);
    const std::vector<Impact> impacts = impacts_at_nodes(subject, table);
    table.damping.resize(rows, columns);
    for (Eigen::Index i = 0; i < rows; ++i)
        for (Eigen::Index j = 0; j < columns; ++j)
            table.damping(i, j) = impacts[static_cast<std::size_t>(i * columns + j)].damping.coefficient;
    const ImpactBatchResult result = solve(impacts);
    using RowMajor = Eigen::Array<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
    table.restitution = Eigen::Map<const RowMajor>(result.restitution.data(), rows, columns);
    table.contact_time = Eigen::Map<const RowMajor>(result.contact_time.data(), rows, columns);
    if (!table.captures) return;
    for (Eigen::Index i = 0; i < rows; ++i)  // damping that rises with the velocity may capture again
        if (!(table.restitution.row(i).tail(columns - 1) > 0).all())
            refuse_several(table.diameter[static_cast<std::size_t>(i)]);
    table.restitution.col(0) = 0;  // the limit, whatever rounding makes of an impact at v_c
    table.contact_time.col(0) = std::numeric_limits<double>::quiet_NaN();
}

/// Places between the nodes: the middles of the cells, and of their sides.
std::vector<double> with_middles(const std::vector<double>& nodes) {
    std::vector<double> places{nodes.front()};
    for (std::size_t i = 1; i < nodes.size(); ++i) {
        places.push_back(0.5 * (nodes[i - 1] + nodes[i]));
        places.push_back(nodes[i]);
    }
    return places;
}

/// The largest |de| along each axis.
struct Errors {
    double along_sizes = 0;
    double along_t = 0;
    double anywhere = 0;
};

/// A place of the table at which it is compared with the solver.
struct Probe {
    double diameter;
    double velocity;
    double start;  ///< v_0 [m/s]
    bool between_sizes;
    bool between_nodes;
};

/// Middles of cells and sides, where e is furthest off; the nodes of the damping, too.
std::vector<Probe> probes_of(const ExportSubject& subject, const ImpactTable& table) {
    std::vector<double> logarithms;
    for (const double diameter : table.diameter) logarithms.push_back(std::log(diameter));
    const std::vector<double> sizes = with_middles(logarithms);
    const std::vector<double> nodes = with_middles(table.t);
    std::vector<Probe> probes;
    for (std::size_t i = 0; i < sizes.size(); ++i) {
        const double d = std::clamp(std::exp(sizes[i]), table.diameter.front(), table.diameter.back());
        const double start = start_velocity(table, d);
        const auto add = [&](double velocity, bool between_nodes) {
            if (velocity > start && velocity <= table.to_velocity)
                probes.push_back({d, velocity, start, i % 2 == 1, between_nodes});
        };
        for (std::size_t j = 0; j < nodes.size(); ++j)
            if (i % 2 + j % 2 > 0) add(velocity_at_place(nodes[j], start), j % 2 == 1);
        if (!subject.depends_on_velocity()) continue;
        for (const AshSize& size : subject.sizes)
            for (const DampingNode& node : size.damping.nodes) add(velocity_at_place(node.t, start), true);
    }
    return probes;
}

Errors errors_of(const ExportSubject& subject, const ImpactTable& table) {
    const std::vector<Probe> probes = probes_of(subject, table);
    if (probes.empty()) return {};
    std::vector<Impact> impacts;
    for (const Probe& probe : probes)
        impacts.push_back(impact_above(subject, probe.diameter, probe.velocity, probe.start));
    const ImpactBatchResult result = solve(impacts);
    Errors errors;
    for (std::size_t i = 0; i < probes.size(); ++i) {
        const auto& [diameter, velocity, start, between_sizes, between_nodes] = probes[i];
        const double error = std::abs(result.restitution[static_cast<Eigen::Index>(i)] -
                                      restitution(table, diameter, velocity));
        errors.anywhere = std::max(errors.anywhere, error);
        if (between_sizes != between_nodes) {
            double& along = between_sizes ? errors.along_sizes : errors.along_t;
            along = std::max(along, error);
        }
    }
    return errors;
}

/// Largest relative error of v_0 in the middles between the sizes, where the cubic is furthest off [1].
double threshold_error(const ExportSubject& subject, const ImpactTable& table) {
    double largest = 0;
    for (std::size_t i = 1; table.captures && i < table.diameter.size(); ++i) {
        const double middle = std::sqrt(table.diameter[i - 1] * table.diameter[i]);
        const double exact = finite_value(threshold_at(subject, middle), middle);
        largest = std::max(largest, std::abs(start_velocity(table, middle) / exact - 1));
    }
    return largest;
}

/// The range of diameters to be asked for instead: on one side of the size at which contacts of law
/// maugis-dugdale begin to end without a gap, where v_c(d) bends.
std::string smoother_range(const ExportSubject& subject) {
    const auto ends_touching = [&](double diameter) {
        const ContactPair contact = contact_at(subject, diameter);
        return is_cohesive(subject.law, contact) &&
               CohesiveZone(transition_parameter_of(contact)).pull_off().touching();
    };
    double lower = subject.from_diameter;
    double upper = subject.to_diameter;
    if (ends_touching(lower) == ends_touching(upper)) return "a shorter range of diameters";
    while (upper > 1.001 * lower) {
        const double middle = std::sqrt(lower * upper);
        (ends_touching(middle) == ends_touching(upper) ? upper : lower) = middle;
    }
    return fmt::format("diameters above or below {}, where v_c by law {} bends", readable(upper, "m"),
                       subject.law.name());
}

/// Sizes that v_c needs, more than e does. @throws InputError where v_c(d) is not smooth
std::size_t sizes_for_thresholds(const ExportSubject& subject) {
    double before = std::numeric_limits<double>::infinity();
    for (std::size_t sizes = smallest_sizes;; sizes = 2 * sizes - 1) {
        ImpactTable table;
        set_thresholds(subject, places_of(subject, sizes), table);
        const double error = threshold_error(subject, table);
        if (error <= threshold_aim) return sizes;
        if (error > threshold_progress * before || sizes * smallest_nodes > largest_cells)
            throw InputError(
                fmt::format("a table of {} sizes is still {:.1g} off in the critical velocity", sizes, error),
                smoother_range(subject));
        before = error;
    }
}

ImpactTable table_of(const ExportSubject& subject, const Division& division) {
    ImpactTable table;
    set_thresholds(subject, places_of(subject, division.sizes), table);
    double end = 0;
    for (const double start : table.start_velocity)
        end = std::max(end, place_above(table.to_velocity, start));
    table.t = even(0, end, division.nodes);
    fill_nodes(subject, table);
    return table;
}

/// Between which diameters of a table of several one lies.
struct Between {
    std::size_t lower;
    double share;  ///< of the way from the lower diameter to the upper one, in ln d
    double width;  ///< in ln d
};

Between between(const std::vector<double>& diameters, double diameter) {
    const auto above = std::clamp<std::ptrdiff_t>(
        std::ranges::upper_bound(diameters, diameter) - diameters.begin(), 1, std::ssize(diameters) - 1);
    const auto i = static_cast<std::size_t>(above) - 1;
    const double width = std::log(diameters[i + 1] / diameters[i]);
    return {i, std::log(diameter / diameters[i]) / width, width};
}

}  // namespace

ImpactTable make_impact_table(const ExportSubject& subject) {
    if (std::log10(subject.to_diameter / subject.from_diameter) > largest_decades)
        throw InputError("the range of diameters spans more than six decades", "a shorter range")
            .at("--from-diameter, --to-diameter");
    Division division{sizes_for_thresholds(subject), smallest_nodes};
    while (true) {
        ImpactTable table = table_of(subject, division);
        const Errors errors = errors_of(subject, table);
        table.largest_error = errors.anywhere;
        if (errors.anywhere <= aim) {
            if (subject.friction > 0 && subject.law.is_adhesive())
                table.attraction = attraction_at_nodes(impacts_at_nodes(subject, table), table);
            return table;
        }
        const double half = aim / 2;  // of the error, for each axis
        if (errors.along_sizes > half) division.sizes = 2 * division.sizes - 1;
        if (errors.along_t > half || errors.along_sizes <= half) division.nodes = 2 * division.nodes - 1;
        if (table.diameter.size() * division.nodes > largest_cells)
            throw InputError(fmt::format("a table of {} nodes is still {:.1g} off in the restitution",
                                         table.t.size() * table.diameter.size(), errors.anywhere),
                             "a shorter range of diameters or velocities");
    }
}

double start_velocity(const ImpactTable& table, double diameter) {
    if (table.diameter.size() == 1) return table.start_velocity.front();
    const auto [i, s, width] = between(table.diameter, diameter);
    const double value = (1 + 2 * s) * (1 - s) * (1 - s) * std::log(table.start_velocity[i]) +
                         s * s * (3 - 2 * s) * std::log(table.start_velocity[i + 1]) +
                         s * (1 - s) * width * ((1 - s) * table.slope[i] - s * table.slope[i + 1]);
    return std::exp(value);
}

double restitution(const ImpactTable& table, double diameter, double velocity) {
    const double start = start_velocity(table, diameter);
    if (velocity < start) return table.captures ? 0 : table.restitution(0, 0);
    const double spacing = table.t[1] - table.t[0];
    const double place = place_above(velocity, start) / spacing;
    const auto j = std::min(static_cast<Eigen::Index>(place), static_cast<Eigen::Index>(table.t.size()) - 2);
    const double b = place - static_cast<double>(j);
    const auto along_t = [&](std::size_t size) {
        const auto i = static_cast<Eigen::Index>(size);
        return (1 - b) * table.restitution(i, j) + b * table.restitution(i, j + 1);
    };
    if (table.diameter.size() == 1) return along_t(0);
    const auto [i, a, width] = between(table.diameter, diameter);
    return (1 - a) * along_t(i) + a * along_t(i + 1);
}

}  // namespace ashimpact
