// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <tuple>
#include <vector>

#include "core/finding.hpp"
#include "core/tables/number_marks.hpp"

namespace ashimpact {

/// Uncertainty of one measured impact: variances and covariance of its two velocities [m2/s2].
struct VelocityNoise {
    double incident;
    double rebound;
    double covariance = 0.0;

    /// Independent standard uncertainties of v_in and v_r [m/s].
    [[nodiscard]] static VelocityNoise of_velocities(double incident, double rebound) {
        return {incident * incident, rebound * rebound, 0.0};
    }
    /// Independent standard uncertainties of v_in [m/s] and e_n [1] at a point.
    [[nodiscard]] static VelocityNoise of_restitution(double velocity, double restitution,
                                                      double velocity_uncertainty,
                                                      double restitution_uncertainty);
    [[nodiscard]] VelocityNoise scaled(double factor) const {
        return {factor * incident, factor * rebound, factor * covariance};
    }
};

/// The outcome of an impact as the laboratory noted it.
enum class NotedOutcome {
    from_reading,  ///< not noted: a reading of zero or below means that no rebound was seen
    rebound,
    capture,
};

/// One measured impact. Kept in velocities, in which a camera's errors are independent and normal; e_n, their
/// ratio, has errors in both axes of every plot against it.
struct Measurement {
    double velocity;  ///< v_in, normal to the wall [m/s]
    double rebound;   ///< v_r, normal to the wall, a magnitude; 0 if no rebound was seen [m/s]
    std::optional<VelocityNoise> noise{};  ///< none: not known
    std::size_t line = 0;                  ///< of the file; 0: it comes from no file
    std::size_t count = 1;                 ///< number of impacts of which this is the mean
    /// Rebound velocity from which on the camera always sees the particle move; 0: not known [m/s].
    double resolution = 0.0;
    NotedOutcome outcome = NotedOutcome::from_reading;
    std::optional<double>
        tangential{};  ///< velocity along the wall before the impact; none: not stated [m/s]

    [[nodiscard]] double restitution() const { return rebound / velocity; }
    /// Whether no rebound was seen: a capture or, unless it was noted as one, perhaps a rebound too slow to
    /// be seen.
    [[nodiscard]] bool captured() const { return outcome == NotedOutcome::capture || rebound == 0.0; }
    /// Orders impacts, first by velocity; those with equal keys may stand for one another.
    [[nodiscard]] auto key() const {
        const VelocityNoise known = noise.value_or(VelocityNoise{0.0, 0.0});
        return std::tuple(velocity, rebound, known.incident, known.rebound, known.covariance, count,
                          resolution, outcome, tangential.value_or(0));
    }
};

/// Code of every finding on a file of impacts.
inline constexpr std::string_view impacts_code = "impacts";

/// The impacts of one sample, in the order of the file.
struct MeasurementSet {
    std::string source;  ///< file name, for messages
    std::vector<Measurement> points;
    std::vector<Finding> warnings{};
    std::size_t unknown = 0;  ///< impacts of the file left out because their outcome is not known
    bool rebound_alone_uncertain = false;  ///< the file states u(v_r) and not u(v_in)
    std::string sample{};                  ///< name in the column "sample", if all rows have the same
    std::string sheet{};                   ///< of the workbook
    std::string reading{};                 ///< how the table was read, by TableReading

