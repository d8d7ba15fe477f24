#include "suite/run/run_pieces.h"

#include <algorithm>

namespace glibra::suite {

std::vector<std::vector<std::size_t>> planPieces(std::size_t count, int workers,
                                                 const std::function<bool(std::size_t)>& joins) {
    // Guided self-scheduling (Polychronopoulos and Kuck, 1987): each piece is a share of what remains.
    constexpr std::size_t kLongest = 16;
    constexpr std::size_t kShares = 3;
    const std::size_t share = kShares * static_cast<std::size_t>(std::max(1, workers));
    const bool isShared = workers > 1;
    std::vector<std::vector<std::size_t>> pieces;
    for (std::size_t next = 0; next < count;) {
        const std::size_t size =
            isShared ? std::clamp<std::size_t>((count - next) / share, 1, kLongest) : count - next;
        std::vector<std::size_t>& piece = pieces.emplace_back();
        do piece.push_back(next++);
        while (next < count && piece.size() < size && joins(next));
    }
    return pieces;
}

}  // namespace glibra::suite
