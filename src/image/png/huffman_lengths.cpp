#include "image/png/huffman_lengths.h"

#include <algorithm>
#include <numeric>
#include <vector>

namespace glibra::image {
namespace {

struct Leaf {
    std::uint32_t count = 0;
    std::size_t symbol = 0;
};

/// The depth of each leaf in a Huffman tree. The leaves are in rising order of their counts.
std::vector<unsigned> depthsOf(std::span<const Leaf> leaves) {
    // Nodes: the leaves, then the inner nodes in rising order of their sums (van Leeuwen's two queues, 1976).
    const std::size_t count = leaves.size();
    std::vector<std::uint64_t> sums;
    std::vector<std::size_t> parents(2 * count - 1);
    std::size_t leaf = 0, inner = 0;
    const auto takeLeast = [&]() -> std::uint64_t {
        const bool isLeaf = inner == sums.size() || (leaf < count && leaves[leaf].count <= sums[inner]);
        parents[isLeaf ? leaf : count + inner] = count + sums.size();
        return isLeaf ? leaves[leaf++].count : sums[inner++];
    };
    while (sums.size() + 1 < count) {
        const std::uint64_t first = takeLeast();
        sums.push_back(first + takeLeast());
    }
    std::vector<unsigned> depths(2 * count - 1, 0);
    for (std::size_t i = depths.size() - 1; i-- > 0;) depths[i] = depths[parents[i]] + 1;
    depths.resize(count);
    return depths;
}

}  // namespace

void chooseCodeLengths(std::span<const std::uint32_t> counts, unsigned most,
                       std::span<std::uint8_t> lengths) {
    std::vector<Leaf> leaves;
    for (std::size_t i = 0; i < counts.size(); ++i)
        if (counts[i] > 0) leaves.push_back({counts[i], i});
    std::ranges::stable_sort(leaves, {}, &Leaf::count);
    std::vector<unsigned> depths = depthsOf(leaves);
    // Halved counts differ less, so the tree becomes flatter; equal counts make it as flat as possible.
    while (std::ranges::max(depths) > most) {
        for (Leaf& each : leaves) each.count = each.count / 2 + 1;
        depths = depthsOf(leaves);
    }
    std::ranges::fill(lengths, std::uint8_t{0});
    for (std::size_t i = 0; i < leaves.size(); ++i)
        lengths[leaves[i].symbol] = static_cast<std::uint8_t>(depths[i]);
}

void assignCodes(std::span<const std::uint8_t> lengths, std::span<Code> codes) {
    std::array<unsigned, 16> next{};
    for (const std::uint8_t each : lengths) ++next[each];
    next[0] = 0;
    unsigned code = 0;
    for (unsigned& each : next) {
        const unsigned count = each;
        each = code;
        code = (code + count) << 1U;
    }
    for (std::size_t i = 0; i < lengths.size(); ++i) {
        const unsigned length = lengths[i];
        codes[i].length = static_cast<std::uint16_t>(length);
        if (length == 0) continue;
        unsigned forward = next.at(length)++, reversed = 0;
        for (unsigned bit = 0; bit < length; ++bit, forward >>= 1U)
            reversed = reversed << 1U | (forward & 1U);
        codes[i].bits = static_cast<std::uint16_t>(reversed);
    }
}

}  // namespace glibra::image
