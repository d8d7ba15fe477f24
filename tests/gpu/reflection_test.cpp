#include "gpu/object/uniform.h"

#include <fmt/format.h>

#include <algorithm>

#include "fixture.h"
#include "gpu/format/gl_names.h"

namespace glibra::gpu {
namespace {

class ReflectionTest : public test::GpuTest {
  protected:
    /// Reflects a program whose vertex stage covers everything.
    static std::optional<base::ActiveResources> reflectFragment(const std::string& fragment) {
        const auto program = build(test::kCoverAll, fragment);
        if (!program) return std::nullopt;
        return reflect(*program);
    }
    static const base::ActiveUniform* uniform(const base::ActiveResources& interface, std::string_view name) {
        const auto found =
            std::find_if(interface.uniforms.begin(), interface.uniforms.end(),
                         [name](const base::ActiveUniform& each) { return each.name == name; });
        return found == interface.uniforms.end() ? nullptr : &*found;
    }
};

TEST_F(ReflectionTest, ArraysAreOneUniformWithoutSubscript) {
    const auto interface = reflectFragment(R"(#version 410 core
uniform float uWeights[7];
uniform vec3 uOne[1];
uniform mat2 uTurn;
uniform int uPick;
uniform float uUnused;
out vec4 fColor;
void main() { fColor = vec4(uTurn * uOne[0].xy, uWeights[uPick], 1); }
)");
    ASSERT_TRUE(interface);
    EXPECT_EQ(interface->uniforms.size(), 4U);
    const base::ActiveUniform* weights = uniform(*interface, "uWeights");
    ASSERT_TRUE(weights);
    EXPECT_TRUE(weights->isArray);
    EXPECT_EQ(weights->arraySize, 7);
    EXPECT_EQ(weights->type.word, "float");
    EXPECT_GE(weights->location, 0);
    EXPECT_EQ(weights->block, -1);
    const base::ActiveUniform* one = uniform(*interface, "uOne");
    ASSERT_TRUE(one);
    EXPECT_TRUE(one->isArray);
    EXPECT_EQ(one->arraySize, 1);
    const base::ActiveUniform* turn = uniform(*interface, "uTurn");
    ASSERT_TRUE(turn);
    EXPECT_FALSE(turn->isArray);
    EXPECT_EQ(turn->type.word, "mat2");
    EXPECT_FALSE(uniform(*interface, "uUnused"));
}

TEST_F(ReflectionTest, ArrayElementsHaveLocationsInARow) {
    const auto program = build(test::kCoverAll, R"(#version 410 core
uniform vec4 uList[5];
uniform int uPick;
out vec4 fColor;
void main() { fColor = uList[uPick]; }
)");
    ASSERT_TRUE(program);
    const base::ActiveResources interface = reflect(*program);
    const base::ActiveUniform* list = uniform(interface, "uList");
    ASSERT_TRUE(list);
    for (int i = 0; i < 5; ++i)
        EXPECT_EQ(glGetUniformLocation(program->id(), ("uList[" + std::to_string(i) + "]").c_str()),
                  list->location + i);
}

TEST_F(ReflectionTest, MembersOfStructuresAreUniformsOfTheirOwn) {
    const auto interface = reflectFragment(R"(#version 410 core
struct Light { vec3 position; float powers[2]; };
uniform Light uLights[2];
uniform Light uSun;
uniform int uPick;
out vec4 fColor;
void main() {
    fColor = vec4(uLights[0].position + uLights[1].position + uSun.position, uLights[1].powers[uPick]);
}
)");
    ASSERT_TRUE(interface);
    for (const char* name : {"uLights[0].position", "uLights[1].position", "uSun.position"}) {
        const base::ActiveUniform* member = uniform(*interface, name);
        ASSERT_TRUE(member) << name;
        EXPECT_EQ(member->type.word, "vec3");
        EXPECT_FALSE(member->isArray);
    }
    const base::ActiveUniform* powers = uniform(*interface, "uLights[1].powers");
    ASSERT_TRUE(powers);
    EXPECT_TRUE(powers->isArray);
    EXPECT_EQ(powers->arraySize, 2);
}

TEST_F(ReflectionTest, BlocksHaveTheLayoutOfStd140) {
    const auto interface = reflectFragment(R"(#version 410 core
layout(std140) uniform Paint {
    float uStrength;
    vec3 uTint;
    float uSteps[3];
    mat3 uTurn;
    layout(row_major) mat2x4 uRows;
    bool uOn;
};
out vec4 fColor;
void main() {
    fColor = vec4(uTurn * uTint * uStrength, uOn ? uSteps[2] + uSteps[1] + uSteps[0] : 0.) + uRows[1];
}
)");
    ASSERT_TRUE(interface);
    ASSERT_EQ(interface->blocks.size(), 1U);
    EXPECT_EQ(interface->blocks[0].name, "Paint");
    struct Expected {
        const char* name;
        int offset, arrayStride, matrixStride;
        bool rowMajor;
    };
    // OpenGL 4.1 specification, section 2.11.4, "Standard Uniform Block Layout".
    for (const Expected& each : {Expected{"uStrength", 0, 0, 0, false}, Expected{"uTint", 16, 0, 0, false},
                                 Expected{"uSteps", 32, 16, 0, false}, Expected{"uTurn", 80, 0, 16, false},
                                 Expected{"uRows", 128, 0, 16, true}, Expected{"uOn", 192, 0, 0, false}}) {
        const base::ActiveUniform* member = uniform(*interface, each.name);
        ASSERT_TRUE(member) << each.name;
        EXPECT_EQ(member->block, 0) << each.name;
        EXPECT_EQ(member->location, -1) << each.name;
        EXPECT_EQ(member->offset, each.offset) << each.name;
        EXPECT_EQ(member->matrixStride, each.matrixStride) << each.name;
        EXPECT_EQ(member->rowMajor, each.rowMajor) << each.name;
        if (each.arrayStride != 0) {
            EXPECT_EQ(member->arrayStride, each.arrayStride) << each.name;
        }
    }
    EXPECT_GE(interface->blocks[0].bytes, 196);
}

TEST_F(ReflectionTest, ArraysOfBlocksAreBlocksOfTheirOwn) {
    const auto interface = reflectFragment(R"(#version 410 core
layout(std140) uniform Light { vec4 color; } uLights[2];
out vec4 fColor;
void main() { fColor = uLights[0].color + uLights[1].color; }
)");
    ASSERT_TRUE(interface);
    ASSERT_EQ(interface->blocks.size(), 2U);
    EXPECT_EQ(interface->blocks[0].name, "Light[0]");
    EXPECT_EQ(interface->blocks[1].name, "Light[1]");
}

TEST_F(ReflectionTest, InputsAreThoseThatTheVertexStageReads) {
    const auto program = build(R"(#version 410 core
in vec3 aPosition;
in vec2 aUnused;
in int aKind;
in mat3 aFrame;
in dvec2 aFine;
void main() {
    gl_Position = vec4(aFrame * aPosition, 1) * float(aKind + gl_VertexID) + float(aFine.y);
}
)",
                               "#version 410 core\nout vec4 fColor;\nvoid main() { fColor = vec4(1); }");
    ASSERT_TRUE(program);
    const base::ActiveResources interface = reflect(*program);
    std::vector<std::string> seen;
    for (const base::ActiveInput& each : interface.inputs) {
        seen.push_back(each.name + " " + std::string(each.type.word));
        EXPECT_EQ(each.location, glGetAttribLocation(program->id(), each.name.c_str()));
        EXPECT_EQ(each.arraySize, 1);
    }
    std::sort(seen.begin(), seen.end());
    EXPECT_EQ(seen, (std::vector<std::string>{"aFine dvec2", "aFrame mat3", "aKind int", "aPosition vec3"}));
}

TEST_F(ReflectionTest, SamplersAndTheirArraysSayWhatTheyRead) {
    const auto interface = reflectFragment(R"(#version 410 core
uniform sampler2D uPictures[3];
uniform samplerCube uSky;
out vec4 fColor;
void main() {
    fColor = texture(uPictures[0], vec2(0)) + texture(uPictures[2], vec2(0)) + texture(uSky, vec3(1));
}
)");
    ASSERT_TRUE(interface);
    const base::ActiveUniform* pictures = uniform(*interface, "uPictures");
    ASSERT_TRUE(pictures);
    EXPECT_EQ(pictures->arraySize, 3);
    EXPECT_EQ(pictures->emittedName, pictures->name);
    EXPECT_TRUE(pictures->type.isOpaque());
    EXPECT_EQ(pictures->type.target, base::TextureTarget::texture2D);
    const base::ActiveUniform* sky = uniform(*interface, "uSky");
    ASSERT_TRUE(sky);
    EXPECT_EQ(sky->type.target, base::TextureTarget::cube);
}

/// Compiles a program per GLSL type, so that the table must agree with the driver on number and word.
TEST_F(ReflectionTest, EveryNumericTypeIsKnownByItsWord) {
    for (const char* word :
         {"float",   "vec2",    "vec3",    "vec4",    "double",  "dvec2",  "dvec3", "dvec4",
          "int",     "ivec2",   "ivec3",   "ivec4",   "uint",    "uvec2",  "uvec3", "uvec4",
          "bool",    "bvec2",   "bvec3",   "bvec4",   "mat2",    "mat3",   "mat4",  "mat2x3",
          "mat2x4",  "mat3x2",  "mat3x4",  "mat4x2",  "mat4x3",  "dmat2",  "dmat3", "dmat4",
          "dmat2x3", "dmat2x4", "dmat3x2", "dmat3x4", "dmat4x2", "dmat4x3"}) {
        const std::string type = word;
        const auto interface =
            reflectFragment(fmt::format("#version 410 core\nuniform {0} u;\nout vec4 fColor;\n"
                                        "void main() {{ fColor = vec4(u == {0}(1)); }}",
                                        type));
        ASSERT_TRUE(interface) << word;
        ASSERT_EQ(interface->uniforms.size(), 1U) << word;
        EXPECT_EQ(interface->uniforms[0].type.word, type);
    }
}

TEST_F(ReflectionTest, EverySamplerTypeIsKnownByItsWord) {
    for (const std::string prefix : {"", "i", "u"})
        for (const std::string shape :
             {"1D", "2D", "3D", "Cube", "1DArray", "2DArray", "CubeArray", "2DRect", "Buffer", "2DMS",
              "2DMSArray", "1DShadow", "2DShadow", "CubeShadow", "1DArrayShadow", "2DArrayShadow",
              "CubeArrayShadow", "2DRectShadow"}) {
            if (!prefix.empty() && shape.ends_with("Shadow")) continue;
            const std::string type = fmt::format("{}sampler{}", prefix, shape);
            const bool hasLevels = shape.find("Rect") == std::string::npos && shape != "Buffer" &&
                                   shape.find("MS") == std::string::npos;
            const bool oneSize = shape == "1D" || shape == "1DShadow" || shape == "Buffer";
            const std::string size =
                std::string("textureSize(u") + (hasLevels ? ", 0)" : ")") + (oneSize ? "" : ".x");
            const auto interface = reflectFragment(
                fmt::format("#version 410 core\n#extension GL_ARB_texture_cube_map_array : enable\n"
                            "uniform {} u;\nout vec4 fColor;\nvoid main() {{ fColor = vec4({}); }}",
                            type, size));
            ASSERT_TRUE(interface) << type;
            ASSERT_EQ(interface->uniforms.size(), 1U) << type;
            EXPECT_EQ(interface->uniforms[0].type.word, type);
            const std::string plain = shape.substr(0, shape.find("Shadow"));
            const bool isFillable = plain == "1D" || plain == "2D" || plain == "3D" || plain == "Cube";
            EXPECT_EQ(interface->uniforms[0].type.target.has_value(), isFillable) << type;
        }
}

TEST_F(ReflectionTest, EveryImageTypeIsKnownByItsWord) {
    if (driver().glslVersion < 430) GTEST_SKIP() << "images came with GLSL 4.20, their sizes with 4.30";
    for (const std::string prefix : {"", "i", "u"})
        for (const std::string shape : {"1D", "2D", "3D", "Cube", "1DArray", "2DArray", "CubeArray", "2DRect",
                                        "Buffer", "2DMS", "2DMSArray"}) {
            const std::string type = fmt::format("{}image{}", prefix, shape);
            const std::string format = prefix.empty() ? "rgba32f" : prefix == "i" ? "rgba32i" : "rgba32ui";
            const bool oneSize = shape == "1D" || shape == "Buffer";
            const auto interface =
                reflectFragment(fmt::format("#version 430 core\nlayout({}) uniform {} u;\nout vec4 fColor;\n"
                                            "void main() {{ fColor = vec4(imageSize(u){}); }}",
                                            format, type, oneSize ? "" : ".x"));
            ASSERT_TRUE(interface) << type;
            ASSERT_EQ(interface->uniforms.size(), 1U) << type;
            EXPECT_EQ(interface->uniforms[0].type.word, type);
            EXPECT_EQ(interface->uniforms[0].type.base, base::BaseType::image);
        }
}

TEST(ValueTypes, AnUnknownNumberHasNoWord) {
    EXPECT_TRUE(valueType(1).word.empty());
    EXPECT_EQ(valueType(1).base, base::BaseType::other);
    EXPECT_EQ(valueType(GL_FLOAT_MAT4x3).columns, 4);
    EXPECT_EQ(valueType(GL_FLOAT_MAT4x3).rows, 3);
}

TEST_F(ReflectionTest, StorageBlocksHaveTheLayoutOfTheDriver) {
    if (!driver().compute) GTEST_SKIP() << "needs GL 4.3";
    const auto interface = reflectFragment(R"(#version 430 core
struct Item { vec3 position; float weights[2]; };
layout(std430) buffer Items { uint count; Item items[]; } all;
layout(std430) readonly buffer Plain { float plain[]; };
layout(binding = 2, offset = 4) uniform atomic_uint uCount;
out vec4 fColor;
void main() {
    atomicCounterIncrement(uCount);
    fColor = vec4(all.items[all.count].position, all.items[1].weights[1] + plain[2]);
}
)");
    ASSERT_TRUE(interface);
    ASSERT_EQ(interface->storageBlocks.size(), 2U);
    const bool isFirst = interface->storageBlocks[0].name == "Items";
    const base::StorageBlock& items = interface->storageBlocks[isFirst ? 0 : 1];
    const base::StorageBlock& plain = interface->storageBlocks[isFirst ? 1 : 0];
    EXPECT_EQ(items.name, "Items");
    ASSERT_EQ(items.members.size(), 3U);
    for (const base::StorageMember& each : items.members) {
        SCOPED_TRACE(each.name);
        if (each.name == "Items.count") {
            EXPECT_EQ(each.offset, 0);
            EXPECT_EQ(each.outerSize, 1);
        } else if (each.name == "Items.items[0].position") {
            EXPECT_EQ(each.offset, 16);
            EXPECT_EQ(each.outerSize, 0);
            EXPECT_EQ(each.outerStride, 32);
            EXPECT_EQ(each.type.word, "vec3");
        } else {
            EXPECT_EQ(each.name, "Items.items[0].weights[0]");
            EXPECT_EQ(each.offset, 28);
            EXPECT_EQ(each.arraySize, 2);
            EXPECT_EQ(each.arrayStride, 4);
        }
    }
    ASSERT_EQ(plain.members.size(), 1U);
    EXPECT_EQ(plain.members[0].name, "plain[0]");
    EXPECT_EQ(plain.members[0].arraySize, 0);
    EXPECT_EQ(plain.members[0].arrayStride, 4);
    ASSERT_EQ(interface->counterBuffers.size(), 1U);
    EXPECT_EQ(interface->counterBuffers[0].binding, 2);
    EXPECT_GE(interface->counterBuffers[0].bytes, 8);
    EXPECT_EQ(interface->counterBuffers[0].counters, std::vector<std::string>{"uCount"});
    EXPECT_TRUE(interface->uniforms.empty());
}

}  // namespace
}  // namespace glibra::gpu
