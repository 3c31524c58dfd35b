// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include "pipeline/present/report/drawing/markup.hpp"
#include "pipeline/present/report/page/html.hpp"
#include "pipeline/present/report/page/run_page.hpp"

namespace ashimpact::report {

namespace {

std::string arrow(double x, double from, double to, const char* look) {
    const double head = to > from ? -7 : 7;
    return fmt::format(
        "<g class=\"{0}\"><path class=\"line\" d=\"M{1} {2}V{3}M{4} {5}L{1} {3}L{6} {5}\"/></g>", look,
        pixels(x), pixels(from), pixels(to), pixels(x - 4), pixels(to + head), pixels(x + 4));
}

std::string text(double x, double y, const std::string& label, const char* look = "") {
    return fmt::format("<text class=\"{}\" x=\"{}\" y=\"{}\">{}</text>", look, pixels(x), pixels(y),
                       subscripted(label));
}

/// The particle before, during and after the impact, at @p left.
std::string particle(double left, double centre, const char* title) {
    return fmt::format(
               "<circle class=\"shade\" cx=\"{0}\" cy=\"{1}\" r=\"44\"/><circle class=\"frame\" cx=\"{0}\" "
               "cy=\"{1}\" r=\"44\"/>",
               pixels(left), pixels(centre)) +
           text(left, 16, title, "mid title");
}

std::string stage(int number, double middle, double wall) {
    if (number == 0)
        return particle(middle, wall - 80, "before") + arrow(middle, wall - 70, wall - 40, "k1 d0") +
               text(middle + 8, wall - 46, "v_in") + text(middle + 50, wall - 80, "r, m, E, ν");
    if (number == 1)
        return particle(middle, wall - 34, "in contact") +
               fmt::format("<g class=\"k0 d0\"><path class=\"line\" d=\"M{} {}h56\"/></g>",
                           pixels(middle - 28), pixels(wall)) +
               fmt::format(
                   "<g class=\"k0 d2 thin\"><path class=\"line\" d=\"M{0} {1}v10M{2} {1}v10M{0} "
                   "{3}H{2}\"/></g>",
                   pixels(middle), pixels(wall + 2), pixels(middle + 28), pixels(wall + 8)) +
               text(middle + 10, wall + 21, "a", "tick") + arrow(middle + 58, wall + 10, wall, "k2 d0") +
               text(middle + 64, wall + 12, "δ = r − d") + arrow(middle, wall - 8, wall - 34, "k2 d0") +
               text(middle + 5, wall - 22, "F_r") + arrow(middle - 14, wall - 34, wall - 10, "k3 d0") +
               text(middle - 35, wall - 24, "F_a") + text(middle + 48, wall - 50, "η dδ/dt");
    return particle(middle, wall - 80, "after") + arrow(middle, wall - 40, wall - 70, "k1 d0") +
           text(middle + 50, wall - 80, "v_r = e_n v_in");
}

std::string drawing(bool wide) {
    const double width = wide ? 840 : 340;
    const double height = wide ? 178 : 3 * 178;
    std::string svg = fmt::format(
        "<svg class=\"{}\" viewBox=\"0 0 {} {}\" role=\"img\" aria-label=\"A sphere before, during and after "
        "its impact on a wall\">",
        wide ? "wide" : "narrow", pixels(width), pixels(height));
    for (int i = 0; i < 3; ++i) {
        const double top = wide ? 0 : 178.0 * i;
        const double middle = wide ? 140 + 280.0 * i : 150;
        const double wall = 146;
        svg += fmt::format(
            "<g transform=\"translate(0 {})\"><rect class=\"shade\" x=\"{}\" y=\"{}\" width=\"{}\" "
            "height=\"14\"/><path class=\"frame\" d=\"M{} {}h{}\"/>",
            pixels(top), pixels(wide ? 280.0 * i : 0), pixels(wall), pixels(wide ? 280 : 340),
            pixels(wide ? 280.0 * i : 0), pixels(wall), pixels(wide ? 280 : 340));
        svg += stage(i, middle, wall) + "</g>";
    }
    return svg + "</svg>";
}

}  // namespace

std::string sketch_html(const std::string& id) {
    const std::string caption = with_subscripts(
        "A sphere of radius r meets a flat wall at v_in. In contact, at a distance d of its centre from the "
        "wall, it overlaps the wall by δ over a circle of radius a; "
        "repulsion F_r pushes it away, attraction F_a holds it, damping η dδ/dt takes energy. It leaves at "
        "v_r = e_n v_in, or stays: then e_n = 0.");
    return fmt::format(
        "<figure id=\"{}\"><h3>One impact, and what its quantities are called</h3>{}{}<figcaption>{} <span "
        "class=\"counterpart\">In Dong et al. 2013: Figures 1, "
        "2 and 4.</span></figcaption></figure>\n",
        id, drawing(true), drawing(false), caption);
}

}  // namespace ashimpact::report
