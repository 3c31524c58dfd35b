// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <map>
#include <regex>
#include <set>
#include <string>
#include <vector>

#include <doctest/doctest.h>
#include <fmt/format.h>

#include "pipeline/document/edits.hpp"
#include "pipeline/document/results_json.hpp"
#include "pipeline/files/file.hpp"
#include "pipeline/present/report/figures/figures.hpp"
#include "pipeline/present/report/page/page.hpp"
#include "pipeline/run/stage.hpp"
#include "solver/contact/pair.hpp"
#include "tests/pipeline/sandbox.hpp"

namespace ashimpact::report {

namespace {

using test::ashimpact_program;
using test::Sandbox;

constexpr const char* figures_of_a_run[] = {"composition",  "static-force",
                                            "regime-map",   "restitution",
                                            "damping",      "damping-fit",
                                            "damping-laws", "contact-time",
                                            "sizes",        "histories",
                                            "energy",       "critical-velocity",
                                            "which-sizes",  "critical-velocity-by-size",
                                            "sensitivity"};

const Sandbox& paper() {
    static const Sandbox sandbox;
    static const auto& run = test::put_built_in_run(sandbox);
    REQUIRE(test::lines_of(run.out).back() == "Report: results/report.html");
    return sandbox;
}

std::string between(const std::string& text, const std::string& from, const std::string& to) {
    const auto first = text.find(from);
    REQUIRE(first != std::string::npos);
    const auto last = text.find(to, first + from.size());
    REQUIRE(last != std::string::npos);
    return text.substr(first + from.size(), last - first - from.size());
}

const RunData& paper_run() {
    static const RunData run(read_run(load_artifacts(paper().folder() / "results", report_artifacts())), "");
    return run;
}

}  // namespace

TEST_CASE("a run ends with a report that holds every figure, asks for nothing and stays small") {
    const std::string page = paper().read("results/report.html");
    CHECK(page.size() < 1'000'000);
    for (const char* id : figures_of_a_run) {
        CAPTURE(id);
        CHECK(page == test::containing("<figure id=\"" + std::string(id) + "\">"));
    }
    for (const char* foreign :
         {"http://", "https://", "<img", "<iframe", " style=", " onclick=", "@import", "url("}) {
        CAPTURE(foreign);
        CHECK(page != test::containing(foreign));
    }
    CHECK_FALSE(std::regex_search(page, std::regex(R"(\bnan\b)")));
    const std::string policy = between(page, "Content-Security-Policy\" content=\"", "\"");
    CHECK(policy.starts_with("default-src 'none'"));
    CHECK(policy != test::containing("unsafe"));
    std::set<std::string> ids;
    const std::regex attribute(R"RE( id="([^"]*)")RE");
    for (auto match = std::sregex_iterator(page.begin(), page.end(), attribute);
         match != std::sregex_iterator(); ++match)
        CHECK_MESSAGE(ids.insert((*match)[1]).second, "twice: " << (*match)[1]);
}

TEST_CASE("the map of laws: its ends, and the load above which Hertz is enough") {
    const RunData& run = paper_run();
    const Figure figure = figure_named("regime-map", run);
    const auto& panel = std::get<XyPanel>(figure.panels.at(0));
    CHECK(panel.x.from == 0.01);
    CHECK(panel.x.to == 100);
    const std::vector<Point>& line = panel.series.at(0).line;
    CHECK(line.front().x == doctest::Approx(0.01).epsilon(1e-12));
    CHECK(line.back().x == doctest::Approx(100).epsilon(1e-12));
    // Adhesion is 5 % of the load P: Maugis's equations solved apart from this program (40 in DMT's limit).
    CHECK(line.front().y == doctest::Approx(47.8038194).epsilon(1e-7));
    // By JKR sqrt(6 x) = 0.05 P with P = x - sqrt(6 x).
    const double root = 1.05 * std::sqrt(6.0) / 0.05;
    CHECK(line.back().y == doctest::Approx(root * root - std::sqrt(6.0) * root).epsilon(1e-3));
}

TEST_CASE("`report` makes the same bytes again from the artifacts alone") {
    const std::string first = paper().read("results/report.html");
    test::succeeded(paper(), "report results -o again.html");
    CHECK(paper().read("again.html") == first);
    test::succeeded(paper(), "report results results -o both.html");
    CHECK(paper().read("both.html") == test::containing("the runs have the same inputs"));
    CHECK(paper().read("both.html") == test::containing("<figure id=\"restitution-2\">"));
}

TEST_CASE("a figure shows no number of an artifact beside those that it lists") {
    const auto shown = [](const FigureMaker& maker, const Run& run) {
        const Figure figure = maker.make(RunData(run, ""));
        return html_of(figure, "figure");
    };
    const auto blank = [](auto& result) {
        for (auto& sample : result.samples) {
            std::string name = sample.name;
            sample = {};
            sample.name = std::move(name);
        }
    };
    const Run& whole = paper_run().run();
    for (const FigureMaker& maker : figure_makers())
        for (const std::string_view file : report_artifacts()) {
            if (std::ranges::find(maker.shows, file) != maker.shows.end()) continue;
            Run run = whole;
            if (file == modulus_artifact) blank(run.modulus);
            if (file == contact_artifact) blank(run.contact);
            if (file == analytic_artifact) blank(run.analytic);
            if (file == restitution_artifact) blank(run.restitution);
            if (file == damping_artifact) blank(run.damping);
            if (file == fit_artifact) blank(run.fit);
            if (file == critical_velocity_artifact) blank(run.critical_velocity);
            if (file == histories_artifact) blank(run.histories);
            if (file == comparison_artifact) {
                blank(run.comparison);
                run.comparison.conclusion.clear();
            }
            CAPTURE(maker.id);
            CAPTURE(file);
            CHECK((shown(maker, run) == shown(maker, whole)));
        }
}

TEST_CASE("the numbers of a figure are those of the artifact") {
    const RunData& run = paper_run();
    const Figure figure = figure_named("contact-time", run);
    const Json damping = paper().json("results/5-damping.json").at("result").at("samples").at(0).at("hertz");
    std::size_t found = 0;
    for (const auto& row : figure.numbers.rows)
        if (std::get<std::string>(row[0]) == "88 um" && std::get<std::string>(row[1]) == "Hertz") {
            CHECK(std::get<double>(row[3]) == damping.at("velocity").at("values").at(found).get<double>());
            CHECK(std::get<double>(row[4]) ==
                  damping.at("contact_time").at("values").at(found).get<double>());
            ++found;
        }
    CHECK(found == damping.at("velocity").at("values").size());
}

TEST_CASE("every figure comes with the numbers behind it, the histories with those of every law") {
    const RunData& run = paper_run();
    for (const char* id : figures_of_a_run) {
        CAPTURE(id);
        const NumberTable numbers = figure_named(id, run).numbers;
        CHECK(!numbers.rows.empty());
        for (const auto& row : numbers.rows) REQUIRE(row.size() == numbers.columns.size());
    }
    std::map<std::pair<std::string, std::string>, int> listed;
    for (const auto& row : figure_named("histories", run).numbers.rows)
        ++listed[{std::get<std::string>(row[0]), std::get<std::string>(row[1])}];
    for (const SampleData& sample : run.samples())
        for (const LawData& law : sample.laws) {
            const int rows = listed[{sample.name(), law.name}];
            CHECK(rows > 50);
        }
}

TEST_CASE("the model's curve gives back the points it was fitted to") {
    const RunData& run = paper_run();
    for (const SampleData& sample : run.samples())
        for (const LawData& law : sample.laws) {
            CAPTURE(sample.name());
            CAPTURE(law.name);
            REQUIRE(law.curve().size() > 10);
            const CurveImpact& last = law.curve().back();           // at the greatest restitution of the data
            if (law.name != "JKR" && law.name != "Maugis-Dugdale")  // points of another law's fit
                CHECK(last.velocity == doctest::Approx(law.damping->velocity.back()).epsilon(1e-6));
            for (const CurveImpact& impact : law.curve()) {
                CHECK(impact.lower < impact.velocity);
                CHECK(impact.upper > impact.velocity);
            }
        }
}

TEST_CASE(
    "attraction at overlap 3: Brach-Dunn has about twice that of JKR, as the paper says of its Figure 3") {
    const RunData& run = paper_run();
    const std::string caption = figure_named("static-force", run).caption;
    const auto ratio = std::stod(between(caption, "Brach-Dunn attracts ", " times"));
    CHECK(ratio > 1.9);
    CHECK(ratio < 2.2);
}

TEST_CASE("the page's answer is the velocity that the summary of the run names") {
    const std::string page = paper().read("results/report.html");
    const Json compared = Json::parse(paper().read("results/comparison.json")).at("result").at("samples");
    REQUIRE(compared.size() == 3);
    for (const Json& sample : compared) {
        const Json& reported = sample.at("reported");
        const std::string velocity = fmt::format("<span class=\"value\">{:#.3g} m/s</span>, by {}",
                                                 reported.at("critical_velocity").at("value").get<double>(),
                                                 report::display_name(reported.at("law").get<std::string>()));
        CAPTURE(velocity);
        CHECK(page == test::containing(velocity));
    }
    CHECK(page == test::containing("A reproduction of published fits of damping, so without an interval."));
}

TEST_CASE("a run without figures takes those of the run before away, and no figure of somebody else") {
    const Sandbox sandbox;
    test::put_built_in_run(sandbox);
    const auto figure = [&](const std::string& name) {
        test::succeeded(sandbox, "figure energy results -o results/figures/" + name);
    };
    figure("energy.svg");
    sandbox.write("results/figures/energy.pdf", "its PDF");
    sandbox.write("results/figures/damping.svg", "<svg>mine</svg>");
    sandbox.write("results/figures/damping.pdf", "mine");
    const auto again = ashimpact_program(sandbox, "run -o results --no-report");
    CHECK(again.status == 0);
    CHECK(again.err == test::containing("results/figures: 2 figures of an earlier run removed"));
    CHECK_FALSE(sandbox.has("results/figures/energy.svg"));
    CHECK_FALSE(sandbox.has("results/figures/energy.pdf"));
    CHECK(sandbox.has("results/figures/damping.svg"));
    CHECK(sandbox.has("results/figures/damping.pdf"));
    CHECK(ashimpact_program(sandbox, "run -o results --only comparison").err != test::containing("figures"));
}

TEST_CASE("--no-report removes the report of the run before, a part of a run makes it again") {
    const Sandbox sandbox;
    test::put_built_in_run(sandbox);
    REQUIRE(sandbox.has("results/report.html"));
    const auto without = ashimpact_program(sandbox, "run -o results --no-report");
    CHECK(without.status == 0);
    CHECK(without.out != test::containing("report.html"));
    CHECK_FALSE(sandbox.has("results/report.html"));
    const auto part = ashimpact_program(sandbox, "run -o results --from comparison");
    CHECK(part.status == 0);
    CHECK(test::lines_of(part.out).back() == "Report: results/report.html");
    CHECK(sandbox.has("results/report.html"));
    sandbox.write("results/report.html", "<p>mine</p>");
    test::succeeded(sandbox, "run -o results --only comparison --no-report");
    CHECK(sandbox.read("results/report.html") == "<p>mine</p>");
}

TEST_CASE("measured impacts: the history at capture has the damping of its critical velocity") {
    const Sandbox sandbox;
    constexpr std::array laws{"hertz", "dmt", "brach-dunn", "jkr"};
    test::write_example(sandbox, test::with_one_sample(test::example_case(), {laws.begin(), laws.end()}));
    test::succeeded(sandbox, "run case.json -o results");
    const Json velocities = sandbox.json("results/7-critical-velocity.json").at("result").at("samples");
    const Json histories = sandbox.json("results/8-histories.json").at("result").at("samples");
    for (const char* law : laws) {
        CAPTURE(law);
        const Json& velocity = velocities.at(0).at(law);
        const Json& history = histories.at(0).at(law).at(0);
        CHECK(history.at("part") == "critical");
        CHECK(history.at("damping").at("value") == velocity.at("damping").at("value"));
        CHECK(history.at("outcome") == "rebound");  // just above its critical velocity
        CHECK(history.at("restitution").at("value").get<double>() < 0.1);
    }
    const std::string page = sandbox.read("results/report.html");

    // Curves end at the v_c of their law, whose interval comes from the impacts alone; the reported one is
    // drawn.
    const RunData run(read_run(load_artifacts(sandbox.folder() / "results", report_artifacts())), "");
    const SampleData& sample = run.samples().at(0);
    const auto restitution = std::get<XyPanel>(figure_named("restitution", run).panels.at(0));
    for (std::size_t i = 0; i < std::size(laws); ++i) {
        CAPTURE(laws.at(i));
        const VelocityEstimate head = sample.laws.at(i).headline().value();
        const std::vector<Point>& line = restitution.series.at(i).line;
        REQUIRE(line.size() > 20);
        CHECK(line.front().x == head.value);
        CHECK(line.front().y == 0);
        CHECK(line[1].y < 0.1);
        for (std::size_t k = 1; k < line.size(); ++k) CHECK(line[k].x > line[k - 1].x);
        // The impacts scatter about the curve by their noise.
        CHECK(line.back().x == doctest::Approx(greatest_of(sample.laws.at(i).damping->velocity)));
    }
    const ReportedVelocity& reported = sample.comparison->reported.value();
    CHECK(restitution.rules.at(0).x == reported.velocity->value);
    CHECK(restitution.rules.at(0).interval->to == *reported.interval->upper);
    for (const auto& row : figure_named("sensitivity", run).numbers.rows) {
        CHECK(std::get<std::string>(row.at(2)) == "measured impacts");
        CHECK(std::get<double>(row.at(5)) == 1);
    }

    const auto columns = [](const std::string& html) {
        return between(html, "<th scope=\"col\">sample</th>", "</tr>");
    };
    CHECK(columns(page) == test::containing("measured (95&nbsp;%)"));
    CHECK(columns(page) != test::containing("published"));  // nothing was
    const std::string paper_page = paper().read("results/report.html");
    CHECK(paper_page == test::containing(">1.92<"));
    CHECK(columns(paper().read("results/report.html")) == test::containing("published"));
}

TEST_CASE("a sweep ends with its report, which `report` makes again") {
    const Sandbox sandbox;
    sandbox.write("spec.json", read_file(std::filesystem::path(ASHIMPACT_TEST_DATA) /
                                         "../pipeline/report/browser/sweep.json"));
    const auto sweep = ashimpact_program(sandbox, "sweep spec.json -o sweep.json");
    CAPTURE(sweep.err);
    REQUIRE(sweep.status == 0);
    CHECK(test::lines_of(sweep.out).back() == "Report: sweep.html");
    const std::string page = sandbox.read("sweep.html");
    for (const char* id : {"capture", "histogram", "sensitivity"})
        CHECK(page == test::containing("<figure id=\"" + std::string(id) + "\">"));
    test::succeeded(sandbox, "report sweep.json -o again.html");
    CHECK(sandbox.read("again.html") == page);
    test::succeeded(sandbox, "sweep spec.json -o sweep.json --no-report");
    CHECK_FALSE(sandbox.has("sweep.html"));
    sandbox.write("sweep.html", "<p>mine</p>");
    const auto refused = ashimpact_program(sandbox, "sweep spec.json -o sweep.json");
    CHECK(refused.status == 2);
    CHECK(refused.err == test::containing("sweep.html"));
    CHECK(sandbox.read("sweep.html") == "<p>mine</p>");
    CHECK(ashimpact_program(sandbox, "sweep spec.json -o result.html").status == 2);
}

TEST_CASE("warnings that differ in their numbers alone come out once, with the range of these") {
    const std::string page = paper().read("results/report.html");
    const std::string warnings = between(page, "<h2 id=\"warnings\">", "</section>");
    CHECK(warnings ==
          test::containing("Tabor parameter 1.98 to 2.02 is between DMT (&lt; 0.1) and JKR (&gt; 5)"));
}

TEST_CASE("what cannot be drawn is refused in one line") {
    const auto refused = [](const std::string& arguments, const std::string& part) {
        const auto run = ashimpact_program(paper(), arguments);
        CAPTURE(arguments);
        CAPTURE(run.err);
        CHECK(run.status == 2);
        CHECK(test::lines_of(run.err).size() == 1);
        CHECK(run.err == test::containing(part));
        CHECK(run.out.empty());
    };
    refused("figure restitutoin results -o x.svg", "did you mean \"restitution\"?");
    refused("figure restitution results -o x.jpg", ".svg, .pdf or .png");
    refused("figure restitution nowhere -o x.svg", "nowhere");
    refused("figure restitution results/report.html -o x.svg", "no artifact");
    refused("report results/1-modulus.json", "no folder");
    refused("report results results", "-o");
}

TEST_CASE("a figure as SVG, PDF and PNG, for one column and for two") {
    REQUIRE(ashimpact_program(paper(), "figure restitution results/4-restitution.json -o wide.svg").status ==
            0);
    REQUIRE(ashimpact_program(paper(), "figure restitution results --width single -o narrow.svg").status ==
            0);
    CHECK(paper().read("wide.svg") == test::containing("width=\"170mm\""));
    CHECK(paper().read("narrow.svg") == test::containing("width=\"85mm\""));
    CHECK(paper().read("wide.svg") != test::containing("var("));  // which converters do not know
    const auto pdf = ashimpact_program(paper(), "figure restitution results -o figure.pdf");
    if (pdf.status == 2 && pdf.err.find("librsvg2-bin") != std::string::npos) {
        MESSAGE("SKIPPED: no rsvg-convert, so no PDF and no PNG");
        CHECK(std::getenv("CI") == nullptr);
        return;
    }
    REQUIRE(pdf.status == 0);
    const std::string bytes = paper().read("figure.pdf");
    CHECK(bytes.starts_with("%PDF"));
    CHECK(bytes != test::containing("/Subtype /Image"));  // vector
    test::succeeded(paper(), "figure restitution results -o again.pdf");
    CHECK(paper().read("again.pdf") == bytes);
    test::succeeded(paper(), "figure restitution results -o figure.png");
    CHECK(paper().read("figure.png").starts_with("\x89PNG"));
}

TEST_CASE("a figure that is larger than a pipe holds goes through the converter whole") {
    Series many{.name = "many", .legend = "many", .look = Look::plain(0)};
    for (int i = 0; i < 4000; ++i) many.marks.push_back({i / 4000.0, i * 7919 % 4000 / 4000.0, 0, 0});
    XyPanel panel{.title = "", .x = {.label = "x"}, .y = {.label = "y"}};
    panel.series.push_back(std::move(many));
    const Figure figure{.id = "many",
                        .title = "Many marks",
                        .counterpart = {},
                        .caption = "",
                        .panels = {std::move(panel)},
                        .numbers = {},
                        .columns = 1,
                        .panel_height = 320};
    const std::string svg = figure_bytes(figure, Width::wide, FigureFormat::svg);
    REQUIRE(svg.size() > 200'000);
    // A converter that gives back what it gets.
    const Sandbox sandbox;
    sandbox.write("rsvg-convert", "#!/bin/sh\nexec cat\n");
    std::filesystem::permissions(sandbox.folder() / "rsvg-convert", std::filesystem::perms::owner_all);
    const std::string before = std::getenv("PATH");
    setenv("PATH", (sandbox.folder().string() + ":" + before).c_str(), 1);
    const std::string converted = figure_bytes(figure, Width::wide, FigureFormat::pdf);
    setenv("PATH", before.c_str(), 1);
    CHECK(converted == svg);
}

}  // namespace ashimpact::report
