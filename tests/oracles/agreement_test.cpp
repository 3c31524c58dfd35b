#include <doctest/doctest.h>

#include <cmath>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "tests/oracles/comparison.hpp"
#include "tests/oracles/grid.hpp"
#include "tests/oracles/oracle.hpp"
#include "tests/oracles/time_domain.hpp"

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

std::string label(const ImpactCase& impact) {
    std::ostringstream text;
    text << name(impact.law) << " R " << impact.radius << " m " << impact.mass << " E* "
         << impact.contact_modulus << " w " << impact.work_of_adhesion << " damping " << impact.damping
         << " v " << impact.velocity;
    return text.str();
}

// Without damping Hertz and DMT have no critical velocity: nothing is lost between zero overlap and zero
// overlap.
std::vector<ImpactCase> with_a_critical_velocity(std::vector<ImpactCase> impacts) {
    std::erase_if(impacts,
                  [](const ImpactCase& impact) { return impact.damping == 0 && impact.law != Law::jkr; });
    return impacts;
}

}  // namespace

TEST_CASE("the oracles agree on restitution, contact time and maximum overlap") {
    const auto columns = oracles();
    const auto compared = compare_impacts(columns, grid());
    verification_page().renew("impacts", impacts_table(columns, compared));
    CHECK(compared.size() >= 30);
    for (const auto& one : compared) {
        CAPTURE(label(one.impact));
        CHECK(one.answers.size() >= 2);
        for (const auto& a : one.answers) {
            CAPTURE(a.oracle);
            CHECK(a.result.rebound);
            CHECK(claimed_error(a.result) < agreement);
            for (const auto& b : one.answers) {
                CAPTURE(b.oracle);
                const double difference = deviation(a.result, b.result);
                CHECK(difference < agreement);
                CHECK(difference <= 2 * (claimed_error(a.result) + claimed_error(b.result)));
            }
        }
    }
}

TEST_CASE("the oracles agree on capture and rebound around the critical velocity") {
    const auto columns = oracles();
    const auto compared =
        compare_verdicts(columns, with_a_critical_velocity(grid()), time_domain_critical_velocity);
    verification_page().renew("verdicts", verdicts_table(columns, compared));
    for (const auto& one : compared) {
        CAPTURE(label(one.impact));
        CAPTURE(one.critical_velocity);
        CHECK(one.answers.size() >= 2);
        for (const auto& answer : one.answers) {
            CAPTURE(answer.oracle);
            CHECK_FALSE(answer.rebounds_below);
            CHECK(answer.rebounds_above);
        }
    }
}

}  // namespace ashimpact::oracles
