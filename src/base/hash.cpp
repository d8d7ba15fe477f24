#include "base/hash.h"

// Compiled in, because a shared library would be loaded at every start of the program.
#define XXH_INLINE_ALL
#include <xxhash.h>

namespace glibra::base {

Hash hashOf(std::initializer_list<std::span<const std::byte>> parts) {
    XXH3_state_t state;
    XXH3_128bits_reset(&state);
    for (const std::span<const std::byte> each : parts) XXH3_128bits_update(&state, each.data(), each.size());
    const XXH128_hash_t digest = XXH3_128bits_digest(&state);
    return {digest.high64, digest.low64};
}

}  // namespace glibra::base
