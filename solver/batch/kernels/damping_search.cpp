// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/batch/kernels/damping_search.hpp"

#include <algorithm>
#include <cmath>

namespace ashimpact::batch {

DampingSearch::DampingSearch(DampingLaw law, double restitution, double undamped)
    : number_of_loss_(1.0 - restitution / undamped), undamped_(undamped) {
    const double wanted = number_of_loss_.wanted();
    const bool possible = wanted > 0.0 && wanted < 1.0;
    if (possible) number_ = hertz_damping_number(law, wanted);
    found_ = !possible;
    number_of_loss_.insert({.value = 0.0, .x = 0.0});
    number_of_loss_.bound(0.0, true);
}

void DampingSearch::observe(double restitution) {
    const double loss = 1.0 - restitution / undamped_;
    number_of_loss_.bound(number_, loss < number_of_loss_.wanted());
    double next = -1.0;
    if (restitution > 0.0) {
        number_of_loss_.insert({.value = loss, .x = number_});
        next = number_of_loss_.interpolated();
        found_ = std::abs(next - number_) <= converged * number_;
    }
    const double lower = number_of_loss_.lower();
    const double upper = std::isinf(number_of_loss_.upper()) ? 2.0 * number_ : number_of_loss_.upper();
    const bool inside = next > lower && next < upper;
    number_ = inside || found_ ? next : 0.5 * (lower + upper);
}

}  // namespace ashimpact::batch
