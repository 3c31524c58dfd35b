// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <initializer_list>

#include "solver/batch/batch.hpp"
#include "solver/batch/kernels/kernel.hpp"

namespace ashimpact::batch {

/// A column of a batch beside those of its contacts, and which of a kernel's inputs it is.
struct OwnColumn {
    Input Inputs::*input;
    const Column& values;
};

/// The problems of a batch, or of a chunk of it, as kernels read them. An input that a kind of problem does
/// not have is the number 1.
struct Problems {
    Law law;
    Detachment detachment;
    DampingLaw damping_law;
    std::size_t count;
    Inputs inputs;

    [[nodiscard]] Eigen::Index size() const { return static_cast<Eigen::Index>(count); }
    [[nodiscard]] Damping damping(std::size_t i) const { return {damping_law, inputs.damping.at(i)}; }
    [[nodiscard]] ContactPair contact(std::size_t i) const;
    [[nodiscard]] Impact impact(std::size_t i) const {
        return {law, detachment, damping(i), contact(i), inputs.velocity.at(i)};
    }
    /// The problems of a chunk.
    [[nodiscard]] Problems part(std::size_t first, std::size_t size) const;
};

/// @throws InputError if the law does not admit the detachment, if lengths of columns differ, or if a
/// parameter of one of the laws is missing
[[nodiscard]] Problems problems_of(Law law, Detachment detachment, DampingLaw damping_law,
                                   const ContactColumns& contact, std::initializer_list<OwnColumn> own);

/// The inputs of one pair; they refer to the numbers of @p contact, which must outlive them.
[[nodiscard]] Inputs inputs_of(Law law, DampingLaw damping_law, const ContactPair& contact);

/// Checks that a law admits a detachment, as refusal() does. @throws InputError
void require_admissible(Law law, Detachment detachment);

/// How many problems pass validate() of an Impact in all inputs given, with a restitution that is finite and
/// not negative, until the first that does not; count if all do.
[[nodiscard]] std::size_t admissible_count(const Inputs& in, std::size_t count);

/// Solves a batch in chunks of a kernel's task.
/// @param threads 0: one for each core
/// @param solve solves a chunk, the first problem of which is the batch's @p first; returns how many of it
/// were left to the scalar solver
/// @return how many were left to the scalar solver
/// @throws InputError naming the first inadmissible problem
std::int64_t solve_in_chunks(
    const Problems& batch, int threads,
    const std::function<std::int64_t(const Problems& chunk, std::size_t first)>& solve);

/// The table of a batch's impacts; null with BatchMethod::integration. @throws InputError if there is none
[[nodiscard]] RestitutionTable* table_for(BatchMethod method, const Problems& problems);

/// Whether the kernel has decided an impact, and its end is possible: 0 < e < 1 if damped, and a positive
/// contact time if it is computed. The scalar solver takes the others.
[[nodiscard]] bool is_possible_end(const ImpactTask& task, std::size_t i);

/// Values that a column may have.
struct Range {
    double least;
    double greatest;
    bool or_zero = false;

    [[nodiscard]] bool holds(double value) const {
        return (value >= least && value <= greatest) || (or_zero && value == 0.0);
    }
};

}  // namespace ashimpact::batch
