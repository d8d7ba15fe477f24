// The lists of a VertexArray, without GL: common vertices, and topologies that core profiles lack.

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include "classic/vertex_lists.h"

namespace glibra::classic {
namespace {

/// The rule, in quadratic time.
std::vector<std::uint32_t> byHand(const VertexLists& from, float tolerance, std::size_t& count) {
    std::vector<std::size_t> kept;
    std::vector<std::uint32_t> vertexOf;
    const auto value = [](const VertexColumn& column, std::size_t i, std::size_t c) {
        return static_cast<double>(column.values[i * static_cast<std::size_t>(column.components) + c]);
    };
    for (std::size_t i = 0; i < from.count(); ++i) {
        std::size_t found = 0;
        for (; found < kept.size(); ++found) {
            bool isSame = true;
            for (std::size_t k = 0; k < from.columns().size(); ++k)
                for (std::size_t c = 0; c < static_cast<std::size_t>(from.columns()[k].components); ++c) {
                    const double off =
                        std::abs(value(from.columns()[k], i, c) - value(from.columns()[k], kept[found], c));
                    isSame = isSame && off <= (k == 0 && c < 3 ? static_cast<double>(tolerance) : 0);
                }
            if (isSame) break;
        }
        if (found == kept.size()) kept.push_back(i);
        vertexOf.push_back(static_cast<std::uint32_t>(found));
    }
    count = kept.size();
    return vertexOf;
}

TEST(Collapse, IsTheRuleForRandomVertices) {
    std::mt19937 random(5);
    for (const float tolerance : {0.F, .01F, .1F, .5F, 3.F, 1e-9F})
        for (const int spread : {2, 5, 20})
            for (int trial = 0; trial < 8; ++trial) {
                VertexLists lists;
                for (int i = 0; i < 150; ++i) {
                    // Places on a lattice and near it, on both sides of 0; few colours.
                    const auto number = [&] {
                        const auto place = static_cast<float>(
                            static_cast<int>(random() % static_cast<unsigned>(spread)) - spread / 2);
                        const auto off = static_cast<float>(static_cast<int>(random() % 5) - 2);
                        return place * .25F + off * tolerance * (trial % 2 == 0 ? .5F : .6F);
                    };
                    const std::array<float, 4> place{number(), number(), number(),
                                                     trial > 5 ? static_cast<float>(random() % 2) : 1};
                    if (trial > 2) lists.setCurrent("aColor", {static_cast<float>(random() % 2), 0, 0, 1}, 3);
                    lists.add(place, trial > 5 ? 4 : 3);
                }
                std::size_t count = 0;
                const std::vector<std::uint32_t> expected = byHand(lists, tolerance, count);
                const Collapsed found = collapse(lists, tolerance);
                EXPECT_EQ(found.vertexOf, expected) << "tolerance " << tolerance << ", spread " << spread;
                EXPECT_EQ(found.count, count);
                for (const VertexColumn& each : found.columns)
                    EXPECT_EQ(each.values.size(), count * static_cast<std::size_t>(each.components));
            }
}

/// What would be compared with all others in a table of places alone, or of hashes that put them together.
TEST(Collapse, TakesLinearTimeWhateverTheVertices) {
    constexpr int kCount = GLIBRA_SANITIZED ? 20000 : 100000;
    const float nan = std::numeric_limits<float>::quiet_NaN();
    const float infinity = std::numeric_limits<float>::infinity();
    for (const float tolerance : {0.F, .1F})
        for (int kind = 0; kind < 5; ++kind) {
            VertexLists lists;
            for (int i = 0; i < kCount; ++i) {
                const auto number = static_cast<float>(i);
                if (kind == 0) lists.setCurrent("aColor", {number, 0, 0, 1}, 3);  // one place
                if (kind == 1) lists.setCurrent("aColor", {nan, 0, 0, 1}, 3);
                const float x = kind == 2 ? nan : kind == 3 ? infinity : kind == 4 ? number * 1e-4F : 0;
                lists.add({x, 0, 0, 1}, 3);
            }
            const Collapsed found = collapse(lists, tolerance);
            const auto count = static_cast<std::size_t>(kCount);
            const bool isLine = kind == 4 && tolerance > 0;
            EXPECT_EQ(found.count < count / 500, isLine) << kind;
            EXPECT_EQ(found.count == count, !isLine) << kind;
        }
}

TEST(Collapse, PlusAndMinusZeroAreTheSame) {
    VertexLists lists;
    lists.add({0.F, 0, 0, 1}, 3);
    lists.add({-0.F, 0, -0.F, 1}, 3);
    EXPECT_EQ(collapse(lists, 0).count, 1U);
}

TEST(VertexLists, AnAttributeThatBeginsLaterHasItsDefaultBefore) {
    VertexLists lists;
    lists.add({1, 2, 3, 1}, 3);
    lists.setCurrent("aColor", {.5F, 0, 0, 1}, 3);
    lists.add({4, 5, 6, 2}, 4);
    lists.setCurrent("aColor", {.25F, 0, 0, .75F}, 4);
    lists.add({7, 8, 9, 1}, 3);
    EXPECT_EQ(lists.columns()[0].values, (std::vector<float>{1, 2, 3, 1, 4, 5, 6, 2, 7, 8, 9, 1}));
    EXPECT_EQ(lists.columns()[1].values, (std::vector<float>{1, 1, 1, 1, .5F, 0, 0, 1, .25F, 0, 0, .75F}));
}

DrawnIndices drawn(unsigned int topology, std::size_t count, std::vector<std::size_t> restarts = {},
                   bool asPatches = false) {
    std::vector<std::uint32_t> same(count);
    for (std::size_t i = 0; i < count; ++i) same[i] = static_cast<std::uint32_t>(i);
    return drawnIndices({{.topology = topology,
                          .patchVertices = 4,
                          .first = 0,
                          .count = count,
                          .restarts = std::move(restarts)}},
                        same, asPatches);
}
using Indices = std::vector<std::uint32_t>;

TEST(DrawnIndices, QuadsAndPolygonsAreTriangles) {
    EXPECT_EQ(drawn(7, 8).indices, (Indices{0, 1, 2, 0, 2, 3, 4, 5, 6, 4, 6, 7}));
    EXPECT_EQ(drawn(8, 4).indices, (Indices{0, 1, 3, 0, 3, 2}));
    EXPECT_EQ(drawn(9, 5).indices, (Indices{0, 1, 2, 0, 2, 3, 0, 3, 4}));
    EXPECT_EQ(drawn(9, 6, {3}).indices, (Indices{0, 1, 2, 3, 4, 5}));
    for (const unsigned int each : {7U, 8U, 9U}) EXPECT_EQ(drawn(each, 8).lists[0].mode, 4U);
}

TEST(DrawnIndices, RestartsSeparatePrimitivesThatAreNotEmpty) {
    const DrawnIndices strip = drawn(3, 5, {0, 2, 2, 5});
    EXPECT_EQ(strip.indices, (Indices{0, 1, kRestart, 2, 3, 4}));
    EXPECT_EQ(strip.lists[0].mode, 3U);
    EXPECT_TRUE(strip.lists[0].hasRestarts);
}

TEST(DrawnIndices, EveryTopologyIsPatchesForProgramsThatTessellate) {
    struct Row {
        unsigned int topology;
        int patchVertices;
        std::size_t patches;  ///< of 12 vertices
    };
    for (const Row& each : {Row{0, 1, 12}, Row{1, 2, 6}, Row{2, 2, 12}, Row{3, 2, 11}, Row{4, 3, 4},
                            Row{5, 3, 10}, Row{6, 3, 10}, Row{7, 4, 3}, Row{8, 4, 5}, Row{9, 3, 10},
                            Row{10, 4, 3}, Row{11, 4, 9}, Row{12, 6, 2}, Row{13, 6, 4}, Row{14, 4, 3}}) {
        const DrawnIndices found = drawn(each.topology, 12, {}, true);
        EXPECT_EQ(found.lists[0].mode, 14U) << each.topology;
        EXPECT_EQ(found.lists[0].patchVertices, each.patchVertices) << each.topology;
        EXPECT_EQ(found.indices.size(), each.patches * static_cast<std::size_t>(each.patchVertices))
            << each.topology;
    }
    EXPECT_EQ(drawn(8, 4, {}, true).indices, (Indices{0, 1, 3, 2}));
    EXPECT_EQ(drawn(3, 5, {3}, true).indices, (Indices{0, 1, 1, 2, 3, 4}));
    EXPECT_FALSE(isTopology(15));
}

}  // namespace
}  // namespace glibra::classic
