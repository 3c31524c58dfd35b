// SPDX-License-Identifier: GPL-3.0-or-later
// Deposition on a tube, on the command line.
#include <cmath>
#include <limits>
#include <numbers>
#include <string>
#include <vector>

#include <doctest/doctest.h>

#include "core/json/document.hpp"
#include "tests/pipeline/sandbox.hpp"
#include "tests/support/checks.hpp"

using namespace ashimpact;
using namespace ashimpact::test;

namespace {

const std::string superheater =
    " --tube-diameter '38 mm' --gas-velocity '12 m/s' --gas-temperature '900 C' -o tube";
/// So slow that no particle arrives: what is read of sizes does not take the time of their paths.
const std::string slow_gas =
    " --tube-diameter '38 mm' --gas-velocity '0.3 m/s' --gas-temperature '900 C' -o tube";
const std::string sticky_ash =
    " --law jkr --density '2300 kg/m3' --contact-modulus '90 GPa' --work-of-adhesion '0.3 J/m2' "
    "--damping-law tsuji "
    "--damping 1.8";

/// The artifact of a deposition.
Json deposited(const Sandbox& sandbox, const std::string& arguments) {
    succeeded(sandbox, "deposit" + superheater + arguments);
    return sandbox.json("tube/deposit.json");
}

double value_of(const Json& parent, const char* key) {
    return parent.at(key).at("value").get<double>();
}

}  // namespace

TEST_CASE("a damping by its restitution is that of the size, and refused where sizes need different ones") {
    const Sandbox sandbox;
    const std::string contact =
        " --law jkr --density '2300 kg/m3' --contact-modulus '90 GPa' "
        "--work-of-adhesion '0.3 J/m2' --damping-restitution 0.5 --at '1 m/s'";
    const std::string many = " --sizes 'rosin-rammler: 20 um, 1.2'";
    for (const std::string law : {"constant", "contact-radius", "tsuji"}) {
        CAPTURE(law);
        const std::string all =
            contact.substr(0, law == "tsuji" ? contact.find(" --at") : std::string::npos) +
            " --damping-law " + law;
        const Json alone =
            parse_json(succeeded(sandbox, "critical-velocity --diameter '20 um' --json" + all).out);
        const Json artifact = deposited(sandbox, all + " --sizes '20 um'");
        CHECK(value_of(artifact["result"]["sizes"][0], "critical_velocity") ==
              doctest::Approx(value_of(alone, "critical_velocity")).epsilon(1e-3));
        if (law == "tsuji")
            deposited(sandbox, all + many);
        else
            check_refused(sandbox, "deposit" + superheater + all + many,
                          "needs another damping at each size");
    }
}

TEST_CASE("one damping in kg/s for many sizes is doubted, unless its law is stated") {
    const Sandbox sandbox;
    const std::string contact =
        " --law dmt --density '2300 kg/m3' --contact-modulus '90 GPa' --work-of-adhesion '0.3 J/m2' "
        "--damping '1e-4 kg/s'";
    const std::string many = " --sizes 'rosin-rammler: 20 um, 1.2'";
    const auto said = [&](const std::string& more) {
        return contains(succeeded(sandbox, "deposit" + superheater + contact + more).err,
                        "one coefficient in kg/s for sizes of");
    };
    CHECK(said(many));
    CHECK_FALSE(said(many + " --damping-law constant"));
    CHECK_FALSE(said(" --sizes '20 um'"));
}

