// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

#include "core/quantities/parameter.hpp"
#include "solver/batch/lanes/number_task.hpp"

namespace ashimpact {

class Law;

namespace batch {

/// One column as the kernels read it.
struct Input {
    const double* values = nullptr;
    std::size_t size = 0;  ///< 1: one value for all

    [[nodiscard]] double at(std::size_t i) const { return values[size == 1 ? 0 : i]; }
};

/// The values of a law parameter.
struct ParameterInput {
    const LawParameter* parameter = nullptr;
    Input values{};
};

/// Inputs of the problems of a task; those that a kind of task does not use stay empty.
struct Inputs {
    Input mass{};
    Input effective_radius{};
    Input contact_modulus{};
    Input work_of_adhesion{};
    Input yield_pressure{};
    Input damping{};
    Input velocity{};
    Input restitution{};
    std::array<ParameterInput, most_parameter_values> parameters{};  ///< the first parameter_count are used
    std::size_t parameter_count = 0;
};

class CriticalTable;
class RestitutionTable;
enum class PieceState : std::uint8_t;

/// A chunk of impacts for one thread.
struct ImpactTask {
    DampingLaw damping_law;
    Detachment detachment;
    bool with_contact_time;
    bool turning_point;
    RestitutionTable* table;  ///< none: integrate all; turning points are integrated in any case
    std::size_t count;
    Inputs inputs;
    LaneEnd* end;
    double* restitution;      ///< 0 where it is not a rebound [1]
    double* contact_time;     ///< NaN where it is not a rebound; undefined without with_contact_time [s]
    double* approach_time;    ///< NaN where it never turns; untouched without turning_point [s]
    double* maximum_overlap;  ///< NaN where the turn is in doubt; untouched without turning_point [m]
};

/// A chunk of impacts for one thread: searches the dampings that give their restitutions.
struct InversionTask {
    DampingLaw damping_law;
    Detachment detachment;
    RestitutionTable* table;  ///< none: integrate all
    std::size_t count;
    Inputs inputs;        ///< damping: the single value 1
    double* number_unit;  ///< damping coefficient of damping number 1 [unit of the law]
    double* number;       ///< damping number found [1]
    double* undamped;     ///< e_0, restitution without damping [1]
    std::uint8_t* found;  ///< 1 if the search converged
};

/// A chunk of critical velocities for one thread, read from their table; undecided where the contact has no
/// adhesion or no damping.
struct CriticalTask {
    DampingLaw damping_law;
    CriticalTable* table;
    std::size_t count;
    Inputs inputs;
    PieceState* state;  ///< of the piece of the table
    double* value;      ///< v_c, where tabulated [m/s]
};

/// The kernels of one contact law for the chosen instruction set.
struct Kernels {
    void (*impacts)(const ImpactTask&);
    NumberKernel numbers;
    void (*inversions)(const InversionTask&);
    void (*critical_velocities)(const CriticalTask&);
};

/// The kernels of a contact law; CMake makes their sources from kernel.cpp.in.
template <template <class> class L>
[[nodiscard]] Kernels law_kernels();

/// The kernels of a law; without any, every problem is left to the scalar solver.
[[nodiscard]] Kernels kernels_of(Law law, DampingLaw damping_law);

/// Transition parameters of cohesive zones [1], NaN for problems that have none or one beyond the law's
/// range.
void find_transition_parameters(const Inputs& inputs, std::size_t count, double* out);

/// Whether there are kernels: the contact law is in the list of solver/CMakeLists.txt, and the damping law
/// has one number.
[[nodiscard]] bool has_kernels(Law law, DampingLaw damping_law);

/// The table of a law's impacts for the chosen instruction set.
[[nodiscard]] RestitutionTable& restitution_table(Law law, Detachment detachment, DampingLaw damping_law);

}  // namespace batch

/// Instruction sets this program was built for and this processor has, the best first: "avx512", "avx2",
/// "baseline".
[[nodiscard]] std::vector<std::string_view> instruction_sets();

/// Makes every later batch use this instruction set, for measurements and tests. No other thread may be in a
/// batch meanwhile. @param name empty: the best one again @throws InputError naming the available ones
void use_instruction_set(std::string_view name);

}  // namespace ashimpact
