#include "render/draw/work_share.h"

#include <algorithm>
#include <array>
#include <cstddef>

namespace glibra::render {
namespace {

/// Rows that are done first, and show how long the others take, at these parts of the height: what is slow
/// need not cover the picture.
constexpr std::array<int, 3> kProbes{1, 3, 5};  // sixths
constexpr int kRowsOfProbe = 128;               ///< as a part of the height
constexpr int kFewestRows = 16;                 ///< of a draw that is cut
constexpr int kMostParts = 64;                  ///< that a draw is cut into because of what each costs

}  // namespace

Shares doInShares(int rows, double share, const std::function<void(int first, int end)>& work,
                  const std::function<double()>& wait) {
    const auto whole = [&] {
        work(0, rows);
        return Shares{1, wait()};
    };
    if (rows < kFewestRows) return whole();
    work(0, 0);
    const double own = wait();
    if (own > share) return whole();  // what every part repeats is the longest of all
    const int height = std::max(1, rows / kRowsOfProbe);
    int done = 0;
    std::array<std::array<int, 2>, kProbes.size() + 1> gaps{};
    for (std::size_t i = 0; i < kProbes.size(); ++i) {
        const int first = rows * kProbes.at(i) / 6;
        work(first, first + height);
        gaps.at(i) = {done, first};
        done = first + height;
    }
    gaps.back() = {done, rows};
    Shares shares{static_cast<int>(kProbes.size()), wait()};
    // Of a row, as if one probe had taken all of the time.
    double slowest = std::max(0., shares.seconds - own) / height;
    const bool isQuick = slowest * rows < kQuickShare * share;
    const int fewest = own > share / kMostParts ? std::max(1, rows / kMostParts) : 1;
    for (const auto& [begin, end] : gaps)
        for (int first = begin; first < end; ++shares.parts) {
            const double fitting = isQuick || slowest <= 0 ? rows : share / slowest;
            const int count = std::max(1, static_cast<int>(std::clamp<double>(fitting, fewest, end - first)));
            work(first, first + count);
            first += count;
            if (isQuick) continue;
            const double taken = wait();
            shares.seconds += taken;
            slowest = std::max(slowest, (taken - own) / count);
        }
    if (isQuick) shares.seconds = slowest * rows + own;
    return shares;
}

}  // namespace glibra::render