TEST_CASE("a deposition conserves mass over sizes, around the tube and along its length") {
    const Sandbox sandbox;
    const Json artifact =
        deposited(sandbox, sticky_ash + " --sizes 'rosin-rammler: 20 um, 1.2' --ash-load '10 g/m3'");
    const Json& result = artifact["result"];
    const Json& total = result["total"];
    double mass = 0;
    double stays = 0;
    double arrives = 0;
    for (const Json& size : result["sizes"]) {
        mass += value_of(size, "mass_fraction");
        stays += value_of(size, "deposition_flux");
        arrives += value_of(size, "mass_fraction") * value_of(size, "impaction_efficiency");
        CHECK(value_of(size, "stick_fraction") <= 1);
    }
    double around = 0;
    double arrives_around = 0;
    for (const Json& arc : result["angles"]) {
        around += value_of(arc, "deposition_flux") * (value_of(arc, "to") - value_of(arc, "from"));
        arrives_around += value_of(arc, "arrives");
    }
    CHECK(std::abs(mass - 1) < 1e-12);
    const double flux = value_of(total, "deposition_flux");
    CHECK(flux > 0);
    CHECK(relative_difference(stays, flux) < 1e-12);
    CHECK(relative_difference(around / std::numbers::pi, flux) < 1e-12);
    CHECK(relative_difference(value_of(total, "deposition_rate"), flux * std::numbers::pi * 0.038) < 1e-12);
    CHECK(relative_difference(arrives, value_of(total, "impaction_efficiency")) < 1e-12);
    CHECK(relative_difference(arrives_around, arrives) < 1e-12);
    // Load times velocity times the shares, over the circumference.
    CHECK(relative_difference(
              flux, 0.01 * 12 / std::numbers::pi * arrives * value_of(total, "stick_fraction")) < 1e-12);
    // At 0 C the same load is 10 g/m3 times 1173.15/273.15.
    const Json normal = deposited(
        sandbox, sticky_ash + " --sizes 'rosin-rammler: 20 um, 1.2' --ash-load '42.94892915980231 g/Nm3'");
    CHECK(relative_difference(value_of(normal["result"]["total"], "deposition_flux"), flux) < 1e-9);
    for (const char* file : {"deposit.html", "deposit-by-size.csv", "deposit-around-the-tube.csv"})
        CHECK(sandbox.has(std::string("tube/") + file));
    CHECK(succeeded(sandbox, "inspect tube/deposit.json").out == containing("deposition_flux"));
}

TEST_CASE("what stays of a wider distribution goes on falling, though it is all of some classes") {
    const Sandbox sandbox;
    const std::string weakly_damped =
        " --law jkr --density '2300 kg/m3' --contact-modulus '90 GPa' --work-of-adhesion '0.05 J/m2' "
        "--damping-law tsuji --damping 0.1 --ash-load '10 g/m3'";
    double before = std::numeric_limits<double>::infinity();
    for (const char* width : {"2.6", "2.8", "3", "3.2", "3.6", "4"}) {
        const Json artifact =
            deposited(sandbox, weakly_damped + " --sizes 'log-normal: 20 um, " + width + "'");
        const double flux = value_of(artifact["result"]["total"], "deposition_flux");
        CHECK_MESSAGE(flux < before, width);
        before = flux;
    }
}

TEST_CASE("sizes that stick again when they are faster are refused" * doctest::test_suite("long")) {
    const Sandbox sandbox;
    const std::string pair =
        " --law thornton-ning --density 2300kg/m3 --contact-modulus 90GPa --work-of-adhesion 0.3J/m2 "
        "--yield-pressure 1GPa --damping-law contact-radius --damping '2150 Pa s'";
    const auto deposit = [&](const std::string& velocity) {
        return ashimpact_program(sandbox, "deposit" + pair +
                                              " --tube-diameter '38 mm' --gas-temperature '900 C' --sizes "
                                              "'20 um' --ash-load '10 g/m3' -o d --gas-velocity " +
                                              velocity);
    };
    CHECK(ashimpact_program(sandbox, "critical-velocity --diameter 20um" + pair).out ==
          test::containing("captured again     above 3.94"));
    const Finished fast = deposit("12m/s");
    CHECK(fast.status == 2);
    CHECK(fast.err == test::containing("20 um spheres stick below 1.412 m/s and again above 3.94"));
    CHECK(deposit("3m/s").status == 0);
}

