#pragma once
// "did you mean 'uShrink'?": the known name that lies nearest to one that is not known.

#include <span>
#include <string>
#include <string_view>

namespace glibra::plan {

/// The candidate with the smallest edit distance (Damerau's with adjacent transpositions, letters compared
/// without regard to case), the first of several; empty if none is near. Near means 0 edits for up to 3
/// letters, 1 up to 6, 2 up to 10, else 3. Names longer than 128 bytes are near to nothing.
std::string nearestName(std::string_view wanted, std::span<const std::string> candidates);

/// "; did you mean 'uShrink'?", or nothing.
std::string suggestion(std::string_view wanted, std::span<const std::string> candidates);

}  // namespace glibra::plan
