#include "base/suggest.h"

#include <algorithm>
#include <array>
#include <vector>

#include "base/text.h"

namespace glibra::base {
namespace {

constexpr std::size_t kLongestWord = 128;

std::size_t allowedEdits(std::size_t length) {
    if (length <= 2) return 0;
    if (length <= 5) return 1;
    return length <= 9 ? 2 : 3;
}

}  // namespace

std::size_t editDistance(std::string_view a, std::string_view b) {
    // Rows i - 2, i - 1 and i of the table of distances between prefixes.
    std::array<std::vector<std::size_t>, 3> rows;
    for (auto& row : rows) row.resize(b.size() + 1);
    for (std::size_t j = 0; j <= b.size(); ++j) rows[0][j] = j;
    for (std::size_t i = 1; i <= a.size(); ++i) {
        const auto& two = rows[(i + 1) % 3];
        const auto& one = rows[(i + 2) % 3];
        auto& here = rows[i % 3];
        here[0] = i;
        for (std::size_t j = 1; j <= b.size(); ++j) {
            const bool same = lower(a[i - 1]) == lower(b[j - 1]);
            here[j] = std::min({one[j] + 1, here[j - 1] + 1, one[j - 1] + (same ? 0 : 1)});
            const bool exchanged =
                i > 1 && j > 1 && lower(a[i - 1]) == lower(b[j - 2]) && lower(a[i - 2]) == lower(b[j - 1]);
            if (exchanged) here[j] = std::min(here[j], two[j - 2] + 1);
        }
    }
    return rows[a.size() % 3][b.size()];
}

std::string nearestName(std::string_view word, std::span<const std::string_view> candidates,
                        std::size_t prefix) {
    if (word.size() > kLongestWord) return {};
    const std::size_t allowed = allowedEdits(word.size() - std::min(prefix, word.size()));
    std::size_t best = allowed + 1;
    std::string_view nearest;
    for (const std::string_view candidate : candidates) {
        const std::size_t shorter = std::min(word.size(), candidate.size());
        if (std::max(word.size(), candidate.size()) - shorter > allowed || candidate == word) continue;
        const std::size_t distance = editDistance(word, candidate);
        if (distance < best) {
            best = distance;
            nearest = candidate;
        }
    }
    return std::string(nearest);
}

std::string suggestion(std::string_view word, std::span<const std::string_view> candidates,
                       std::size_t prefix) {
    const std::string nearest = nearestName(word, candidates, prefix);
    return nearest.empty() ? std::string() : "; did you mean '" + nearest + "'?";
}

}  // namespace glibra::base