TEST_CASE("what stays goes from nothing to all, and without a load there are shares alone") {
    const Sandbox sandbox;
    const std::string ash = " --density '2300 kg/m3' --contact-modulus '90 GPa' --sizes '20 um'";
    const Json hardly = deposited(sandbox,
                                  " --density '2300 kg/m3' --contact-modulus '90 GPa' --sizes '90 um' "
                                  "--law hertz --damping '1e-5 kg/s'");  // v_c 1e-16 m/s
    CHECK(value_of(hardly["result"]["total"], "stick_fraction") == 0);
    const Json none = deposited(sandbox, ash + " --law hertz");
    CHECK(value_of(none["result"]["total"], "stick_fraction") == 0);
    CHECK(value_of(none["result"]["total"], "impaction_efficiency") > 0.2);
    CHECK(none["result"]["total"]["deposition_flux"].is_null());
    const Json all = deposited(sandbox, ash + " --law hertz --damping '1 kg/s'");
    CHECK(value_of(all["result"]["total"], "stick_fraction") == 1);
    CHECK(all["result"]["assumption"] == "constant");
    CHECK(all["result"]["total"]["rebound_velocity"].is_null());
    CHECK(value_of(all["result"]["total"], "outside_model_fraction") == 1);
    // Damping that grows with overlap and velocity alike: captured at every velocity.
    const Finished always = succeeded(sandbox, "deposit" + superheater + ash +
                                                   " --law jkr --work-of-adhesion '0.4 J/m2' "
                                                   "--damping-law hunt-crossley --damping '50 s/m'");
    CHECK(always.err == containing("that it stays is no result"));
    // Undamped spheres without adhesion rebound as they came; with Tsuji's damping all with the same e.
    CHECK(std::abs(value_of(none["result"]["total"], "restitution") - 1) < 1e-12);
    CHECK(relative_difference(value_of(none["result"]["total"], "rebound_velocity"),
                              value_of(none["result"]["sizes"][0], "normal_velocity")) < 1e-2);
    const Json damped = deposited(sandbox, ash + " --law hertz --damping-law tsuji --damping 0.5");
    const double e = parse_json(succeeded(sandbox,
                                          "impact --json --law hertz --density '2300 kg/m3' "
                                          "--contact-modulus '90 GPa' --diameter '20 um' --velocity "
                                          "'5 m/s' --damping-law tsuji --damping 0.5")
                                    .out)["restitution"]["value"];
    CHECK(relative_difference(value_of(damped["result"]["sizes"][0], "restitution"), e) < 1e-6);
    // The mean of the whole tube is that of its parts.
    const Json adhesive =
        deposited(sandbox, ash +
                               " --law jkr --work-of-adhesion '0.4 J/m2' --damping-law tsuji "
                               "--damping 0.5");
    CHECK(value_of(adhesive["result"]["total"], "stick_fraction") > 0);
    for (const char* mean : {"restitution", "rebound_velocity"})
        CHECK(relative_difference(value_of(adhesive["result"]["total"], mean),
                                  value_of(adhesive["result"]["sizes"][0], mean)) < 1e-4);
    const Json thick = deposited(sandbox, ash + " --law hertz --gas-viscosity '200 uPa s'");
    CHECK(value_of(thick["result"]["total"], "impaction_efficiency") <
          0.2 * value_of(none["result"]["total"], "impaction_efficiency"));
}

