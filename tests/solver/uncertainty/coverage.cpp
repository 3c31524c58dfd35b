#include "tests/solver/uncertainty/coverage.hpp"

#include "materials/error.hpp"
#include <cstdio>
#include <cstdlib>

namespace ashimpact::test {

Coverage coverage_of(const SyntheticLaboratory& laboratory, const DampingCurveOptions& options,
                     int repetitions, unsigned long seed) {
    gsl::Random random(seed);
    Coverage coverage{.repetitions = repetitions};
    const double truth = laboratory.critical_damping();
    int bounded = 0;
    for (int i = 0; i < repetitions; ++i) {
        const MeasurementSet set = laboratory.measure(random);
        try {
            const DampingCurveFit fit = fit_damping_curve(laboratory.model, set, options);
            const Interval& interval = fit.critical_damping;
            if (interval.lower && *interval.lower > truth) ++coverage.damping_above;
            if (interval.upper && *interval.upper < truth) ++coverage.damping_below;
            if (fit.critical_velocity.contains(laboratory.critical_velocity())) ++coverage.velocity;
            coverage.bias += (interval.value / truth - 1.0) / repetitions;
            if (!interval.lower || !interval.upper) continue;
            ++bounded;
            coverage.width += 0.5 * (*interval.upper - *interval.lower) / truth;
        } catch (const ConvergenceError& error) {
            { ++coverage.failures; if (std::getenv("SHOW")) std::fprintf(stderr, "%s\n", error.what()); }
        } catch (const InputError& error) {
            { ++coverage.failures; if (std::getenv("SHOW")) std::fprintf(stderr, "%s\n", error.what()); }
        }
    }
    if (bounded > 0) coverage.width /= bounded;
    return coverage;
}

}  // namespace ashimpact::test
