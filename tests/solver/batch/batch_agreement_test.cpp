// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <mutex>

#include <doctest/doctest.h>

#include "solver/batch/batch.hpp"
#include "solver/batch/parallel.hpp"
#include "tests/solver/batch/batch_sample.hpp"

using namespace ashimpact;
using namespace ashimpact::test;

namespace {

/// How far a batch is from the scalar solver.
struct Agreement {
    double restitution = 0.0;  ///< greatest |d(e^2)| over the conditioning of the problem
    double contact_time =
        0.0;  ///< greatest relative difference over the conditioning, which near capture is 1/e^2
    Eigen::Index outcomes = 0;  ///< that differ

    void add(const ImpactBatchResult& batch, Eigen::Index i, const ImpactResult& reference) {
        if (batch.outcome[i] != reference.outcome) {
            ++outcomes;
            return;
        }
        restitution = std::max(restitution, conditioned_error(batch.restitution[i], reference));
        if (!reference.contact_time) return;
        const double depth = 1.0 + std::abs(reference.energy.minimum) / reference.energy.incident;
        const double condition = 1.0 + depth / std::pow(reference.restitution, 2.0);
        const double difference = std::abs(batch.contact_time[i] / *reference.contact_time - 1.0);
        contact_time = std::max(contact_time, difference / condition);
    }
    void add(const Agreement& other) {
        restitution = std::max(restitution, other.restitution);
        contact_time = std::max(contact_time, other.contact_time);
        outcomes += other.outcomes;
    }
};

struct Agreements {
    Agreement integrated{};
    Agreement tabulated{};
    Eigen::Index rebounds = 0;
};

Agreements agreements(const Impacts& impacts) {
    const ImpactBatchResult integrated = solve_impacts(impacts.batch(), {.threads = 0});
    const ImpactBatchResult tabulated =
        solve_impacts(impacts.batch(), {.threads = 0, .turning_point = false, .method = BatchMethod::table});
    Agreements all;
    std::mutex adding;
    const auto chunk = [&](std::size_t first, std::size_t count) {
        Agreements own;
        for (auto i = static_cast<Eigen::Index>(first); i < static_cast<Eigen::Index>(first + count); ++i) {
            const ImpactResult reference = solve_impact(impacts.at(i));
            own.integrated.add(integrated, i, reference);
            own.tabulated.add(tabulated, i, reference);
            if (reference.outcome == Outcome::rebound) ++own.rebounds;
        }
        const std::scoped_lock lock(adding);
        all.integrated.add(own.integrated);
        all.tabulated.add(own.tabulated);
        all.rebounds += own.rebounds;
    };
    batch::for_chunks(static_cast<std::size_t>(impacts.size()), 512, 0, chunk);
    return all;
}

#ifdef __SANITIZE_ADDRESS__
constexpr Eigen::Index impacts_in_all = 2'100;  // every one of them makes a square of a table
#else
constexpr Eigen::Index impacts_in_all = 1'000'000;
#endif

}  // namespace

TEST_CASE("a million random impacts: integrated and tabulated batches do what the scalar solver does") {
    const auto sets = std::ssize(random_impacts(1, 1.0, 51));
    Eigen::Index solved = 0;
    Eigen::Index rebounds = 0;
    for (const Impacts& impacts : random_impacts(impacts_in_all / sets + 1, 1.1, 51)) {
        CAPTURE(impacts.law.name());
        CAPTURE(name_of(impacts.detachment));
        CAPTURE(name_of(impacts.damping_law));
        const Agreements found = agreements(impacts);
        solved += impacts.size();
        rebounds += found.rebounds;
        MESSAGE("integrated ", found.integrated.restitution, ", ", found.integrated.contact_time, "; table ",
                found.tabulated.restitution, ", ", found.tabulated.contact_time);
        for (const Agreement& agreement : {found.integrated, found.tabulated}) {
            CHECK(agreement.outcomes == 0);
            CHECK(agreement.restitution <= 1e-12);
            CHECK(agreement.contact_time <= 1e-11);
        }
    }
    CHECK(solved >= impacts_in_all);
    CHECK(rebounds > solved / 4);
    CHECK(rebounds < solved);
}
