// SPDX-License-Identifier: GPL-3.0-or-later
#include <doctest/doctest.h>

#include "tests/pipeline/sandbox.hpp"

using namespace ashimpact;
using test::ashimpact_program;
using test::check_refused;
using test::example_case;
using test::Sandbox;

namespace {

/// Edits that spoil the example case, and what the program has to say of it: where, and that.
struct Spoiled {
    const char* edits;
    const char* pointer;
    const char* says;
};

const Spoiled spoiled_cases[]{
    {"- /name", "/", R"("name" is missing)"},
    {"- /samples/0/diameter", "/samples/0", R"("diameter" is missing; allowed: a length)"},
    {"- /work_of_adhesion", "/samples/0", R"("work_of_adhesion" is missing)"},
    {"- /wall", "/samples/0", "neither a wall nor a contact modulus"},
    {"- /wall/poisson_ratio", "/wall", R"("poisson_ratio" is missing)"},
    {"/wal = 1", "/wal", R"(unknown key, did you mean "wall"?)"},
    {"/samples/1/densitty = 1", "/samples/1/densitty", R"(did you mean "density"?)"},
    {R"(/laws/0 = "herz")", "/laws/0", R"(did you mean "hertz"?; allowed: hertz, dmt, brach-dunn, jkr)"},
    {R"(/laws = ["dmt", "dmt"])", "/laws", "the same value twice"},
    {"/laws = []", "/laws", "allowed: a list of contact laws"},
    {"/samples/1/composition/weight_fractions/quarz0 = 0.01",
     "/samples/1/composition/weight_fractions/quarz0", "quarz0"},
    {"/samples/1/composition/weight_fractions/quartz = 0.7", "/samples/1/composition/weight_fractions",
     "add up to 130.5 %"},
    {R"(/samples/1/composition/amorphous = "none")", "/samples/1/composition", "add up to 70.5 %"},
    {"- /samples/1/composition/amorphous", "/samples/1/composition", "amorphous"},
    {"/samples/1/composition/weight_fractions/quartz = -0.1",
     "/samples/1/composition/weight_fractions/quartz", "fraction is -10 %"},
    {R"(/samples/0/composition/weight_fractions = {"quartz": 1})", "/samples/0/composition",
     "more than one way"},
    {R"(/samples/1/composition/weight_fractions/quartz = "10,5 %")",
     "/samples/1/composition/weight_fractions/quartz", R"(has a decimal comma, write "10.5 %")"},
    {R"(/samples/1/density = {"value": "2,3", "unit": "g/cm3"})", "/samples/1/density/value",
     "write 2.3 without quotes"},
    {R"(/samples/1/restitution/velocity/values/0 = "0,54")", "/samples/1/restitution/velocity/values/0",
     "write 0.54 without quotes"},
    {R"(/samples/1/composition/internal_standard = {"phase": "quartz", "added_fraction": 0.09})",
     "/samples/1/composition/internal_standard", "which is stated too"},
    {R"(/samples/1/composition/densities = {"calcite": 2700})", "/samples/1/composition/densities/calcite",
     "not in the composition"},
    // What a sample could have from all particles is checked, though every sample states its own.
    {"/samples/0/density = 2300 ; /samples/1/density = 2300 ; /particle/density = -1", "/particle/density",
     "density is -1"},
    {"/samples/0/poisson_ratio = 0.2 ; /samples/1/poisson_ratio = 0.2 ; /particle/poisson_ratio = 0.7",
     "/particle/poisson_ratio", "0.7"},
    {"/samples/0/contact_modulus = 9e10 ; /samples/1/contact_modulus = 9e10 ; "
     R"(/particle/contact_modulus = "90 kg")",
     "/particle/contact_modulus", "not one of pressure"},
    {R"(/work_of_adhesion = {"surface_energies": {"particle": 0.04, "wall": 0.5}})", "/work_of_adhesion",
     R"("rule" is missing, by which w follows from the surface energies; allowed: girifalco-good)"},
    {R"(/samples/0/density = "2300 GPa")", "/samples/0/density",
     R"(the unit "GPa" is not one of density; allowed: a density [kg/m3])"},
    {R"(/samples/1/composition/xrd_decimal = "comma")", "/samples/1/composition/xrd_decimal",
     "belongs to an XRD file"},
    {R"(/samples/1/restitution/decimal = "comma")", "/samples/1/restitution/decimal",
     "belongs to a file of impacts"},
    {R"(/samples/0/restitution/decimal = "dot")", "/samples/0/restitution/decimal", "allowed: point, comma"},
    {R"(/samples/0/diameter = {"value": 88, "unit": "kg"})", "/samples/0/diameter", "not one of length"},
    {R"(/samples/0/diameter = {"value": 1, "units": "m"})", "/samples/0/diameter/units",
     R"(unknown key, did you mean "unit"?)"},
    {R"(/samples/0/diameter = "88 furlnogs")", "/samples/0/diameter", "is not known"},
    {R"(/samples/0/diameter = "large")", "/samples/0/diameter", "does not start with a number"},
    {R"(/samples/0/diameter = "nan um")", "/samples/0/diameter", "is not finite"},
    {R"(/samples/0/density = "inf kg/m3")", "/samples/0/density", "is not finite"},
    {R"(/samples/1/density = "-2300 kg/m3")", "/samples/1/density",
     "density is -2300 kg/m3; allowed: a positive density"},
    {"/samples/1/diameter = 0", "/samples/1/diameter", "diameter is 0 m"},
    {"/work_of_adhesion = -0.1", "/work_of_adhesion", "work of adhesion is -0.1 J/m2"},
    {"/wall/poisson_ratio = 0.7", "/wall/poisson_ratio", "is 0.7"},
    {"/wall/rigid = true", "/wall", "more than one way"},
    {R"(/wall = {"rigid": false})", "/wall/rigid", "needs its moduli"},
    {"/samples/0/diameter = [1, 2]", "/samples/0/diameter", "is a list of 2; allowed: a length"},
    {"/name = 3", "/name", "is 3; allowed: a name"},
    {R"(/detachments/dmt = "pull-off")", "/detachments/dmt", "pull-off does not end a contact of law dmt"},
    {R"(/laws = ["dmt"] ; /detachments/jkr = "pull-off")", "/detachments/jkr",
     R"(the law is not among "laws"; allowed: a law of the case)"},
    {"/phases = []", "/phases", "at least one phase"},
    {R"(/phases = [{"name": "x", "density": 3000, "young_modulus": 9e10}, {"name": "x", "density": )"
     R"(3000, "young_modulus": 9e10}])",
     "/phases/1", R"(two phases are called "x"; allowed: each phase once)"},
    // A file without an end.
    {R"(/samples/0/restitution/file = "/dev/zero")", "/samples/0/restitution/file",
     "/dev/zero: lies outside of the folder of the case"},
    {R"(/detachments/dtm = "pull-off")", "/detachments/dtm",
     R"(no contact law is called "dtm", did you mean "dmt"?)"},
    {R"(/damping_law = "viscous")", "/damping_law", "allowed: constant, contact-radius, tsuji"},
    {R"(/samples/1/name = "fine")", "/samples/1/name", "two samples have this name"},
    {"/samples = []", "/samples", "allowed: a list of at least one sample"},
    {"/samples/1/restitution/restitution = [0.1]", "/samples/1/restitution/restitution",
     "has 1 values, velocity has 20"},
    {"/samples/1/restitution/restitution/3 = 1.2", "/samples/1/restitution",
     "point 4: restitution is 1.2; allowed: 0 <= restitution < 1"},
    // Uncertainties above every velocity.
    {R"(/samples/1/restitution/camera = {"frame_rate": 80000, "pixel_size": "1 m"})",
     "/samples/1/restitution/camera", "the standard uncertainty of v_in is at least"},
    {R"(/camera = {"frame_rate": 80000, "pixel_size": "1 m"})", "/camera",
     "the standard uncertainty of v_in is at least"},
    {R"(/samples/1/restitution = {"velocity": [1, 2], "restitution": [0, 0.1], "velocity_uncertainty": )"
     R"([1e3, 1e3], "rebound_uncertainty": [0.1, 0.1]})",
     "/samples/1/restitution", "the standard uncertainty of v_in is at least"},
    {R"(/samples/1/restitution/binning = {"width": "1e-30 m/s"})", "/samples/1/restitution/binning",
     "a width of at least a millionth"},
    {"/samples/1/restitution/velocity/values/0 = -1", "/samples/1/restitution",
     "point 1: velocity is -1 m/s"},
    // Faster after the impact than before, without an uncertainty.
    {R"(/samples/1/restitution = {"velocity": [1, 2], "rebound_velocity": [0.2, 2.5]})",
     "/samples/1/restitution", "point 2: restitution is 1.25"},
    {R"(/samples/1/restitution = {"velocity": [1, 2], "restitution": [0, 0.1], "velocity_uncertainty": )"
     "[0.1, 0.1]}",
     "/samples/1/restitution", "velocity_uncertainty with rebound_uncertainty"},
    {R"(/samples/1/restitution = {"velocity": [1, 2], "restitution": [0, 0.1], "velocity_uncertainty": )"
     R"([0, 0], "rebound_uncertainty": [0.1, 0.1]})",
     "/samples/1/restitution", "an uncertainty is not a finite number > 0"},
    {R"(/samples/1/restitution = {"velocity": [1, 2], "restitution": [0, 0.1], "rebound_velocity": )"
     "[0.1, 0.1]}",
     "/samples/1/restitution", "given in more than one way"},
    {"/samples/0/restitution/velocity_uncertainty = [0.1]", "/samples/0/restitution/velocity_uncertainty",
     "belongs to velocities of the case"},
    {R"(/samples/0/restitution = {"camera": {"frame_rate": 80000, "pixel_size": "2 um"}, )"
     R"("reconstruct": {"from": 0.1, "to": 0.5, "points": 5, "reference_law": "dmt"}})",
     "/samples/0/restitution/camera", "belongs to measured impacts"},
    {R"(/camera = {"frame_rate": 80000})", "/camera", R"("pixel_size" is missing)"},
    {R"(/camera = {"frame_rate": 80000, "pixel_size": 0})", "/camera/pixel_size", "pixel size is 0 m"},
    {R"(/samples/0/restitution/binning = {"impacts_per_bin": 3, "width": "0.1 m/s"})",
     "/samples/0/restitution/binning", "binning by both or neither"},
    {R"(/fit = {"order": 9})", "/fit/order", "allowed: 1 to 6"},
    {R"(/samples/0/restitution/file = "none.csv")", "/samples/0/restitution/file",
     "none.csv: cannot be read: No such file"},
    {R"(/samples/0/composition/xrd_sample = "x")", "/samples/0/composition/xrd_sample",
     "no such sample; allowed: fine"},
    {R"(/samples/0/restitution = {"reconstruct": {"from": 0.1, "to": 0.5, "points": 5, )"
     R"("reference_law": "dmt"}})",
     "/samples/0/restitution/reconstruct", R"("damping_fits" is missing)"},
    {R"(/phase_set = "paper")", "/phase_set", "allowed: literature, dong2013"},
    {R"(/phases = [{"name": "x", "density": 3000}])", "/phases/0", R"("young_modulus" is missing)"},
    {R"(/published = "dong2014")", "/published", "cannot be read"},
};

/// Refuses the case with its pointer, and leaves every file as it was.
void check_case_refused(const Sandbox& sandbox, const std::string& pointer, const std::string& says) {
    const std::string message = check_refused(sandbox, "run case.json -o out", says);
    CHECK_MESSAGE(message.starts_with("case.json: " + pointer + ": "), message);
}

}  // namespace

