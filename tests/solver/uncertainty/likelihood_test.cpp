#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "solver/uncertainty/likelihood/impact_likelihood.hpp"
#include "solver/uncertainty/likelihood/rebound_density.hpp"
#include "solver/uncertainty/likelihood/rebound_selection.hpp"
#include "tests/relative_difference.hpp"
#include "tests/solver/uncertainty/coverage.hpp"

using namespace ashimpact;
using namespace ashimpact::test;

namespace {

MeasurementSet laboratory_of(const ContactModel& model, int impacts, int frames = 5) {
    SyntheticLaboratory laboratory = ash_laboratory(model, TrueDamping::quadratic);
    laboratory.impacts = impacts;
    laboratory.camera.frames = frames;
    Random random(3);
    return laboratory.measure(random);
}

/// Largest difference of a gradient from central differences, over its length.
double gradient_error(const ImpactLikelihood& likelihood, const Eigen::VectorXd& at) {
    Eigen::VectorXd differences(at.size());
    for (Eigen::Index i = 0; i < at.size(); ++i) {
        const Eigen::VectorXd step = 1e-5 * at[0] * Eigen::VectorXd::Unit(at.size(), i);
        differences[i] =
            (likelihood.at(at + step)->value - likelihood.at(at - step)->value) / (2.0 * step[i]);
    }
    return (likelihood.at(at)->gradient - differences).norm() / differences.norm();
}

}  // namespace

TEST_CASE("the gradient of the likelihood: with slow rebounds, with captures, and where the curve folds") {
    const ContactModel model = ash_model(Law::of<BrachDunn>());
    const MeasurementSet set = laboratory_of(model, 200);
    RestitutionData data = select_rebounds(model, set).data;
    REQUIRE(std::any_of(data.rebounds.begin(), data.rebounds.end(), is_slow));
    const Eigen::VectorXd truth = Eigen::Vector3d(0.0149, -0.0213, 0.0101);
    const Eigen::VectorXd folding = Eigen::Vector3d(0.0149, -0.0260, 0.0230);
    for (const bool captures : {false, true}) {
        CAPTURE(captures);
        if (captures) data.captures = captures_of(set);
        CHECK(gradient_error(ImpactLikelihood(model, data, truth), truth) < 1e-3);
        CHECK(gradient_error(ImpactLikelihood(model, data, folding), folding) < 1e-3);
    }
}

TEST_CASE(
    "likelihoods given a rebound do not grow towards curves that fold back from far above the impacts") {
    const ContactModel model = ash_model(Law::of<BrachDunn>());
    const RestitutionData data = select_rebounds(model, laboratory_of(model, 100, 20)).data;
    const Eigen::VectorXd truth = Eigen::Vector3d(0.0149, -0.0213, 0.0101);
    const double best = ImpactLikelihood(model, data, truth).at(truth)->value;
    for (const Eigen::Vector3d& folding :
         {Eigen::Vector3d(0.0175, -0.0364, 0.0290), Eigen::Vector3d(0.0195, -0.0480, 0.0435)}) {
        const auto at = ImpactLikelihood(model, data, folding).at(folding);
        REQUIRE(at);
        CHECK(at->value > best);
    }
}

TEST_CASE("how a rebound slower than its uncertainty was recorded does not matter") {
    const ContactModel model = ash_model(Law::of<BrachDunn>());
    MeasurementSet set = laboratory_of(model, 100);
    const double u = std::sqrt(set.points.front().noise->rebound);
    const DampingCurveFit before = fit_damping_curve(model, set, direct_fit);
    int changed = 0;
    for (Measurement& point : set.points) {
        if (point.captured() || point.rebound >= slow_rebound * u) continue;
        point.rebound = 0.9 * slow_rebound * u;
        ++changed;
    }
    REQUIRE(changed > 0);
    const DampingCurveFit after = fit_damping_curve(model, set, direct_fit);
    CHECK(relative_difference(after.critical_damping.value, before.critical_damping.value) < 1e-4);
}

TEST_CASE(
    "fits of many impacts do not see where the velocities aimed at end, nor that slow rebounds are cut") {
    const ContactModel model = ash_model(Law::of<Hertz>());
    const MeasurementSet set = laboratory_of(model, 10000);
    const RestitutionData data = select_rebounds(model, set).data;
    const RestitutionData inner = away_from_fastest(data);
    const double fastest = 3.0 * ash_laboratory(model, TrueDamping::quadratic).critical_velocity();
    const double u = std::sqrt(set.points.front().noise->incident);
    for (const Measurement& point : inner.rebounds) CHECK(point.velocity < fastest - 2.0 * u);
    CHECK(inner.rebounds.size() > 8 * data.rebounds.size() / 10);
    for (const DampingCurveOptions& options : {extrapolated_fit, direct_fit}) {
        CAPTURE(options.captures);
        const Interval fitted = fit_damping_curve(model, set, options).critical_damping;
        CHECK(std::abs(fitted.value - 0.0155) < 3.0 * fitted.standard_uncertainty);
        CHECK(fitted.standard_uncertainty < 0.003 * fitted.value);
    }
}
