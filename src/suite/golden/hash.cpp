#include "suite/golden/hash.h"

#include <fmt/format.h>

#include <array>
#include <charconv>
#include <cstdint>

namespace glibra::suite {

Hash hashOf(const image::Image& picture) {
    const std::array<std::int32_t, 4> shape{picture.width, picture.height, picture.components,
                                            static_cast<std::int32_t>(picture.type)};
    return base::hashOf({std::as_bytes(std::span(shape)), picture.data});
}

Hash hashOf(std::span<const std::byte> bytes) {
    return base::hashOf({bytes});
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