TEST_CASE("every kind of wrong case: exit 2, one line with file and pointer, nothing written") {
    for (const Spoiled& spoiled : spoiled_cases) {
        CAPTURE(spoiled.edits);
        const Sandbox sandbox;
        test::write_example(sandbox, test::edited(example_case(), spoiled.edits));
        check_case_refused(sandbox, spoiled.pointer, spoiled.says);
    }
}

TEST_CASE("what JSON itself forbids is found by line and column, a duplicate key by its pointer") {
    struct Text {
        const char* text;
        const char* place;
        const char* says;
    };
    for (const Text& text :
         {Text{"{\"name\": \"x\",\n \"samples\": [}", "line 2, column 14", "not valid JSON"},
          Text{"{\"name\": \"a\", \"name\": \"b\"}", "/name", "this key is there twice"},
          Text{"{\"samples\": [{\"density\": 1e999}]}", "/samples/0/density", "out of the range"},
          Text{"[1, 2]", "/", "allowed: a case"}, Text{"null", "/", "allowed: a case"}}) {
        CAPTURE(text.text);
        const Sandbox sandbox;
        sandbox.write("case.json", text.text);
        check_case_refused(sandbox, text.place, text.says);
    }
}

TEST_CASE("a file given by an absolute path keeps path and pointer apart") {
    const Sandbox sandbox;
    Json document = example_case();
    document["samples"][0]["density"] = -1;
    test::write_example(sandbox, document);
    const std::string path = sandbox.path("case.json");
    const auto finished = ashimpact_program(sandbox, "run " + path);
    CHECK(finished.status == 2);
    CHECK_MESSAGE(finished.err.starts_with(path + ": /samples/0/density: density is"), finished.err);
}

