#include "solver/contact/registry.hpp"

#include "materials/base/error.hpp"

namespace ashimpact {

namespace {

template <class Names>
std::string joined(const Names& names) {
    std::string text;
    for (const std::string_view name : names) {
        if (!text.empty()) text += ", ";
        text += name;
    }
    return text;
}

}  // namespace

std::string law_names() {
    return joined(RegisteredLaws::names);
}

Law Law::named(std::string_view name) {
    for (std::size_t index = 0; index < RegisteredLaws::size; ++index) {
        if (RegisteredLaws::names[index] == name) return Law(index);
    }
    throw InputError("unknown contact law '" + std::string(name) + "'", law_names());
}

Detachment Law::default_detachment() const {
    return visit<Detachment>([]<template <class> class L>() { return L<double>::default_detachment; });
}

std::string_view name_of(Detachment detachment) {
    for (const DetachmentName& entry : detachment_names) {
        if (entry.detachment == detachment) return entry.name;
    }
    return {};
}

Detachment detachment_named(std::string_view name) {
    std::array<std::string_view, detachment_names.size()> names;
    for (std::size_t i = 0; i < names.size(); ++i) {
        names[i] = detachment_names[i].name;
        if (names[i] == name) return detachment_names[i].detachment;
    }
    throw InputError("unknown detachment '" + std::string(name) + "'", joined(names));
}

}  // namespace ashimpact
