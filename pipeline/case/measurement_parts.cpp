// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/case/measurement_parts.hpp"

#include <fmt/format.h>

#include "core/quantities/checks.hpp"
#include "core/quantities/readable.hpp"
#include "pipeline/case/measurement_json.hpp"
#include "solver/inference/impacts/measurement.hpp"

namespace ashimpact {

namespace {

void apply_camera(const View& node, MeasuredRestitution& data) {
    const Camera camera = read_camera(node);
    data.impacts = at_place(node.pointer(), [&] { return with_camera(std::move(data.impacts), camera); });
    data.source += fmt::format("; velocities of a camera with {} frames/s and {} a pixel, u = {}",
                               readable_number(camera.frame_rate, 6), readable(camera.pixel_size, "m"),
                               readable(camera.velocity_uncertainty(), "m/s"));
}

void apply_binning(const View& node, MeasuredRestitution& data) {
    Binning binning;
    if (const auto count = node.find("impacts_per_bin")) binning.impacts_per_bin = count->integer();
    if (const auto width = node.find("width"))
        binning.width = positive_quantity(*width, "width", Dimension::velocity).value;
    const std::size_t before = data.impacts.rebounds();
    data.impacts = at_place(node.pointer(), [&] { return binned(data.impacts, binning); });
    data.source += fmt::format("; {} rebounds in {} bins", before, data.impacts.rebounds());
}

}  // namespace

Camera read_camera(const View& node) {
    Camera camera{
        .frame_rate = node.at("frame_rate").number(Dimension::fraction),
        .pixel_size = positive_quantity(node.at("pixel_size"), "pixel size", Dimension::length).value};
    if (const auto frames = node.find("frames")) camera.frames = frames->integer();
    if (const auto position = node.find("position_in_pixels"))
        camera.position_in_pixels = position->number(Dimension::fraction);
    at_place(node.pointer(), [&] { static_cast<void>(camera.velocity_uncertainty()); });
    return camera;
}

MeasuredRestitution read_measured(const View& node, InputFiles& files, const std::optional<View>& camera) {
    MeasuredRestitution data{.source = "the case file"};
    if (const auto file = node.find("file")) {
        const std::string name = file->text();
        data.source = name;
        const auto sheet = node.find("sheet");
        data.impacts = at_place(file->pointer(), [&] {
            return read_measurements(files.read(name), files.shown(name),
                                     sheet ? sheet->text() : std::string());
        });
    } else {
        data.impacts = read_measurement_columns(node);
    }
    if (const auto source = node.find("source")) data.source = source->text();
    if (const auto own = node.find("camera"))
        apply_camera(*own, data);
    else if (camera && !data.impacts.has_noise())
        apply_camera(*camera, data);
    const auto place = node.find("file");
    at_place((place ? *place : node).pointer(), [&] {
        if (!place) return check_impacts(data.impacts);
        at_place(FileName{files.shown(place->text())}, [&] { check_impacts(data.impacts); });
    });
    if (const auto binning = node.find("binning")) apply_binning(*binning, data);
    return data;
}

FitChoices read_fit_choices(const std::optional<View>& node) {
    FitChoices choices;
    if (!node) return choices;
    if (const auto order = node->find("order")) choices.order = order->integer();
    if (const auto scatter = node->find("size_scatter"))
        choices.size_scatter = scatter->number(Dimension::fraction);
    if (const auto robust = node->find("robust")) choices.robust = robust->truth();
    if (const auto flatness = node->find("flatness"))
        choices.flatness = flatness->number(Dimension::fraction);
    if (const auto outlier = node->find("outlier")) choices.outlier = outlier->number(Dimension::fraction);
    return choices;
}

UncertaintyChoices read_uncertainty_choices(const std::optional<View>& node) {
    UncertaintyChoices choices;
    if (!node) return choices;
    if (const auto samples = node->find("samples")) choices.propagation.samples = samples->integer();
    if (const auto count = node->find("replicates")) choices.propagation.replicates = count->integer();
    if (const auto seed = node->find("seed"))
        choices.propagation.seed = static_cast<unsigned long>(seed->integer());
    if (const auto damping = node->find("damping")) choices.reread = damping->text() == "reread";
    return choices;
}

}  // namespace ashimpact
