// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/contact/law.hpp"

#include <algorithm>

#include "core/text/error.hpp"
#include "core/text/text.hpp"
#include "solver/contact/registry.hpp"

namespace ashimpact {

std::vector<std::string> names_of_laws() {
    std::vector<std::string> names;
    for (std::size_t i = 0; i < Law::count(); ++i) names.emplace_back(Law::at(i).name());
    return names;
}

std::string law_names(bool (*fits)(Law)) {
    std::vector<std::string> names;
    for (std::size_t i = 0; i < Law::count(); ++i)
        if (fits(Law::at(i))) names.emplace_back(Law::at(i).name());
    return joined(names);
}

Law Law::named(std::string_view name) {
    for (std::size_t i = 0; i < count(); ++i)
        if (at(i).name() == name) return at(i);
    throw unknown_name("contact law", name, names_of_laws());
}

std::string_view Law::name() const {
    return visit<std::string_view>([]<template <class> class L>() {
        static_assert(
            has_polynomials<L> || requires { L<double>::has_cohesive_zone; },
            "solver/motion follows laws that are polynomials of u, or have a cohesive zone");
        return L<double>::name;
    });
}

std::string_view Law::summary() const {
    return visit<std::string_view>([]<template <class> class L>() { return L<double>::summary; });
}

std::string Law::page() const {
    return "docs/laws/" + std::string(name()) + ".md";
}

Detachment Law::default_detachment() const {
    return visit<Detachment>([]<template <class> class L>() { return L<double>::default_detachment; });
}

std::span<const LawParameter> Law::parameters() const {
    using Parameters = std::span<const LawParameter>;
    return visit<Parameters>([]<template <class> class L>() -> Parameters {
        if constexpr (requires { L<double>::parameters; }) return L<double>::parameters;
        return {};
    });
}

bool Law::takes(const LawParameter& parameter) const {
    return std::ranges::count(parameters(), parameter.name, &LawParameter::name) > 0;
}

bool Law::is_adhesive() const {
    return uses_work_of_adhesion() || !parameters().empty();
}

bool Law::uses_work_of_adhesion() const {
    return visit<bool>([]<template <class> class L>() { return L<double>::uses_work_of_adhesion; });
}

bool Law::self_similar() const {
    return visit<bool>([]<template <class> class L>() {
        if constexpr (requires { L<double>::self_similar; }) return L<double>::self_similar;
        return true;
    });
}

bool Law::is_plastic() const {
    return visit<bool>([]<template <class> class L>() {
        if constexpr (requires { L<double>::is_plastic; }) return L<double>::is_plastic;
        return false;
    });
}

bool Law::has_cohesive_zone() const {
    return visit<bool>([]<template <class> class L>() {
        if constexpr (requires { L<double>::has_cohesive_zone; }) return L<double>::has_cohesive_zone;
        return false;
    });
}

AdhesionRegime Law::limit() const {
    return visit<AdhesionRegime>([]<template <class> class L>() {
        if constexpr (requires { L<double>::limit; }) return L<double>::limit;
        return AdhesionRegime::none;
    });
}

Law Law::similar() const {
    return visit<Law>([this]<template <class> class L>() {
        if constexpr (requires { L<double>::similar; }) return named(L<double>::similar);
        return *this;
    });
}

Trust Law::trust(double tabor, bool yields) const {
    return visit<Trust>([=]<template <class> class L>() { return L<double>::trust(tabor, yields); });
}

PressureProfile Law::pressure(const ContactPair& contact, double a) const {
    return visit<PressureProfile>(
        [&]<template <class> class L>() { return L<double>::pressure(contact, a); });
}

}  // namespace ashimpact
