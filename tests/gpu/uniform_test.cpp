#include "gpu/object/uniform.h"

#include <cmath>
#include <cstring>
#include <limits>
#include <numbers>

#include "base/number.h"
#include "fixture.h"
#include "gpu/context/call_counter.h"
#include "gpu/format/gl_names.h"
#include "gpu/object/buffer.h"

namespace glibra::gpu {
namespace {

class UniformTest : public test::GpuTest {
  protected:
    /// A program with `uniform TYPE u[4]`, all elements active.
    static std::optional<Program> withArrayOf(const std::string& type) {
        return build(test::kCoverAll, "#version 410 core\nuniform " + type +
                                          " u[4];\nuniform int uPick;\nout vec4 fColor;\n"
                                          "void main() { fColor = vec4(u[uPick] == " +
                                          type + "(1)); }");
    }
    static base::ActiveUniform find(const Program& program, std::string_view name) {
        for (const base::ActiveUniform& each : reflect(program).uniforms)
            if (each.name == name) return each;
        ADD_FAILURE() << "no uniform " << name;
        return {};
    }
};

constexpr std::array kNumericTypes{
    "float", "vec2",  "vec3",    "vec4",    "double",  "dvec2",   "dvec3",   "dvec4",  "int",    "ivec2",
    "ivec3", "ivec4", "uint",    "uvec2",   "uvec3",   "uvec4",   "bool",    "bvec2",  "bvec3",  "bvec4",
    "mat2",  "mat3",  "mat4",    "mat2x3",  "mat2x4",  "mat3x2",  "mat3x4",  "mat4x2", "mat4x3", "dmat2",
    "dmat3", "dmat4", "dmat2x3", "dmat2x4", "dmat3x2", "dmat3x4", "dmat4x2", "dmat4x3"};

TEST_F(UniformTest, EveryTypeReadsBackWhatWasSet) {
    for (const char* word : kNumericTypes) {
        const auto program = withArrayOf(word);
        ASSERT_TRUE(program) << word;
        const base::ActiveUniform uniform = find(*program, "u");
        ASSERT_EQ(uniform.type.word, word);
        const auto components = static_cast<std::size_t>(uniform.type.components());
        std::vector<double> values;
        for (std::size_t i = 0; i < 4 * components; ++i) {
            // Not representable in float, so that single and double precision differ.
            const double fraction = 1 + static_cast<double>(i) + 1. / 3;
            const bool isWhole = uniform.type.base == base::BaseType::integer ||
                                 uniform.type.base == base::BaseType::unsignedInteger;
            values.push_back(uniform.type.base == base::BaseType::boolean ? static_cast<double>(i % 2)
                             : isWhole                                    ? static_cast<double>(i + 1)
                                                                          : fraction);
        }
        EXPECT_EQ(setUniform(*program, uniform, values), 4) << word;
        for (int element = 0; element < 4; ++element) {
            const std::vector<double> read = getUniform(*program, uniform, element);
            ASSERT_EQ(read.size(), components);
            for (std::size_t c = 0; c < components; ++c) {
                double expected = values[static_cast<std::size_t>(element) * components + c];
                if (uniform.type.base == base::BaseType::floating)
                    expected = static_cast<double>(static_cast<float>(expected));
                EXPECT_EQ(read[c], expected) << word << " element " << element << " component " << c;
            }
        }
    }
}

TEST_F(UniformTest, MatricesAreTakenColumnByColumn) {
    const auto program = build(test::kCoverAll, R"(#version 410 core
uniform mat2x3 uMatrix;
out vec4 fColor;
void main() { fColor = vec4(uMatrix[0][0], uMatrix[0][2], uMatrix[1][0], uMatrix[1][1]); }
)");
    ASSERT_TRUE(program);
    const std::array<double, 6> values{1, 2, 3, 4, 5, 6};
    EXPECT_EQ(setUniform(*program, find(*program, "uMatrix"), values), 1);
    EXPECT_EQ(shade(*program).at(0), (test::Rgba{1, 3, 4, 5}));
}

TEST_F(UniformTest, ElementsCanBeSetFromAnyPlaceOn) {
    const auto program = withArrayOf("vec2");
    ASSERT_TRUE(program);
    const base::ActiveUniform uniform = find(*program, "u");
    const std::array<double, 8> all{1, 2, 3, 4, 5, 6, 7, 8};
    setUniform(*program, uniform, all);
    const std::array<double, 3> part{20, 30, 40};
    EXPECT_EQ(setUniform(*program, uniform, part, 2), 1) << "the incomplete element is left out";
    EXPECT_EQ(getUniform(*program, uniform, 1), (std::vector<double>{3, 4}));
    EXPECT_EQ(getUniform(*program, uniform, 2), (std::vector<double>{20, 30}));
    EXPECT_EQ(getUniform(*program, uniform, 3), (std::vector<double>{7, 8}));
    EXPECT_EQ(setUniform(*program, uniform, all, 3), 1) << "elements beyond the array are left out";
    EXPECT_EQ(setUniform(*program, uniform, all, 4), 0);
    EXPECT_EQ(setUniform(*program, uniform, all, -1), 0);
    EXPECT_EQ(setUniform(*program, uniform, {}), 0);
    EXPECT_TRUE(getUniform(*program, uniform, 4).empty());
}

TEST_F(UniformTest, EqualValuesAreUploadedOnce) {
    const auto program = withArrayOf("float");
    ASSERT_TRUE(program);
    const base::ActiveUniform uniform = find(*program, "u");
    const std::array four{1., 2., 3., 4.};
    const auto uploads = [&](std::span<const double> values, int first) {
        const CallCounter counter;
        setUniform(*program, uniform, values, first);
        return counter.counts().calls;
    };
    EXPECT_EQ(uploads(four, 0), 1U);
    EXPECT_EQ(uploads(four, 0), 0U);
    EXPECT_EQ(uploads(std::array{3.}, 2), 0U) << "element 2 holds it already";
    EXPECT_EQ(uploads(std::array{9.}, 2), 1U);
    EXPECT_EQ(uploads(four, 0), 1U);
    EXPECT_EQ(getUniform(*program, uniform, 2), std::vector{3.});
}

TEST_F(UniformTest, SamplersTakeTheirUnit) {
    const auto program = build(test::kCoverAll, R"(#version 410 core
uniform sampler2D uPictures[2];
out vec4 fColor;
void main() { fColor = texture(uPictures[0], vec2(0)) + texture(uPictures[1], vec2(0)); }
)");
    ASSERT_TRUE(program);
    const base::ActiveUniform pictures = find(*program, "uPictures");
    const std::array<double, 2> units{3, 7};
    EXPECT_EQ(setUniform(*program, pictures, units), 2);
    EXPECT_EQ(getUniform(*program, pictures, 0), (std::vector<double>{3}));
    EXPECT_EQ(getUniform(*program, pictures, 1), (std::vector<double>{7}));
}

TEST_F(UniformTest, IntegersAreCutAndLimited) {
    const auto program = withArrayOf("int");
    ASSERT_TRUE(program);
    const base::ActiveUniform uniform = find(*program, "u");
    const std::array<double, 4> wild{-2.9, 1e300, -1e300, std::nan("")};
    setUniform(*program, uniform, wild);
    EXPECT_EQ(getUniform(*program, uniform, 0).at(0), -2);
    EXPECT_EQ(getUniform(*program, uniform, 1).at(0), 2147483647);
    EXPECT_EQ(getUniform(*program, uniform, 2).at(0), -2147483648.);
    EXPECT_EQ(getUniform(*program, uniform, 3).at(0), 0);
}

TEST_F(UniformTest, MembersOfABlockAreReadAsWritten) {
    const auto program = build(test::kCoverAll, R"(#version 410 core
layout(std140) uniform Paint {
    float uStrength;
    vec3 uTint;
    int uSteps[3];
    mat2x3 uTurn;
    layout(row_major) mat3x2 uRows;
    bool uOn;
    double uFine;
    uint uCount;
};
uniform int uWhich;
out vec4 fColor;
void main() {
    if (uWhich == 0) fColor = vec4(uStrength, uTint);
    else if (uWhich == 1) fColor = vec4(uSteps[0], uSteps[1], uSteps[2], uOn);
    else if (uWhich == 2) fColor = vec4(uTurn[0], uTurn[1].z);
    else if (uWhich == 3) fColor = vec4(uRows[0], uRows[2]);
    else fColor = vec4(float(uFine), uCount, uTurn[1].xy);
}
)");
    ASSERT_TRUE(program);
    const base::ActiveResources interface = reflect(*program);
    ASSERT_EQ(interface.blocks.size(), 1U);
    std::vector<std::byte> memory(static_cast<std::size_t>(interface.blocks[0].bytes));
    const auto write = [&](std::string_view name, const std::vector<double>& values) {
        EXPECT_GT(writeBlockMember(memory, find(*program, name), values), 0) << name;
    };
    write("uStrength", {.5});
    write("uTint", {1, 2, 3});
    write("uSteps", {-4, 5, 6});
    write("uTurn", {11, 12, 13, 14, 15, 16});
    write("uRows", {21, 22, 23, 24, 25, 26});
    write("uOn", {7});
    write("uFine", {1. / 3});
    write("uCount", {4e9});

    const auto buffer = Buffer::create(memory);
    ASSERT_TRUE(buffer);
    buffer->bindBase(GL_UNIFORM_BUFFER, 2);
    glUniformBlockBinding(program->id(), interface.blocks[0].index, 2);
    const auto look = [&](double which) {
        const std::array<double, 1> value{which};
        setUniform(*program, find(*program, "uWhich"), value);
        return shade(*program).at(0);
    };
    EXPECT_EQ(look(0), (test::Rgba{.5F, 1, 2, 3}));
    EXPECT_EQ(look(1), (test::Rgba{-4, 5, 6, 1}));
    EXPECT_EQ(look(2), (test::Rgba{11, 12, 13, 16}));
    EXPECT_EQ(look(3), (test::Rgba{21, 22, 25, 26}));
    EXPECT_EQ(look(4), (test::Rgba{1.F / 3, 4e9F, 14, 15}));
}

TEST_F(UniformTest, NothingIsWrittenOutsideABlocksMemory) {
    base::ActiveUniform member;
    member.type = valueType(GL_FLOAT_VEC4);
    member.block = 0;
    member.offset = 8;
    std::array<std::byte, 24> memory{};
    memory.fill(std::byte{0x5a});
    const std::array<double, 4> values{1, 2, 3, 4};
    writeBlockMember(std::span(memory).first(16), member, values);
    for (std::size_t i = 16; i < memory.size(); ++i) EXPECT_EQ(memory[i], std::byte{0x5a});
    float second = 0;
    std::memcpy(&second, &memory[12], 4);
    EXPECT_EQ(second, 2.F);
}

TEST(Numbers, FloatsRoundLikeTheHardware) {
    const double largest = static_cast<double>(std::numeric_limits<float>::max());
    EXPECT_EQ(base::toFloat(1. / 3), 1.F / 3);
    EXPECT_EQ(base::toFloat(largest), std::numeric_limits<float>::max());
    EXPECT_EQ(base::toFloat(largest * (1 + 0x1p-26)), std::numeric_limits<float>::max());
    EXPECT_EQ(base::toFloat(largest * (1 + 0x1p-24)), std::numeric_limits<float>::infinity());
    EXPECT_EQ(base::toFloat(-1e300), -std::numeric_limits<float>::infinity());
    EXPECT_TRUE(std::isnan(base::toFloat(std::nan(""))));
}

TEST(Numbers, UnsignedNumbersAreNeverNegative) {
    EXPECT_EQ(base::toUnsigned(-1), 0U);
    EXPECT_EQ(base::toUnsigned(std::nan("")), 0U);
    EXPECT_EQ(base::toUnsigned(3.99), 3U);
    EXPECT_EQ(base::toUnsigned(1e10), std::numeric_limits<std::uint32_t>::max());
}

}  // namespace
}  // namespace glibra::gpu
