// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>

#include "solver/batch/columns.hpp"
#include "solver/batch/kernel.hpp"
#include "solver/motion/impact.hpp"

namespace ashimpact::batch {

[[nodiscard]] inline Input input_of(const Column& column) {
    return {column.data(), column.size() == 1};
}

/// The columns of the parameters that a law takes. @throws InputError where one is missing
[[nodiscard]] ParameterInputs parameter_inputs(Law law, const ContactColumns& contact);

/// Inputs with the contact pairs of a law; the rest stays empty.
/// @throws InputError where a parameter of the law is missing
[[nodiscard]] inline Inputs inputs_of(Law law, const ContactColumns& contact) {
    return {.mass = input_of(contact.mass),
            .effective_radius = input_of(contact.effective_radius),
            .contact_modulus = input_of(contact.contact_modulus),
            .work_of_adhesion = input_of(contact.work_of_adhesion),
            .yield_pressure = input_of(contact.yield_pressure),
            .parameters = parameter_inputs(law, contact)};
}

/// The inputs of one pair; they refer to the numbers of @p contact, which must outlive them.
[[nodiscard]] Inputs inputs_of(Law law, const ContactPair& contact);

/// Makes @p pair that of problem @p i. The parameters it carries must be those of the same inputs, or none.
inline void set_pair(ContactPair& pair, const Inputs& in, std::size_t i) {
    pair.mass = in.mass.at(i);
    pair.effective_radius = in.effective_radius.at(i);
    pair.contact_modulus = in.contact_modulus.at(i);
    pair.work_of_adhesion = in.work_of_adhesion.at(i);
    pair.yield_pressure = in.yield_pressure.at(i);
    for (std::size_t k = 0; k < in.parameters.count; ++k)
        pair.parameters.set(in.parameters.parameter[k]->name, in.parameters.values[k].at(i));
}
[[nodiscard]] inline ContactPair pair_at(const Inputs& in, std::size_t i) {
    ContactPair pair{};
    set_pair(pair, in, i);
    return pair;
}

/// How many problems pass validate() of an Impact in all inputs given, with a restitution that is finite and
/// not negative, until the first that does not; count if all do.
[[nodiscard]] std::size_t admissible_count(const Inputs& in, std::size_t count);

/// Whether the kernel has decided an impact, and its end is possible: 0 < e < 1 if damped, and a positive
/// contact time if it was asked for. The scalar solver takes the others.
[[nodiscard]] inline bool is_possible_end(const ImpactTask& task, std::size_t i) {
    if (task.end[i] == LaneEnd::undecided) return false;
    if (task.end[i] == LaneEnd::capture) return true;
    const double e = task.restitution[i];
    const bool damped = task.inputs.damping.at(i) > 0.0;
    if (!(e > 0.0 && (damped ? e < 1.0 : e <= 1.0))) return false;
    const double time = task.contact_time[i];
    return !task.with_contact_time || (time > 0.0 && std::isfinite(time));
}

/// Finds the first inadmissible problem of a batch. Several threads may check chunks at once.
class FirstFault {
  public:
    /// Checks a chunk. @return whether all of it is admissible
    bool check(const Inputs& chunk, std::size_t first, std::size_t count);
    /// If a problem is not admissible: calls @p refuse with its place, and adds the place to the InputError
    /// that it throws.
    void raise(const std::function<void(std::size_t)>& refuse) const;

  private:
    static constexpr std::size_t none = std::numeric_limits<std::size_t>::max();
    std::atomic<std::size_t> place_{none};
};

}  // namespace ashimpact::batch
