// SPDX-License-Identifier: GPL-3.0-or-later
// Values that are probably slips of their units, at every door.
#include <string>

#include <doctest/doctest.h>

#include "tests/pipeline/sandbox.hpp"

using namespace ashimpact;
using test::check_refused;
using test::containing;
using test::Sandbox;

namespace {

constexpr auto usual_contact =
    " --density '2300 kg/m3' --contact-modulus '90 GPa' --work-of-adhesion '0.3 J/m2'";

/// Files of which each is wrong in one number, and commands that read them.
void write_files(const Sandbox& sandbox) {
    test::write_example(sandbox, test::with_one_sample(test::example_case(), {"hertz"}));
    sandbox.write("fast.csv", "v_in,e_n\n2e7,0.2\n3e7,0.3\n");
    sandbox.write("quick.csv", "v_in [km/s],e_n\n1,0.2\n3,0.3\n3,0.3\n");
    sandbox.write("small.csv", "d [nm],v_c [m/s]\n5.0,1.2\n20.0,0.4\n");
    sandbox.write("soft.csv", "phase,wt%,density [kg/m3]\nquartz,40,2.65\nglass,60,2500\n");
    sandbox.write("stiff.csv", "phase,wt%\nquartz,100\n");
    sandbox.write("phases.json", R"([{"name": "soft", "density": "2 g/cm3", "young_modulus": 70}])");
    sandbox.write("sweep.json",
                  R"({"impact": {"laws": ["hertz"], "radius": 44, "density": 2300, "contact_modulus": 9e10},
                      "variables": {"velocity": {"values": [1, 2]}}, "sampling": {"method": "grid"}})");
}

}  // namespace

TEST_CASE("a bare number far from what ash has is refused at every door, with the unit that was meant") {
    const Sandbox sandbox;
    write_files(sandbox);
    const Json document = sandbox.json("case.json");
    for (const auto& [pointer, value, says] :
         {std::tuple{"/samples/0/diameter", Json("90"),
                     "/samples/0/diameter: 90 has no unit and is 90 m, did you "
                     "mean 90 um?; allowed: 10 nm to 5 mm; beyond that a number"},
          {"/samples/0/diameter", Json(90), "did you mean 90 um?"},
          {"/samples/0/density", Json(2.3),
           "/samples/0/density: 2.3 has no unit and is 2.3 kg/m3, did you mean 2.3 g/cm3?"},
          {"/wall/young_modulus", Json(193),
           "/wall/young_modulus: 193 has no unit and is 193 Pa, did you mean 193 GPa"},
          {"/particle", Json{{"contact_modulus", "90"}}, "/particle/contact_modulus: 90 has no unit"},
          {"/phases", Json::parse(sandbox.read("phases.json")), "/phases/0/young_modulus: 70 has no unit"}}) {
        Json wrong = document;
        wrong[Json::json_pointer(pointer)] = value;
        sandbox.write("case.json", wrong.dump());
        CAPTURE(says);
        check_refused(sandbox, "run case.json -o out", says);
    }
    for (const auto& [command, says] :
         {std::pair{std::string("impact --law jkr --velocity '2 m/s' --diameter 90") + usual_contact,
                    "--diameter: 90 has no unit and is 90 m, did you mean 90 um?"},
          {"contact --diameter '88 um' --density '2300 kg/m3' --young-modulus 110 --poisson-ratio 0.2 "
           "--rigid-wall "
           "--work-of-adhesion '0.3 J/m2'",
           "--young-modulus: 110 has no unit and is 110 Pa, did you mean 110 GPa?"},
          {std::string("export lammps --law jkr --diameter '88 um' --to-diameter 120 -o out") + usual_contact,
           "--to-diameter: 120 has no unit"},
          {std::string("damping --law jkr --diameter '88 um' --impacts fast.csv") + usual_contact,
           "fast.csv: line 2: v_in: 2e+07 has no unit and is 2e+07 m/s, did you mean"},
          {"impact --law jkr --velocity '2 m/s' --damping-restitution 0.5 --at 2e8 --diameter '88 um'" +
               std::string(usual_contact),
           "--at: 2e+08 has no unit and is 2e+08 m/s"},
          {"contact --contact-radius 1 --diameter '88 um'" + std::string(usual_contact),
           "--contact-radius: 1 has no unit and is 1 m, did you mean 1 um?"},
          {"modulus soft.csv --phases phases.json", "phases.json: /0/young_modulus: 70 has no unit"},
          {"sweep sweep.json -o out.json",
           "sweep.json: /impact/radius: 44 has no unit and is 44 m, did you mean 44 um?"}})
        check_refused(sandbox, command, says);
}

