// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include <doctest/doctest.h>

#include "tests/oracles/comparison.hpp"
#include "tests/oracles/time_domain.hpp"
#include "tests/support/checks.hpp"

namespace ashimpact::oracles {

namespace {

constexpr double agreement = 1e-8;

// docs/verification.md with its tables renewed, in the build directory, to be copied back when it should
// change.
class VerificationPage {
  public:
    VerificationPage() {
        std::ostringstream text;
        text << std::ifstream(ASHIMPACT_VERIFICATION_PAGE).rdbuf();
        text_ = text.str();
    }

    void renew(const std::string& section, const std::string& table) {
        const std::string begin = "<!-- begin " + section + " -->\n";
        const auto start = text_.find(begin);
        const auto end = text_.find("<!-- end " + section + " -->");
        if (start == std::string::npos || end == std::string::npos)
            throw std::runtime_error("docs/verification.md has no section " + section);
        text_.replace(start + begin.size(), end - start - begin.size(), '\n' + table + '\n');
        std::ofstream(ASHIMPACT_VERIFICATION_RENEWED) << text_;
    }

  private:
    std::string text_;
};

VerificationPage& verification_page() {
    static VerificationPage page;
    return page;
}

std::string label(const Impact& impact) {
    std::ostringstream text;
    text << impact.law.name() << " R " << impact.contact.effective_radius << " m " << impact.contact.mass
         << " E* " << impact.contact.contact_modulus << " w " << impact.contact.work_of_adhesion
         << " damping " << impact.damping.coefficient << " v " << impact.velocity;
    return text.str();
}

// Contact that ends where it began, at zero overlap, takes nothing without damping; at zero force it never
// captures.
std::vector<Impact> with_a_critical_velocity(std::vector<Impact> impacts) {
    std::erase_if(impacts, [](const Impact& impact) {
        return impact.detachment == Detachment::zero_force ||
               (impact.detachment == Detachment::zero_overlap && impact.damping.coefficient == 0);
    });
    return impacts;
}

}  // namespace

TEST_CASE("solver and oracles agree on restitution, contact time and maximum overlap") {
    const auto all = columns();
    const auto compared = compare_impacts(all, grid());
    verification_page().renew("impacts", impacts_table(all, compared));
    CHECK(compared.size() >= 30);
    for (const auto& one : compared) {
        CAPTURE(label(one.impact));
        CHECK(one.answers.size() >= 3);
        for (const auto& a : one.answers) {
            CAPTURE(a.column);
            CHECK(a.result.rebound);
            CHECK(claimed_error(a.result) < agreement);
            for (const auto& b : one.answers) {
                CAPTURE(b.column);
                const double difference = deviation(a.result, b.result);
                CHECK(difference < agreement);
                CHECK(difference <= 2 * (claimed_error(a.result) + claimed_error(b.result)));
            }
        }
    }
}

TEST_CASE("solver and oracles agree on capture and rebound around the critical velocity") {
    const auto all = columns();
    const auto compared = compare_verdicts(all, with_a_critical_velocity(grid()), solver_critical_velocity);
    verification_page().renew("verdicts", verdicts_table(all, compared));
    for (const auto& one : compared) {
        CAPTURE(label(one.impact));
        CAPTURE(one.critical_velocity);
        CHECK(one.answers.size() >= 3);
        for (const auto& answer : one.answers) {
            CAPTURE(answer.column);
            CHECK_FALSE(answer.rebounds_below);
            CHECK(answer.rebounds_above);
        }
    }
}

TEST_CASE("the solver agrees with GSL on laws and ends of contact that no DEM code has") {
    const std::vector pair{time_domain_oracle(), solver_under_test()};
    for (const auto& one : compare_impacts(pair, grid_beyond_dem_codes())) {
        const OracleResult& oracle = one.answers.front().result;
        const OracleResult& solver = one.answers.back().result;
        CAPTURE(label(one.impact));
        CHECK(solver.rebound == oracle.rebound);
        CHECK(deviation(solver, oracle) < 1e-10);
    }
}

TEST_CASE("the solver agrees with GSL on the critical velocity") {
    for (const Impact& impact : with_a_critical_velocity(grid_beyond_dem_codes())) {
        CAPTURE(label(impact));
        const double bisected = time_domain_critical_velocity(impact);
        CHECK(test::relative_difference(solver_critical_velocity(impact), bisected) < 1e-9);
    }
}

}  // namespace ashimpact::oracles