    [[nodiscard]] std::size_t captures() const {
        return static_cast<std::size_t>(std::ranges::count_if(points, &Measurement::captured));
    }
    [[nodiscard]] std::size_t rebounds() const { return points.size() - captures(); }
    /// Whether the uncertainties are known, which holds for all points or for none.
    [[nodiscard]] bool has_noise() const { return !points.empty() && points.front().noise.has_value(); }
    /// The impacts by rising velocity, so that no result depends on the order of the file.
    [[nodiscard]] std::vector<Measurement> sorted() const {
        std::vector<Measurement> all = points;
        std::ranges::sort(all, {}, &Measurement::key);
        return all;
    }
};

/// The remark that impacts are taken for a sample, and their file or sheet names another one; none for sheets
/// that are not named as samples of that series, "Messung 1" for "FA 7".
[[nodiscard]] std::optional<Finding> other_sample_finding(const MeasurementSet& set,
                                                          const std::string& sample);

/// That a critical velocity [m/s] is below every capture or above every rebound, in words: no impact of that
/// kind then ends as it was seen. Empty if it is not, by three standard uncertainties of v_in.
[[nodiscard]] std::string contradiction_of(const MeasurementSet& set, double critical_velocity);

/// Checks that there is at least one point, that numbers are finite, v_in > 0, v_r >= 0, and that
/// uncertainties are positive and given for all points or for none.
/// @throws InputError with source and line
void validate(const MeasurementSet& set);

/// A high-speed camera, whose velocities are slopes of positions in successive frames.
struct Camera {
    double frame_rate;                     ///< [1/s]; Dong et al. 2013: 80,000
    double pixel_size;                     ///< in the object [m]
    int frames = 2;                        ///< positions used for each velocity, >= 2
    double position_in_pixels = 0.288675;  ///< standard uncertainty of a position; 1/sqrt(12): whole pixels

    /// Standard uncertainty of a velocity [m/s]: that of the slope of a straight line through equally spaced
    /// positions, u_x f sqrt(12/(n (n^2 - 1))). @throws InputError
    [[nodiscard]] double velocity_uncertainty() const;
};

/// The set with the camera's uncertainty in both velocities of every point, in place of any given before.
/// @throws InputError for a camera that cannot resolve even the fastest impact
[[nodiscard]] MeasurementSet with_camera(MeasurementSet set, const Camera& camera);

/// How neighbouring rebounds are averaged, in files of thousands of impacts.
struct Binning {
    int impacts_per_bin = 0;  ///< rebounds in each bin; 0: bins have a width
    double width = 0.0;       ///< width of the bins in v_in [m/s]; exactly one of both is given
};

/// The set with the rebounds of each bin replaced by their mean in both velocities and its uncertainty. If
/// noise is known the weight of a rebound is the inverse of the sum of its two variances. Captures stay as
/// they are. A mean of points on a curved e(v) lies beside the curve, so bins should be narrow compared to
/// its structure.
/// @throws InputError unless exactly one option is given
[[nodiscard]] MeasurementSet binned(const MeasurementSet& set, const Binning& binning);

/// Reads a table of measured impacts: comma, semicolon or tab; a heading with units, which may stand in a
/// second line, then one impact a line.
///
///     v_in [m/s]; v_r (mm/s); u(v_in) [m/s]; u(v_r) [m/s]
///     1,95; 120; 0,02; 0,02
///
/// Columns, under several names: the incident velocity v_in, and the rebound velocity v_r (a magnitude) or
/// the restitution e_n; their standard uncertainties u(...), or "1.95 ± 0.02" in the cell. e_n may be in per
/// cent. NumberMarks decides what points and commas in numbers are.
///
/// A column "outcome" holds rebound, capture or unknown. If it is empty or missing the reading decides: v_r =
/// 0, or a word for it such as "captured", is a capture; an empty cell or "unknown" is not known, and such an
/// impact is counted and left out. A reading below zero is taken for zero where noise explains it: within 6
/// standard uncertainties, or without those within a tenth of v_in. A column "correlation" holds that of the
/// errors of v_in and v_r. Beside a column of angles from the normal v_in is the velocity of the sphere, of
/// which the part normal to the wall counts; beside one of velocities along the wall v_in is normal to it.
/// Uncertainties of one velocity only are taken for the other, too; those of v_in and e_n as independent.
/// Other columns, rows such as "Mittel" and notes below the table are left out with a warning, lines that
/// begin with # without one. The table may be a sheet of a spreadsheet (.xlsx, .ods): the one of that name,
/// else the only one that holds one. Errors: InputError "NAME: line N: problem; allowed: ..." for anything
/// that is not that; of a spreadsheet the place is `sheet "S", cell B7`.
[[nodiscard]] MeasurementSet read_measurements(std::string_view text, std::string_view name,
                                               const TableOptions& options = {});

}  // namespace ashimpact
