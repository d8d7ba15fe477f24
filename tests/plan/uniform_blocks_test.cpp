#include "plan/uniform_blocks.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <cstring>

#include "by_hand.h"

namespace glibra::plan {
namespace {

template <class Number>
Number read(const std::vector<std::byte>& bytes, std::size_t offset) {
    Number value;
    std::memcpy(&value, bytes.data() + offset, sizeof value);
    return value;
}
ActiveUniform member(const char* word, int offset, int arrayStride = 0, int matrixStride = 0) {
    ActiveUniform result = test::uniform("m", word);
    result.block = 0;
    result.offset = offset;
    result.arrayStride = arrayStride;
    result.matrixStride = matrixStride;
    return result;
}

TEST(BlockMember, ScalarsHaveTheirTypesBytes) {
    std::vector<std::byte> bytes(32);
    writeMember(member("float", 0), 0, std::vector<double>{.1}, bytes);
    writeMember(member("int", 4), 0, std::vector<double>{-7}, bytes);
    writeMember(member("uint", 8), 0, std::vector<double>{4294967295.0}, bytes);
    writeMember(member("bool", 12), 0, std::vector<double>{1}, bytes);
    writeMember(member("double", 16), 0, std::vector<double>{.1}, bytes);
    EXPECT_EQ(read<float>(bytes, 0), .1F);
    EXPECT_EQ(read<std::int32_t>(bytes, 4), -7);
    EXPECT_EQ(read<std::uint32_t>(bytes, 8), 4294967295U);
    EXPECT_EQ(read<std::uint32_t>(bytes, 12), 1U);
    EXPECT_EQ(read<double>(bytes, 16), .1);
}
// OpenGL 4.6, 7.6.2.2: in std140 an array of vec3 has stride 16, a mat3's columns have stride 16.
TEST(BlockMember, ArrayElementsLieAStrideApart) {
    std::vector<std::byte> bytes(48);
    writeMember(member("vec3[3]", 0, 16), 1, std::vector<double>{1, 2, 3, 4, 5, 6}, bytes);
    EXPECT_EQ(read<float>(bytes, 0), 0);
    EXPECT_EQ(read<float>(bytes, 16), 1);
    EXPECT_EQ(read<float>(bytes, 24), 3);
    EXPECT_EQ(read<float>(bytes, 28), 0);
    EXPECT_EQ(read<float>(bytes, 32), 4);
}
TEST(BlockMember, MatrixColumnsLieAStrideApart) {
    std::vector<std::byte> bytes(64);
    const std::vector<double> columns{1, 2, 3, 4, 5, 6, 7, 8, 9};
    writeMember(member("mat3", 16, 0, 16), 0, columns, bytes);
    EXPECT_EQ(read<float>(bytes, 16), 1);
    EXPECT_EQ(read<float>(bytes, 20), 2);
    EXPECT_EQ(read<float>(bytes, 32), 4);
    EXPECT_EQ(read<float>(bytes, 56), 9);
}
TEST(BlockMember, RowMajorMatricesAreTransposed) {
    std::vector<std::byte> bytes(48);
    ActiveUniform matrix = member("mat3", 0, 0, 16);
    matrix.rowMajor = true;
    writeMember(matrix, 0, std::vector<double>{1, 2, 3, 4, 5, 6, 7, 8, 9}, bytes);
    EXPECT_EQ(read<float>(bytes, 0), 1);
    EXPECT_EQ(read<float>(bytes, 4), 4);
    EXPECT_EQ(read<float>(bytes, 16), 2);
    EXPECT_EQ(read<float>(bytes, 40), 9);
}
TEST(BlockMember, NeverWritesOutsideItsBlock) {
    std::vector<std::byte> bytes(32);
    const std::span<std::byte> block(bytes.data(), 8);
    writeMember(member("vec4", 4), 0, std::vector<double>{1, 2, 3, 4}, block);
    writeMember(member("vec4", 2000000000), 0, std::vector<double>{1}, block);
    writeMember(member("vec4", -4), 0, std::vector<double>{9}, block);
    writeMember(member("float[2]", 0, 4), 7, std::vector<double>{9}, block);
    EXPECT_EQ(read<float>(bytes, 0), 0);
    EXPECT_EQ(read<float>(bytes, 4), 1);
    for (std::size_t i = block.size(); i < bytes.size(); ++i) EXPECT_EQ(bytes[i], std::byte{0}) << i;
}
TEST(BlockContent, IsZeroWithItsLiteralsInIt) {
    ProgramInterface interface = test::interfaceWith({{"a", "float"}, {"b", "float"}, {"c", "float"}});
    interface.blocks = {{"A", 16}, {"B", 16}};
    for (int i = 0; i < 3; ++i) interface.uniforms[static_cast<std::size_t>(i)].block = i == 2 ? 1 : 0;
    interface.uniforms[1].offset = 4;
    const std::vector<UniformBinding> bindings{{UniformIndex(1), 0, Literal{{5}}},
                                               {UniformIndex(2), 0, Literal{{7}}}};
    const std::vector<std::byte> bytes = blockContent(interface, 0, bindings);
    ASSERT_EQ(bytes.size(), 16U);
    EXPECT_EQ(read<float>(bytes, 0), 0);
    EXPECT_EQ(read<float>(bytes, 4), 5);
}

}  // namespace
}  // namespace glibra::plan
