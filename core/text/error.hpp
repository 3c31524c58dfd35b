// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <stdexcept>
#include <string>
#include <utility>

namespace ashimpact {

/// A file as the place of an error. Its name is never taken for a JSON pointer, even if it begins with a
/// slash.
struct FileName {
    std::string name;
};

/// The user's input is wrong (exit status 2). The message is one line: place, what is wrong, what is allowed.
class InputError : public std::runtime_error {
  public:
    /// @param problem what is wrong, naming quantity, value and unit
    /// @param allowed what would be accepted; may be empty
    explicit InputError(std::string problem, std::string allowed = {});

    /// The same error with the place where it was found, a JSON pointer, line, option or file, in front of
    /// any place it has. Two JSON pointers are joined; a place is never repeated.
    [[nodiscard]] InputError at(const std::string& place) const;
    [[nodiscard]] InputError at(const FileName& file) const;

    [[nodiscard]] const std::string& place() const { return place_; }
    [[nodiscard]] const std::string& problem() const { return problem_; }
    [[nodiscard]] const std::string& allowed() const { return allowed_; }

  private:
    InputError(std::string place, std::string problem, std::string allowed, bool names_file);

    std::string place_;
    std::string problem_;
    std::string allowed_;
    bool names_file_;
};

/// A computation did not converge (exit status 3).
class ConvergenceError : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

/// Returns what @p read returns. An InputError that it throws gets @p place, a text or a FileName, in front
/// of its own place.
template <class Place, class Read>
decltype(auto) at_place(const Place& place, Read&& read) {
    try {
        return std::forward<Read>(read)();
    } catch (const InputError& error) {
        throw error.at(place);
    }
}

}  // namespace ashimpact
