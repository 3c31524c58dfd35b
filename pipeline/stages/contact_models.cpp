#include "pipeline/stages/contact_models.hpp"

#include <array>
#include <map>
#include <tuple>

#include "solver/scaled_impact.hpp"
#include "solver/uncertainty/measured_damping.hpp"

namespace ashimpact {

bool has_contact_model(const LawChoice& choice, DampingLaw damping_law, const ContactPair& contact) {
    return damping_law == DampingLaw::constant && !can_yield(choice.law, contact);
}

ContactModel contact_model_for(const LawChoice& choice, const ContactPair& contact,
                               const MeasurementSet& impacts) {
    // Only a map made for exactly the same question is used again: results do not depend on what ran before.
    using Key = std::tuple<std::string, Detachment, std::array<double, 6>>;
    static std::map<Key, std::shared_ptr<const RestitutionMap>> maps;
    const VelocityRange range = velocities_for_fits(choice.law, choice.detachment, contact, impacts);
    const Key key{std::string(choice.law.name()),
                  choice.detachment,
                  {contact.mass, contact.effective_radius, contact.contact_modulus, contact.work_of_adhesion,
                   range.lower, range.upper}};
    auto& map = maps[key];
    if (!map) map = make_restitution_map(choice.law, choice.detachment, {contact}, range);
    return {map, contact};
}

}  // namespace ashimpact
