// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "pipeline/case/case.hpp"
#include "solver/surrogate/contact_model.hpp"

namespace ashimpact {

/// Whether measured impacts are fitted through the dynamic model of a law: constant damping and a contact
/// without a history. Others are inverted one by one and fitted by least squares.
[[nodiscard]] bool has_contact_model(const LawChoice& choice, DampingLaw damping_law,
                                     const ContactPair& contact);

/// The model of a law that serves fits of some impacts. Its map takes tenths of a second and several stages
/// need the same one, so it is kept while the program runs.
[[nodiscard]] ContactModel contact_model_for(const LawChoice& choice, const ContactPair& contact,
                                             const MeasurementSet& impacts);

}  // namespace ashimpact
