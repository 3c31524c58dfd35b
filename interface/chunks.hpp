// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstddef>
#include <stdexcept>
#include <string>

#include "core/text/error.hpp"

namespace ashimpact {

/// Solves the problems of a chunk that failed one by one, so that the message names the first that fails by
/// its place in the call, and names no place in a call of one problem.
template <class Solve>
void find_failure(std::size_t first, std::size_t size, bool only_one, const Solve& solve) {
    for (std::size_t i = first; i < first + size; ++i) {
        const std::string place = "impact " + std::to_string(i);
        try {
            solve(i, std::size_t{1});
        } catch (const InputError& error) {
            if (only_one) throw InputError(error.problem(), error.allowed());
            throw InputError(error.problem(), error.allowed()).at(place);
        } catch (const ConvergenceError& error) {
            std::string message = error.what();
            const std::string own_place = "impact 0: ";
            if (message.starts_with(own_place)) message.erase(0, own_place.size());
            if (!only_one) message.insert(0, ": ").insert(0, place);
            throw ConvergenceError(message);
        }
    }
}

/// Calls solve(first, size) for consecutive chunks of count problems, at most @p capacity at a time.
/// @throws what solve throws for the first problem that fails, with its place
template <class Solve>
void in_chunks(std::size_t count, std::size_t capacity, const Solve& solve) {
    for (std::size_t first = 0; first < count; first += capacity) {
        const std::size_t size = std::min(capacity, count - first);
        try {
            solve(first, size);
        } catch (const InputError&) {
            find_failure(first, size, count == 1, solve);
            throw;
        } catch (const ConvergenceError&) {
            find_failure(first, size, count == 1, solve);
            throw;
        }
    }
}

}  // namespace ashimpact
