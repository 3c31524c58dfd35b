#include "materials/error.hpp"

#include <utility>

namespace ashimpact {

namespace {

std::string one_line(const std::string& place, const std::string& problem, const std::string& allowed) {
    std::string line = place.empty() ? problem : place + ": " + problem;
    if (!allowed.empty()) line += "; allowed: " + allowed;
    return line;
}

std::string nested(const std::string& outer, const std::string& inner) {
    if (inner.empty()) return outer;
    return outer.front() == '/' ? outer + inner : outer + ": " + inner;
}

}  // namespace

InputError::InputError(std::string problem, std::string allowed)
    : InputError(std::string{}, std::move(problem), std::move(allowed)) {}

InputError::InputError(std::string place, std::string problem, std::string allowed)
    : std::runtime_error(one_line(place, problem, allowed)),
      place_(std::move(place)),
      problem_(std::move(problem)),
      allowed_(std::move(allowed)) {}

InputError InputError::at(const std::string& place) const {
    return {nested(place, place_), problem_, allowed_};
}

}  // namespace ashimpact
