// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/present/text/histogram_text.hpp"

#include <algorithm>
#include <numeric>

#include <fmt/format.h>

#include "core/quantities/readable.hpp"
#include "pipeline/present/text/short_text.hpp"
#include "pipeline/present/text/table.hpp"

namespace ashimpact {

bool is_histogram(const Json& value) {
    return value.is_object() && value.contains("edges") && value.contains("counts") &&
           is_column(value["edges"]) && value["counts"].is_array() && !value["counts"].empty() &&
           std::all_of(value["counts"].begin(), value["counts"].end(),
                       [](const Json& count) { return count.is_number(); }) &&
           value["edges"]["values"].size() == value["counts"].size() + 1;
}

std::string histogram_text(const Json& histogram, std::size_t indent, std::size_t width) {
    constexpr std::size_t most_bars = 16;
    constexpr std::size_t numbers_width = 40;  // of edges and counts beside the bars
    const auto edges = histogram.at("edges").at("values").get<std::vector<double>>();
    const auto counts = histogram.at("counts").get<std::vector<double>>();
    const std::size_t merged = (counts.size() + most_bars - 1) / most_bars;
    std::vector<double> sums;
    for (std::size_t i = 0; i < counts.size(); i += merged)
        sums.push_back(std::accumulate(
            counts.begin() + static_cast<std::ptrdiff_t>(i),
            counts.begin() + static_cast<std::ptrdiff_t>(std::min(i + merged, counts.size())), 0.0));
    const double greatest = *std::max_element(sums.begin(), sums.end());
    const double longest = static_cast<double>(width - std::min(width - 10, indent + numbers_width));

    const std::string unit = histogram.at("edges").at("unit").get<std::string>();
    TextTable table({"from" + (unit == "1" ? "" : " [" + unit + "]"), "to", "count", ""});
    for (std::size_t i = 0; i < sums.size(); ++i) {
        const auto length = static_cast<std::size_t>(greatest > 0 ? longest * sums[i] / greatest + 0.5 : 0.0);
        const std::string bar(length, '#');
        table.add({readable_number(edges[i * merged]),
                   readable_number(edges[std::min((i + 1) * merged, counts.size())]),
                   readable_number(sums[i], 12),
                   bar + std::string(static_cast<std::size_t>(longest) - length, ' ')});
    }
    std::string text = table.text(indent, width);
    if (histogram.contains("zeros"))
        text += fmt::format("{}zero: {}\n", std::string(indent, ' '),
                            short_text(histogram.at("zeros")).value_or("-"));
    return text;
}

}  // namespace ashimpact
