// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "solver/batch/kernels/kernel.hpp"
#include "solver/contact/law.hpp"
#include "solver/contact/pair.hpp"
#include "solver/damping/damping.hpp"

namespace ashimpact {

/// Impacts that come one by one: restitutions and critical velocities of one law, detachment and damping law
/// from their tables. The same bits as solve_impacts() with BatchMethod::table and critical_velocities(), for
/// a third of what a batch of one impact costs. Immutable, so that any number of threads may use it at once.
class SingleImpacts {
  public:
    /// @throws InputError if the law does not admit the detachment
    SingleImpacts(Law law, Detachment detachment, DampingLaw damping_law);

    /// Restitution e_n; 0 for a capture [1]. None if the impact is not admissible or needs the scalar solver:
    /// a batch of one impact then gives the result, or the reason why there is none.
    /// @param contact with the parameters that the law needs
    /// @param damping coefficient [unit of the damping law] @param velocity v_in [m/s]
    [[nodiscard]] std::optional<double> restitution(const ContactPair& contact, double damping,
                                                    double velocity) const;
    /// Critical velocity v_c; 0 if nothing is captured, infinite if everything is [m/s]. None as above.
    [[nodiscard]] std::optional<double> critical_velocity(const ContactPair& contact, double damping) const;

  private:
    Law law_;
    Detachment detachment_;
    DampingLaw damping_law_;
    batch::Kernels kernels_{};
    batch::RestitutionTable* table_ = nullptr;  ///< none: the law has no kernels
};

}  // namespace ashimpact
