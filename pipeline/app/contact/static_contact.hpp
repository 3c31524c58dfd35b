// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/finding.hpp"
#include "core/json/document.hpp"
#include "pipeline/app/command.hpp"
#include "pipeline/app/contact/single_contact.hpp"
#include "pipeline/present/text/layout.hpp"

namespace ashimpact {

/// The options --contact-radius, --force and --pressure: the JKR contact at rest, Dong et al. 2013, Eqs. 15
/// to 20; Hertz's without adhesion.
void add_static_options(Command& command);

/// Adds the contacts at rest that the options name to a JSON object, as `static`, and to a list; writes the
/// file of --pressure. Findings are of the widest one, or of the contact without a force where none is named.
/// @throws InputError naming the option, for a contact larger than a sphere too
void add_static_contacts(const CommandOptions& options, const ContactChoice& contact, Json& json,
                         TextList& list, std::vector<Finding>& findings);

}  // namespace ashimpact
