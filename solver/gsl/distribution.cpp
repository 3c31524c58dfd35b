#include "solver/gsl/distribution.hpp"

#include <gsl/gsl_cdf.h>

namespace ashimpact::gsl {

double normal_quantile(double probability) {
    return gsl_cdf_ugaussian_Pinv(probability);
}

double normal_probability(double x) {
    return gsl_cdf_ugaussian_P(x);
}

double chi_squared_exceedance(double chi_squared, int degrees_of_freedom) {
    return degrees_of_freedom > 0 ? gsl_cdf_chisq_Q(chi_squared, degrees_of_freedom) : 1.0;
}

}  // namespace ashimpact::gsl
