#include "pipeline/files/sha256.hpp"

#include <nettle/sha2.h>

#include <array>
#include <cstdint>

namespace ashimpact {

std::string sha256(std::string_view bytes) {
    sha256_ctx context;
    sha256_init(&context);
    // The one cast the C interface needs: it reads octets.
    sha256_update(&context, bytes.size(), reinterpret_cast<const std::uint8_t*>(bytes.data()));
    std::array<std::uint8_t, SHA256_DIGEST_SIZE> digest{};
    sha256_digest(&context, digest.size(), digest.data());

    constexpr std::string_view digits = "0123456789abcdef";
    std::string text;
    for (const std::uint8_t octet : digest) {
        text += digits[octet >> 4U];
        text += digits[octet & 15U];
    }
    return text;
}

}  // namespace ashimpact
