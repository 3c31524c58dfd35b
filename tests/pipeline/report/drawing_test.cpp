// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include <doctest/doctest.h>

#include "pipeline/present/report/drawing/figure.hpp"
#include "pipeline/present/report/drawing/markup.hpp"
#include "pipeline/present/report/drawing/panel.hpp"
#include "pipeline/run/curves/model_curve.hpp"
#include "solver/contact/law_parameters.hpp"
#include "solver/contact/pair.hpp"
#include "solver/critical_velocity/critical_velocity.hpp"
#include "solver/motion/impact.hpp"
#include "tests/support/checks.hpp"

namespace ashimpact::report {

TEST_CASE("text comes out as text, whatever it holds") {
    CHECK(escaped("<b> & \"x\" 'y'") == "&lt;b&gt; &amp; &quot;x&quot; &#39;y&#39;");
    CHECK(escaped("a\x01\x1b"
                  "b\x7f") == "ab");
    CHECK(escaped("\xC2\x85"
                  "c") == "c");  // a control character of two bytes
    CHECK(escaped("\U0001F30B \u05d0\u05e4\u05e8") == "\U0001F30B \u05d0\u05e4\u05e8");
    CHECK(escaped("\xff\xfe") == "\uFFFD\uFFFD");
    CHECK(escaped("\xC0\xBC") == "\uFFFD\uFFFD");            // '<' in two bytes is not UTF-8
    CHECK(escaped("\xED\xA0\x80") == "\uFFFD\uFFFD\uFFFD");  // half of a surrogate pair
    CHECK(escaped("\xE2\x82") == "\uFFFD\uFFFD");            // cut off
    CHECK(percent_encoded("a,b\n\"<\xC3\xA9") == "a,b%0A%22%3C%C3%A9");
    CHECK(base64("") == "");
    CHECK(base64("f") == "Zg==");
    CHECK(base64("fo") == "Zm8=");
    CHECK(base64("foobar") == "Zm9vYmFy");
}

TEST_CASE("labels keep their characters; a subscript follows an underscore") {
    CHECK(subscripted("\u03b7 a") == "\u03b7 a");
    CHECK(test::contains(subscripted("v_in"), "<tspan class=\"sub\" dy=\"3\">in</tspan>"));
    CHECK(subscripted("a_ b") == "a_ b");
    CHECK(fitted("abc", 10, 100) == "abc");
    const std::string cut = fitted("a very long name of a sample", 10, 60);
    CHECK(cut.ends_with("\u2026"));
    CHECK(text_width(cut, 10) <= 60 + 11);  // the estimate of the ellipsis is on the safe side
}

TEST_CASE("ticks are round numbers within the axis, few enough to be read") {
    const Range ranges[]{{0, 1}, {0.0123, 0.0127}, {-3, 1e4}, {1e-9, 3e-9}, {5, 1e7}, {0.7, 0.71}};
    for (const Range& range : ranges)
        for (const Spacing spacing : {Spacing::linear, Spacing::logarithmic}) {
            if (spacing == Spacing::logarithmic && range.from <= 0) continue;
            for (const int most : {3, 5, 9}) {
                const Scale scale{spacing, range, {0, 300}};
                const auto ticks = scale.ticks(most);
                CAPTURE(range.from);
                CAPTURE(range.to);
                CAPTURE(most);
                CHECK(ticks.size() >= 1);
                CHECK(static_cast<int>(ticks.size()) <= most);
                for (const Tick& tick : ticks) {
                    CHECK(tick.value >= range.from - 1e-9 * std::abs(range.to));
                    CHECK(tick.value <= range.to + 1e-9 * std::abs(range.to));
                    CHECK(scale(tick.value) >= -1e-6);
                    CHECK(scale(tick.value) <= 300 + 1e-6);
                }
            }
        }
    CHECK(number_label(0) == "0");
    CHECK(number_label(0.25) == "0.25");
    CHECK(number_label(1e-7) == "10\u207b\u2077");
    CHECK(number_label(2e10) == "2\u00b710\u00b9\u2070");
}

TEST_CASE("whole decades keep their labels where labels of a logarithmic axis would touch") {
    const Axis axis{.label = "v", .spacing = Spacing::logarithmic};
    for (const double width : {250.0, 500.0, 740.0, 900.0})
        for (const Range& range : {Range{0.0115, 1.64}, Range{0.05, 3}, Range{0.3, 12}, Range{0.7, 1.6}}) {
            CAPTURE(width);
            CAPTURE(range.from);
            const Box plot{0, 0, width, 100};
            const std::string svg = horizontal_axis(axis, scale_of(axis, range, {0, width}), plot);
            for (const double decade : {0.1, 1.0, 10.0})
                if (decade > range.from && decade < range.to)
                    CHECK(svg.find(">" + number_label(decade) + "<") != std::string::npos);
        }
}

TEST_CASE("a range of one value is drawn a tenth of it to both sides, in the logarithm by a factor") {
    const auto ends = [](Spacing spacing, double value) {
        const Range range = drawable({value, value}, spacing);
        return std::pair{range.from, range.to};
    };
    CHECK(ends(Spacing::linear, 20.0) == std::pair{18.0, 22.0});
    CHECK(ends(Spacing::linear, -20.0) == std::pair{-22.0, -18.0});
    CHECK(ends(Spacing::linear, 0.0) == std::pair{-1.0, 1.0});
    CHECK(ends(Spacing::logarithmic, 3.0) == std::pair{2.0, 4.5});
}

TEST_CASE("a scale takes its ends to its pixels, straight or in the logarithm") {
    const Scale straight{Spacing::linear, {2, 4}, {100, 0}};
    CHECK(straight(2) == doctest::Approx(100));
    CHECK(straight(3) == doctest::Approx(50));
    CHECK(straight(4) == doctest::Approx(0));
    const Scale logarithmic{Spacing::logarithmic, {0.01, 100}, {10, 50}};
    CHECK(logarithmic(1) == doctest::Approx(30));
    CHECK(drawable({3, 3}, Spacing::linear).from < 3);
    CHECK(drawable({NAN, 3}, Spacing::linear).to > drawable({NAN, 3}, Spacing::linear).from);
    CHECK(drawable({0, 3}, Spacing::logarithmic).from > 0);
}

namespace {

XyPanel one_line(std::vector<Point> line) {
    XyPanel panel{.title = "<t>",
                  .x = {.label = "x", .from = 0.0, .to = 10.0},
                  .y = {.label = "y", .from = 0.0, .to = 10.0}};
    panel.series.push_back({.name = "a & b", .legend = "a", .line = std::move(line)});
    return panel;
}

}  // namespace

TEST_CASE("lines lose the vertices nobody would miss, and nothing else") {
    std::vector<Point> straight;
    for (int i = 0; i <= 100; ++i) straight.push_back({i / 10.0, i / 20.0});
    const std::string svg = drawn(one_line(straight), {0, 0, 300, 200});
    const auto path = svg.substr(svg.find("class=\"line\" d=\""));
    CHECK(path.substr(0, path.find("/>")).find('L') ==
          path.substr(0, path.find("/>")).rfind('L'));  // two vertices are left
    std::vector<Point> corner{{0, 0}, {5, 5}, {10, 0}};
    const std::string bent = drawn(one_line(corner), {0, 0, 300, 200});
    const auto kept = bent.substr(bent.find("class=\"line\" d=\""));
    CHECK(kept.substr(0, kept.find("/>")).find('L') != kept.substr(0, kept.find("/>")).rfind('L'));
    CHECK_FALSE(test::contains(bent, "<t>"));
    CHECK(test::contains(bent, "&lt;t&gt;"));
    CHECK(test::contains(bent, "a &amp; b"));
}

TEST_CASE("what is not finite or outside of fixed ends is not drawn") {
    const std::string svg = drawn(one_line({{1, 1}, {2, NAN}, {3, 3}, {4, 4}, {5, 50}}), {0, 0, 300, 200});
    CHECK_FALSE(test::contains(svg, "nan"));
    CHECK_FALSE(test::contains(svg, "inf"));
    XyPanel marks = one_line({});
    marks.series.front().marks = {{5, 5}, {5, 11}, {NAN, 1}};
    const std::string drawn_marks = drawn(marks, {0, 0, 300, 200});
    CHECK(test::contains(drawn_marks, "<use"));
    CHECK(drawn_marks.find("<use") == drawn_marks.rfind("<use"));
}

TEST_CASE("a title that has no room is set smaller, then cut") {
    const auto drawn_title = [](std::size_t letters) {
        return title_text(std::string(letters, 'n'), {.least = 10, .x = 40, .end = 200, .y = 12});
    };
    CHECK(drawn_title(0).empty());
    CHECK(drawn_title(3).find("<text class=\"title\" x=\"40\"") == 0);
    std::vector<std::string> looks;
    for (std::size_t letters = 1; letters < 100; ++letters) {
        const std::string svg = drawn_title(letters);
        const std::string look = svg.substr(0, svg.find(" x="));
        if (looks.empty() || looks.back() != look) looks.push_back(look);
        CHECK((svg.find("<title>") == std::string::npos) == (svg.find("\u2026") == std::string::npos));
    }
    CHECK(looks == std::vector<std::string>{"<text class=\"title\"", "<text class=\"title tick\"",
                                            "<text class=\"title sub\""});
}

TEST_CASE("CSV quotes what would break it") {
    const NumberTable table{.columns = {"a", "b [m/s]"},
                            .rows = {{std::string("x, \"y\""), 0.1}, {std::string("z"), NAN}}};
    CHECK(csv_of(table) == "a,b [m/s]\n\"x, \"\"y\"\"\",0.1\nz,\n");
    for (const char* name : {"=1+1", "+1", "-1", "@a"})
        CHECK(csv_of({.columns = {"a"}, .rows = {{Cell(std::string(name))}, {Cell(-0.5)}}}) ==
              "a\n'" + std::string(name) + "\n-0.5\n");
}

}  // namespace ashimpact::report

