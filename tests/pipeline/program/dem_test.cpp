// SPDX-License-Identifier: GPL-3.0-or-later
// What users of DEM codes type: a requested restitution, a softened contact.
#include <algorithm>
#include <cmath>
#include <string>

#include <doctest/doctest.h>

#include "core/json/document.hpp"
#include "tests/pipeline/sandbox.hpp"
#include "tests/support/checks.hpp"

using namespace ashimpact;
using namespace ashimpact::test;

namespace {

const std::string dem_ash =
    " --radius '44 um' --density '2600 kg/m3' --contact-modulus '90 GPa' --work-of-adhesion '0.3 J/m2'";

Json answer_of(const Sandbox& sandbox, const std::string& arguments) {
    return Json::parse(succeeded(sandbox, arguments + " --json").out);
}

double si_value(const Json& quantity) {
    return quantity["value"].get<double>();
}

}  // namespace

TEST_CASE("a damping for a restitution gives it without adhesion, and less with it") {
    const Sandbox sandbox;
    const std::string requested = " --damping-restitution 0.3 --at '2 m/s'";
    const std::string impact = "impact --velocity '2 m/s'" + dem_ash + requested;
    for (const std::string damping_law : {"constant", "contact-radius"}) {
        CAPTURE(damping_law);
        std::string by = impact;
        by += " --damping-law " + damping_law;
        const Json hertz = answer_of(sandbox, by + " --law hertz");
        CHECK(relative_difference(si_value(hertz["restitution"]), 0.3) < 1e-12);
        const Json dmt = answer_of(sandbox, by + " --law dmt");
        CHECK(si_value(dmt["damping"]) == si_value(hertz["damping"]));
        CHECK(si_value(dmt["restitution"]) < 0.3);
        const Json& answer = dmt["damping_restitution"];
        CHECK(si_value(answer["requested"]) == 0.3);
        CHECK(si_value(answer["velocity"]) == 2);
        CHECK(si_value(answer["damping"]) == si_value(dmt["damping"]));
        REQUIRE(answer["codes"].size() == 4);
        CHECK(answer["codes"][0]["code"] == "LAMMPS 20220106");
        // Measured with LAMMPS and LIGGGHTS themselves at time steps of 1 ps.
        CHECK(si_value(answer["codes"][0]["restitution"]) == doctest::Approx(0.439596).epsilon(1e-5));
        CHECK(si_value(answer["codes"][1]["restitution"]) == doctest::Approx(0.3).epsilon(1e-9));
    }
    const std::string text = succeeded(sandbox, impact + " --law dmt").out;
    CHECK(text == containing("damping for a restitution       0.3 without adhesion and yield at 2 m/s"));
    CHECK(text == containing("LAMMPS 20220106 asked for it"));
    const Json cut = answer_of(sandbox, "impact --velocity '2 m/s'" + dem_ash +
                                            " --law hertz --detachment zero-force --damping-law tsuji "
                                            "--damping-restitution 0.5");
    CHECK(relative_difference(si_value(cut["restitution"]), 0.5) < 1e-12);
    const std::string of_law = " --law dmt" + dem_ash + requested;
    CHECK(si_value(answer_of(sandbox, "critical-velocity" + of_law)["damping_restitution"]["damping"]) ==
          si_value(answer_of(sandbox, impact + " --law dmt")["damping"]));
    CHECK(si_value(answer_of(sandbox, "contact" + dem_ash + requested)["damping"]) ==
          si_value(answer_of(sandbox, impact + " --law dmt")["damping"]));
    CHECK_FALSE(answer_of(sandbox, "impact --law dmt --velocity 2 --damping 0.01" + dem_ash)
                    .contains("damping_restitution"));
}

