// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <initializer_list>
#include <limits>
#include <optional>
#include <stdexcept>
#include <string_view>
#include <utility>

#include "core/units/units.hpp"

namespace ashimpact {

/// A parameter of a contact law, beyond the properties that every contact pair has. A law declares its
/// parameters in its header; command line, case, schema, sweep and batch take them from there.
struct LawParameter {
    /// Key in JSON; the option of the command line is "--" and the name with hyphens. Laws that take the same
    /// quantity share the declaration.
    std::string_view name;
    Dimension dimension;
    std::string_view description;  ///< for help and messages: "k_c, cohesion energy per volume of overlap"
    std::string_view example;      ///< as a user writes it, at fly-ash scale: "20 MJ/m3"
    double typical;                ///< the same number [SI unit of the dimension]; the contract suite uses it
    bool may_be_zero = false;
    double greatest = std::numeric_limits<double>::infinity();  ///< bound, inclusive [SI]
    std::optional<double> otherwise{};  ///< default value; none: a value must be given [SI]
    /// Parameters of a law that share a number other than 0 are alternatives: exactly one must be given.
    int choice = 0;
    /// Power of the unit of overlap with which the parameter goes in softened contacts. Needed for a length,
    /// whose dimension leaves it open; see length_power() in solver/dem/softening.hpp.
    std::optional<double> length_power{};
    bool of_attraction = false;  ///< of a damping law: without effect on a contact law that has no attraction
};

/// Most parameters with a value that a contact pair carries.
inline constexpr std::size_t most_parameter_values = 4;

/// Values of law parameters by name. A pair may carry values for several laws; each law reads its own.
template <class Real>
class ParameterValues {
  public:
    using Entry = std::pair<std::string_view, Real>;

    constexpr ParameterValues() = default;
    /// @param values names and values [SI]; a name is that of a LawParameter, it must outlive the values
    constexpr ParameterValues(std::initializer_list<Entry> values) {
        for (const Entry& entry : values) set(entry.first, entry.second);
    }

    /// Sets the value of the parameter called @p name [SI]. @throws std::logic_error if there is no room
    constexpr void set(std::string_view name, const Real& value) {
        std::size_t i = 0;
        while (i < size_ && entries_[i].first != name) ++i;
        if (i == most_parameter_values) throw std::logic_error("too many law parameters for one pair");
        entries_[i] = {name, value};
        if (i == size_) ++size_;
    }
    /// Whether @p parameter was given.
    [[nodiscard]] constexpr bool has(const LawParameter& parameter) const {
        return find(parameter.name) != nullptr;
    }
    /// Returns the value given, else the parameter's default, else NaN [SI].
    [[nodiscard]] constexpr Real operator[](const LawParameter& parameter) const {
        if (const Real* value = find(parameter.name)) return *value;
        return Real(parameter.otherwise.value_or(std::numeric_limits<double>::quiet_NaN()));
    }

    [[nodiscard]] constexpr const Entry* begin() const { return entries_.data(); }
    [[nodiscard]] constexpr const Entry* end() const { return entries_.data() + size_; }

  private:
    [[nodiscard]] constexpr const Real* find(std::string_view name) const {
        for (const Entry& entry : *this)
            if (entry.first == name) return &entry.second;
        return nullptr;
    }

    std::array<Entry, most_parameter_values> entries_{};
    std::size_t size_ = 0;
};

}  // namespace ashimpact
