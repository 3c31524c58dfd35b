#include "solver/gsl/random.hpp"

#include "solver/gsl/status.hpp"

#include <gsl/gsl_randist.h>
#include <gsl/gsl_rng.h>

namespace ashimpact::gsl {

struct Random::Generator {
    std::unique_ptr<gsl_rng, decltype(&gsl_rng_free)> state{gsl_rng_alloc(gsl_rng_mt19937), &gsl_rng_free};
};

Random::Random(unsigned long seed) {
    quiet();
    generator_ = std::make_unique<Generator>();
    gsl_rng_set(generator_->state.get(), seed);
}

Random::~Random() = default;
Random::Random(Random&&) noexcept = default;
Random& Random::operator=(Random&&) noexcept = default;

double Random::uniform(double lower, double upper) {
    return gsl_ran_flat(generator_->state.get(), lower, upper);
}

double Random::normal(double deviation) {
    return gsl_ran_gaussian_ziggurat(generator_->state.get(), deviation);
}

}  // namespace ashimpact::gsl
