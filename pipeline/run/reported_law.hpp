// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "pipeline/case/case.hpp"
#include "pipeline/run/results/contact.hpp"
#include "pipeline/run/results/reported.hpp"

namespace ashimpact {

/// Chooses one law for all samples of a run, by what is known before any velocity is compared: the Tabor
/// parameters of the contacts, whether they yield, and the laws of the case. No critical velocity enters,
/// neither a computed nor a measured one.
///
/// The order is: thornton-ning where the contact of a sample yields in every measured rebound;
/// maugis-dugdale, which holds for every Tabor parameter; JKR or DMT, whichever limit is nearer to the
/// geometric mean of the Tabor parameters (Johnson & Greenwood 1997); brach-dunn and sjkr, whose adhesion is
/// empirical; hertz.
///
/// Admissible are laws with a theory of the adhesion that one of the contacts has: maugis-dugdale always, DMT
/// up to a Tabor parameter of 5, JKR from 0.1. Where contacts yield only a law that includes it is. None of
/// the empirical laws is admissible, nor hertz where there is adhesion, unless it is the reported one.
/// @return none for a case without laws or samples
[[nodiscard]] std::optional<ReportedLaw> reported_law(const Case& data, const ContactResult& contacts);

/// The laws of the case in the order in which reported_law() prefers them.
[[nodiscard]] std::vector<Law> laws_by_preference(const Case& data, const ContactResult& contacts);

}  // namespace ashimpact