TEST_CASE("a sieve table in any form is the distribution it was made of") {
    const Sandbox sandbox;
    std::string passing = "Korngröße [µm];Durchgang [%]\n";
    std::string residue = "size (mm),residue\n";
    std::string shares = "from [um]\tto [um]\tshare [%]\n";
    double before = 0;
    double below = 0;
    for (double d = 0.5; d < 200; d *= 1.25) {
        const double finer = d * 1.25 < 200 ? -std::expm1(-std::pow(d / 20, 1.2)) : 1;
        std::string decimal = std::to_string(d);
        decimal.replace(decimal.find('.'), 1, ",");
        passing += decimal + ";" +
                   std::to_string(100 * finer).replace(std::to_string(100 * finer).find('.'), 1, ",") + "\n";
        residue += std::to_string(d / 1000) + "," + std::to_string(1 - finer) + "\n";
        shares += std::to_string(before) + "\t" + std::to_string(d) + "\t" +
                  std::to_string(100 * (finer - below)) + "\n";
        before = d;
        below = finer;
    }
    sandbox.write("passing.csv", passing);
    sandbox.write("residue.csv", residue);
    sandbox.write("shares.tsv", shares);
    const Json law = deposited(sandbox, sticky_ash + " --sizes 'rosin-rammler: 20 um, 1.2'");
    const double expected = value_of(law["result"]["total"], "stick_fraction");
    for (const char* file : {"passing.csv", "residue.csv", "shares.tsv"}) {
        CAPTURE(file);
        const Json table = deposited(sandbox, sticky_ash + " --sizes " + file);
        CHECK(relative_difference(value_of(table["result"]["total"], "stick_fraction"), expected) < 0.01);
        CHECK(table["provenance"]["inputs"].size() == 1);
    }
}

TEST_CASE("of a run v_c by size counts, and beyond the measured sizes the headline says so") {
    const Sandbox sandbox;
    put_built_in_run(sandbox);
    const std::string ash = " results --sizes 'rosin-rammler: 20 um, 1.2' --ash-load '10 g/m3'";
    const Finished finished = succeeded(sandbox, "deposit" + superheater + ash);
    CHECK(finished.out.starts_with("This is outside of what the data support"));
    CHECK(finished.out == containing("What this is not"));
    CHECK(finished.err == containing("and the fastest impact of the run has"));
    const Json first = sandbox.json("tube/deposit.json");
    const Json& result = first["result"];
    CHECK(finished.out == containing(" K (900 C)"));
    CHECK(result["assumption"] == "tsuji");
    const Json& span = result["total"]["stick_fraction_span"];
    CHECK(value_of(span, "least") <= value_of(result["total"], "stick_fraction"));
    CHECK(value_of(span, "greatest") > 0.9);
    CHECK(first["provenance"]["run"] == sandbox.json("results/comparison.json")["provenance"]["run"]);
    const Json again = deposited(sandbox, ash);
    CHECK(again == first);
    const Json constant = deposited(sandbox, ash + " --assumption constant");
    CHECK(constant["result"]["assumptions"].size() == result["assumptions"].size());
    CHECK(value_of(constant["result"]["total"], "stick_fraction") > 0.9);
    // Over the measured sizes v_c is as measured whatever is assumed elsewhere.
    const Json measured = deposited(sandbox, " results --sizes '96 um'");
    CHECK(relative_difference(value_of(measured["result"]["sizes"][0], "critical_velocity"),
                              1.2296515777623622) < 1e-6);
    CHECK(value_of(measured["result"]["total"], "supported_fraction") == 1);
    // Their rebounds as well: e between the least and the greatest of the laboratory near these velocities.
    const double e = value_of(measured["result"]["total"], "restitution");
    CHECK(e > 0);
    for (const Json& arc : measured["result"]["angles"])
        if (!arc["rebound_velocity"].is_null())
            CHECK(value_of(arc, "rebound_velocity") <= value_of(arc, "normal_velocity"));
    check_refused(sandbox, "deposit" + superheater + ash + " --assumption hunt-crossley",
                  "do not admit hunt-crossley");
    check_refused(sandbox, "deposit" + superheater + ash + " --density 2000", "--density: the run has it");
    check_refused(sandbox, "deposit" + superheater + ash + " --at '2 m/s'", "--at: the run has it");
}