TEST_CASE("wrong options: exit 2, one line that names the option") {
    const std::string contact =
        " --radius '44 um' --density '2600 kg/m3' --contact-modulus '90 GPa' --work-of-adhesion '0.3 J/m2'";
    struct Wrong {
        std::string arguments;
        const char* says;
    };
    const Sandbox sandbox;
    for (const Wrong& wrong : {
             Wrong{"", "a command is missing; allowed: run, modulus, contact, impact"},
             Wrong{"runn", "unknown command \"runn\", did you mean \"run\"?"},
             Wrong{"modulsu ash.csv", "unknown command \"modulsu\", did you mean \"modulus\"?"},
             Wrong{"impact --radios 3", "\"--radios\" is not expected, did you mean --radius?"},
             Wrong{"run --plot x", "\"--plot\" is not expected; allowed: "},
             Wrong{"phases kryptonite",
                   "no phase is called \"kryptonite\"; allowed: a phase that `ashimpact phases`"},
             Wrong{"impact", "--law is missing; allowed: contact law: hertz"},
             Wrong{"impact --law dmt --law dmt", "--law is given more than once; allowed: contact law"},
             Wrong{"impact --law", "--law has no value; allowed: contact law"},
             Wrong{"run a.json b.json", "\"b.json\" is not expected; allowed: "},
             Wrong{"run --fron fit", "\"--fron\" is not expected, did you mean --from?; allowed: "},
             Wrong{"run -o ''", "--output: is empty; allowed: folder of the artifacts"},
             Wrong{"init ''", "DIR: is empty; allowed: where to write it"},
             Wrong{"run --from ''", "--from: is empty; allowed: start at this stage"},
             Wrong{"run --only ''", "--only: is empty; allowed: run this stage alone"},
             Wrong{"modulus x.csv --sample ''", "--sample: is empty; allowed: "},
             Wrong{"calibrate --free ''", "--free: is empty; allowed: a constant to find"},
             Wrong{"sweep s.json -o s2.json --checkpoint nan",
                   "--checkpoint: is \"nan\"; allowed: a number from 0 to 1000000"},
             Wrong{"impact --law dmt --velocity 2 --damping ''" + contact, "--damping: is empty; allowed: "},
             Wrong{"impact --law dmt --velocity 2 --trajectory -" + contact,
                   "--trajectory: is \"-\"; allowed: a path, ./- for a file of that name"},
             Wrong{"impact --law dmt --velocity 2 --traj t.csv" + contact,
                   "\"--traj\" is not expected, did you mean --trajectory?"},
             Wrong{"frob --help", "unknown command \"frob\"; allowed: run"},
             Wrong{"frob --version", "unknown command \"frob\""},
             Wrong{"schema -q -v", "--quiet, --verbose: both are given; allowed: one of the two"},
             Wrong{"-q schema -v", "--quiet, --verbose: both are given"},
             Wrong{"init " + std::string(300, 'a'), "File name too long; allowed: "},
             Wrong{"inspect /dev/zero", "/dev/zero: is longer than 256 MiB; allowed: "},
             Wrong{"calibrate --free contact_modulus --free wall_young_modulus",
                   "contact_modulus and wall_young_modulus are both free"},
             Wrong{"critical-velocity --law hertz --damping 1e-40" + contact,
                   "--damping: the velocity that this damping captures is "},
             Wrong{"critical-velocity --law hertz --damping 1e30" + contact,
                   "--damping: the critical velocity is above 500 m/s, outside the model, beyond the range"},
             Wrong{"impact --law dmt --velocity 2 --radius '44 um' --density 2600 --contact-modulus 9e10 "
                   "--work-of-adhesion '1e300 J/m2'",
                   "--work-of-adhesion: work of adhesion is 1e+300 J/m2; allowed: 0, or 1e-40 to 1e40"},
             Wrong{"impact --law hertz --velocity 2 --radius '1e-20 m' --density 2600 --contact-modulus 9e10",
                   "--radius, --density: mass of the sphere is "},
             Wrong{"impact --law dmt --velocity 2 --radius '44 um' --contact-modulus '90 GPa'",
                   "--density, --mass: neither is given"},
             Wrong{"impact --law dmt --velocity 2 --mass 1e-9" + contact,
                   "--density, --mass: both are given"},
             Wrong{"impact --law dmt --velocity 2 --radius '44 um' --density 2600 --contact-modulus '90 GPa'",
                   "--work-of-adhesion: is missing"},
             Wrong{"contact --rigid-wall" + contact,
                   "--contact-modulus, --rigid-wall: both are given; allowed: one"},
             Wrong{"contact --wall-poisson-ratio 9" + contact,
                   "--contact-modulus, --wall-poisson-ratio: both"},
             Wrong{"contact --wall-surface-energy 1" + contact,
                   "--work-of-adhesion, --wall-surface-energy: both"},
             Wrong{"contact --rigid-wall --wall-young-modulus '193 GPa' --young-modulus '148 GPa' "
                   "--poisson-ratio 0.2 --radius '44 um' --density 2600 --work-of-adhesion 0.3",
                   "--rigid-wall, --wall-young-modulus: both are given"},
             Wrong{"impact --law dtm --velocity 2" + contact,
                   "--law: no contact law is called \"dtm\", did you mean \"dmt\"?; allowed: hertz"},
             Wrong{"impact --law dmt --velocity '2 m'" + contact,
                   "--velocity: the unit \"m\" is not one of velocity"},
             Wrong{"impact --law dmt --velocity -2" + contact, "--velocity: velocity is -2 m/s"},
             Wrong{"impact --law dmt --velocity 2 --damping '1 kg'" + contact,
                   "--damping: the unit \"kg\" is not one of damping"},
             Wrong{"impact --law dmt --velocity 2 --damping -1" + contact, "--damping: damping is -1 kg/s"},
             Wrong{"impact --law dmt --velocity 2 --detachment pull-off" + contact,
                   "--detachment: pull-off does not end"},
             Wrong{"impact --law dmt --velocity 2 --damping-law x" + contact, "--damping-law: "},
             Wrong{"impact --law dmt --velocity 2 --method euler" + contact,
                   "--method: unknown method \"euler\"; allowed: taylor, paper-explicit"},
             Wrong{"impact --law dmt --velocity 2 --frobnicate" + contact, "--frobnicate"},
             Wrong{"impact --law dmt --velocity 2 --trajectory no/such\\0x" + contact + " --points 1",
                   "--points"},
             Wrong{"impact --law dmt --velocity 2 --points 11" + contact,
                   "--points requires --trajectory; allowed: both or neither"},
             Wrong{"impact --law dmt --velocity 2 --trajectory t.csv --points 1" + contact,
                   "--points: is \"1\"; allowed: a whole number from 2 to 10000000"},
             Wrong{"impact --law hertz --velocity -2" + contact, "--velocity: velocity is -2 m/s"},
             Wrong{"damping --law jkr --velocity 0.001 --restitution 0.3" + contact,
                   "allowed: 0, or a velocity at which the impact rebounds without damping"},
             Wrong{"impact --law jkr --velocity 2 --method paper-explicit" + contact,
                   "cannot treat law 'jkr'"},
             Wrong{
                 "impact --law thornton-ning --yield-pressure '1 GPa' --velocity 2 --method paper-explicit" +
                     contact,
                 "cannot treat law 'thornton-ning'"},
             Wrong{"damping --law dmt --velocity 2 --restitution 1.5" + contact, "--restitution: "},
             Wrong{"modulus x.csv --phases zz", "zz: cannot be read"},
             Wrong{"damping --law dmt" + contact,
                   "--velocity, --impacts: neither is given; allowed: the velocity of one impact"},
             Wrong{"damping --law dmt --velocity 2" + contact, "--restitution: is missing"},
             Wrong{"damping --law dmt --velocity 2 --impacts x.csv" + contact,
                   "--velocity excludes --impacts; allowed: one of them"},
             Wrong{"damping --law dmt --impacts x.csv" + contact, "x.csv: cannot be read"},
             Wrong{"damping --law dmt --velocity 2 --restitution 0.1 --bin 3" + contact,
                   "--bin requires --impacts; allowed: both or neither"},
             Wrong{"damping --law dmt --impacts x.csv --damping-law tsuji" + contact,
                   "--damping-law: a series of impacts is read with constant damping"},
             Wrong{"impact --law dmt --velocity 2 --density 2300 --contact-modulus '90 GPa' "
                   "--work-of-adhesion 0.3",
                   "--diameter, --radius: neither is given; allowed: one of the two"},
             Wrong{"literature --law dmt --contact-modulus '90 GPa' --work-of-adhesion 0.3",
                   "--density: is missing; allowed: a density"},
             Wrong{"literature --damping-law tsuji", "--damping-law: is given without --law"},
             Wrong{"calibrate --damping-law tsuji", "--damping-law: is given without --sizes"},
             Wrong{"calibrate --sizes arffman2015 --free work_of_adhesion --uncertainty 0.1 --density 2300",
                   "--law: is missing; allowed: hertz"},
             Wrong{"cross-check none.json", "none.json: cannot be read"},
             Wrong{"thornton-ning", "unknown command"},
             Wrong{"impact --law thornton-ning --velocity 2" + contact, "--yield-pressure: is missing"},
             Wrong{"impact --law sjkr --velocity 2" + contact,
                   "--cohesion-energy-density: is missing; allowed: k_c"},
             Wrong{"impact --law sjkr --velocity 2 --cohesion-energy-density '-1 J/m3'" + contact,
                   "--cohesion-energy-density: cohesion_energy_density is -1 Pa"},
             Wrong{"impact --law sjkr --velocity 2 --cohesion-energy-density '1 J/m2'" + contact,
                   "--cohesion-energy-density: the unit \"J/m2\" is not one of pressure"},
             Wrong{"run --from fitt",
                   "--from: no stage is called \"fitt\", did you mean \"fit\"?; allowed: modulus"},
             Wrong{"run --from fit --only fit", "--only"},
             Wrong{"run --from fit -o nowhere", "nowhere/0-case.json: cannot be read"},
             Wrong{"modulus none.csv", "none.csv: cannot be read"},
             Wrong{"damping --law hertz --velocity 2 --restitution 0.5 --decimal comma" + contact,
                   "--decimal requires --impacts; allowed: both or neither"},
             Wrong{"inspect none.json", "none.json: cannot be read"},
             Wrong{"schema cases", "no schema is called \"cases\""},
             Wrong{"calibrate --free density --free density:each", "--free: \"density\" is given twice"},
             Wrong{"impact --law dmt --velocity '1e308 m/s'" + contact, "allowed: 1e-40 to 1e40"},
             Wrong{"critical-velocity --law dmt --damping 1e300" + contact, "allowed: 0, or 1e-40 to 1e40"},
             Wrong{"calibrate --free speed",
                   "--free: no constant of a calibration is called \"speed\"; allowed: density"},
         }) {
        check_refused(sandbox, wrong.arguments, wrong.says);
    }
    CHECK(sandbox.everything().empty());
}

