#include "solver/batch/tables/critical_table.hpp"

#include "solver/motion/scale.hpp"
#include "solver/motion/velocity_scales.hpp"
#include "solver/numeric/chebyshev.hpp"

#include <algorithm>
#include <cmath>

namespace ashimpact::batch {

namespace {

constexpr int degree = 16;
constexpr double tolerance = 1e-12;  ///< of ln(work/beta), in its last coefficients

/// An adhesive pair. Its values do not matter: scaled, v_c is the same for every pair.
ContactPair sample_pair(Law law) {
    return {.mass = 1e-9,
            .effective_radius = 44e-6,
            .contact_modulus = 90e9,
            .work_of_adhesion = 0.3,
            .parameters = typical_parameters(law)};
}

Scale sample_scale(Law law) {
    const ContactPair pair = sample_pair(law);
    return Scale::of(pair, velocity_of_adhesion(law, pair));
}

/// Sum of coefficients times Chebyshev polynomials at t in [-1, 1] (Clenshaw).
double chebyshev_sum(const std::vector<double>& coefficients, double t) {
    double b1 = 0.0;
    double b2 = 0.0;
    for (std::size_t k = coefficients.size() - 1; k > 0; --k) {
        const double b0 = coefficients[k] + 2.0 * t * b1 - b2;
        b2 = b1;
        b1 = b0;
    }
    return coefficients[0] + t * b1 - b2;
}

}  // namespace

CriticalTable& CriticalTable::of(Law law, Detachment detachment, DampingLaw damping_law) {
    constexpr std::size_t combinations =
        Law::count() * all_values<Detachment>.size() * all_values<DampingLaw>.size();
    static const auto tables = [] {
        auto all = std::make_unique<std::array<CriticalTable, combinations>>();
        std::size_t place = 0;
        for (std::size_t index = 0; index < Law::count(); ++index) {
            for (const Detachment end : all_values<Detachment>) {
                for (const DampingLaw damping : all_values<DampingLaw>) {
                    CriticalTable& table = (*all)[place++];
                    table.law_ = Law::at(index);
                    table.detachment_ = end;
                    table.damping_law_ = damping;
                }
            }
        }
        return all;
    }();
    const auto end = static_cast<std::size_t>(detachment);
    return (*tables)[(law.index() * all_values<Detachment>.size() + end) * all_values<DampingLaw>.size() +
                     static_cast<std::size_t>(damping_law)];
}

std::optional<CriticalTable::Entry> CriticalTable::at(double beta) {
    const int octave = beta > 0.0 ? std::max(std::ilogb(beta), lowest_octave) : lowest_octave;
    if (octave >= lowest_octave + octaves) return std::nullopt;
    double lower = std::ldexp(1.0, octave);
    double upper = 2.0 * lower;
    const double within = std::max(beta, lower);
    Piece* piece = &pieces_[static_cast<std::size_t>(octave - lowest_octave)];
    for (int halvings = 0;; ++halvings) {
        std::call_once(piece->computed, [&] { compute(lower, upper, halvings < most_halvings, *piece); });
        if (piece->state != State::halved) break;
        const double middle = lower + (upper - lower) / 2.0;
        const bool right = within >= middle;
        (right ? lower : upper) = middle;
        piece = piece->half[right ? 1 : 0].get();
    }
    if (piece->state == State::undecided) return std::nullopt;
    if (piece->state == State::always_captured) return Entry{CaptureVerdict::always_captured, 0.0};
    const double t = (2.0 * within - lower - upper) / (upper - lower);
    const double work = beta * std::exp(chebyshev_sum(piece->coefficients, t));
    return Entry{CaptureVerdict::finite, std::sqrt(2.0 * (work + piece->detachment_energy))};
}

CriticalVelocity CriticalTable::solved(double beta) const {
    const double coefficient = sample_scale(law_).damping_coefficient(damping_law_, beta);
    return critical_velocity({law_, detachment_, {damping_law_, coefficient}, sample_pair(law_)});
}

void CriticalTable::compute(double lower, double upper, bool may_halve, Piece& piece) const {
    const ChebyshevAxis axis{lower, upper, degree};
    const double unit = sample_scale(law_).energy();
    Eigen::VectorXd values(degree + 1);
    int finite = 0;
    for (int i = 0; i <= degree; ++i) {
        const double beta = axis.node(i);
        const CriticalVelocity critical = solved(beta);
        // Capture only grows with damping: if v_c is not finite here, it is not at the later nodes either.
        if (!critical.value) break;
        values[i] = std::log(critical.dissipated / unit / beta);
        piece.detachment_energy = critical.detachment_energy / unit;
        ++finite;
    }
    if (finite == 0) {
        piece.state = State::always_captured;
        return;
    }
    if (finite > degree) {
        const Eigen::VectorXd coefficients = axis.analysis() * values;
        if (coefficients.tail(3).cwiseAbs().maxCoeff() < tolerance) {
            piece.coefficients.assign(coefficients.begin(), coefficients.end());
            piece.state = State::finite;
            return;
        }
    }
    if (!may_halve) return;
    for (auto& half : piece.half) half = std::make_unique<Piece>();
    piece.state = State::halved;
}

}  // namespace ashimpact::batch
