#pragma once

#include "solver/critical_velocity/critical_velocity.hpp"

#include <array>
#include <memory>
#include <mutex>
#include <optional>
#include <vector>

namespace ashimpact::batch {

/// The critical velocity of one law, detachment and damping law with adhesion. It depends on one number: the
/// damping number beta in the scale in which the adhesion number is 1 (velocity V_a). The table holds the
/// work of damping at v_c over beta as Chebyshev polynomials on octaves of beta, through backward
/// integrations. Octaves are halved until the last coefficients are below 1e-12. A piece is computed when it
/// is first needed.
///
/// The relative error of v_c is below 1e-10 (1e-12 as measured in the tests). The table has no value next to
/// the damping from which on everything is captured.
class CriticalTable {
  public:
    /// The table of that combination, one for the process. Thread-safe.
    [[nodiscard]] static CriticalTable& of(Law law, Detachment detachment, DampingLaw damping_law);

    struct Entry {
        CaptureVerdict verdict;
        double value;  ///< v_c/V_a, where finite
    };
    /// The entry at beta >= 0; none where the table has no value.
    [[nodiscard]] std::optional<Entry> at(double beta);

  private:
    static constexpr int lowest_octave = -40;  ///< below it v_c is that of its lower end, to its rounding
    static constexpr int octaves = 64;
    static constexpr int most_halvings = 16;

    enum class State { finite, always_captured, halved, undecided };
    struct Piece {
        std::once_flag computed;
        State state = State::undecided;
        std::vector<double> coefficients{};            ///< of ln(work/beta), where finite
        double detachment_energy = 0.0;                ///< in units of m V_a^2
        std::array<std::unique_ptr<Piece>, 2> half{};  ///< where halved
    };

    void compute(double lower, double upper, bool may_halve, Piece& piece) const;
    [[nodiscard]] CriticalVelocity solved(double beta) const;

    Law law_ = Law::of<Hertz>();
    Detachment detachment_ = Detachment::zero_overlap;
    DampingLaw damping_law_ = DampingLaw::constant;
    std::array<Piece, octaves> pieces_;
};

}  // namespace ashimpact::batch
