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

    /// The same error with the place (file, JSON pointer or line) it was found at; an inner place is kept.
    [[nodiscard]] InputError at(const std::string& place) const;

    [[nodiscard]] const std::string& place() const { return place_; }
    [[nodiscard]] const std::string& problem() const { return problem_; }
    [[nodiscard]] const std::string& allowed() const { return allowed_; }

  private:
    InputError(std::string place, std::string problem, std::string allowed);

    std::string place_;
    std::string problem_;
    std::string allowed_;
};

/// A computation did not converge (exit status 3).
class ConvergenceError : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

}  // namespace ashimpact