TEST_CASE("with its unit it counts, and is warned of before anything else") {
    const Sandbox sandbox;
    write_files(sandbox);
    Json sweep = sandbox.json("sweep.json");
    sweep["impact"]["radius"] = "44 um";
    sweep["impact"].erase("density");
    sweep["impact"]["mass"] = "1 mg";
    sandbox.write("sweep.json", sweep.dump());
    for (const auto& [command, says] :
         {std::pair{
              std::string("impact --law hertz --velocity '2 m/s' --diameter '90 m'") + usual_contact,
              "warning: --diameter: 90 m is outside of what is plausible, 10 nm to 5 mm: is the unit right?"},
          {"modulus soft.csv", "warning: soft.csv: density of \"quartz\": 2.65 kg/m3 is outside"},
          {std::string("damping --law jkr --diameter '88 um' --impacts quick.csv") + usual_contact,
           "warning: quick.csv: line 3: v_in: 3000 m/s is outside"},
          {"impact --law hertz --velocity '2 m/s' --diameter '88 um' --mass '1 kg' --contact-modulus '90 "
           "GPa'",
           "warning: --mass: 1 kg is outside of what is plausible"},
          {"impact --law hertz --velocity '2 m/s' --diameter '88 um' --mass '1 mg' --contact-modulus '90 "
           "GPa'",
           "warning: --mass: density of the sphere: 2.803e+06 kg/m3 is outside"},
          {std::string(
               "impact --law hertz --velocity '2 m/s' --diameter '88 um' --angle '45 deg' --friction 20") +
               usual_contact,
           "warning: --friction: 20 is outside of what is plausible, 0.001 to 2"},
          {std::string("deposit --law hertz --sizes '20 um' --tube-diameter '38 mm' --gas-velocity 12 "
                       "--gas-temperature '900 C' -o tube --ash-load '10 kg/Nm3'") +
               usual_contact,
           "warning: --ash-load: 2.328 kg/m3 is outside of what is plausible"},
          {"modulus stiff.csv --amorphous-fraction none --porosity-law spriggs --porosity 0.2 "
           "--porosity-coefficient 300",
           "warning: stiff.csv: Young's modulus: "},
          {"contact --diameter '88 um' --density '2300 kg/m3' --contact-modulus '90 GPa' --adhesion-rule "
           "dupre "
           "--surface-energy '15 J/m2' --wall-surface-energy '15 J/m2' --interfacial-energy '1e-4 J/m2'",
           "warning: work_of_adhesion: 30 J/m2 is outside of what is plausible"},
          {"calibrate --sizes small.csv --uncertainty '10 %' --law jkr --density '2300 kg/m3' "
           "--contact-modulus '90 GPa' --free work_of_adhesion",
           "warning: small.csv: 5 nm is outside of what is plausible, 10 nm to 5 mm"},
          {"sweep sweep.json -o out.json",
           "warning: mass: density of the sphere: 2.803e+06 kg/m3 is outside"}}) {
        CAPTURE(command);
        CHECK(test::ashimpact_program(sandbox, command).err.starts_with(says));
    }
    Json document = sandbox.json("case.json");
    document["samples"][0]["work_of_adhesion"] = "300 J/m2";
    sandbox.write("case.json", document.dump());
    const auto run = test::succeeded(sandbox, "run case.json -o out");
    CHECK(
        run.err.starts_with("warning: 0-case.json: fine: /samples/0/work_of_adhesion: 300 J/m2 is outside"));
    const Json notes = sandbox.json("out/0-case.json")["notes"];
    REQUIRE(notes.size() > 0);
    CHECK(notes[0]["code"] == "implausible");
    CHECK(notes[0]["severity"] == "doubt");
    CHECK(notes[0]["sample"] == "fine");
}

