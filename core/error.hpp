// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <stdexcept>
#include <string>

namespace ashimpact {

/// The user's input is wrong (exit status 2). The message is one line: place, what is wrong, what is allowed.
class InputError : public std::runtime_error {
  public:
    /// @param problem what is wrong, naming quantity, value and unit
    /// @param allowed what would be accepted; may be empty
    explicit InputError(std::string problem, std::string allowed = {});

    /// The same error with the place (JSON pointer, line, option) where it was found, in front of any place
    /// it has. Two JSON pointers are joined; a place is never repeated.
    [[nodiscard]] InputError at(const std::string& place) const;

    /// The same error with the file where it was found, in front of any place. The name of a file is not
    /// taken for a JSON pointer, even if it begins with a slash.
    [[nodiscard]] InputError in_file(const std::string& file) const;

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

}  // namespace ashimpact
