// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/text/error.hpp"

#include <algorithm>
#include <utility>

#include "core/text/text.hpp"

namespace ashimpact {

namespace {

std::string one_line(const std::string& place, const std::string& problem, const std::string& allowed) {
    std::string line = place.empty() ? problem : place + ": " + problem;
    if (!allowed.empty()) line += "; allowed: " + allowed;
    return line;
}

/// True if the outer place is the whole or the first part of a place: "line 3" of "line 3, cell 1".
bool is_prefix_of(const std::string& outer, const std::string& place) {
    return place == outer || place.starts_with(outer + ": ") || place.starts_with(outer + ", ");
}

/// A place for messages: the middle of each long part of a JSON pointer is left out.
std::string with_short_keys(const std::string& place) {
    constexpr std::size_t longest = 200;  // of a place that is taken as it is
    if (!place.starts_with('/') || place.size() <= longest) return place;
    std::string shown;
    for (std::size_t start = 0; start < place.size();) {
        const std::size_t end = std::min(place.find('/', start + 1), place.size());
        shown += shortened(place.substr(start, end - start));
        start = end;
    }
    return shown;
}

}  // namespace

InputError::InputError(std::string problem, std::string allowed)
    : InputError(std::string{}, std::move(problem), std::move(allowed), false) {}

InputError::InputError(std::string place, std::string problem, std::string allowed, bool names_file)
    : std::runtime_error(one_line(place, problem, allowed)),
      place_(std::move(place)),
      problem_(std::move(problem)),
      allowed_(std::move(allowed)),
      names_file_(names_file) {}

InputError InputError::at(const std::string& whole_place) const {
    if (whole_place.empty()) return *this;
    const std::string place = with_short_keys(whole_place);
    if (place_.empty()) return {place, problem_, allowed_, names_file_};
    if (!place.starts_with('/') && is_prefix_of(place, place_)) return *this;
    const bool one_pointer = !names_file_ && place.starts_with('/') && place_.starts_with('/');
    return {one_pointer ? place + place_ : place + ": " + place_, problem_, allowed_, names_file_};
}

InputError InputError::at(const FileName& file) const {
    if (names_file_ && is_prefix_of(file.name, place_)) return *this;
    return {place_.empty() ? file.name : file.name + ": " + place_, problem_, allowed_, true};
}

}  // namespace ashimpact
