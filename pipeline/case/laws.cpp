#include "pipeline/case/laws.hpp"

#include <stdexcept>

#include "solver/motion/scaled_impact.hpp"

namespace ashimpact {

bool yields(Law law) {
    return can_yield(
        law,
        {.mass = 1, .effective_radius = 1, .contact_modulus = 1, .work_of_adhesion = 1, .yield_pressure = 1});
}

Dimension dimension_of(DampingLaw law) {
    switch (law) {
        case DampingLaw::constant:
            return Dimension::damping;
        case DampingLaw::contact_radius:
            return Dimension::viscosity;
        case DampingLaw::tsuji:
            return Dimension::fraction;
    }
    throw std::logic_error("damping law without a dimension");
}

}  // namespace ashimpact
