#include "solver/reconstruction.hpp"

#include "materials/error.hpp"
#include "solver/critical_velocity.hpp"
#include "solver/gsl/root.hpp"

#include <cmath>
#include <string>

namespace ashimpact {

namespace {

Impact impact_with(const PublishedDamping& published, double e, double velocity) {
    return {.law = published.law,
            .detachment = published.detachment,
            .damping = {DampingLaw::constant, published.damping(e)},
            .contact = published.contact,
            .velocity = velocity};
}

[[noreturn]] void not_reached(double restitution, const std::string& allowed) {
    throw InputError("restitution " + std::to_string(restitution) + " is not reached at any velocity",
                     allowed);
}

}  // namespace

double velocity_of_restitution(const Impact& impact, double restitution) {
    if (impact.damping.law != DampingLaw::constant) {
        throw InputError("restitution need not rise with velocity for damping law '" +
                             std::string(name_of(impact.damping.law)) + "'",
                         std::string(name_of(DampingLaw::constant)));
    }
    if (!(restitution > 0.0 && restitution < 1.0)) not_reached(restitution, "0 < e < 1");
    const CriticalVelocity critical =
        critical_velocity({impact.law, impact.detachment, impact.damping, impact.contact});
    if (critical.verdict != CaptureVerdict::finite) {
        not_reached(restitution, "a damping with a finite critical velocity; here: " +
                                     std::string(name_of(critical.verdict)));
    }
    const auto miss = [&](double log_velocity) {
        Impact at = impact;
        at.velocity = std::exp(log_velocity);
        return restitution_of(at) - restitution;
    };
    const double lower = std::log(*critical.value);
    double width = 1.0;
    while (miss(lower + width) < 0.0) {
        width *= 2.0;
        if (width > 256.0) not_reached(restitution, "a smaller restitution for this damping law");
    }
    return std::exp(gsl::brent(miss, lower, lower + width, {.relative = 0.0, .absolute = 1e-13}).root);
}

double reconstructed_velocity(const PublishedDamping& published, double e) {
    return velocity_of_restitution(impact_with(published, e, 1.0), e);
}

double reconstructed_restitution(const PublishedDamping& published, double velocity) {
    const auto miss = [&](double e) { return restitution_of(impact_with(published, e, velocity)) - e; };
    if (miss(0.0) <= 0.0) return 0.0;
    return gsl::brent(miss, 0.0, 1.0, {.relative = 0.0, .absolute = 1e-13}).root;
}

}  // namespace ashimpact
