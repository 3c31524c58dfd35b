// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/run/uncertainty/contact_models.hpp"

#include "solver/inference/measured_damping.hpp"

namespace ashimpact {

bool has_contact_model(const LawChoice& choice, DampingLaw damping_law, const ContactPair& contact) {
    return restitution_rises(damping_law) && choice.detachment != Detachment::zero_force &&
           is_self_similar(choice.law, contact);
}

ContactModel ContactModels::model_for(const LawChoice& choice, const ContactPair& contact,
                                      const MeasurementSet& impacts) {
    const VelocityRange range = velocities_for_fits(choice.law, choice.detachment, contact, impacts);
    const Key key{std::string(choice.law.name()),
                  choice.detachment,
                  {contact.mass, contact.effective_radius, contact.contact_modulus, contact.work_of_adhesion,
                   range.lower, range.upper}};
    const auto made = [&] {
        const std::lock_guard lock(access_);
        std::shared_future<Map>& map = maps_[key];
        if (!map.valid())  // made by the first caller, outside the lock
            map = std::async(std::launch::deferred, [choice, contact, range] {
                      return make_restitution_map(choice.law, choice.detachment, {contact}, range);
                  }).share();
        return map;
    }();
    return {made.get(), contact};
}

}  // namespace ashimpact