TEST_CASE("damping of two terms is answered with both coefficients") {
    const Sandbox sandbox;
    const std::string both =
        dem_ash + " --damping-law brach-dunn-damping --damping '0.2 s/m' --adhesion-damping-ratio 3";
    const std::string impact = "impact --law dmt --velocity '2 m/s'" + both;
    for (const Json& answer : {answer_of(sandbox, impact), answer_of(sandbox, "contact" + both),
                               answer_of(sandbox, "critical-velocity --law dmt" + both)}) {
        CHECK(si_value(answer["adhesion_damping"]) == doctest::Approx(0.6).epsilon(1e-15));
        CHECK(answer["adhesion_damping"]["unit"] == "s/m");
    }
    const Json found =
        answer_of(sandbox, "damping --law dmt --velocity '2 m/s' --restitution 0.4" + dem_ash +
                               " --damping-law brach-dunn-damping --adhesion-damping '0.1 s/m'");
    CHECK(si_value(found["adhesion_damping"]) == 0.1);
    CHECK(succeeded(sandbox, impact).out == containing("  adhesion damping"));
    CHECK(succeeded(sandbox, "contact" + both).out == containing("  adhesion damping"));
    CHECK_FALSE(answer_of(sandbox, "impact --law dmt --velocity 2 --damping 0.01" + dem_ash)
                    .contains("adhesion_damping"));
}

TEST_CASE("tsuji needs no velocity for its restitution, the others do") {
    const Sandbox sandbox;
    const std::string impact = "impact --law hertz --velocity '1 m/s' --damping-restitution 0.3" + dem_ash;
    const Json alone = answer_of(sandbox, impact + " --damping-law tsuji");
    CHECK(relative_difference(si_value(alone["restitution"]), 0.3) < 1e-12);
    CHECK(alone["damping_restitution"]["velocity"].is_null());
    const auto idle = ashimpact_program(sandbox, impact + " --damping-law tsuji --at '2 m/s' --json");
    CHECK(idle.status == 0);
    CHECK(idle.err ==
          containing("--at: by damping law 'tsuji' the restitution is the same at every velocity"));
    CHECK(Json::parse(idle.out)["restitution"] == alone["restitution"]);
    check_refused(sandbox, impact, "--at: is missing: by damping law 'constant' the restitution depends");
    check_refused(sandbox, impact + " --at '-2 m/s'", "--at: ");
    check_refused(sandbox, impact + " --at 2 --damping 1",
                  "--damping, --damping-restitution: both are given");
    check_refused(sandbox, "impact --law hertz --velocity 1 --at 2" + dem_ash, "--at: belongs to");
    for (const char* wrong : {"0", "1.2", "-0.3", "nan", "'30 m'"})
        check_refused(
            sandbox,
            "impact --law hertz --velocity 1 --at 2 --damping-restitution " + std::string(wrong) + dem_ash,
            "--damping-restitution");
}

TEST_CASE("contact lists the constants of a softened contact") {
    const Sandbox sandbox;
    const std::string contact = "contact --damping '0.0141 kg/s'" + dem_ash;
    const Json json = answer_of(sandbox, contact + " --soften 1000");
    const Json& soft = json["softened"];
    CHECK(si_value(json["contact_modulus"]) == 90e9);
    CHECK(si_value(soft["contact_modulus"]) == 90e6);
    CHECK(relative_difference(si_value(soft["work_of_adhesion"]), 0.3 * std::pow(1000, -0.4)) < 1e-14);
    CHECK(relative_difference(si_value(soft["damping"]), 0.0141 * std::pow(1000, -0.4)) < 1e-14);
    CHECK(relative_difference(soft["stretch"].get<double>(), std::pow(1000, 0.4)) < 1e-14);
    const Json& factors = soft["parameter_factors"];
    CHECK(relative_difference(factors["yield_pressure"].get<double>(), std::pow(1000, -0.8)) < 1e-14);
    CHECK(relative_difference(factors["cohesion_range"].get<double>(), std::pow(1000, 0.4)) < 1e-14);
    CHECK(factors["tabor"] == 1.0);
    CHECK(relative_difference(soft["damping_factors"]["contact-radius"].get<double>(), std::pow(1000, -0.6)) <
          1e-14);
    // The softened constants have the critical velocity of the stiff ones.
    const auto critical = [&](const Json& pair, double damping) {
        return si_value(answer_of(sandbox,
                                  "critical-velocity --law brach-dunn --radius '44 um' --density 2600"
                                  " --contact-modulus " +
                                      pair["contact_modulus"]["value"].dump() + " --work-of-adhesion " +
                                      pair["work_of_adhesion"]["value"].dump() + " --damping " +
                                      Json(damping).dump())["critical_velocity"]);
    };
    CHECK(relative_difference(critical(soft, si_value(soft["damping"])), critical(json, 0.0141)) < 1e-12);
    CHECK_FALSE(answer_of(sandbox, contact).contains("softened"));
    CHECK(succeeded(sandbox, contact + " --soften 1000").out == containing("softened by 1000"));
    for (const char* wrong : {"1", "0", "-5", "nan", "inf", "1e300", "'2 m'", "many"})
        check_refused(sandbox, contact + " --soften " + wrong, "--soften: ");
}

