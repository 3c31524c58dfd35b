// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/json/document.hpp"
#include "pipeline/case/case.hpp"

namespace ashimpact {

/// The case, complete, as a case document: reading it back gives the same case.
[[nodiscard]] Json case_json(const Case& data);

/// Parts of it that artifacts repeat.
[[nodiscard]] Json stated_json(const Stated& stated);
[[nodiscard]] Json quadratic_json(const DampingPolynomial& fit);
[[nodiscard]] Json published_json(const PublishedSample& published);

}  // namespace ashimpact
