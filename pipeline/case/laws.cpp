#include "pipeline/case/laws.hpp"

#include "solver/motion/scaled_impact.hpp"

namespace ashimpact {

bool yields(Law law) {
    return can_yield(
        law,
        {.mass = 1, .effective_radius = 1, .contact_modulus = 1, .work_of_adhesion = 1, .yield_pressure = 1});
}

}  // namespace ashimpact