TEST_CASE("what a sieve table has beside sizes and shares is said") {
    const Sandbox sandbox;
    for (const auto& [table, says] :
         {std::pair{"size [um];passing [wt%];Bemerkung\n10;20;x\n20;100;\n",
                    "column \"Bemerkung\" is not used"},
          {"size [um];;passing [%]\n10;5;20\n20;6;100\n",
           "column 2, which has no heading, is not used: \"5\""},
          {"size [um];Comment;passing [%]\n10;dry;20\n20;by laser;100\n",
           "column \"Comment\" is not used: \"dry\", \"by laser\""},
          {"size [um];passing [Vol.-%]\n10;20\n20;100\n", "is by volume: taken as by mass"},
          {"size [um];passing [%]\n10;20\n20;99.5\n", "0.5 % is coarser than the largest size of the table"},
          {"size [um];passing\n10;20\n20;100\n", "by their size they are per cent"},
          {"size [um];cumulative residue\n10;80\n15;20\n20;0\n", "by their size they are per cent"},
          {"size [um];passing [%]\n10 um;20 \u00b1 1\n20 um;100\n", "uncertainties are not used"},
          {"size [um];passing [%]\n10;20\n20;100\nTotal;100\n", "line 4 is no size and left out"},
          {"size [um];residue [%]\n0;100\n10;80\n20;0\n", "line 2 is no size and left out"},
          {"Ash 7\nsize [um];passing [%]\n10;20\n20;100\n",
           "line 1, above the heading, is not read: \"Ash 7\""},
          {"size [um];passing [%]\n10;20\n20;100\n\n* dry sieved\n", "line 5 below the table is not read"},
          {"Siebweite;Durchgang\n10 \u00b5m;20 %\n20 \u00b5m;100 %\nBoden;0 %\n",
           "line 4 is no size and left out"},
          {"Size (\u00b5m);Vol Under %\n10;20\n20;100\n", "is by volume: taken as by mass"},
          {"Size (\u00b5m);Cumulative Volume % under\n10;20\n20;100\n", "is by volume: taken as by mass"},
          {"Size (\u00b5m);Undersize Volume (%)\n10;20\n20;100\n", "is by volume: taken as by mass"},
          {"size [um];passing [%];residue [%]\n10;20;80\n20;100;0\n",
           "column \"residue [%]\" agrees with \"passing [%]\", which is used"},
          {"size [um];passing [%];retained [%]\n10;20;20\n20;100;80\n", "\"retained [%]\" agrees"},
          {"size [um];share [%];Q3(x) [%]\n10;20;20\n20;80;100\n", "\"share [%]\" agrees with \"Q3(x) [%]\""},
          {"from [um];to [um];share [%];passing [%]\n5;10;20;20\n10;20;80;100\n",
           "\"passing [%]\" agrees with \"share [%]\""},
          {"from [um];to [um];share [%]\n1;10;18.4\n10;20;80\n",
           "the shares add up to 98.4 % and are scaled to 100 %"},
          {"from [um];to [um];share [%]\n0;10;20\n10;20;80\n", "20 % is finer than the smallest size"}}) {
        CAPTURE(table);
        sandbox.write("sieve.csv", table);
        CHECK(succeeded(sandbox, "deposit" + slow_gas + sticky_ash + " --sizes sieve.csv").err ==
              containing(says));
    }
}

