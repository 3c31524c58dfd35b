// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/run/uncertainty/contact_models.hpp"

#include <array>
#include <future>
#include <map>
#include <mutex>
#include <tuple>

#include "solver/inference/measured_damping.hpp"

namespace ashimpact {

bool has_contact_model(const LawChoice& choice, DampingLaw damping_law, const ContactPair& contact) {
    return damping_law == DampingLaw::constant && is_self_similar(choice.law, contact);
}

ContactModel contact_model_for(const LawChoice& choice, const ContactPair& contact,
                               const MeasurementSet& impacts) {
    // A map is reused only for exactly the same inputs, so that results do not depend on what ran before.
    using Key = std::tuple<std::string, Detachment, std::array<double, 6>>;
    using Map = std::shared_ptr<const RestitutionMap>;
    static std::map<Key, std::shared_future<Map>> maps;
    static std::mutex access;
    const VelocityRange range = velocities_for_fits(choice.law, choice.detachment, contact, impacts);
    const Key key{std::string(choice.law.name()),
                  choice.detachment,
                  {contact.mass, contact.effective_radius, contact.contact_modulus, contact.work_of_adhesion,
                   range.lower, range.upper}};
    const auto made = [&] {
        const std::lock_guard lock(access);
        std::shared_future<Map>& map = maps[key];
        if (!map.valid())  // made by whoever asks first, outside the lock
            map = std::async(std::launch::deferred, [choice, contact, range] {
                      return make_restitution_map(choice.law, choice.detachment, {contact}, range);
                  }).share();
        return map;
    }();
    return {made.get(), contact};
}

}  // namespace ashimpact