TEST_CASE("a critical velocity above 500 m/s is outside the model; JSON keeps the number, with a note") {
    const Sandbox sandbox;
    const std::string sphere = std::string(" --diameter '88 um'") + usual_contact;
    for (const auto& [options, rest] :
         {std::pair{"jkr --damping '100 kg/s' --angle '60 deg'", "at 60 degrees"},
          {"brach-dunn --damping '100 kg/s'", "damping"}}) {
        CAPTURE(options);
        const auto text =
            test::succeeded(sandbox, std::string("critical-velocity --law ") + options + sphere);
        CHECK(text.err == containing("the critical velocity is above 500 m/s, outside the model"));
        const auto last = text.out.rfind(rest);
        REQUIRE(last != std::string::npos);
        CHECK(text.out.find("above 500 m/s, outside the model") != std::string::npos);
        CHECK(text.out.find("e+") == std::string::npos);
    }
    for (const char* law : {"jkr", "maugis-dugdale --tabor 1"})
        check_refused(sandbox, std::string("critical-velocity --damping '1e30 kg/s' --law ") + law + sphere,
                      "--damping: the critical velocity is above 500 m/s, outside the model, beyond the "
                      "range of numbers");
    const auto stuck = test::succeeded(
        sandbox, std::string("deposit --law jkr --damping '10 kg/s' --sizes '20 um' --tube-diameter '38 mm' "
                             "--gas-velocity 12 --gas-temperature '900 C' -o tube") +
                     usual_contact);
    CHECK(stuck.err ==
          containing("of 100 % of the mass that arrives v_c is above 500 m/s, outside the model"));
    CHECK(test::lines_of(stuck.out)[0] == containing("100 % of that stays; of 100"));
    CHECK(sandbox.json("tube/deposit.json")["result"]["total"]["outside_model_fraction"]["value"] == 1);
    CHECK(sandbox.read("tube/deposit-by-size.csv") == containing("\"above 500 m/s, outside the model\""));

    write_files(sandbox);
    Json sweep = sandbox.json("sweep.json");
    sweep["impact"].update({{"radius", "44 um"}, {"damping", "100 kg/s"}});
    sandbox.write("sweep.json", sweep.dump());
    const auto swept = test::succeeded(sandbox, "sweep sweep.json -o out.json");
    CHECK(swept.err == containing("hertz: of 100 % of the captures v_c is above 500 m/s, outside the model"));
    CHECK(swept.out == containing("2 captured (100 %: 100 % with v_c above 500 m/s, outside the"));
    CHECK(sandbox.json("out.json")["result"]["laws"][0]["captured_outside_model"]["value"] == 1);
    CHECK(sandbox.read("out.html") == containing("100 % with v_c above 500 m/s, outside the model"));

    const auto none = test::succeeded(
        sandbox, std::string("critical-velocity --law dmt --diameter '88 um'") + usual_contact);
    CHECK(none.out == containing("none: rebounds at every velocity"));
    CHECK(none.err == containing("is between DMT (< 0.1) and JKR (> 5)"));

    const std::string command =
        std::string("critical-velocity --law hertz --diameter '88 um' --damping '100 kg/s'") + usual_contact;
    const auto text = test::succeeded(sandbox, command);
    CHECK(text.out == containing("above 500 m/s, outside the model"));
    CHECK(text.err == containing("warning: the critical velocity is above 500 m/s, outside the model"));
    for (const char* absurd : {"contact time", "maximum overlap", "greatest pressure"})
        CHECK(text.out.find(absurd) == std::string::npos);
    const Json json = Json::parse(test::succeeded(sandbox, command + " --json").out);
    CHECK(json["critical_velocity"]["value"].get<double>() > 500);
    CHECK(json["notes"].dump() == containing("above 500 m/s, outside the model"));

    Json document = test::with_one_sample(test::example_case(), {"jkr"});
    document["samples"][0]["diameter"] = "11 nm";
    document["samples"][0]["work_of_adhesion"] = "19 J/m2";
    test::write_example(sandbox, document);
    const auto run = test::succeeded(sandbox, "run case.json -o out");
    CHECK(run.out == containing("above 500 m/s, outside the model"));
    CHECK(sandbox.read("out/report.html") == containing("above 500 m/s, outside the model"));
    CHECK(test::succeeded(sandbox, "inspect out/3-analytic.json").out ==
          containing("above 500 m/s, outside the model"));
}

TEST_CASE("the contact is printed as it was read") {
    const Sandbox sandbox;
    for (const char* command : {"critical-velocity", "impact --velocity '1 m/s'"})
        CHECK(test::succeeded(sandbox, std::string(command) +
                                           " --law sjkr --radius '5 um' --density '2300 kg/m3' "
                                           "--contact-modulus '90 GPa' --cohesion-energy-density 1000")
                  .out ==
              containing("R* 5 um, m 1.204 ng, E* 90 GPa, w 0 J/m2\n  cohesion energy density  1000 Pa\n"));
    CHECK(test::succeeded(sandbox,
                          "critical-velocity --diameter 20um --law thornton-ning --density 2300kg/m3 "
                          "--contact-modulus 90GPa --work-of-adhesion 0.3J/m2 --yield-pressure 5GPa "
                          "--damping-law contact-radius --damping '2150 Pa s'")
              .out == containing("captured again     above 500 m/s, outside the model"));
}

TEST_CASE("a bare number in an edited 0-case.json is checked as one of a case file") {
    const Sandbox sandbox;
    test::write_example(sandbox, test::with_one_sample(test::example_case(), {"hertz"}));
    test::succeeded(sandbox, "run case.json -o out");
    const Json artifact = sandbox.json("out/0-case.json");
    const auto edit = [&](const std::string& edits) {
        sandbox.write("out/0-case.json", test::edited(artifact, edits).dump());
    };
    for (const auto& [edits, says] :
         {std::pair{
              "/result/samples/0/diameter = 88",
              "0-case.json: /result/samples/0/diameter: 88 has no unit and is 88 m, did you mean 88 um?"},
          {"/result/samples/0/work_of_adhesion = 300",
           "/result/samples/0/work_of_adhesion: 300 has no unit and is 300 J/m2, did you mean 300 mJ/m2?"},
          {"/result/roughness = 5", "0-case.json: /result/roughness: 5 has no unit and is 5 m"}}) {
        CAPTURE(edits);
        edit(edits);
        check_refused(sandbox, "run -o out --from modulus", says);
    }
    edit("/result/samples/0/density = 30 ; /result/friction = 20");
    const auto run = test::succeeded(sandbox, "run -o out --from modulus");
    CHECK(run.err == containing("/result/samples/0/density: 30 kg/m3 is outside of what is plausible"));
    CHECK(run.err == containing("/result/friction: 20 is outside of what is plausible"));
}
