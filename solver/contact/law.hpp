// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "solver/contact/mechanics.hpp"
#include "solver/contact/pair.hpp"

namespace ashimpact {

/// Every contact law; the header of each is included by registry.hpp alone.
template <class Real>
struct BrachDunn;
template <class Real>
struct Dmt;
template <class Real>
struct Hertz;
template <class Real>
struct Jkr;
template <class Real>
struct MaugisDugdale;
template <class Real>
struct Sjkr;
template <class Real>
struct ThorntonNing;

/// A list of contact laws. The position in the list is the identity of a law at run time.
template <template <class> class... L>
struct LawList {
    static constexpr std::size_t size = sizeof...(L);

    /// Position of law @p One in the list; size if it is not in it.
    template <template <class> class One>
    [[nodiscard]] static constexpr std::size_t index_of() {
        std::size_t index = 0;
        static_cast<void>(((Same<One, L>::value || (++index, false)) || ...));
        return index;
    }

  private:
    template <template <class> class A, template <class> class B>
    struct Same {
        static constexpr bool value = false;
    };
    template <template <class> class A>
    struct Same<A, A> {
        static constexpr bool value = true;
    };
};

/// The registered laws. Registering one is its declaration above, its word here, and its include in
/// registry.hpp.
using RegisteredLaws = LawList<Hertz, Dmt, BrachDunn, Jkr, ThorntonNing, Sjkr, MaugisDugdale>;

/// A registered contact law, chosen at run time. Its members return what the law's header states;
/// docs/adding-a-law.md lists the members of a header.
class Law {
  public:
    /// Hertz, the law without attraction.
    constexpr Law() = default;
    [[nodiscard]] static constexpr Law without_attraction() { return {}; }
    /// @throws InputError naming the registered laws
    [[nodiscard]] static Law named(std::string_view name);
    /// The law of that template, e.g. Law::of<Dmt>(), in tests and headers of laws.
    template <template <class> class L>
    [[nodiscard]] static constexpr Law of() {
        constexpr std::size_t index = RegisteredLaws::index_of<L>();
        static_assert(index < RegisteredLaws::size, "the law is not registered");
        return Law(index);
    }
    /// The law at a position of the list, for loops over all of them.
    [[nodiscard]] static constexpr Law at(std::size_t index) { return Law(index); }
    [[nodiscard]] static constexpr std::size_t count() { return RegisteredLaws::size; }

    [[nodiscard]] constexpr std::size_t index() const { return index_; }
    [[nodiscard]] std::string_view name() const;
    /// What the law describes, in some words.
    [[nodiscard]] std::string_view summary() const;
    /// Page of the documentation, "docs/laws/dmt.md".
    [[nodiscard]] std::string page() const;
    [[nodiscard]] Detachment default_detachment() const;
    /// The parameters that the law declares.
    [[nodiscard]] std::span<const LawParameter> parameters() const;
    /// Whether the law declares this parameter.
    [[nodiscard]] bool takes(const LawParameter& parameter) const;
    /// Whether the law has an attraction, from the work of adhesion or from its parameters.
    [[nodiscard]] bool is_adhesive() const;
    /// Whether the law's attraction depends on the work of adhesion.
    [[nodiscard]] bool uses_work_of_adhesion() const;
    /// Whether scaled elastic impacts of the law depend on the contact through the adhesion number alone.
    /// Tables and maps leave a law in which another number remains, such as a Tabor parameter, to the scalar
    /// solver.
    [[nodiscard]] bool self_similar() const;
    /// Whether contacts of the law with a yield pressure deform plastically.
    [[nodiscard]] bool is_plastic() const;
    /// Whether a contact with work of adhesion has a cohesive zone around it.
    [[nodiscard]] bool has_cohesive_zone() const;
    /// The limit of the Tabor parameter that the law is, dmt or jkr; none if it is neither.
    [[nodiscard]] AdhesionRegime limit() const;
    /// A self-similar law of nearly the same impacts, to bracket searches; the law itself if it states none.
    [[nodiscard]] Law similar() const;
    /// How far the law is to be trusted. @param tabor Tabor parameter, 0 without adhesion [1]
    /// @param yields whether the contact yields
    [[nodiscard]] Trust trust(double tabor, bool yields) const;
    /// Pressure under a contact of radius @p a [m] that has not yielded.
    [[nodiscard]] PressureProfile pressure(const ContactPair& contact, double a) const;

    /// Calls @p visitor.template operator()<L>() with the law's template. Include registry.hpp to use it.
    template <class Result, class Visitor>
    Result visit(Visitor&& visitor) const;

    friend constexpr bool operator==(const Law&, const Law&) = default;

  private:
    explicit constexpr Law(std::size_t index) : index_(index) {}
    std::size_t index_ = RegisteredLaws::index_of<Hertz>();
};

/// Names of all laws, in the order of the list.
[[nodiscard]] std::vector<std::string> names_of_laws();
/// "hertz, dmt, ...", the laws that fit, for messages.
[[nodiscard]] std::string law_names(bool (*fits)(Law) = [](Law) { return true; });

/// Whether a contact has a plastic history: the law is plastic and the yield pressure finite.
[[nodiscard]] inline bool can_yield(Law law, const ContactPair& contact) {
    return law.is_plastic() && std::isfinite(contact.yield_pressure);
}

/// Whether a contact has a cohesive zone. Without work of adhesion such a law is Hertz.
[[nodiscard]] inline bool is_cohesive(Law law, const ContactPair& contact) {
    return law.has_cohesive_zone() && contact.work_of_adhesion > 0.0;
}

/// Whether the scaled impacts of a contact depend on its adhesion and damping number alone: the law is
/// self-similar and the contact has no plastic history.
[[nodiscard]] inline bool is_self_similar(Law law, const ContactPair& contact) {
    return law.self_similar() && !can_yield(law, contact);
}

}  // namespace ashimpact
