// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <concepts>
#include <type_traits>
#include <utility>

#include "pipeline/document/field_reader.hpp"
#include "pipeline/document/field_writer.hpp"
#include "pipeline/run/results/contact.hpp"
#include "pipeline/run/results/note.hpp"

/// One list of the fields of a struct gives its JSON object and reads it back:
///
///     void fields(auto& io, Is<ContactTimeAt> auto& time) {
///         io("law", time.law);
///         io("velocity", time.velocity, Dimension::velocity);
///         io("contact_time", time.contact_time, Dimension::time);
///     }
///
/// @p io is a FieldWriter or a FieldReader. The forms of single values are those of values_json.hpp; an
/// optional without a value is null, a list an array, values under names or laws an object, and a struct with
/// fields an object of these.
namespace ashimpact {

template <class T, class Struct>
concept Is = std::same_as<std::remove_const_t<T>, Struct>;

/// The JSON object of a struct with fields. @param law which determines the unit of damping coefficients
template <class Struct>
Json to_json(const Struct& value, DampingLaw law) {
    FieldWriter writer(law);
    fields(writer, value);
    return std::move(writer).json();
}

template <class Struct>
Struct from_json(const View& node, DampingLaw law) {
    Struct value{};
    FieldReader reader(node, law);
    fields(reader, value);
    return value;
}

template <class T>
requires detail::is_a<std::remove_const_t<T>, SampleResults>
void fields(auto& io, T& result) {
    io("samples", result.samples);
}

/// What is known of impacts beside their velocities.
void noise_fields(auto& io, Is<ListedImpacts> auto& columns) {
    io.unless_empty("velocity_uncertainty", columns.velocity_uncertainty, Dimension::velocity);
    io.unless_empty("rebound_uncertainty", columns.rebound_uncertainty, Dimension::velocity);
    io.unless_empty("velocity_correlation", columns.correlation, Dimension::fraction);
    io.unless_empty("rebound_resolution", columns.resolution, Dimension::velocity);
    io.unless_empty("noted_capture", columns.noted_captures, Dimension::fraction);
    io.unless_empty("tangential_velocity", columns.tangential, Dimension::velocity);
    io.unless_empty("impacts", columns.counts, Dimension::fraction);
}

void fields(auto& io, Is<ListedImpacts> auto& columns) {
    io("velocity", columns.velocity, Dimension::velocity);
    io("restitution", columns.restitution, Dimension::fraction);
    noise_fields(io, columns);
}

}  // namespace ashimpact
