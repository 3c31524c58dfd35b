// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/units/unit_system.hpp"

#include <array>
#include <memory>
#include <mutex>
#include <new>
#include <stdexcept>
#include <utility>

#include <udunits2.h>

#include "core/units/unit_text.hpp"

namespace ashimpact {

namespace {

struct SystemDeleter {
    void operator()(ut_system* system) const { ut_free_system(system); }
};
struct UnitDeleter {
    void operator()(ut_unit* unit) const { ut_free(unit); }
};
struct ConverterDeleter {
    void operator()(cv_converter* converter) const { cv_free(converter); }
};
using System = std::unique_ptr<ut_system, SystemDeleter>;
using Unit = std::unique_ptr<ut_unit, UnitDeleter>;
using Converter = std::unique_ptr<cv_converter, ConverterDeleter>;

struct NamedUnit {
    const char* symbol;  ///< case matters; may be null
    const char* name;    ///< in any case; may be null
    const char* definition;
};

/// Units common in input about fly ash. A definition may only use rows above it. No symbol with a prefix may
/// coincide with another unit of the database (with a tonne, ft would be a femtotonne).
constexpr std::array named_units{
    NamedUnit{"N", "newton", "kg.m.s-2"},   NamedUnit{"Pa", "pascal", "N.m-2"},
    NamedUnit{"J", "joule", "N.m"},         NamedUnit{"W", "watt", "J.s-1"},
    NamedUnit{"g", "gram", "1e-3 kg"},      NamedUnit{nullptr, "bar", "1e5 Pa"},
    NamedUnit{"dyn", "dyne", "1e-5 N"},     NamedUnit{nullptr, "erg", "1e-7 J"},
    NamedUnit{nullptr, "micron", "1e-6 m"}, NamedUnit{nullptr, "angstrom", "1e-10 m"},
    NamedUnit{"%", "percent", "0.01"},
};

constexpr std::array symbol_prefixes{
    std::pair{"T", 1e12},  std::pair{"G", 1e9},   std::pair{"M", 1e6},  std::pair{"k", 1e3},
    std::pair{"c", 1e-2},  std::pair{"m", 1e-3},  std::pair{"u", 1e-6}, std::pair{"n", 1e-9},
    std::pair{"p", 1e-12}, std::pair{"f", 1e-15},
};
constexpr std::array name_prefixes{
    std::pair{"giga", 1e9},   std::pair{"mega", 1e6},   std::pair{"kilo", 1e3},  std::pair{"centi", 1e-2},
    std::pair{"milli", 1e-3}, std::pair{"micro", 1e-6}, std::pair{"nano", 1e-9},
};

void ensure(ut_status status) {
    if (status != UT_SUCCESS) throw std::logic_error("a row of the unit table was refused");
}

void name_unit(const ut_unit* unit, const char* symbol, const char* name) {
    if (symbol) ensure(ut_map_symbol_to_unit(symbol, UT_ASCII, unit));
    if (name) ensure(ut_map_name_to_unit(name, UT_ASCII, unit));
}

System make_small_system() {
    System system(ut_new_system());
    if (!system) throw std::bad_alloc();
    for (const auto& [prefix, factor] : symbol_prefixes)
        ensure(ut_add_symbol_prefix(system.get(), prefix, factor));
    for (const auto& [prefix, factor] : name_prefixes)
        ensure(ut_add_name_prefix(system.get(), prefix, factor));
    for (const auto& [symbol, name] : {std::pair{"m", "meter"}, {"kg", "kilogram"}, {"s", "second"}})
        name_unit(Unit(ut_new_base_unit(system.get())).get(), symbol, name);
    for (const auto& [symbol, name, definition] : named_units)
        name_unit(Unit(ut_parse(system.get(), definition, UT_ASCII)).get(), symbol, name);
    return system;
}

const ut_system* small_system() {
    static const System system = make_small_system();
    return system.get();
}

/// The UDUNITS-2 database; null if the machine has none.
const ut_system* database() {
    static const System system(ut_read_xml(nullptr));
    return system.get();
}

UnitScale scale_in(const ut_system* system, const std::string& unit, const std::string& target) {
    if (!system) return {.problem = UnitProblem::unknown};
    const Unit from(ut_parse(system, unit.c_str(), UT_ASCII));
    if (!from) return {.problem = UnitProblem::unknown};
    const Unit to(ut_parse(system, target.c_str(), UT_ASCII));
    if (!to || !ut_are_convertible(from.get(), to.get())) return {.problem = UnitProblem::other_dimension};
    const Converter converter(ut_get_converter(from.get(), to.get()));
    if (!converter) return {.problem = UnitProblem::other_dimension};
    // An offset shows at zero, a logarithm or a reciprocal (s from 1/s counts as convertible) in 2 x.
    const double at_one = cv_convert_double(converter.get(), 1);
    if (cv_convert_double(converter.get(), 0) != 0 || cv_convert_double(converter.get(), 2) != 2 * at_one)
        return {.problem = UnitProblem::other_dimension};
    return {.scale = at_one};
}

/// Locks UDUNITS-2, which parses through global state.
std::unique_lock<std::mutex> hold_library() {
    static std::mutex mutex;
    std::unique_lock lock(mutex);
    static const auto printing_handler = ut_set_error_message_handler(ut_ignore);
    static_cast<void>(printing_handler);
    return lock;
}

}  // namespace

UnitScale database_scale_to(std::string_view unit, std::string_view target) {
    const std::string text = ascii(unit);
    if (!names_a_unit(text)) return {.problem = UnitProblem::unknown};
    const auto lock = hold_library();
    return scale_in(database(), text, std::string(target));
}

UnitScale scale_to(std::string_view unit, std::string_view target) {
    const std::string text = ascii(unit);
    if (!names_a_unit(text)) return {.problem = UnitProblem::unknown};
    const auto lock = hold_library();
    const UnitScale quick = scale_in(small_system(), text, std::string(target));
    return quick.problem == UnitProblem::unknown ? scale_in(database(), text, std::string(target)) : quick;
}

}  // namespace ashimpact