TEST_CASE("a bad case or artifact is refused with its file and pointer, the results of the run before stay") {
    const Sandbox sandbox;
    Json bad_case = test::example_under("dmt");
    test::write_example(sandbox, bad_case);
    test::succeeded(sandbox, "run case.json -o out");
    bad_case["samples"][1]["density"] = -1;
    sandbox.write("case.json", bad_case.dump());
    check_case_refused(sandbox, "/samples/1/density", "density is -1 kg/m3");
    struct Spoilt {
        const char* file;
        const char* edits;
        const char* says;
    };
    for (const Spoilt& edit : {
             Spoilt{"2-contact.json", R"(/result/samples/0/mass/unit = "Pa")",
                    "out/2-contact.json: /result/samples/0/mass"},
             Spoilt{"2-contact.json", "/result/samples/0/contact_modulus/value = -1.0", "/result/samples/0"},
             Spoilt{"2-contact.json", "/result/samples/1/density/value = -1.0",
                    "out/2-contact.json: /result/samples/1/density/value: is -1 kg/m3; allowed: 0 or more"},
             Spoilt{"2-contact.json", "- /result/samples/1",
                    "the sample \"coarse\" is missing; allowed: every sample of 0-case.json"},
             Spoilt{"2-contact.json", "- /result/samples", "/result: \"samples\" is missing"},
             Spoilt{"2-contact.json", R"(/schema = "3-analytic")", "/schema: "},
             Spoilt{"6-fit.json",
                    "/result/samples/1/dmt/c/value = -0.01 ; - /result/samples/1/dmt/extrapolated ; "
                    "/result/samples/1/dmt/critical_damping/value = -0.01 ; - /result/samples/1/dmt/direct",
                    "/critical_damping: critical damping is -0.01 kg/s; allowed: a non-negative damping"},
             Spoilt{"7-critical-velocity.json", "/result/samples/1/dmt/critical_velocity/value = -1.0",
                    "out/7-critical-velocity.json: /result/samples/1/dmt/critical_velocity/value: "
                    "is -1 m/s; allowed: 0 or more"},
             Spoilt{"7-critical-velocity.json", "/result/samples/0/measured/critical_velocity/value = -1.0",
                    "/result/samples/0/measured/critical_velocity/value: is -1 m/s"},
         }) {
        CAPTURE(edit.says);
        const std::string file = std::string("out/") + edit.file;
        const Json good = sandbox.json(file);
        sandbox.write(file, test::edited(good, edit.edits).dump());
        const std::string stage = file == "out/6-fit.json"                 ? "critical-velocity"
                                  : file == "out/7-critical-velocity.json" ? "histories"
                                                                           : "restitution";
        check_refused(sandbox, "run -o out --from " + stage, edit.says);
        sandbox.write(file, good.dump());
    }
}
