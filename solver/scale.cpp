#include "solver/scale.hpp"

#include <cmath>

namespace ashimpact {

Scale Scale::of(const ContactPair& pair, double velocity) {
    const double stiffness = hertz_stiffness(pair);
    const double length = std::pow(pair.mass * velocity * velocity / stiffness, 0.4);
    return {.mass = pair.mass,
            .stiffness = stiffness,
            .velocity = velocity,
            .length = length,
            .radius_length = std::sqrt(pair.effective_radius * length)};
}

double Scale::damping_unit(DampingLaw law) const {
    switch (law) {
        case DampingLaw::constant:
            return momentum() / length;
        case DampingLaw::contact_radius:
            return momentum() / (length * radius_length);
        case DampingLaw::tsuji:
            return 1.0;  // sqrt(m k) L^(1/4) is the unit of damping itself
    }
    return 0.0;
}

double Scale::damping_number(const Damping& damping) const {
    return damping.coefficient / damping_unit(damping.law);
}

double Scale::damping_coefficient(DampingLaw law, double number) const {
    return number * damping_unit(law);
}

}  // namespace ashimpact