// The curves of the report: impacts that have wanted restitutions.

namespace ashimpact::curves {

TEST_CASE("impacts of wanted restitutions have their velocities, and the contact times of those velocities") {
    const ContactPair pair{
        .mass = 9.3e-10, .effective_radius = 44e-6, .contact_modulus = 90e9, .work_of_adhesion = 0.3};
    const Eigen::ArrayXd velocity = Eigen::ArrayXd::LinSpaced(6, 1.5, 9.0);
    for (const LawChoice& choice : {LawChoice{Law::of<Dmt>(), Detachment::zero_overlap},
                                    LawChoice{Law::of<Jkr>(), Detachment::pull_off}}) {
        CAPTURE(choice.law.name());
        Impact impact{.law = choice.law,
                      .detachment = choice.detachment,
                      .damping = {DampingLaw::tsuji, 0.0},
                      .contact = pair,
                      .velocity = 1.0};
        // A damping that falls with velocity, as measured ones do: restitution rises by it and by less
        // adhesion.
        const Eigen::ArrayXd damping = 0.3 * velocity.pow(-0.5);
        Eigen::ArrayXd e(velocity.size());
        for (Eigen::Index i = 0; i < e.size(); ++i) {
            impact.damping.coefficient = damping[i];
            impact.velocity = velocity[i];
            e[i] = solve_impact(impact).restitution;
        }
        for (const double from : {1.4, 1.003})  // the second one is found at the first impact
            for (Eigen::Index i = 0; i < e.size(); ++i) {
                CAPTURE(from);
                CAPTURE(i);
                const FoundImpacts found =
                    impacts_with(e, {choice, DampingLaw::tsuji, pair}, damping, from * velocity, 1e-2);
                CHECK(test::relative_difference(found.velocity[i], velocity[i]) < 4e-3);
                impact.damping.coefficient = damping[i];
                impact.velocity = found.velocity[i];
                CHECK(test::relative_difference(found.contact_time[i], *solve_impact(impact).contact_time) <
                      1e-3);
            }
    }
}

TEST_CASE("impacts of small restitutions are found, with contact times, though the search meets captures") {
    const ContactPair pair{
        .mass = 9.3e-10, .effective_radius = 44e-6, .contact_modulus = 90e9, .work_of_adhesion = 0.3};
    Impact impact{.law = Law::of<Dmt>(),
                  .detachment = Detachment::zero_overlap,
                  .damping = {DampingLaw::constant, 0.012},
                  .contact = pair,
                  .velocity = 1.0};
    const double critical =
        critical_velocity({impact.law, impact.detachment, impact.damping, pair}).value.value();
    const Eigen::ArrayXd velocity = critical * (1 + Eigen::ArrayXd::LinSpaced(12, 0.01, 0.5).square());
    Eigen::ArrayXd e(velocity.size());
    for (Eigen::Index i = 0; i < e.size(); ++i) {
        impact.velocity = velocity[i];
        e[i] = solve_impact(impact).restitution;
    }
    const Eigen::ArrayXd damping = Eigen::ArrayXd::Constant(e.size(), 0.012);
    for (const double from : {0.9, 1.1, 1.4, 2.0})
        for (Eigen::Index i = 0; i < e.size(); ++i) {
            CAPTURE(from);
            CAPTURE(i);
            const FoundImpacts found =
                impacts_with(e, {{impact.law, impact.detachment}, DampingLaw::constant, pair}, damping,
                             from * velocity, 1e-4);
            CHECK(test::relative_difference(found.velocity[i], velocity[i]) < 1e-4);
            impact.velocity = velocity[i];
            CHECK(test::relative_difference(found.contact_time[i], *solve_impact(impact).contact_time) <
                  1e-2);
        }
}

namespace {

/// A curve of a fly-ash particle by one law, with a damping that falls as the restitution rises.
CurveProblem curve_problem(Law law) {
    CurveProblem problem{.choice = {law, law.default_detachment()},
                         .damping_law = DampingLaw::constant,
                         .contact = {.mass = 7.7e-10,
                                     .effective_radius = 44e-6,
                                     .contact_modulus = 90e9,
                                     .work_of_adhesion = law == Law::of<Hertz>() ? 0.0 : 0.3,
                                     .parameters = typical_parameters(law)},
                         .damping_fit = {},
                         .covariance = 1e-8 * Eigen::MatrixXd::Identity(3, 3),
                         .greatest_restitution = 0.4,
                         .greatest_velocity = 100.0,
                         .knots = {{0.4, 3.0}}};
    problem.damping_fit.coefficients = Eigen::Vector3d(0.014, -0.008, -0.001);
    if (law == Law::of<ThorntonNing>()) problem.contact.yield_pressure = 3e9;
    return problem;
}

}  // namespace

TEST_CASE("each impact on a model's curve is that of the solver, by every law, with all of its energy") {
    for (std::size_t index = 0; index < Law::count(); ++index) {
        const Law law = Law::at(index);
        CAPTURE(law.name());
        const CurveProblem problem = curve_problem(law);
        const ModelCurve curve = model_curve(problem);
        const bool yields = std::isfinite(problem.contact.yield_pressure);
        REQUIRE(curve.size() > 10);
        for (const CurveImpact& impact : curve) {
            CAPTURE(impact.restitution);
            Impact exact{problem.choice.law,
                         problem.choice.detachment,
                         {DampingLaw::constant, impact.damping},
                         problem.contact,
                         impact.velocity};
            const ImpactResult result = solve_impact(exact);
            const double whole = result.energy.incident;
            CHECK(result.restitution == doctest::Approx(impact.restitution).epsilon(1e-8));
            REQUIRE(result.contact_time);
            CHECK(*result.contact_time == doctest::Approx(impact.contact_time).epsilon(1e-7));
            CHECK(result.energy.dissipated / whole == doctest::Approx(impact.dissipated).epsilon(1e-8));
            CHECK(result.energy.plastic / whole == doctest::Approx(impact.plastic).epsilon(1e-8));
            CHECK(impact.lower < impact.velocity);
            if (!yields || std::isfinite(impact.upper)) CHECK(impact.upper > impact.velocity);
        }
        CHECK((curve.back().plastic > 0.01) == yields);
        if (yields) continue;
        CurveProblem from_elsewhere = problem;
        from_elsewhere.knots = {{0, 0.1}, {0.2, 30}};
        const ModelCurve again = model_curve(from_elsewhere);
        REQUIRE(again.size() == curve.size());
        for (std::size_t i = 0; i < curve.size(); ++i)
            CHECK(again[i].velocity == doctest::Approx(curve[i].velocity).epsilon(1e-8));
    }
}

TEST_CASE("a model's curve and its band end at the greatest velocity") {
    CurveProblem problem = curve_problem(Law::of<Dmt>());
    const ModelCurve whole = model_curve(problem);
    problem.greatest_velocity = whole[whole.size() / 2].velocity;
    const ModelCurve curve = model_curve(problem);
    REQUIRE(curve.size() == whole.size() / 2 + 1);
    for (std::size_t i = 0; i < curve.size(); ++i) {
        CHECK(curve[i].velocity == whole[i].velocity);
        CHECK(curve[i].lower == whole[i].lower);
        CHECK(curve[i].upper == std::min(whole[i].upper, problem.greatest_velocity));
    }
}

}  // namespace ashimpact::curves
