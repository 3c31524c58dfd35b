#include "solver/gsl/quasi_random.hpp"

#include "solver/gsl/status.hpp"

#include <gsl/gsl_errno.h>
#include <gsl/gsl_qrng.h>

namespace ashimpact::gsl {

struct QuasiRandom::Sequence {
    std::unique_ptr<gsl_qrng, decltype(&gsl_qrng_free)> state{nullptr, &gsl_qrng_free};
};

QuasiRandom::QuasiRandom(int dimensions) {
    quiet();
    constexpr int most_sobol = 40;
    const gsl_qrng_type* type = dimensions <= most_sobol ? gsl_qrng_sobol : gsl_qrng_reversehalton;
    sequence_ = std::make_unique<Sequence>();
    if (dimensions >= 1 && dimensions <= most_dimensions)
        sequence_->state.reset(gsl_qrng_alloc(type, static_cast<unsigned>(dimensions)));
    if (!sequence_->state) check(GSL_EINVAL, "quasi-random sequence");
}

QuasiRandom::~QuasiRandom() = default;
QuasiRandom::QuasiRandom(QuasiRandom&&) noexcept = default;
QuasiRandom& QuasiRandom::operator=(QuasiRandom&&) noexcept = default;

void QuasiRandom::next(std::span<double> point) {
    check(gsl_qrng_get(sequence_->state.get(), point.data()), "quasi-random sequence");
}

std::string_view QuasiRandom::name() const {
    return gsl_qrng_name(sequence_->state.get());
}

}  // namespace ashimpact::gsl
