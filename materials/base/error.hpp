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

    /// The same error with the place it was found at (JSON pointer, line, option) in front of any inner
    /// place. Joins JSON pointers; never repeats a place.
    [[nodiscard]] InputError at(const std::string& place) const;

    /// The same error with the file it was found in, in front of any place. A file name that begins with a
    /// slash does not count as a pointer.
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
