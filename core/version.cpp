// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/version.hpp"

#include <string_view>

#include "revision.hpp"  // written at every build by cmake/Revision.cmake

namespace ashimpact {

std::string_view program_version() {
    return ASHIMPACT_VERSION;
}

std::string_view program_revision() {
    return ASHIMPACT_REVISION;
}

}  // namespace ashimpact