TEST_CASE("one sieve table in the forms that laboratories write is one result") {
    const Sandbox sandbox;
    const auto captured = [&](const std::string& table) {
        sandbox.write("sieve.csv", table);
        succeeded(sandbox, "deposit" + slow_gas + sticky_ash + " --sizes sieve.csv");
        return sandbox.json("tube/deposit.json")["result"]["sizes"].dump();
    };
    const std::string plain = captured("size [um];passing [%]\n10;20\n20;50\n40;100\n");
    CHECK(contains(plain, "mass_fraction"));
    for (const char* table :
         {"Siebweite / \u00b5m;Durchgang / %\n10;20\n20;50\n40;100\n",
          "x [\u00b5m];Q3(x) [%]\n10;20\n20;50\n40;100\n",
          "Size (\u00b5m);Cum. % passing\n10;20\n20;50\n40;100\n",
          "size;passing\num;%\n10;20\n20;50\n40;100\n", "size;passing\n10 um;20 %\n20 um;50 %\n40 um;100 %\n",
          "size [um];passing [%]\n10;20,000\n20;50,000\n40;100,000\n",
          "size [um];passing [%];residue [%]\n10;20;80\n20;50;50\n40;100;0\n",
          "size [um];passing [%]\n0;0\n10;20\n20;50\n40;100\n",
          "Size [um];Mass Below %\n10;20\n20;50\n40;100\n",
          "Siebweite [um];Durchgang\n10;20\n20;50\n40;100\n"}) {
        CAPTURE(table);
        CHECK(captured(table) == plain);
    }
    const std::string quarters = captured("size [um];passing [%]\n10;25\n20;50\n40;100\n");
    for (const char* heading :
         {"Siebweite [um];Siebr\u00fcckstand kumuliert [%]", "Siebweite [um];R\u00fcckstand kumuliert %",
          "Sieve [um];Cumulative retained [%]", "Sieve [um];Cum. % retained"}) {
        CAPTURE(heading);
        CHECK(captured(std::string(heading) + "\n10;75\n20;50\n40;0\n") == quarters);
    }
    const std::string classes = captured("from [um];to [um];share [%]\n0;10;20\n10;20;30\n20;40;50\n");
    for (const char* table :
         {"Fraktion [um];Anteil [%]\n<10;20\n10-20;30\n20-40;50\n",
          "Fraktion;Gew.-%\n< 10 um;20\n10\u201320 um;30\n20 - 40 um;50\n",
          "Fraction (um);wt%\n0-10;20\n10 to 20;30\n20 to 40;50\n",
          "Klasse;Anteil\n<10 um;20 %\n10/20 um;30 %\n20/40 um;50 %\n",
          "from [um];to [um];wt%\n0;10;20\n10;20;30\n20;40;50\n",
          "von [um];bis [um];Fraktion [%]\n0;10;20\n10;20;30\n20;40;50\n",
          "size class [um];mass [%];passing [%]\n<10;20;20\n10-20;30;50\n20-40;50;100\n"}) {
        CAPTURE(table);
        CHECK(captured(table) == classes);
    }
}

