#include "pipeline/edits.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "materials/base/error.hpp"
#include "materials/base/json_input.hpp"
#include "materials/base/text.hpp"
#include "materials/contact_properties.hpp"

namespace ashimpact {

namespace {

/// Relative difference up to which two numbers are one, written with fewer digits.
constexpr double same_number = 1e-9;

double number_at(const Json& object, const char* key) {
    return object.at(key).at("value").get<double>();
}

/// Refuses an edited quantity in another form or unit than the one that was written, as the two are compared.
void require_form_of(const Json& was, const Json& now, const std::string& pointer) {
    for (const auto& [key, written] : was.items()) {
        if (!written.is_object() || !now.contains(key)) continue;
        const Json& edited = now.at(key);
        const std::string place = child_pointer(pointer, key);
        if (!written.contains("value")) {
            if (edited.is_object()) require_form_of(written, edited, place);
            continue;
        }
        const bool alike = edited.is_object() && edited.contains("value") && edited["value"].is_number() &&
                           edited.value("unit", Json()) == written.value("unit", Json());
        if (!alike)
            throw InputError("is not in the form in which it was written",
                             "an object with \"value\", a number, and the unit that was there")
                .at(place);
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
        require_form_of(was_, now_, pointer_);
    }

    /// Refuses a part whose quantities have another form than they had in @p was.
    void require_form(const char* part, const Json& was) const {
        require_form_of(was, now_.at(part), child_pointer(pointer_, part));
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
        fit.require_form("extrapolated", {{"critical_damping", was.at("critical_damping")}});
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

}  // namespace

Json originals_of(const std::string& schema, const Json& result) {
    Json originals = Json::array();
    if ((schema != "6-fit" && schema != "2-contact") || !result.contains("samples")) return originals;
    for (std::size_t i = 0; i < result.at("samples").size(); ++i) {
        const Json& sample = result.at("samples")[i];
        const std::string pointer = "/result/samples/" + std::to_string(i);
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
        Edited edited(result.at(within), original.at("value"), at);
        const std::vector<std::string> done = schema == "2-contact"
                                                  ? reconcile_mass(std::move(edited))
                                                  : reconcile_fit(std::move(edited), original.at("value"));
        told.insert(told.end(), done.begin(), done.end());
    }
    return told;
}

}  // namespace ashimpact