TEST_CASE("the folder of a requested restitution is compared at its velocity, softened too") {
    const Sandbox sandbox;
    const std::string lammps = "export lammps --law dmt --damping-law hunt-crossley" + dem_ash +
                               " --damping-restitution 0.3 --at '2 m/s' -o d --soften ";
    succeeded(sandbox, lammps + "100");
    bool compared = false;
    const Json expected = sandbox.json("d/expected.json");
    for (const Json& impact : expected["impacts"])
        if (si_value(impact["velocity"]) == 2.0) {
            compared = true;
            CHECK(si_value(impact["restitution"]) == doctest::Approx(0.296).epsilon(1e-3));
        }
    CHECK(compared);
    check_refused(sandbox, lammps + "10000",
                  "at 2 m/s the contact of 88 um softened 10000 times overlaps by");
}

TEST_CASE("exports refuse a softening that no contact follows or that goes too far") {
    const Sandbox sandbox;
    const std::string lammps = "export lammps --law dmt --damping '0.0141 kg/s' -o d" + dem_ash;
    check_refused(sandbox, lammps + " --to-velocity '0.1 m/s'",
                  "--to-velocity: no impact up to 0.1 m/s is left to compare with");
    CHECK_FALSE(sandbox.has("d"));
    succeeded(sandbox, lammps + " --to-velocity '30 m/s'");
    const auto impacts = sandbox.json("d/expected.json")["impacts"];
    CHECK(std::ranges::any_of(
        impacts, [](const Json& each) { return si_value(each["velocity"]) == doctest::Approx(30); }));
    for (const char* wrong : {"1", "0.5", "nan"})
        check_refused(sandbox, lammps + " --soften " + wrong, "--soften: ");
    for (const std::string code : {"openfoam", "fluent"}) {
        std::string command = "export " + code;
        command += " --law dmt --damping '0.0141 kg/s' --soften 10 -o d" + dem_ash;
        check_refused(sandbox, command, code + ": its ");
    }
    // What the refusal allows is taken.
    const std::string line =
        check_refused(sandbox, lammps + " --soften 1000", "softened 1000 times overlaps by");
    const auto after = [&](const std::string& word) {
        const auto at = line.find(word);
        REQUIRE(at != std::string::npos);
        return std::to_string(std::stod(line.substr(at + word.size())));
    };
    succeeded(sandbox, lammps + " --soften " + after("allowed: up to 5 %, --soften "));
    succeeded(sandbox, lammps + " --soften 1000 --to-velocity " + after("--to-velocity \""));
    CHECK(sandbox.read("d/README.md") == containing("Softened by 1000: contacts last 15.85 times longer"));
    CHECK(sandbox.read("d/assumptions.md") == containing("E* 90 GPa -> 90 MPa, w 0.3 J/m2 -> 0.01893 J/m2"));
    CHECK(sandbox.json("d/expected.json")["softening"]["factor"] == 1000);
}
