#pragma once
// The `store` of a suite: where the pictures are of which its goldens have the hashes
// (golden/picture_store.h).

#include <string>
#include <string_view>

namespace glibra::suite {

/// What stands in an address for the hash of a picture.
inline constexpr std::string_view kHashSlot = "{hash}";

/// True for the address of a web server, false for a folder.
bool isAddress(std::string_view store);
/// Why a text cannot be a store; empty if it can: a folder, or "https://host/place/{hash}.png" (http, too),
/// where {hash} stands once, after the last '/'.
std::string whyNoStore(std::string_view text);

}  // namespace glibra::suite
