#include "plan/memory_pattern.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>

#include "by_hand.h"

namespace glibra::plan {
namespace {

base::StorageMember member(std::string name, const std::string& word, int offset, int size = 1,
                           int stride = 0, int outerSize = 1, int outerStride = 0) {
    base::StorageMember made;
    made.name = std::move(name);
    made.type = test::valueType(word);
    made.offset = offset;
    made.arraySize = size;
    made.arrayStride = stride;
    made.outerSize = outerSize;
    made.outerStride = outerStride;
    return made;
}

std::vector<std::uint64_t> offsets(const MemoryPattern& pattern, std::uint64_t count) {
    std::vector<std::uint64_t> found;
    for (std::uint64_t i = 0; i < count; ++i) found.push_back(pattern.at(i).offset);
    return found;
}

TEST(MemoryPattern, OfARuntimeSizedArrayRepeats) {
    const auto pattern = patternOf(base::StorageBlock{"B", 4, 0, {member("a[0]", "float", 0, 0, 4, 0, 4)}});
    ASSERT_TRUE(pattern);
    EXPECT_TRUE(pattern->isRuntimeSized());
    EXPECT_EQ(pattern->bytes(6), 24U);
    EXPECT_EQ(pattern->numbers(6), 6U);
    EXPECT_EQ(offsets(*pattern, 4), (std::vector<std::uint64_t>{0, 4, 8, 12}));
}

/// buffer B { uint count; Item items[]; } all; with struct Item { vec3 position; float weights[2]; };
base::StorageBlock itemBlock() {
    return {"B",
            48,
            0,
            {member("B.items[0].weights[0]", "float", 28, 2, 4, 0, 48),
             member("B.items[0].position", "vec3", 16, 1, 0, 0, 48), member("B.count", "uint", 0)}};
}

TEST(MemoryPattern, OfStructuresIsInTheOrderOfMemory) {
    const auto pattern = patternOf(itemBlock());
    ASSERT_TRUE(pattern);
    EXPECT_EQ(pattern->head.size(), 1U);
    EXPECT_EQ(pattern->element.size(), 5U);
    EXPECT_EQ(pattern->elementsAt, 16U);
    EXPECT_EQ(pattern->stride, 48U);
    EXPECT_EQ(pattern->bytes(3), 160U);
    EXPECT_EQ(offsets(*pattern, 8), (std::vector<std::uint64_t>{0, 16, 20, 24, 28, 32, 64, 68}));
    EXPECT_EQ(pattern->at(0).kind, NumberKind::unsignedInteger);
    EXPECT_EQ(pattern->at(1).kind, NumberKind::floating);
}

TEST(MemoryPattern, OfAnArrayInTheMiddleListsAllElements) {
    const auto pattern =
        patternOf(base::StorageBlock{"B",
                                     64,
                                     0,
                                     {member("a[0].x", "float", 0, 1, 0, 2, 8),
                                      member("a[0].y", "float", 4, 1, 0, 2, 8), member("last", "vec4", 16)}});
    ASSERT_TRUE(pattern);
    EXPECT_TRUE(pattern->element.empty());
    EXPECT_EQ(pattern->bytes(9), 64U);
    EXPECT_EQ(offsets(*pattern, 6), (std::vector<std::uint64_t>{0, 4, 8, 12, 16, 20}));
}

TEST(MemoryPattern, OfUniformBlocksKnowsStd140) {
    base::ActiveResources resources;
    resources.blocks.push_back({"Weights", 80, 0});
    ActiveUniform weights = test::uniform("w", "float[5]");
    weights.block = 0;
    weights.arrayStride = 16;
    weights.emittedName = "w";
    resources.uniforms.push_back(weights);
    const auto pattern = patternOf(resources, 0);
    ASSERT_TRUE(pattern);
    EXPECT_FALSE(pattern->isRuntimeSized());
    EXPECT_EQ(pattern->numbers(99), 5U);
    EXPECT_EQ(offsets(*pattern, 5), (std::vector<std::uint64_t>{0, 16, 32, 48, 64}));
}

TEST(MemoryPattern, OfTypesFollowsStd430) {
    const auto vectors = patternOf("vec3", {});
    ASSERT_TRUE(vectors);
    EXPECT_EQ(offsets(*vectors, 4), (std::vector<std::uint64_t>{0, 4, 8, 16}));
    const auto matrices = patternOf("mat3", {});
    ASSERT_TRUE(matrices);
    EXPECT_EQ(offsets(*matrices, 4), (std::vector<std::uint64_t>{0, 4, 8, 16}));
    EXPECT_EQ(matrices->stride, 48U);
    glsl::MemoryStructures structures;
    glsl::MemoryMember position, mass;
    position.name = "position";
    position.type = "vec3";
    mass.name = "mass";
    mass.type = "float";
    structures["Item"].members = {position, mass};
    const auto items = patternOf("Item", structures);
    ASSERT_TRUE(items);
    EXPECT_EQ(items->stride, 16U);
    EXPECT_EQ(offsets(*items, 5), (std::vector<std::uint64_t>{0, 4, 8, 12, 16}));
    EXPECT_FALSE(patternOf("Itm", structures));
    EXPECT_FALSE(patternOf("", structures));
}

TEST(MemoryPattern, DifferencesAreFoundInLaterElements) {
    const auto tight = patternOf(base::StorageBlock{"B", 4, 0, {member("a[0]", "float", 0, 0, 4, 0, 4)}});
    const auto vectors = patternOf(base::StorageBlock{"B", 16, 0, {member("a[0]", "vec4", 0, 0, 16, 0, 16)}});
    const auto triples = patternOf(base::StorageBlock{"B", 16, 0, {member("a[0]", "vec3", 0, 0, 16, 0, 16)}});
    const auto whole = patternOf(base::StorageBlock{"B", 4, 0, {member("a[0]", "int", 0, 0, 4, 0, 4)}});
    const auto natural = patternOf(base::StorageBlock{"B", 4, 0, {member("a[0]", "uint", 0, 0, 4, 0, 4)}});
    EXPECT_FALSE(firstDifference(*tight, *vectors, 1000));
    EXPECT_EQ(firstDifference(*tight, *triples, 1000), 3U);
    EXPECT_FALSE(firstDifference(*tight, *triples, 3));
    EXPECT_EQ(firstDifference(*tight, *whole, 1000), 0U);
    EXPECT_FALSE(firstDifference(*whole, *natural, 1000));
}

TEST(MemoryPattern, NumbersAreWrittenAndReadBack) {
    const MemoryPattern pattern = *patternOf(itemBlock());
    std::vector<std::byte> memory(pattern.bytes(2), std::byte{0xee});
    const std::vector<double> values{2, .1, -2, 3e300, 4, 5, 6};
    writeNumbers(pattern, 0, values, memory);
    for (std::uint64_t i = 0; i < values.size(); ++i)
        EXPECT_EQ(readNumber(pattern.at(i), memory),
                  i == 3 ? static_cast<double>(std::numeric_limits<float>::infinity())
                         : static_cast<double>(static_cast<float>(values[i])))
            << i;
    EXPECT_EQ(memory[4], std::byte{0xee});  // padding is not written
    writeNumbers(pattern, 0, std::vector<double>{-7}, memory);
    EXPECT_EQ(readNumber(pattern.at(0), memory), 0);
    writeNumbers(pattern, 9, values, memory);  // what lies outside is left out
    EXPECT_EQ(readNumber(pattern.at(9), memory), static_cast<double>(2));
}

}  // namespace
}  // namespace glibra::plan
