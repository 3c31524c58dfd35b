#pragma once

#include <string>

namespace ashimpact {

/// What to type at a prompt in the working folder to start this program again: "ashimpact" where the search
/// path leads to it, else its path, relative if it is below the working folder, as a word of a shell command.
/// Within another program, such as one that uses the library, "ashimpact".
[[nodiscard]] std::string program_word();

}  // namespace ashimpact
