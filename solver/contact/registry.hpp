// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "solver/contact/brach_dunn.hpp"
#include "solver/contact/dmt.hpp"
#include "solver/contact/hertz.hpp"
#include "solver/contact/jkr.hpp"
#include "solver/contact/maugis_dugdale.hpp"
#include "solver/contact/sjkr.hpp"
#include "solver/contact/thornton_ning.hpp"

namespace ashimpact {

/// A list of contact laws; the position in the list is the identity of a law at run time.
template <template <class> class... L>
struct LawList {
    static constexpr std::size_t size = sizeof...(L);
    static constexpr std::array<std::string_view, size> names{L<double>::name...};

    /// Calls @p visitor.template operator()<Law>() for the law at @p index (which must be below size).
    template <class Result, class Visitor>
    static Result visit(std::size_t index, Visitor&& visitor) {
        using Entry = Result (*)(Visitor&);
        static constexpr std::array<Entry, size> entries{&call<L, Result, Visitor>...};
        return entries[index](visitor);
    }

  private:
    template <template <class> class One, class Result, class Visitor>
    static Result call(Visitor& visitor) {
        return visitor.template operator()<One>();
    }
};

/// Every contact law with dynamics. Registering a law is one word here.
using RegisteredLaws = LawList<Hertz, Dmt, BrachDunn, Jkr, ThorntonNing, Sjkr, MaugisDugdale>;

/// Whether overlap and force of a law are polynomials of u, as make_motion() takes them.
template <template <class> class L>
inline constexpr bool has_polynomials = requires(const L<double>& law) {
    law.overlap(1.0);
};

/// A registered contact law, chosen at run time.
class Law {
  public:
    /// @throws InputError naming the registered laws
    [[nodiscard]] static Law named(std::string_view name);
    /// The law of that template, e.g. Law::of<Dmt>().
    template <template <class> class L>
    [[nodiscard]] static constexpr Law of() {
        std::size_t index = 0;
        while (RegisteredLaws::names[index] != L<double>::name) ++index;
        return Law(index);
    }
    /// The law at a position of the registry, for loops over all of them.
    [[nodiscard]] static constexpr Law at(std::size_t index) { return Law(index); }
    [[nodiscard]] static constexpr std::size_t count() { return RegisteredLaws::size; }

    [[nodiscard]] constexpr std::size_t index() const { return index_; }
    [[nodiscard]] std::string_view name() const { return RegisteredLaws::names[index_]; }
    [[nodiscard]] Detachment default_detachment() const;
    /// The parameters that the law declares.
    [[nodiscard]] std::span<const LawParameter> parameters() const;
    /// Whether the law declares this parameter.
    [[nodiscard]] bool takes(const LawParameter& parameter) const;
    /// Whether scaled impacts of the law depend on the contact through the adhesion number alone. A law in
    /// which another number remains, such as a Tabor parameter, declares
    /// `static constexpr bool self_similar = false`; tables and maps leave it to the scalar solver.
    [[nodiscard]] bool self_similar() const;
    /// Whether the law's attraction depends on the work of adhesion.
    [[nodiscard]] bool uses_work_of_adhesion() const;

    /// Calls @p visitor.template operator()<L>() with the law's template.
    template <class Result, class Visitor>
    Result visit(Visitor&& visitor) const {
        return RegisteredLaws::visit<Result>(index_, visitor);
    }

    friend constexpr bool operator==(const Law&, const Law&) = default;

  private:
    explicit constexpr Law(std::size_t index) : index_(index) {}
    std::size_t index_;
};

/// The parameters of all registered laws, each name once.
[[nodiscard]] const std::vector<LawParameter>& law_parameters();

/// Parameters of a law of which too few or, of a choice, too many are given.
struct ParameterFault {
    std::vector<LawParameter> parameters;       ///< one, or those of a choice
    int given;                                  ///< 0, or two or more of a choice
    [[nodiscard]] std::string problem() const;  ///< "cohesion_energy_density is missing"
    [[nodiscard]] std::string allowed() const;  ///< what each of them is, in words
};

/// The first parameter or choice of the law that is not given as it must be; none if all are.
[[nodiscard]] std::optional<ParameterFault> parameter_fault(
    Law law, const std::function<bool(const LawParameter&)>& is_given);

/// Checks one value of a parameter [SI]. @throws InputError naming it, its value, unit and what is allowed
void require_allowed(const LawParameter& parameter, double value);

/// Checks that a law has the parameters it needs and that their values are allowed. @throws InputError
void require_parameters(Law law, const ParameterValues<double>& values);

/// Typical values of the parameters that a law requires, one for each choice. For code whose results do not
/// depend on them, such as tables in scaled numbers.
[[nodiscard]] ParameterValues<double> typical_parameters(Law law);

/// "hertz, dmt, ...", for messages.
[[nodiscard]] std::string law_names();

}  // namespace ashimpact
