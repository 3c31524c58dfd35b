// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/files/sha256.hpp"

#include <array>
#include <cstdint>

#include <fmt/format.h>
#include <nettle/sha2.h>

namespace ashimpact {

std::string sha256(std::string_view bytes) {
    sha256_ctx context;
    sha256_init(&context);
    // The one cast the C interface needs: it reads octets.
    sha256_update(&context, bytes.size(), reinterpret_cast<const std::uint8_t*>(bytes.data()));
    std::array<std::uint8_t, SHA256_DIGEST_SIZE> digest{};
    sha256_digest(&context, digest.size(), digest.data());
    return fmt::format("{:02x}", fmt::join(digest, ""));
}

}  // namespace ashimpact
