// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/document/edits.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "core/error.hpp"
#include "core/json/document.hpp"
#include "core/json/view.hpp"
#include "core/text.hpp"
#include "materials/contact_properties.hpp"

namespace ashimpact {

namespace {

/// Relative difference up to which two numbers are one, written with fewer digits.
constexpr double same_number = 1e-9;

double number_at(const Json& object, const char* key) {
    return object.at(key).at("value").get<double>();
}

/// The dimension of which @p unit is the SI unit, as artifacts have it.
std::optional<Dimension> dimension_of_unit(const Json& unit) {
    for (int i = 0; i <= static_cast<int>(Dimension::impulse); ++i)
        if (unit == si_unit(static_cast<Dimension>(i))) return static_cast<Dimension>(i);
    return std::nullopt;
}

/// An edited quantity as it would have been written. A standard uncertainty that was left as it was when the
/// value got another unit is in the old one still.
Json as_written(const View& edited, const Json& was, Dimension dimension) {
    const Json& now = edited.json();
    if (now.is_object() && now.value("unit", Json()) == was.at("unit") && now.contains("value") &&
        now["value"].is_number())
        return now;
    Json converted = edited.quantity(dimension);
    if (now.is_object() && was.contains("standard_uncertainty") &&
        now.value("standard_uncertainty", Json()) == was["standard_uncertainty"])
        converted["standard_uncertainty"] = was["standard_uncertainty"];
    for (const char* key : {"origin", "source"})
        if (now.is_object() && now.contains(key)) converted[key] = now[key];
    return converted;
}

/// Converts edited quantities to the form and unit in which they were written.
/// @throws InputError for a quantity of another dimension
void to_form_of(const Json& was, Json& now, const std::string& pointer) {
    for (const auto& entry : was.items()) {
        const std::string& key = entry.key();
        const Json& written = entry.value();
        if (!written.is_object() || !now.contains(key)) continue;
        const std::string place = child_pointer(pointer, key);
        if (!written.contains("value")) {
            if (now[key].is_object()) to_form_of(written, now[key], place);
            continue;
        }
        const auto dimension = dimension_of_unit(written.value("unit", Json()));
        if (!dimension || now[key].is_null())
            throw InputError("is not in the form in which it was written",
                             "an object with \"value\" and \"unit\"")
                .at(place);
        now[key] = at_place(place, [&] { return as_written(View(now[key]), written, *dimension); });
    }
}

bool differ(double x, double y) {
    return std::abs(x - y) > same_number * std::max(std::abs(x), std::abs(y));
}

/// One object of a result, as it is now and as it was written.
class Edited {
  public:
    Edited(Json& now, const Json& was, std::string pointer)
        : now_(now), was_(was), pointer_(std::move(pointer)) {
        to_form_of(was_, now_, pointer_);
    }

    /// Converts the quantities of a part to the form that they had in @p was.
    void to_form(const char* part, const Json& was) {
        to_form_of(was, now_.at(part), child_pointer(pointer_, part));
    }
    [[nodiscard]] Json& now() { return now_; }
    [[nodiscard]] bool has(const char* key) const { return now_.contains(key) && was_.contains(key); }
    [[nodiscard]] double value(const char* key) const { return number_at(now_, key); }
    [[nodiscard]] bool changed(const char* key) const {
        return has(key) && differ(number_at(now_, key), number_at(was_, key));
    }
    /// Whether a value was edited, and its standard uncertainty left as it was.
    [[nodiscard]] bool lost_uncertainty(const char* key) const {
        return changed(key) && now_.at(key).contains("standard_uncertainty") &&
               was_.at(key).contains("standard_uncertainty") &&
               now_.at(key).at("standard_uncertainty") == was_.at(key).at("standard_uncertainty");
    }
    void drop_uncertainty(const char* key) {
        if (!lost_uncertainty(key)) return;
        now_.at(key).erase("standard_uncertainty");
        say(key, "the value was edited without its standard uncertainty, which is dropped");
    }
    /// Removes a part that belongs to other values than the edited ones.
    void drop(const char* key, const std::string& why) {
        if (now_.erase(key) > 0) say(key, "is dropped: " + why);
    }
    void set(const char* key, double value, const std::string& from) {
        now_.at(key)["value"] = value;
        say(key, fmt::format("follows {}, which was edited: {}", from, shortest(value)));
    }
    void say(const char* key, const std::string& what) {
        told_.push_back(child_pointer(pointer_, key) + ": " + what);
    }
    [[noreturn]] void refuse(const char* key, const std::string& problem, const std::string& allowed) const {
        throw InputError(problem, allowed).at(child_pointer(pointer_, key));
    }
    [[nodiscard]] std::vector<std::string> told() && { return std::move(told_); }

