// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/inference/impacts/measurement.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "core/quantities/quantity.hpp"
#include "core/tables/vocabulary.hpp"
#include "core/text/error.hpp"
#include "core/text/text.hpp"

namespace ashimpact {

namespace {

[[noreturn]] void fail(const Measurement& point, const std::string& problem, const std::string& allowed) {
    const InputError error(problem, allowed);
    throw point.line == 0 ? error : error.at("line " + std::to_string(point.line));
}

/// Refuses uncertainties above every velocity: nothing was measured then. @throws InputError
void require_resolution(const MeasurementSet& set) {
    if (!set.has_noise() || set.rebounds() == 0) return;
    double least = std::numeric_limits<double>::infinity();
    double fastest = 0.0;
    for (const Measurement& point : set.points) {
        least = std::min(least, std::sqrt(point.noise->incident));
        fastest = std::max(fastest, point.velocity);
    }
    const bool comparable = fastest > 0.0;  // otherwise each velocity is refused on its own
    if (least < fastest || !comparable) return;
    throw InputError("the standard uncertainty of v_in is at least " + shortest(least) +
                         " m/s, but the fastest impact has " + shortest(fastest) + " m/s",
                     "uncertainties below the velocities");
}

bool is_physical(const VelocityNoise& noise) {
    return std::isfinite(noise.incident) && std::isfinite(noise.rebound) && noise.incident > 0.0 &&
           noise.rebound > 0.0 && noise.covariance * noise.covariance < noise.incident * noise.rebound;
}

constexpr double least_width = 1e-6;  ///< of a bin, in fastest velocities

Measurement mean_of(const std::vector<Measurement>& bin) {
    Measurement mean{.velocity = 0.0, .rebound = 0.0, .noise = {}, .line = 0, .count = 0};
    VelocityNoise noise{0.0, 0.0, 0.0};
    double sum = 0.0;
    long double velocity = 0.0L;  // means of the points so far
    long double rebound = 0.0L;
    long double along = 0.0L;
    long double weights = 0.0L;
    for (const Measurement& point : bin) {
        const double weight = point.noise ? 1.0 / (point.noise->incident + point.noise->rebound)
                                          : static_cast<double>(point.count);
        weights += weight;
        velocity += (point.velocity - velocity) * (weight / weights);
        rebound += (point.rebound - rebound) * (weight / weights);
        along += (point.tangential.value_or(0.0) - along) * (weight / weights);
        sum += weight;
        mean.count += point.count;
        if (!point.noise) continue;
        noise.incident += weight * weight * point.noise->incident;
        noise.rebound += weight * weight * point.noise->rebound;
        noise.covariance += weight * weight * point.noise->covariance;
    }
    mean.velocity = static_cast<double>(velocity);
    mean.rebound = static_cast<double>(rebound);
    if (std::ranges::all_of(bin, [](const Measurement& point) { return point.tangential.has_value(); }))
        mean.tangential = static_cast<double>(along);
    if (bin.front().noise) mean.noise = noise.scaled(1.0 / (sum * sum));
    return mean;
}

}  // namespace

VelocityNoise VelocityNoise::of_restitution(double velocity, double restitution, double velocity_uncertainty,
                                            double restitution_uncertainty) {
    const double u = velocity_uncertainty;
    const double by_velocity = restitution * u;
    const double by_restitution = velocity * restitution_uncertainty;
    return {.incident = u * u,
            .rebound = by_velocity * by_velocity + by_restitution * by_restitution,
            .covariance = restitution * u * u};
}

std::optional<Finding> other_sample_finding(const MeasurementSet& set, const std::string& sample) {
    const std::string own = word_key(sample);
    const auto marks = [](const std::string& name) {
        std::string kept = sample_key(name);
        std::erase_if(kept,
                      [](char c) { return std::string_view("+<>.,").find(c) == std::string_view::npos; });
        return kept;
    };
    const auto is_of = [&](const std::string& name) {  // "FA 8 (96 um)" of "FA8", and not "FA80"
        if (marks(name) != marks(sample)) return false;
        const std::vector<std::string> words = words_in(name);
        for (std::size_t i = 0; i < words.size(); ++i) {
            std::string joined;
            for (std::size_t k = i; k < words.size() && joined.size() < own.size(); ++k) joined += words[k];
            if (joined == own) return true;
        }
        return false;
    };
    const auto series = [](const std::string& key) { return key.substr(0, key.find_first_of("0123456789")); };
    const bool other_sheet = series(word_key(set.sheet)) == series(own) && !is_of(set.sheet);
    if (!set.sample.empty() && !is_of(set.sample))
        return Finding{
            impacts_code, Severity::remark,
            "the impacts are those of the sample " + in_quotes(set.sample) + ", as its column says"};
    if (!set.sample.empty() || set.sheet.empty() || !other_sheet) return std::nullopt;
    return Finding{impacts_code, Severity::remark,
                   "the impacts are those of the sheet " + in_quotes(set.sheet)};
}

std::string contradiction_of(const MeasurementSet& set, double critical_velocity) {
    constexpr double certain = 3;  // standard uncertainties
    double slowest = std::numeric_limits<double>::infinity();
    double fastest = 0;
    bool below = false;
    bool above = false;
    for (const Measurement& point : set.points) {
        (point.captured() ? below : above) = true;
        if (point.captured())
            slowest = std::min(slowest, point.velocity);
        else
            fastest = std::max(fastest, point.velocity);
    }
    for (const Measurement& point : set.points) {
        const double margin = point.noise ? certain * std::sqrt(point.noise->incident) : 0;
        if (point.captured())
            below = below && critical_velocity < point.velocity - margin;
        else
            above = above && critical_velocity > point.velocity + margin;
    }
    if (below) return fmt::format("is below every capture, from {} m/s on", readable_number(slowest));
    return above ? fmt::format("is above every rebound, up to {} m/s", readable_number(fastest))
                 : std::string();
}

void validate(const MeasurementSet& set) {
    if (set.points.empty()) throw InputError("there is no measurement", "at least one");
    for (const Measurement& point : set.points) {
        if (!(std::isfinite(point.velocity) && point.velocity > 0.0))
            fail(point, "v_in is " + shortest(point.velocity) + " m/s", "a finite number > 0");
        if (!(std::isfinite(point.rebound) && point.rebound >= 0.0))
            fail(point, "v_r is " + shortest(point.rebound) + " m/s", "a finite number >= 0");
        if (point.noise.has_value() != set.has_noise())
            fail(point, "only some measurements have an uncertainty", "all of them or none");
        if (point.noise && !is_physical(*point.noise))
            fail(point, "an uncertainty is not a finite number > 0", "> 0 for every point");
    }
    require_resolution(set);
}

double Camera::velocity_uncertainty() const {
    const auto require = [](double value, const char* name) {
        if (!(std::isfinite(value) && value > 0.0))
            throw InputError(std::string(name) + " is " + shortest(value), "a finite number > 0");
    };
    require(frame_rate, "frame rate of the camera [1/s]");
    require(pixel_size, "pixel size of the camera [m]");
    require(position_in_pixels, "position uncertainty of the camera [pixel]");
    if (frames < 2) throw InputError("a velocity from " + std::to_string(frames) + " frames", "at least 2");
    const double n = frames;
    return position_in_pixels * pixel_size * frame_rate * std::sqrt(12.0 / (n * (n * n - 1.0)));
}

MeasurementSet with_camera(MeasurementSet set, const Camera& camera) {
    const double u = camera.velocity_uncertainty();
    set.rebound_alone_uncertain = false;
    const double moves = camera.frame_rate * camera.pixel_size / (camera.frames - 1);
    if (std::ranges::any_of(set.points, [](const Measurement& point) { return point.noise.has_value(); }))
        set.warnings.push_back({impacts_code, Severity::remark,
                                "the uncertainty of the camera, " + shortest(u) +
                                    " m/s, takes the place of the uncertainties stated with the impacts"});
    for (Measurement& point : set.points) {
        const double of_mean = u / std::sqrt(static_cast<double>(point.count));
        point.noise = VelocityNoise::of_velocities(of_mean, of_mean);
        point.resolution = point.count > 1 ? 0 : moves;
    }
    require_resolution(set);
    return set;
}

MeasurementSet binned(const MeasurementSet& set, const Binning& binning) {
    if ((binning.impacts_per_bin > 0) == (binning.width > 0.0))
        throw InputError("binning by both or neither of impacts and width", "exactly one, > 0");
    double fastest = 0.0;
    for (const Measurement& point : set.points) fastest = std::max(fastest, point.velocity);
    if (binning.width > 0.0 && binning.width < least_width * fastest)
        throw InputError(
            "bins of " + shortest(binning.width) + " m/s for impacts of up to " + shortest(fastest) + " m/s",
            "a width of at least a millionth of the fastest velocity");
    MeasurementSet result{.source = set.source,
                          .points = {},
                          .warnings = set.warnings,
                          .sample = set.sample,
                          .sheet = set.sheet};
    std::vector<Measurement> rebounds;
    for (const Measurement& point : set.sorted())
        (point.captured() ? result.points : rebounds).push_back(point);
    std::vector<Measurement> bin;
    for (const Measurement& point : rebounds) {
        const bool full = binning.impacts_per_bin > 0
                              ? bin.size() == static_cast<std::size_t>(binning.impacts_per_bin)
                              : !bin.empty() && std::floor(point.velocity / binning.width) !=
                                                    std::floor(bin.front().velocity / binning.width);
        if (full) {
            result.points.push_back(mean_of(bin));
            bin.clear();
        }
        bin.push_back(point);
    }
    if (!bin.empty()) result.points.push_back(mean_of(bin));
    return result;
}

}  // namespace ashimpact
