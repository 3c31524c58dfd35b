#pragma once

namespace ashimpact {

/// The scalar solver's number type: its extra bits tell capture from rebound where the adhesive well is a
/// million times deeper than the kinetic energy.
using Extended = long double;

}  // namespace ashimpact
