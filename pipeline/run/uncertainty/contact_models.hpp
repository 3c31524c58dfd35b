// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <future>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <tuple>

#include "pipeline/case/case.hpp"
#include "solver/surrogate/contact_model.hpp"

namespace ashimpact {

/// Whether restitution rises with velocity under a damping law, so that a restitution has one velocity. Maps,
/// tables and curves e(v) rely on it.
[[nodiscard]] constexpr bool restitution_rises(DampingLaw law) {
    return law == DampingLaw::constant;
}

/// Whether measured impacts are fitted through a dynamic model: constant damping, no history of the contact,
/// and a detachment that can capture. Others are inverted one by one and fitted by least squares.
[[nodiscard]] bool has_contact_model(const LawChoice& choice, DampingLaw damping_law,
                                     const ContactPair& contact);

/// The dynamic models of a run. A map takes tenths of a second and several stages need the same one, so each
/// is made once. One is reused only for exactly the same inputs: results do not depend on earlier calls.
class ContactModels {
  public:
    /// The model of a law that serves fits of some impacts.
    [[nodiscard]] ContactModel model_for(const LawChoice& choice, const ContactPair& contact,
                                         const MeasurementSet& impacts);

  private:
    using Key = std::tuple<std::string, Detachment, std::array<double, 6>>;
    using Map = std::shared_ptr<const RestitutionMap>;

    std::map<Key, std::shared_future<Map>> maps_{};
    std::mutex access_{};
};

}  // namespace ashimpact
