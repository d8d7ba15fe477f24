#include "plan/near_name.h"

#include <cstddef>

#include "glib/suggest.h"

namespace glibra::plan {
namespace {

constexpr std::size_t kLongestName = 128;

std::size_t allowedEdits(std::size_t letters) {
    if (letters <= 3) return 0;
    if (letters <= 6) return 1;
    return letters <= 10 ? 2 : 3;
}

}  // namespace

std::string nearestName(std::string_view wanted, std::span<const std::string> candidates) {
    if (wanted.size() > kLongestName) return {};
    std::size_t best = allowedEdits(wanted.size()) + 1;
    std::string nearest;
    for (const std::string& candidate : candidates) {
        if (candidate.size() > kLongestName || candidate == wanted) continue;
        const std::size_t distance = glib::editDistance(wanted, candidate);
        if (distance >= best) continue;
        best = distance;
        nearest = candidate;
    }
    return nearest;
}

std::string suggestion(std::string_view wanted, std::span<const std::string> candidates) {
    const std::string nearest = nearestName(wanted, candidates);
    return nearest.empty() ? std::string() : "; did you mean '" + nearest + "'?";
}

}  // namespace glibra::plan
