#pragma once

#include <cstddef>

namespace CLI {  // NOLINT(readability-identifier-naming): the library's own name
class Validator;
}

namespace ashimpact {

/// That a file or folder is named at all: an empty name would mean the current folder.
[[nodiscard]] CLI::Validator not_empty();

/// That the argument is a whole number from @p least to @p most.
[[nodiscard]] CLI::Validator whole_number(std::size_t least, std::size_t most);

}  // namespace ashimpact
