// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/present/report/figures/figures.hpp"

#include "core/text/error.hpp"
#include "core/text/text.hpp"

namespace ashimpact::report {

const std::vector<FigureMaker>& figure_makers() {
    static const std::vector<FigureMaker> makers{
        {"critical-velocity", critical_velocity_figure},
        {"sensitivity", sensitivity_figure},
        {"composition", composition_figure},
        {"static-force", static_force_figure},
        {"regime-map", regime_map_figure},
        {"restitution", restitution_figure},
        {"damping", damping_figure},
        {"damping-fit", damping_fit_figure},
        {"contact-time", contact_time_figure},
        {"sizes", sizes_figure},
        {"histories", histories_figure},
        {"energy", energy_figure},
    };
    return makers;
}

Figure figure_named(std::string_view id, const RunData& run) {
    std::vector<std::string> ids;
    for (const FigureMaker& maker : figure_makers()) {
        if (maker.id == id) return maker.make(run);
        ids.emplace_back(maker.id);
    }
    throw InputError("no figure is called " + in_quotes(id) + did_you_mean(id, ids), joined(ids));
}

}  // namespace ashimpact::report
