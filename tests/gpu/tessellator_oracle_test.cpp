// The tessellator of geometry/tessellator.h against the driver's. Mesa places and joins vertices as ours
// does, bit for bit; of other drivers the number of vertices is compared.

#include <fmt/format.h>

#include <random>
#include <span>
#include <string>

#include "fixture.h"
#include "geometry/tessellator.h"
#include "gpu/object/buffer.h"
#include "gpu/object/timer.h"

namespace glibra::gpu {
namespace {

using base::TessellationLayout;
using Levels = std::array<float, 6>;
using Coordinates = std::vector<std::array<float, 3>>;

class TessellatorOracleTest : public test::GpuTest {
  protected:
    /// An evaluation stage that delivers gl_TessCoord.
    static std::optional<Program> capturing(const TessellationLayout& layout) {
        constexpr std::array<const char*, 3> kDomains{"triangles", "quads", "isolines"};
        constexpr std::array<const char*, 3> kSpacings{"equal_spacing", "fractional_even_spacing",
                                                       "fractional_odd_spacing"};
        const std::string evaluation = fmt::format(
            "#version 410 core\nlayout({}, {}, {}{}) in;\nout vec3 place;\n"
            "void main() {{ place = gl_TessCoord; gl_Position = vec4(0.); }}\n",
            kDomains.at(static_cast<std::size_t>(layout.domain)),
            kSpacings.at(static_cast<std::size_t>(layout.spacing)), layout.isClockwise ? "cw" : "ccw",
            layout.asPoints ? ", point_mode" : "");
        const std::array<StageSource, 2> stages{
            {{GL_VERTEX_SHADER, "#version 410 core\nvoid main() { gl_Position = vec4(0.); }\n"},
             {GL_TESS_EVALUATION_SHADER, evaluation}}};
        BuildOutcome outcome = buildProgram(driver(), {.stages = stages, .captured = {"place"}});
        EXPECT_TRUE(outcome.program) << outcome.linkLog;
        return std::move(outcome.program);
    }

    static Coordinates captured(const TessellationLayout& layout, const Levels& levels, const Buffer& room) {
        constexpr std::array<GLenum, 3> kModes{GL_POINTS, GL_LINES, GL_TRIANGLES};
        const int corners = cornersOf(layout);
        glPatchParameterfv(GL_PATCH_DEFAULT_OUTER_LEVEL, levels.data());
        glPatchParameterfv(GL_PATCH_DEFAULT_INNER_LEVEL, levels.data() + 4);
        const Query written(GL_TRANSFORM_FEEDBACK_PRIMITIVES_WRITTEN);
        written.begin();
        glBeginTransformFeedback(kModes.at(static_cast<std::size_t>(corners) - 1));
        glDrawArrays(GL_PATCHES, 0, 1);
        glEndTransformFeedback();
        written.end();
        Coordinates made(written.result() * static_cast<std::size_t>(corners));
        if (!made.empty()) room.read(0, std::as_writable_bytes(std::span(made)));
        return made;
    }
};

TEST_F(TessellatorOracleTest, DividesAsTheDriverDoes) {
    auto target = Target::window(driver(), 1, 1, TexelFormat::rgba32f);
    ASSERT_TRUE(target);
    target->bind();
    const VertexArray nothing({});
    nothing.bind();
    Result<Buffer> room =
        Buffer::create(std::size_t{64} * 64 * 6 * sizeof(std::array<float, 3>), GL_STREAM_READ);
    ASSERT_TRUE(room);
    room->bindBase(GL_TRANSFORM_FEEDBACK_BUFFER, 0);
    glPatchParameteri(GL_PATCH_VERTICES, 1);
    glEnable(GL_RASTERIZER_DISCARD);
    std::mt19937 random(7);
    std::uniform_real_distribution<float> few(.2F, 9), any(1, 70);
    for (int form = 0; form < 36; ++form) {
        TessellationLayout layout;
        layout.domain = static_cast<TessellationLayout::Domain>(form % 3);
        layout.spacing = static_cast<TessellationLayout::Spacing>(form / 3 % 3);
        layout.isClockwise = form / 9 % 2 == 1;
        layout.asPoints = form / 18 == 1;
        const std::optional<Program> program = capturing(layout);
        ASSERT_TRUE(program);
        program->use();
        for (int i = 0; i < 60; ++i) {
            Levels levels{};
            for (float& each : levels)
                each = random() % 4 == 0   ? 1
                       : random() % 3 == 0 ? static_cast<float>(1 + random() % 9)
                       : random() % 4 == 0 ? any(random)
                                           : few(random);
            const Coordinates own = geometry::tessellate(layout, levels),
                              its = captured(layout, levels, *room);
            const std::string levelsText = fmt::format("form {}, levels {}", form, fmt::join(levels, " "));
            ASSERT_EQ(own.size(), its.size()) << levelsText;
            if (driver().tessellatesInSoftware) {
                ASSERT_EQ(own, its) << levelsText;
            }
        }
    }
    glDisable(GL_RASTERIZER_DISCARD);
    glBindBufferBase(GL_TRANSFORM_FEEDBACK_BUFFER, 0, 0);
}

}  // namespace
}  // namespace glibra::gpu
