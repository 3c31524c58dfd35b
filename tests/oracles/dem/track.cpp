// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/oracles/dem/track.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <utility>

#include <Eigen/LU>

namespace ashimpact::oracles {

namespace {

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

}  // namespace

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

Estimate extrapolate(std::span<const double> steps, std::span<const double> values,
                     std::span<const double> powers) {
    const double best = fit_powers(steps, values, powers).front();
    const auto lower = powers.first(powers.size() - 1);
    const double fine = fit_powers(steps.subspan(1), values.subspan(1), lower).front();
    const double coarse =
        fit_powers(steps.first(lower.size() + 1), values.first(lower.size() + 1), lower).front();
    return {best, std::max(std::abs(best - fine), std::abs(best - coarse))};
}

}  // namespace ashimpact::oracles
