#include "plan/near_name.h"

#include <algorithm>
#include <array>
#include <cstddef>

namespace glibra::plan {
namespace {

constexpr std::size_t kLongestName = 128;

char lower(char letter) {
    return letter >= 'A' && letter <= 'Z' ? static_cast<char>(letter - 'A' + 'a') : letter;
}

/// Optimal string alignment: insertions, deletions, replacements and exchanges of neighbours cost 1 each.
int editDistance(std::string_view a, std::string_view b) {
    std::array<std::array<int, kLongestName + 1>, 3> rows{};
    const auto row = [&](std::size_t i) -> std::array<int, kLongestName + 1>& { return rows.at(i % 3); };
    for (std::size_t j = 0; j <= b.size(); ++j) row(0).at(j) = static_cast<int>(j);
    for (std::size_t i = 1; i <= a.size(); ++i) {
        row(i).at(0) = static_cast<int>(i);
        for (std::size_t j = 1; j <= b.size(); ++j) {
            const bool same = lower(a[i - 1]) == lower(b[j - 1]);
            int best =
                std::min({row(i - 1).at(j) + 1, row(i).at(j - 1) + 1, row(i - 1).at(j - 1) + (same ? 0 : 1)});
            if (i > 1 && j > 1 && lower(a[i - 1]) == lower(b[j - 2]) && lower(a[i - 2]) == lower(b[j - 1]))
                best = std::min(best, row(i - 2).at(j - 2) + 1);
            row(i).at(j) = best;
        }
    }
    return row(a.size()).at(b.size());
}

int allowedEdits(std::size_t letters) {
    if (letters <= 3) return 0;
    if (letters <= 6) return 1;
    return letters <= 10 ? 2 : 3;
}

}  // namespace

std::string nearestName(std::string_view wanted, std::span<const std::string> candidates) {
    if (wanted.size() > kLongestName) return {};
    int best = allowedEdits(wanted.size()) + 1;
    std::string nearest;
    for (const std::string& candidate : candidates) {
        if (candidate.size() > kLongestName || candidate == wanted) continue;
        const int distance = editDistance(wanted, candidate);
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
