#include "suite/golden/hash.h"

#include <fmt/format.h>

#include <array>
#include <charconv>

// Compiled in, because a shared library would be loaded at every start of the program.
#define XXH_INLINE_ALL
#include <xxhash.h>

namespace glibra::suite {

Hash hashOf(const image::Image& picture) {
    const std::array<std::int32_t, 4> shape{picture.width, picture.height, picture.components,
                                            static_cast<std::int32_t>(picture.type)};
    XXH3_state_t state;
    XXH3_128bits_reset(&state);
    XXH3_128bits_update(&state, shape.data(), sizeof shape);
    XXH3_128bits_update(&state, picture.data.data(), picture.data.size());
    const XXH128_hash_t digest = XXH3_128bits_digest(&state);
    return {digest.high64, digest.low64};
}

Hash hashOf(std::span<const std::byte> bytes) {
    const XXH128_hash_t digest = XXH3_128bits(bytes.data(), bytes.size());
    return {digest.high64, digest.low64};
}

std::string toText(const Hash& hash) {
    return fmt::format("{:016x}{:016x}", hash.high, hash.low);
}

std::optional<Hash> parseHash(std::string_view text) {
    constexpr std::size_t kDigits = 16;
    if (text.size() != 2 * kDigits) return std::nullopt;
    Hash hash;
    const auto half = [&](std::size_t at, std::uint64_t& value) {
        const char* begin = text.data() + at;
        const auto [end, failed] = std::from_chars(begin, begin + kDigits, value, 16);
        return failed == std::errc{} && end == begin + kDigits;
    };
    if (!half(0, hash.high) || !half(kDigits, hash.low)) return std::nullopt;
    return hash;
}

}  // namespace glibra::suite