TEST_CASE("what is wrong with a tube, its gas or its ash is one line") {
    const Sandbox sandbox;
    sandbox.write("twice.csv", "size [um],retained [%]\n10,20\n20,100\n");
    sandbox.write("falls.csv", "size [um],passing [%]\n10,50\n20,40\n40,100\n");
    sandbox.write("short.csv", "size [um],passing [%]\n10,20\n20,60\n");
    sandbox.write("bare.csv", "size,passing [%]\n10,20\n20,100\n");
    sandbox.write("sum.csv", "from [um],to [um],share [%]\n0,10,20\n10,20,60\n");
    sandbox.write("gap.csv", "from [um],to [um],share [%]\n0,10,40\n12,20,60\n");
    sandbox.write("none.csv", "a,b\n1,2\n");
    sandbox.write("no-share.csv", "d / mm,D / %\n0.1,90\n");
    sandbox.write("sum-and-rest.csv", "size [um];passing [%];residue [%]\n10;20;20\n20;100;0\n");
    sandbox.write("each.csv", "Residue on each sieve\nsize [um];residue [%]\n80;0\n40;20\n20;30\n10;40\n");
    sandbox.write("two-sizes.csv", "size [um];size [mm];passing [%]\n10;1;20\n20;2;100\n");
    sandbox.write("units.csv", "size [um];passing [%]\n10 um;20\n0.02 mm;100\n");
    sandbox.write("residue.csv", "size [um];residue [%]\n5;60\n20;30\n40;10\n100;0\n");
    sandbox.write("no-pan.csv", "size [um];residue [%]\n63;25\n90;20\n125;15\n200;5\n");
    sandbox.write("behind.csv", "size [um];passing [%] on each\n10;20\n20;80\n");
    sandbox.write("density.csv", "size [um];q3\n5;0.1\n20;0.5\n40;1\n");
    sandbox.write("grams.csv", "size [um];passing [g]\n10;0.2\n20;1\n");
    sandbox.write("number.csv", "size [um];passing [number fraction]\n10;0.2\n20;1\n");
    sandbox.write("samples.csv", "Probe;size [um];passing [%]\nA;10;20\nB;20;100\n");
    sandbox.write("thousands.csv", "size [nm];passing [%]\n5.000;20\n9.000;100\n");
    const auto titled = [&](const char* file, const std::string& title) {
        sandbox.write(file, title + "\nsize [um];passing [%]\n10;20\n20;100\n");
    };
    titled("by-number.csv", "Number passing");
    titled("comment.csv", "# by number");
    titled("counted.csv", "Particle number distribution");
    titled("oversize.csv", "Cumulative residue (oversize)");
    titled("radii.csv", "Sizes are radii");
    titled("millimetres.csv", "# sizes in mm");
    titled("aerodynamic.csv", "# aerodynamic diameters");
    sandbox.write("unit-column.csv", "size [um];passing [%];unit\n10;20;mm\n20;100;mm\n");
    sandbox.write("outlier.csv", "size [um];passing [%];remark\n10;20;outlier\n20;100;\n");
    sandbox.write("pan.csv", "size [um];passing [%]\n10;20\n20;100\nBoden;100\n");
    sandbox.write("open.csv", "Fraktion [um];Anteil [%]\n<10;20\n10-20;30\n>20;50\n");
    sandbox.write("mixed.csv", "Fraktion;Anteil [%]\n<10 um;20\n10-20 mm;80\n");
    sandbox.write("one-size.csv", "Fraktion [um];Anteil [%]\n10;20\n20;80\n");
    sandbox.write("sum-of-class.csv", "Fraktion [um];Durchgang [%]\n<10;20\n10-20;100\n");
    sandbox.write("rest-of-class.csv", "Fraction [um];R\u00fcckstand [%]\n10-20;20\n20-40;80\n");
    sandbox.write("no-unit.csv", "Fraction;wt%\n<10;20\n10-20;80\n");
    sandbox.write("cells.csv", "size;passing [%]\n10 um;20\n0.02 mm;100\n");
    struct Refused {
        const char* sizes;
        const char* says;
    };
    for (const auto& [sizes, says] :
         {Refused{"'rosin-rammler: 20 um'", "1 value is given"},
          Refused{"'rosin-rammler: 20 um, -1'", "exponent is \"-1\""},
          Refused{"'gamma: 20 um, 2'", "no distribution is called \"gamma\""},
          Refused{"'log-normal: 20 um, 0.5'", "geometric standard deviation is \"0.5\""},
          Refused{"'log-normal: 20 um, 2, area'", "the basis is \"area\""},
          Refused{"20", "did you mean 20 um?"},
          Refused{"'20 kg'", "--sizes"},
          Refused{"'-3 um'", "a positive length"},
          Refused{"coarse", "cannot read \"coarse\""},
          Refused{"missing.csv", "missing.csv"},
          Refused{"twice.csv", "two readings"},
          Refused{"falls.csv", "line 3"},
          Refused{"short.csv", "40 % is coarser than the largest size"},
          Refused{"bare.csv", "no unit"},
          Refused{"sum.csv", "add up to 80 %"},
          Refused{"sum-and-rest.csv", "\"passing [%]\" and \"residue [%]\" do not agree"},
          Refused{"each.csv", "states what lies on each sieve, and the heading \"residue [%]\" all that"},
          Refused{"millimetres.csv", "states mm, and column \"size [um]\" is taken in another unit"},
          Refused{"unit-column.csv", "\"mm\" states mm, and column \"size [um]\" is taken in another unit"},
          Refused{"aerodynamic.csv", "states aerodynamic diameters; allowed: diameters of the particles"},
          Refused{"two-sizes.csv", "state one thing twice"},
          Refused{"residue.csv",
                  "line 2: the residues may be all that is coarser, or what lies on each sieve"},
          Refused{"no-pan.csv", "they add up to 65 %, without a pan; allowed: \"cumulative residue\""},
          Refused{"behind.csv", "\"passing [%] on each\" is not known"},
          Refused{"density.csv", "no line names the columns of a sieve table: \"q3\" is not known"},
          Refused{"no-share.csv", "no line names the columns of a sieve table: no column holds shares"},
          Refused{"units.csv", "line 3, cell 1: cannot read \"0.02 mm\"; allowed: a number in um"},
          Refused{"grams.csv", "unit of \"passing [g]\""},
          Refused{"number.csv", "unit of"},
          Refused{"samples.csv", "several samples, \"A\" and \"B\""},
          Refused{"thousands.csv", "5.000 or 5000"},
          Refused{"by-number.csv", "line 1: \"Number passing\" states shares by number"},
          Refused{"comment.csv", "states shares by number"},
          Refused{"counted.csv", "states shares by number"},
          Refused{"oversize.csv", "states what is coarser, and the heading \"passing [%]\" the contrary"},
          Refused{"radii.csv", "states radii; allowed: diameters of the particles"},
          Refused{"outlier.csv", "line 2, cell 3: \"outlier\" in column \"remark\" calls the row invalid"},
          Refused{"pan.csv", "\"Boden\" is below every sieve: nothing passes it"},
          Refused{"cells.csv", "\"0.02 mm\" is not in um, as other sizes are"},
          Refused{"open.csv", "line 4, cell 1: \">20\" has no upper size"},
          Refused{"mixed.csv", "line 3, cell 1: \"20 mm\" is not in um"},
          Refused{"one-size.csv", "line 2, cell 1: \"10\" is no class of two sizes"},
          Refused{"sum-of-class.csv",
                  "may be of the lower size of each class, of the upper one, or of the class"},
          Refused{"rest-of-class.csv", "may be of the lower size of each class"},
          Refused{"no-unit.csv", "a column of sizes has no unit"},
          Refused{"gap.csv", "does not begin where"},
          Refused{"none.csv", "no line names the columns"}}) {
        CAPTURE(sizes);
        check_refused(sandbox, "deposit" + superheater + sticky_ash + " --sizes " + sizes, says);
    }
    const std::string sized = sticky_ash + " --sizes '20 um'";
    for (const auto& [arguments, says] :
         {Refused{" --diameter '20 um'", "--diameter: the sizes are those of --sizes"},
          Refused{" --partner-radius '1 mm'", "--partner-radius: the partner is the tube"},
          Refused{" --roughness '1 nm'", "--roughness: goes with the size"},
          Refused{" --assumption tsuji", "--assumption: belongs to a run"},
          Refused{" --sheet Siebung", "--sheet: belongs to a sieve table"},
          Refused{" --ash-load -1", "--ash-load"}, Refused{" --ash-load '10 kg'", "--ash-load"},
          Refused{" --gas-viscosity 0", "--gas-viscosity"}}) {
        CAPTURE(arguments);
        check_refused(sandbox, "deposit" + superheater + sized + arguments, says);
    }
    check_refused(sandbox, "deposit" + superheater + " --sizes '20 um'",
                  "neither a run nor a contact is given");
    CHECK(
        succeeded(sandbox,
                  "deposit --tube-diameter '38 m' --gas-velocity 12 --gas-temperature '900 C' -o far" + sized)
            .err == containing("--tube-diameter: 38 m is outside of what is plausible"));
    sandbox.write("tube/deposit.json", "{}");
    check_refused(sandbox, "deposit" + superheater + sized,
                  "deposit.json: is there already, and is nothing that this command writes");
}
