// Draws without data of their own: instances, counts from buffers, attributes from buffers and numbers.

#include <algorithm>

#include "modern_compute.h"

namespace glibra::test {
namespace {

using glsl::Stage;

constexpr const char* kRow = R"(#version 430 core
in vec4 aVertex;
uniform int uFirst;
out vec4 vColor;
void main() {
    int i = uFirst + gl_InstanceID;
    vColor = vec4(float(i % 4) / 3., float(i / 4) / 3., .5, .5);
    gl_Position = vec4(aVertex.xy * .1 + vec2(i % 4, i / 4) * .3 - .5, 0, 1);
}
)";
constexpr const char* kPlainFragment = R"(#version 430 core
in vec4 vColor;
out vec4 fColor;
void main() { fColor = vColor; }
)";

/// Sixteen overlapping squares, drawn at once or one by one.
ComputeScene squares(bool isInstanced) {
    ComputeScene made(64, 64);
    const auto program = made.program("Row", {{Stage::vertex, kRow}, {Stage::fragment, kPlainFragment}});
    made.window();
    for (int i = 0; i < (isInstanced ? 1 : 16); ++i) {
        scene::Draw& draw = made.square(program, 0, 2);
        draw.instances = isInstanced ? 16 : 1;
        draw.raster.change().blend.fill(base::kBlendOver);
        made.set(draw, {{"uFirst", {static_cast<double>(i)}}});
    }
    return made;
}

TEST_F(ModernCompute, InstancesAreTheSameAsALoop) {
    auto instanced = load(squares(true));
    auto looped = load(squares(false));
    ASSERT_TRUE(instanced && looped);
    const std::vector<std::byte> one = draw(*instanced);
    EXPECT_EQ(one, draw(*looped));
    EXPECT_GT(std::ranges::count(one, std::byte{0}), 0);
    EXPECT_GT(std::ranges::count_if(one, [](std::byte each) { return each != std::byte{0}; }), 2000);
}

TEST_F(ModernCompute, CountsOfDrawsComeFromBuffers) {
    auto given = load(squares(true));
    ComputeScene made = squares(true);
    scene::Draw& draw = std::get<scene::Draw>(made.scene.frame.passes.back().steps.back());
    draw.instances = 1;
    draw.instancesFrom.buffer.buffer = made.buffer("count", "uint", {}, {16});
    auto indirect = load(made);
    ASSERT_TRUE(given && indirect);
    EXPECT_EQ(this->draw(*given), this->draw(*indirect));
}

TEST_F(ModernCompute, VerticesNeedNoData) {
    constexpr const char* kVertices = R"(#version 430 core
out vec4 vColor;
void main() {
    vColor = vec4(1, .2, .4, 1);
    gl_Position = vec4(gl_VertexID == 1 ? 3 : -1, gl_VertexID == 2 ? 3 : -1, 0, 1);
}
)";
    for (const bool isFromBuffer : {false, true}) {
        ComputeScene made(8, 8);
        const auto program =
            made.program("Cover", {{Stage::vertex, kVertices}, {Stage::fragment, kPlainFragment}});
        made.window();
        scene::Draw& draw = made.square(program);
        draw.shape = made.bare(geometry::Topology::triangles, isFromBuffer ? 0 : 3);
        if (isFromBuffer) draw.verticesFrom.buffer.buffer = made.buffer("count", "uint", {}, {3});
        auto scene = load(made);
        ASSERT_TRUE(scene);
        const std::vector<std::byte> bytes = this->draw(*scene);
        for (std::size_t i = 0; i < bytes.size(); i += 3) {
            ASSERT_EQ(bytes[i], std::byte{255});
            ASSERT_EQ(bytes[i + 1], std::byte{51});
            ASSERT_EQ(bytes[i + 2], std::byte{102});
        }
    }
}

constexpr const char* kOffset = R"(#version 430 core
in vec4 aVertex;
in vec2 iOffset;
in mat2 iTurn;
in vec4 iColor;
out vec4 vColor;
void main() {
    vColor = iColor;
    gl_Position = vec4(iTurn * aVertex.xy * .1 + iOffset, 0, 1);
}
)";

TEST_F(ModernCompute, AttributesComeFromBuffersAndNumbers) {
    // The same squares with attributes per instance, and one draw each with constant attributes.
    const std::vector<std::array<double, 10>> rows{{-.5, -.5, 1, 0, 0, 1, 1, 0, 0, 1},
                                                   {.5, -.25, .8, .6, -.6, .8, 0, 1, 0, 1},
                                                   {0, .5, .6, .8, -.8, .6, 0, 0, 1, 1}};
    const auto picture = [&](bool isInstanced) {
        ComputeScene made(64, 64);
        const auto program =
            made.program("Place", {{Stage::vertex, kOffset}, {Stage::fragment, kPlainFragment}});
        std::vector<double> offsets, turns, colors;
        for (const auto& row : rows) {
            offsets.insert(offsets.end(), row.begin(), row.begin() + 2);
            turns.insert(turns.end(), row.begin() + 2, row.begin() + 6);
            colors.insert(colors.end(), row.begin() + 6, row.end());
        }
        const scene::BufferView offset{made.buffer("offsets", "vec2", {}, offsets)};
        const scene::BufferView turn{made.buffer("turns", "mat2", {}, turns)};
        const scene::BufferView color{made.buffer("colors", "vec4", {}, colors)};
        made.window();
        for (std::size_t i = 0; i < (isInstanced ? 1 : rows.size()); ++i) {
            scene::Draw& draw = made.square(program, 0, 2);
            scene::AttributeSet set;
            if (isInstanced) {
                draw.instances = 3;
                set.bindings = {{"iOffset", offset, true, {}, {}},
                                {"iTurn", turn, true, {}, {}},
                                {"iColor", color, true, {}, {}}};
            } else {
                const auto& row = rows[i];
                set.bindings = {{"iOffset", std::vector<double>(row.begin(), row.begin() + 2), false, {}, {}},
                                {"iTurn", turn, true, {}, {}},
                                {"iColor", std::vector<double>(row.begin() + 6, row.end()), false, {}, {}}};
                if (i != 0) continue;  // a matrix cannot be a constant attribute
            }
            draw.attributes = made.scene.attributeSets.add(std::move(set));
        }
        auto scene = load(made);
        return scene ? draw(*scene) : std::vector<std::byte>();
    };
    const std::vector<std::byte> instanced = picture(true);
    ASSERT_FALSE(instanced.empty());
    const std::vector<std::byte> first = picture(false);
    std::size_t red = 0, green = 0, blue = 0, redAlone = 0;
    for (std::size_t i = 0; i < instanced.size(); i += 3) {
        red += instanced[i] != std::byte{0};
        green += instanced[i + 1] != std::byte{0};
        blue += instanced[i + 2] != std::byte{0};
        redAlone += first[i] != std::byte{0};
    }
    EXPECT_EQ(red, redAlone);
    EXPECT_GT(red, 100U);
    // Squares with sides of 12.8 pixels, of which pixels at the border count or not.
    for (const std::size_t each : {red, green, blue}) EXPECT_NEAR(static_cast<double>(each), 12.8 * 12.8, 26);
}

}  // namespace
}  // namespace glibra::test
