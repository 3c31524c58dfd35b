// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace ashimpact {

/// The word that starts this program in a shell in the working folder: "ashimpact" if the search path leads
/// to it, else its path, relative if it is below the working folder. "ashimpact" in another program that uses
/// the library.
[[nodiscard]] std::string program_word();

}  // namespace ashimpact
