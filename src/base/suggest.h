#pragma once
// "did you mean 'Sphere'?": finds the known name nearest to an unknown one.

#include <cstddef>
#include <span>
#include <string>
#include <string_view>

namespace glibra::base {

/// Returns the smallest number of insertions, deletions, replacements and exchanges of neighbouring bytes
/// that turn `a` into `b`, where no byte is edited twice (optimal string alignment distance). The case of
/// ASCII letters is ignored.
std::size_t editDistance(std::string_view a, std::string_view b);

/// Returns the first candidate with the smallest distance; empty if none is near. Near means at most 0 edits
/// for words of up to 2 bytes, 1 for up to 5, 2 for up to 9, else 3. The first `prefix` bytes of a word, such
/// as the u that all uniforms share, do not count for its length. Words of more than 128 bytes are near to
/// nothing, and a name is not near to itself.
std::string nearestName(std::string_view word, std::span<const std::string_view> candidates,
                        std::size_t prefix = 0);

/// Returns "; did you mean 'uShrink'?" with the nearest name; empty if none is near.
std::string suggestion(std::string_view word, std::span<const std::string_view> candidates,
                       std::size_t prefix = 0);

}  // namespace glibra::base
