// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <stdexcept>
#include <string>

#include "ashimpact.h"

/// Errors as exceptions. C++17 on top of ashimpact.h: nothing here has code in the library, so that compiler
/// and standard library may differ from those the library was built with. Units: messages name those of each
/// number, SI. Threads: nothing here has a state. Source of the model: Dong et al. 2013; docs/laws names that
/// of each law.
namespace ashimpact {
inline namespace v1 {

/// A number or a name is not admissible. The message is one line: what is wrong, what is allowed.
class InputError : public std::invalid_argument {
  public:
    using std::invalid_argument::invalid_argument;
};

/// A computation did not converge.
class ConvergenceError : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

/// Throws what a status other than ASHIMPACT_OK stands for; std::runtime_error for a defect of the library.
inline void check(ashimpact_status status, const ashimpact_error& error) {
    switch (status) {
        case ASHIMPACT_OK:
            return;
        case ASHIMPACT_INPUT_ERROR:
            throw InputError(error.message);
        case ASHIMPACT_NOT_CONVERGED:
            throw ConvergenceError(error.message);
        case ASHIMPACT_DEFECT:
            break;
    }
    throw std::runtime_error(std::string("ashimpact: ") + error.message);
}

}  // namespace v1
}  // namespace ashimpact
