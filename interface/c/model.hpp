#pragma once

#include <array>
#include <cstddef>
#include <optional>

#include "interface/c/parameters.hpp"
#include "interface/include/ashimpact.h"
#include "solver/contact/registry.hpp"
#include "solver/damping/damping.hpp"

/// What a handle of the C interface stands for. It never changes once it is made.
struct ashimpact_model {  // NOLINT(readability-identifier-naming): the name of the C interface
    ashimpact::Law law;
    ashimpact::Detachment detachment;
    ashimpact::DampingLaw damping_law;
    std::array<std::optional<double>, ashimpact::most_parameters> constants{};

    /// The sources of a call without columns: the constants.
    [[nodiscard]] ashimpact::Parameters parameters() const;
};

namespace ashimpact {

/// Makes a model from what ashimpact_open() takes, null pointers included.
/// @throws InputError for a name that is unknown, a constant that is not admissible, missing or given twice
[[nodiscard]] ashimpact_model make_model(const char* law, const char* detachment, const char* damping_law,
                                         const ashimpact_parameter* parameters, std::size_t count);

}  // namespace ashimpact
