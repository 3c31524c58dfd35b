#include "solver/contact/registry.hpp"

#include "materials/base/checks.hpp"
#include "materials/base/text.hpp"

namespace ashimpact {

std::string law_names() {
    return joined(RegisteredLaws::names);
}

Law Law::named(std::string_view name) {
    for (std::size_t index = 0; index < RegisteredLaws::size; ++index) {
        if (RegisteredLaws::names[index] == name) return Law(index);
    }
    throw unknown_name("contact law", name, {RegisteredLaws::names.begin(), RegisteredLaws::names.end()});
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
    std::vector<std::string> names;
    for (const DetachmentName& entry : detachment_names) {
        if (entry.name == name) return entry.detachment;
        names.emplace_back(entry.name);
    }
    throw unknown_name("detachment", name, names);
}

}  // namespace ashimpact