  private:
    Json& now_;
    const Json& was_;
    std::string pointer_;
    std::vector<std::string> told_{};
};

/// c and the critical damping are one number.
bool reconcile_critical_damping(Edited& fit) {
    const bool c = fit.changed("c");
    const bool critical = fit.changed("critical_damping");
    if (!c && !critical) return false;
    if (c && critical && differ(fit.value("c"), fit.value("critical_damping")))
        fit.refuse("critical_damping", "is not the c of the same fit, and both were edited",
                   "one of them edited, or both alike");
    fit.drop_uncertainty("c");
    fit.drop_uncertainty("critical_damping");
    const char* leading = c ? "c" : "critical_damping";
    const char* following = c ? "critical_damping" : "c";
    if (differ(fit.value("c"), fit.value("critical_damping"))) {
        fit.now().at(following).erase("standard_uncertainty");
        fit.set(following, fit.value(leading), leading);
    }
    return true;
}

/// The critical damping of the estimate, which v_c follows from where there is one.
bool reconcile_estimate(Edited& fit, const Json& was) {
    Json& now = fit.now();
    if (!now.contains("direct") || !now["direct"].is_object() || !was.contains("direct")) return false;
    const double value = number_at(now.at("direct"), "critical_damping");
    if (!differ(value, number_at(was.at("direct"), "critical_damping"))) return false;
    if (fit.changed("c") || fit.changed("critical_damping"))
        fit.refuse("critical_damping", "this and that of \"direct\" were both edited", "one of them edited");
    for (const char* key : {"c", "critical_damping"}) {
        now.at(key).erase("standard_uncertainty");
        fit.set(key, value, "critical_damping of direct");
    }
    return true;
}

std::vector<std::string> reconcile_fit(Edited fit, const Json& was) {
    constexpr auto of_others = "it is of the values before the edit";
    if (reconcile_estimate(fit, was) || reconcile_critical_damping(fit)) {
        for (const char* part : {"direct", "extrapolated", "comparison", "covariance"})
            fit.drop(part, of_others);
        return std::move(fit).told();
    }
    if (fit.changed("a") || fit.changed("b")) {
        for (const char* key : {"a", "b"}) fit.drop_uncertainty(key);
        for (const char* part : {"extrapolated", "comparison", "covariance"}) fit.drop(part, of_others);
    }
    if (fit.now().contains("extrapolated") && fit.now().at("extrapolated").is_object()) {
        const Json& curve = fit.now().at("extrapolated");
        fit.to_form("extrapolated", {{"critical_damping", was.at("critical_damping")}});
        if (differ(number_at(curve, "critical_damping"), fit.value("critical_damping")))
            fit.refuse("extrapolated", "its critical_damping is not that of the fit",
                       "an edited critical_damping of the fit itself, which the rest follows");
        constexpr std::array names{"c", "b", "a"};
        const Json& coefficients = curve.at("coefficients").at("values");
        for (std::size_t i = 0; i < std::min(names.size(), coefficients.size()); ++i)
            if (differ(coefficients[i].get<double>(), fit.value(names.at(i))))
                fit.refuse("extrapolated",
                           std::string("its coefficients are not a, b, c of the fit: ") + names.at(i),
                           "edited a, b, c of the fit itself, which the rest follows");
    }
    return std::move(fit).told();
}

/// R* and m* follow the two spheres.
void reconcile_pair(Edited& contact) {
    const Json& partner = contact.now().at("partner");
    const auto follow = [&](const char* key, double value) {
        if (!differ(value, contact.value(key))) return;
        if (contact.changed(key))
            contact.refuse(key, "is not that of the two spheres", "the value as it was, which follows them");
        contact.set(key, value, "one of the spheres");
    };
    follow("effective_radius", effective_radius(contact.value("radius"), number_at(partner, "radius")));
    follow("effective_mass", effective_mass(contact.value("mass"), number_at(partner, "mass")));
}

/// The mass is that of a sphere of that radius and density; what two spheres have in common follows both.
std::vector<std::string> reconcile_mass(Edited contact) {
    const bool two = contact.has("partner");
    const char* radius = two ? "radius" : "effective_radius";
    const auto volume = [&] { return 4.0 / 3.0 * std::numbers::pi * std::pow(contact.value(radius), 3); };
    for (const char* key : {"density", radius}) contact.drop_uncertainty(key);
    const bool size = contact.changed("density") || contact.changed(radius);
    const double mass = volume() * contact.value("density");
    const bool follows = differ(mass, contact.value("mass"));
    if (follows && size && contact.changed("mass"))
        contact.refuse("mass", "is not that of a sphere of this radius and density, and both were edited",
                       "the mass as it was, which follows radius and density");
    if (follows && size)
        contact.set("mass", mass, "radius and density");
    else if (follows && contact.changed("mass"))
        contact.set("density", contact.value("mass") / volume(), "the mass");
    if (two) reconcile_pair(contact);
    return std::move(contact).told();
}

constexpr std::array fraction_keys{"weight_fraction", "volume_fraction"};

/// Name and fractions of each phase of a sample.
Json composition_of(const Json& sample) {
    Json phases = Json::array();
    for (const Json& phase : sample.at("phases")) {
        Json kept{{"name", phase.at("name")}};
        for (const char* key : fraction_keys) kept[key] = phase.at(key);
        phases.push_back(std::move(kept));
    }
    return {{"phases", phases}};
}

/// Says of edited fractions that no stage reads them: the modulus beside them was computed from the case.
/// They become plain numbers again, whatever their form.
std::vector<std::string> tell_unread_fractions(Json& sample, const Json& was, const std::string& pointer) {
    std::vector<std::string> told;
    Json& phases = sample.at("phases");
    for (std::size_t i = 0; i < std::min(phases.size(), was.at("phases").size()); ++i)
        for (const char* key : fraction_keys) {
            const std::string place = child_pointer(child_pointer(child_pointer(pointer, "phases"), i), key);
            Json& fraction = phases[i].at(key);
            fraction = at_place(place, [&] { return View(fraction).number(Dimension::fraction); });
            if (differ(fraction.get<double>(), was.at("phases")[i].at(key).get<double>()))
                told.push_back(place +
                               ": nothing is computed from it; edit the composition in 0-case.json, and "
                               "`run --from modulus`, or young_modulus here");
        }
    return told;
}

}  // namespace

Json originals_of(const std::string& schema, const Json& result) {
    Json originals = Json::array();
    if ((schema != "6-fit" && schema != "2-contact" && schema != "1-modulus") || !result.contains("samples"))
        return originals;
    for (std::size_t i = 0; i < result.at("samples").size(); ++i) {
        const Json& sample = result.at("samples")[i];
        const std::string pointer = "/result/samples/" + std::to_string(i);
        if (schema == "1-modulus") {
            originals.push_back({{"at", pointer}, {"value", composition_of(sample)}});
            continue;
        }
        if (schema == "2-contact") {
            Json value;
            for (const char* key :
                 {"effective_radius", "density", "mass", "radius", "effective_mass", "partner"})
                if (sample.contains(key)) value[key] = sample.at(key);
            originals.push_back({{"at", pointer}, {"value", value}});
            continue;
        }
        for (const auto& [law, fit] : sample.items()) {
            if (!fit.is_object()) continue;
            Json value;
            for (const char* key : {"a", "b", "c", "critical_damping"}) value[key] = fit.at(key);
            if (fit.contains("direct"))
                value["direct"] = {{"critical_damping", fit.at("direct").at("critical_damping")}};
            originals.push_back({{"at", child_pointer(pointer, law)}, {"value", value}});
        }
    }
    return originals;
}

std::vector<std::string> reconcile(const std::string& schema, Json& result, const Json& originals) {
    std::vector<std::string> told;
    for (const Json& original : originals) {
        const std::string at = original.at("at").get<std::string>();
        const Json::json_pointer within(at.substr(std::string_view("/result").size()));
        if (!result.contains(within)) continue;  // taken out by the reader
        if (schema == "1-modulus") {
            for (std::string& line : tell_unread_fractions(result.at(within), original.at("value"), at))
                told.push_back(std::move(line));
            continue;
        }
        Edited edited(result.at(within), original.at("value"), at);
        const std::vector<std::string> done = schema == "2-contact"
                                                  ? reconcile_mass(std::move(edited))
                                                  : reconcile_fit(std::move(edited), original.at("value"));
        told.insert(told.end(), done.begin(), done.end());
    }
    return told;
}

}  // namespace ashimpact
