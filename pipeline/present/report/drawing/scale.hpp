// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

namespace ashimpact::report {

enum class Spacing { linear, logarithmic };

/// Ends of an axis.
struct Range {
    double from;
    double to;
};

struct Tick {
    double value;
    std::string label;
};

/// Maps numbers to pixels along an axis.
class Scale {
  public:
    /// @param values from < to, both > 0 where logarithmic @param at pixels of the two ends
    Scale(Spacing spacing, Range values, Range at);

    [[nodiscard]] double operator()(double value) const;
    [[nodiscard]] const Range& values() const { return values_; }
    [[nodiscard]] const Range& at() const { return at_; }
    [[nodiscard]] Spacing spacing() const { return spacing_; }

    /// Round numbers within the range, at most @p most (but two at least), with labels.
    [[nodiscard]] std::vector<Tick> ticks(int most) const;

  private:
    Spacing spacing_;
    Range values_;
    Range at_;
};

/// Grows an empty or reversed range so that it can be an axis, and keeps a logarithmic one above 0.
[[nodiscard]] Range drawable(Range range, Spacing spacing);

/// A number as a label: "0.25", "2e-05" as "2·10⁻⁵".
[[nodiscard]] std::string number_label(double value);

}  // namespace ashimpact::report
