// Images, blocks and structures as facts, and where the members of blocks lie.

#include <gtest/gtest.h>

#include <optional>
#include <random>
#include <regex>

#include "glsl/facts/block_layout.h"
#include "support.h"

namespace glibra::glsl::test {
namespace {

TranslatedProgram translateStored(std::vector<std::pair<Stage, std::string>> stages) {
    ProgramRequest request = program(std::move(stages));
    request.acceptsStorage = true;
    return translate(request);
}

MemoryFacts memoryFactsOf(const std::string& declarations) {
    TranslatedProgram translated =
        translateStages({{Stage::compute, "#version 450\nlayout(local_size_x = 1) in;\n" + declarations +
                                              "\nvoid main() { }\n"}});
    EXPECT_EQ("", ids(translated.diagnostics));
    EXPECT_EQ("", glslangErrors(translated));
    return std::move(translated.memory);
}

MemoryLayout layoutOfFirst(const MemoryFacts& facts) {
    const Result<MemoryLayout> layout = layoutOf(facts.blocks.at(0), facts.structures);
    for (const Diagnostic& each : layout.diagnostics) ADD_FAILURE() << toString(each);
    return layout.value.value_or(MemoryLayout{});
}

std::string problemOf(const MemoryFacts& facts) {
    const Result<MemoryLayout> layout = layoutOf(facts.blocks.at(0), facts.structures);
    return layout.diagnostics.empty() ? std::string() : layout.diagnostics.front().text;
}

const MemoryField& field(const MemoryLayout& layout, std::string_view path) {
    static const MemoryField kNone;
    for (const MemoryField& each : layout.fields)
        if (each.path == path) return each;
    ADD_FAILURE() << "no field " << path;
    return kNone;
}

struct Wanted {
    const char* path;
    long long offset;
    std::vector<long long> strides = {};
    long long matrixStride = 0;
};

void expectLayout(const MemoryLayout& layout, const std::vector<Wanted>& wanted) {
    EXPECT_EQ(wanted.size(), layout.fields.size());
    for (const Wanted& each : wanted) {
        const MemoryField& found = field(layout, each.path);
        EXPECT_EQ(each.offset, found.offset) << each.path;
        EXPECT_EQ(each.matrixStride, found.matrixStride) << each.path;
        std::vector<long long> strides;
        for (const MemoryArray& array : found.arrays) strides.push_back(array.stride);
        EXPECT_EQ(each.strides, strides) << each.path;
    }
}

// The example of OpenGL 4.6 Core, 7.6.2.2, with names for its two structures.
TEST(BlockLayout, Std140ExampleOfTheSpecification) {
    const MemoryLayout layout = layoutOfFirst(memoryFactsOf(R"(
struct F { int d; bvec2 e; };
struct O { uvec3 j; vec2 k; float l[2]; vec2 m; mat3 n[2]; };
layout(std140) uniform Example {
    float a;
    vec2 b;
    vec3 c;
    F f;
    float g;
    float h[2];
    mat2x3 i;
    O o[2];
};)"));
    expectLayout(layout, {{"a", 0},
                          {"b", 8},
                          {"c", 16},
                          {"f.d", 32},
                          {"f.e", 40},
                          {"g", 48},
                          {"h[]", 64, {16}},
                          {"i", 96, {}, 16},
                          {"o[].j", 128, {176}},
                          {"o[].k", 144, {176}},
                          {"o[].l[]", 160, {176, 16}},
                          {"o[].m", 192, {176}},
                          {"o[].n[]", 208, {176, 48}, 16}});
    EXPECT_EQ(480, layout.size);
    EXPECT_EQ(0, layout.stride);
    EXPECT_EQ("uint", field(layout, "o[].j").scalar);
    EXPECT_EQ(3, field(layout, "o[].j").components);
    EXPECT_EQ("bool", field(layout, "f.e").scalar);
    EXPECT_EQ(2, field(layout, "i").columns);
    EXPECT_EQ(3, field(layout, "i").components);
    EXPECT_EQ(2, field(layout, "o[].l[]").arrays.at(1).count);
}

TEST(BlockLayout, Std430ByHand) {
    const MemoryLayout layout = layoutOfFirst(memoryFactsOf(R"(
struct S { vec3 v; };
struct T { float x, y, z; };
layout(std430) buffer B {
    float a;        //   0
    vec3 b;         //  16
    float c;        //  28, after the vec3
    vec3 d[2];      //  32, 16 each
    mat3 m;         //  64, 16 a column
    bool e;         // 112
    double f;       // 120
    vec2 g[3];      // 128, 8 each
    S s[2];         // 160, 16 each
    T t[2];         // 192, 12 each
    float h[2][3];  // 216, 12 and 4
    mat2 n;         // 240, 8 a column
    T rest[];       // 256, 12 each
} b;)"));
    expectLayout(layout, {{"a", 0},
                          {"b", 16},
                          {"c", 28},
                          {"d[]", 32, {16}},
                          {"m", 64, {}, 16},
                          {"e", 112},
                          {"f", 120},
                          {"g[]", 128, {8}},
                          {"s[].v", 160, {16}},
                          {"t[].x", 192, {12}},
                          {"t[].y", 196, {12}},
                          {"t[].z", 200, {12}},
                          {"h[][]", 216, {12, 4}},
                          {"n", 240, {}, 8},
                          {"rest[].x", 256, {12}},
                          {"rest[].y", 260, {12}},
                          {"rest[].z", 264, {12}}});
    EXPECT_EQ(256, layout.size);
    EXPECT_EQ(12, layout.stride);
    EXPECT_EQ(16, layout.alignment);
    EXPECT_EQ(0, field(layout, "rest[].x").arrays.at(0).count);
}

TEST(BlockLayout, RowMajorMatrices) {
    const MemoryLayout layout = layoutOfFirst(memoryFactsOf(R"(
struct S { mat4x2 inner; };
layout(std430, row_major) buffer B { mat2x3 a; layout(column_major) mat2x3 b; S s; mat4x3 c[]; };)"));
    // Three rows of vec2; two columns of vec3; two rows of vec4; three rows of vec4.
    expectLayout(layout,
                 {{"a", 0, {}, 8}, {"b", 32, {}, 16}, {"s.inner", 64, {}, 16}, {"c[]", 96, {48}, 16}});
    EXPECT_TRUE(field(layout, "s.inner").isRowMajor);
    EXPECT_FALSE(field(layout, "b").isRowMajor);
}

TEST(BlockLayout, GivenOffsets) {
    const MemoryLayout layout = layoutOfFirst(memoryFactsOf(
        "layout(std430, align = 8) buffer B { float a; layout(offset = 32) float b; layout(align = 64) float "
        "c; float d; };"));
    expectLayout(layout, {{"a", 0}, {"b", 32}, {"c", 64}, {"d", 72}});
}

TEST(BlockLayout, OfTypes) {
    const MemoryFacts facts = memoryFactsOf("struct Particle { vec3 position; float age; vec3 velocity; };");
    const auto of = [&](const char* type, Packing packing) {
        const Result<MemoryLayout> layout = layoutOf(type, packing, facts.structures);
        EXPECT_TRUE(layout) << type;
        return layout.value.value_or(MemoryLayout{});
    };
    EXPECT_EQ(4, of("float", Packing::std430).stride);
    EXPECT_EQ(16, of("float", Packing::std140).stride);
    EXPECT_EQ(12, of("vec3", Packing::std430).size);
    EXPECT_EQ(16, of("vec3", Packing::std430).stride);
    EXPECT_EQ(8, of("uvec2", Packing::std430).stride);
    EXPECT_EQ(32, of("dvec3", Packing::std430).stride);
    EXPECT_EQ(48, of("mat3", Packing::std430).stride);
    EXPECT_EQ(16, of("mat2", Packing::std430).stride);
    EXPECT_EQ("", of("float", Packing::std430).fields.at(0).path);
    const MemoryLayout particle = of("Particle", Packing::std430);
    expectLayout(particle, {{"position", 0}, {"age", 12}, {"velocity", 16}});
    EXPECT_EQ(32, particle.size);
    EXPECT_EQ(32, particle.stride);
}

TEST(BlockLayout, WhatTheTextDoesNotTell) {
    EXPECT_EQ("block 'B' has neither layout(std140) nor layout(std430)",
              problemOf(memoryFactsOf("buffer B { float a; };")));
    EXPECT_EQ("the text does not show the array size of 'a'",
              problemOf(memoryFactsOf("layout(std430) buffer B { float a[gl_MaxDrawBuffers]; };")));
    const Result<MemoryLayout> unknown = layoutOf("Particle", Packing::std430, {});
    ASSERT_FALSE(unknown);
    EXPECT_EQ("'Particle' is neither a basic type nor a structure of the shader",
              unknown.diagnostics.at(0).text);
    EXPECT_FALSE(layoutOf("sampler2D", Packing::std430, {}));
}

TEST(BlockLayout, HostileStructuresEnd) {
    MemoryStructures structures;
    const auto member = [](const std::string& name, const std::string& type, long long size) {
        MemoryMember made;
        made.name = name;
        made.type = type;
        if (size != 0) made.sizes = {size};
        return made;
    };
    structures["Self"].members = {member("self", "Self", 0)};
    EXPECT_FALSE(layoutOf("Self", Packing::std430, structures));
    structures["S0"].members = {member("a", "float", 0)};
    structures["E0"].members = {};
    structures["L0"].members = {member("a", "float", 1'000'000'000)};
    for (int i = 1; i < 30; ++i) {
        for (const char* letter : {"S", "E"}) {
            const std::string inner = letter + std::to_string(i - 1);
            structures[letter + std::to_string(i)].members = {member("x", inner, 0), member("y", inner, 0)};
        }
        structures["L" + std::to_string(i)].members = {
            member("x", "L" + std::to_string(i - 1), 1'000'000'000)};
    }
    EXPECT_FALSE(layoutOf("S29", Packing::std430, structures));
    EXPECT_FALSE(layoutOf("E29", Packing::std430, structures));
    EXPECT_FALSE(layoutOf("L29", Packing::std430, structures));
    EXPECT_TRUE(layoutOf("S9", Packing::std430, structures));
}

/// Random structures and a block that uses them.
class RandomBlock {
  public:
    explicit RandomBlock(unsigned seed) : random_(seed) {}

    std::string text() {
        std::string all;
        for (int i = 0; i < 3; ++i) all += "struct S" + std::to_string(i) + " {" + members(i) + " };\n";
        const bool isBuffer = pick(3) > 0;
        const bool isRowMajor = pick(3) == 0;
        all += std::string("layout(") +
               (pick(2) == 0 ? "std140"
                : isBuffer   ? "std430"
                             : "std140") +
               (isRowMajor ? ", row_major) " : ") ") + (isBuffer ? "buffer" : "uniform") + " B {" +
               members(3);
        if (isBuffer && pick(2) == 0) all += " " + type(3) + " rest[];";
        return all + " } b;\n";
    }

  private:
    unsigned pick(unsigned count) { return static_cast<unsigned>(random_() % count); }
    std::string type(int structures) {
        static const char* const kTypes[] = {"float", "int",    "bool",   "double", "vec2",  "vec3",
                                             "vec4",  "ivec3",  "bvec2",  "dvec3",  "mat2",  "mat3",
                                             "mat4",  "mat2x3", "mat3x2", "mat4x3", "dmat3", "uvec4"};
        if (structures > 0 && pick(4) == 0)
            return "S" + std::to_string(pick(static_cast<unsigned>(structures)));
        return kTypes[pick(std::size(kTypes))];
    }
    std::string members(int structures) {
        std::string all;
        for (unsigned i = 0, count = 1 + pick(5); i < count; ++i) {
            all += " " + type(structures) + " m" + std::to_string(i);
            for (unsigned k = pick(4); k > 1; --k) all += "[" + std::to_string(1 + pick(3)) + "]";
            all += ";";
        }
        return all;
    }
    std::mt19937 random_;
};

/// The offset of "m0[1].a[2]" by the layout, and the stride of the innermost array around it; nothing if
/// there is no such field. Missing subscripts are 0.
std::optional<std::pair<long long, long long>> offsetOf(const MemoryLayout& layout, const std::string& name) {
    const auto bare = [](const std::string& path) {
        return std::regex_replace(path, std::regex("\\[[0-9]*\\]"), "");
    };
    for (const MemoryField& each : layout.fields) {
        if (bare(each.path) != bare(name)) continue;
        long long offset = each.offset;
        std::size_t array = 0, at = 0;
        for (std::size_t i = 0; i < each.path.size(); ++i) {
            if (each.path[i] != '[') {
                if (each.path[i] != ']') ++at;
                continue;
            }
            if (at < name.size() && name[at] == '[') {
                offset += std::stoll(name.substr(at + 1)) * each.arrays.at(array).stride;
                at = name.find(']', at) + 1;
            }
            ++array;
        }
        return std::pair(offset, each.arrays.empty() ? 0 : each.arrays.back().stride);
    }
    return std::nullopt;
}

// glslangValidator computes the layouts independently.
TEST(BlockLayout, RandomBlocksAsGlslangLaysThemOut) {
    int compared = 0;
    for (unsigned seed = 0; seed < 24; ++seed) {
        const std::string text = RandomBlock(seed).text();
        const TranslatedProgram translated =
            translateStages({{Stage::compute, "#version 450\nlayout(local_size_x = 1) in;\n" + text +
                                                  "void main() { bool same = b.m0 == b.m0; }\n"}});
        ASSERT_EQ("", ids(translated.diagnostics)) << text;
        const std::string output = glslangOutput(translated, "-q --reflect-all-block-variables");
        const MemoryLayout layout = layoutOfFirst(translated.memory);
        static const std::regex kLine("\nB\\.([^:]*): offset ([0-9]+)[^\n]*");
        static const std::regex kStride(" arrayStride ([0-9]+)");
        for (std::sregex_iterator at(output.begin(), output.end(), kLine), end; at != end; ++at) {
            const auto own = offsetOf(layout, (*at)[1]);
            ASSERT_TRUE(own) << text << (*at)[0];
            EXPECT_EQ(std::stoll((*at)[2]), own->first) << text << (*at)[0];
            const std::string line = (*at)[0];
            std::smatch stride;
            if (std::regex_search(line, stride, kStride)) {
                EXPECT_EQ(std::stoll(stride[1]), own->second) << text << line;
            }
            ++compared;
        }
    }
    EXPECT_GT(compared, 200);
}

TEST(MemoryFacts, Images) {
    const MemoryFacts facts = memoryFactsOf(R"(
#define FORMAT r32f
const int kCount = 2 + 1;
layout(FORMAT, binding = 4) uniform readonly image2D uIn;
layout(r32ui) uniform coherent uimage3D uBoth;
writeonly uniform image2DArray uOut[kCount * 2][2];
layout(rgb10_a2ui, binding = kCount) uniform uimage2D uFour;
#if 0
layout(rgba8) uniform image2D uGone;
#endif
uniform sampler2D uSampler;)");
    ASSERT_EQ(4U, facts.images.size());
    const ImageUniform& in = facts.images.at("uIn");
    EXPECT_EQ("r32f", in.format);
    EXPECT_EQ("image2D", in.type);
    EXPECT_EQ(4, in.binding);
    EXPECT_TRUE(in.isReadonly);
    EXPECT_FALSE(in.isWriteonly);
    EXPECT_EQ((Place{"a.comp", 6, 54}), in.place);
    const ImageUniform& both = facts.images.at("uBoth");
    EXPECT_EQ("r32ui uimage3D", both.format + " " + both.type);
    EXPECT_FALSE(both.isReadonly || both.isWriteonly || both.binding);
    const ImageUniform& out = facts.images.at("uOut");
    EXPECT_EQ(" image2DArray", out.format + " " + out.type);
    EXPECT_TRUE(out.isWriteonly);
    EXPECT_EQ((ArraySizes{6, 2}), out.sizes);
    EXPECT_EQ("rgb10_a2ui", facts.images.at("uFour").format);
    EXPECT_EQ(3, facts.images.at("uFour").binding);
}

TEST(MemoryFacts, Blocks) {
    const MemoryFacts facts = memoryFactsOf(R"(
layout(std430, row_major) buffer;
layout(std140) uniform;
struct Particle { vec4 position; float weights[2]; };
layout(binding = 3) readonly buffer Particles { uint count; Particle all[]; } particles;
buffer Columns { layout(column_major) mat4 m; writeonly float f[4]; writeonly float g; };
layout(shared) buffer Parts { readonly float a; readonly float b[]; } parts[2];
uniform Light { vec4 ambient; } light;)");
    ASSERT_EQ(4U, facts.blocks.size());
    const MemoryBlock* particles = facts.block("Particles", true);
    ASSERT_NE(nullptr, particles);
    EXPECT_EQ("particles", particles->instance);
    EXPECT_EQ(Packing::std430, particles->packing);
    EXPECT_TRUE(particles->isReadonly);
    EXPECT_TRUE(particles->isRowMajor);
    EXPECT_EQ(3, particles->binding);
    EXPECT_EQ("all Particle", particles->members.at(1).name + " " + particles->members.at(1).type);
    EXPECT_EQ((ArraySizes{0}), particles->members.at(1).sizes);
    const MemoryBlock* columns = facts.block("Columns", true);
    ASSERT_NE(nullptr, columns);
    EXPECT_EQ("", columns->instance);
    EXPECT_EQ(false, columns->members.at(0).isRowMajor);
    EXPECT_FALSE(columns->isReadonly || columns->isWriteonly || columns->binding);
    EXPECT_TRUE(columns->members.at(1).isWriteonly);
    const MemoryBlock* parts = facts.block("Parts", true);
    ASSERT_NE(nullptr, parts);
    EXPECT_EQ(Packing::driver, parts->packing);
    EXPECT_TRUE(parts->isReadonly);
    EXPECT_EQ((ArraySizes{2}), parts->sizes);
    const MemoryBlock* light = facts.block("Light", false);
    ASSERT_NE(nullptr, light);
    EXPECT_EQ(Packing::std140, light->packing);
    EXPECT_FALSE(light->isRowMajor);
    EXPECT_EQ(nullptr, facts.block("Light", true));
    ASSERT_EQ(1U, facts.structures.count("Particle"));
    EXPECT_EQ((ArraySizes{2}), facts.structures.at("Particle").members.at(1).sizes);
}

TEST(MemoryFacts, SizesAreIntegerArithmetic) {
    const MemoryFacts facts = memoryFactsOf(R"(
const uint kWidth = 7u;
const int kHalf = int(kWidth) / 2;
layout(std430) buffer B { float a[kHalf * 2]; float b[1 << kHalf]; float c[(kWidth % 4u) + 0x10u]; };)");
    const std::vector<MemoryMember>& members = facts.blocks.at(0).members;
    EXPECT_EQ((ArraySizes{6}), members.at(0).sizes);
    EXPECT_EQ((ArraySizes{8}), members.at(1).sizes);
    EXPECT_EQ((ArraySizes{19}), members.at(2).sizes);
}

TEST(MemoryFacts, StagesTogether) {
    const TranslatedProgram translated = translateStored(
        {{Stage::vertex,
          "#version 450\nlayout(std430) readonly buffer B { float b[]; };\nlayout(r32f) uniform "
          "readonly image2D uI;\nvoid main() { gl_Position = vec4(b[0], imageLoad(uI, "
          "ivec2(0)).xyz); }"},
         {Stage::fragment,
          "#version 450\nlayout(std430) buffer B { float b[]; };\nlayout(r32f) uniform readonly "
          "image2D uI;\nout vec4 o;\nvoid main() { b[0] = 1.; o = imageLoad(uI, ivec2(1)); }"}});
    EXPECT_EQ("", ids(translated.diagnostics));
    ASSERT_EQ(1U, translated.memory.blocks.size());
    EXPECT_FALSE(translated.memory.blocks[0].isReadonly);
    EXPECT_TRUE(translated.memory.images.at("uI").isReadonly);
    EXPECT_FALSE(translated.stages.at(0).facts.writesMemory);
    EXPECT_TRUE(translated.stages.at(1).facts.writesMemory);
}

TEST(MemoryFacts, AtomicCounters) {
    const MemoryFacts facts = memoryFactsOf(R"(
layout(binding = 0) uniform atomic_uint a;
layout(binding = 0) uniform atomic_uint b[3];
layout(binding = 0, offset = 32) uniform atomic_uint c;
layout(binding = 0) uniform atomic_uint e;)");
    const auto at = [&](const char* name) {
        const AtomicCounter& counter = facts.counters.at(name);
        return std::pair(counter.binding.value_or(-1), counter.offset);
    };
    EXPECT_EQ(std::pair(0, 0LL), at("a"));
    EXPECT_EQ(std::pair(0, 4LL), at("b"));
    EXPECT_EQ(std::pair(0, 32LL), at("c"));
    EXPECT_EQ(std::pair(0, 36LL), at("e"));
    EXPECT_EQ((ArraySizes{3}), facts.counters.at("b").sizes);
}

bool writes(const std::string& declaration, const std::string& statement) {
    const TranslatedProgram translated = translateStored(
        {{Stage::fragment, "#version 450\n" + declaration + "\nout vec4 o;\nvoid main() { o = vec4(0.); " +
                               statement + " }"}});
    EXPECT_EQ("", glslangErrors(translated));
    return translated.stages.at(0).facts.writesMemory;
}

TEST(MemoryFacts, WhatIsNotReadonlyCountsAsWritten) {
    EXPECT_FALSE(writes("", ""));
    EXPECT_TRUE(writes("buffer B { float b; };", "o.x = b;"));
    EXPECT_FALSE(writes("buffer B { float b; };", ""));
    EXPECT_FALSE(writes("readonly buffer B { float b; };", "o.x = b;"));
    EXPECT_FALSE(writes("buffer B { readonly float b; float c; };", "o.x = b;"));
    EXPECT_TRUE(writes("buffer B { readonly float b; float c; } s;", "o.x = s.b;"));
    EXPECT_FALSE(writes("buffer B { readonly float b; readonly float c; } s;", "o.x = s.b;"));
    EXPECT_TRUE(writes("layout(rgba8) uniform image2D i;", "o = imageLoad(i, ivec2(0));"));
    EXPECT_FALSE(writes("layout(rgba8) uniform readonly image2D i;", "o = imageLoad(i, ivec2(0));"));
    EXPECT_TRUE(writes("layout(binding = 0) uniform atomic_uint n;", "o.x = float(atomicCounter(n));"));
    EXPECT_FALSE(writes("uniform B { float b; };", "o.x = b;"));
}

TEST(MemoryFacts, StoredVerticesHaveNoKnownPlacement) {
    const auto placement = [](const std::string& block) {
        return translateStored(
                   {{Stage::vertex, "#version 450\n" + block +
                                        "\nvoid main() { gl_Position = uModelViewProjectionMatrix * "
                                        "aVertex; stored = 1.; }"},
                    {Stage::fragment, kPlainFragment}})
            .placement;
    };
    EXPECT_EQ(Placement::unknown, placement("buffer B { float stored; };"));
    EXPECT_EQ(Placement::vertex, placement("float stored;"));
    EXPECT_TRUE(
        translateStored({{Stage::vertex,
                          "#version 450\nbuffer B { float b[]; };\nvoid main() { b[0] = 1.; gl_Position "
                          "= ftransform(); }"}})
            .stages.at(0)
            .facts.showsPrimitives);
}

TEST(MemoryFacts, LocalSize) {
    const auto of = [](const std::string& text) {
        return translateStages({{Stage::compute, "#version 450\n" + text + "\nvoid main() { }"}}).localSize;
    };
    EXPECT_EQ((std::array{8, 1, 4}), of("layout(local_size_x = 8, local_size_z = 4) in;"));
    EXPECT_EQ((std::array{8, 2, 1}), of("layout(local_size_x = 8) in;\nlayout(local_size_y = 2) in;"));
    EXPECT_EQ((std::array{32, 1, 1}), of("#define N 16\nconst int k = N * 2;\nlayout(local_size_x = k) in;"));
    EXPECT_EQ((std::array{0, 1, 1}), of("layout(local_size_x = gl_MaxImageUnits) in;"));
    EXPECT_EQ((std::array{0, 0, 0}), of(""));
}

}  // namespace
}  // namespace glibra::glsl::test
