#include "render/check/position_search.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <span>
#include <utility>
#include <vector>

#include "gpu/object/buffer.h"
#include "gpu/object/program.h"
#include "gpu/object/timer.h"
#include "gpu/object/uniform.h"
#include "render/draw/frame.h"
#include "render/load/derived_program.h"

namespace glibra::render {
namespace {

constexpr GLuint kMostVertices = 1U << 25U;
constexpr std::size_t kPositionFloats = 4;  ///< per captured vertex

/// The primitives that leave the last stage before rasterisation.
struct Output {
    GLenum mode = GL_TRIANGLES;
    GLuint corners = 3;
    std::string kind = "triangles";
};

Output outputOf(const std::string& word) {
    if (word.starts_with("point")) return {GL_POINTS, 1, "points"};
    if (word.starts_with("line")) return {GL_LINES, 2, "lines"};
    return {};
}

Output outputOf(const glsl::TranslatedProgram& program, geometry::Topology topology) {
    if (!program.geometryOutput.empty()) return outputOf(program.geometryOutput);
    if (!program.tessellationOutput.empty()) return outputOf(program.tessellationOutput);
    if (topology == geometry::Topology::points) return outputOf("points");
    const bool isLines =
        topology == geometry::Topology::lines || topology == geometry::Topology::linesAdjacency;
    return outputOf(isLines ? "lines" : "triangles");
}

/// The count of a query around `work`.
template <class Work>
GLuint counted(GLenum what, const Work& work) {
    const gpu::Query query(what);
    query.begin();
    work();
    query.end();
    return static_cast<GLuint>(query.result());
}

/// The number of captured primitives with a component that is not finite.
std::uint64_t countLost(const gpu::Buffer& buffer, GLuint primitives, GLuint corners) {
    const std::size_t floats = std::size_t{primitives} * corners * kPositionFloats;
    if (floats == 0) return 0;
    std::vector<float> values(floats);
    buffer.read(0, std::as_writable_bytes(std::span(values)));
    std::uint64_t lost = 0;
    for (std::size_t at = 0; at < floats; at += corners * kPositionFloats)
        if (!std::all_of(values.data() + at, values.data() + at + corners * kPositionFloats,
                         [](float each) { return std::isfinite(each); }))
            ++lost;
    return lost;
}

}  // namespace

std::vector<LostPrimitives> PositionSearch::search(SceneRenderer& renderer, double time, Stats& stats) {
    std::vector<LostPrimitives> found;
    std::set<const plan::PlannedDraw*> seen;
    FrameDrawer& drawer = renderer.drawer();
    drawer.setDrawHook([&](const plan::PlannedDraw& draw, bool, bool begins) {
        // A picture of several tiles draws it once per tile.
        if (!begins || !seen.insert(&draw).second) return;
        if (std::optional<LostPrimitives> lost = look(drawer, draw)) found.push_back(std::move(*lost));
    });
    const Result<image::Image> drawn = renderer.draw(time, stats);
    drawer.setDrawHook({});
    return drawn ? std::move(found) : std::vector<LostPrimitives>();
}

/// The program without its fragment stage, which captures gl_Position; null if it does not link.
const gpu::Program* PositionSearch::programFor(const BuiltProgram& built) {
    const auto [known, isNew] = programs_.try_emplace(&built);
    if (isNew) {
        std::vector<glsl::TranslatedStage> stages = built.interface.facts.stages;
        std::erase_if(stages, [](const auto& each) { return each.stage == glsl::Stage::fragment; });
        known->second = capturingProgram(*capabilities_, built, stages, {"gl_Position"});
    }
    return known->second ? &*known->second : nullptr;
}

std::optional<LostPrimitives> PositionSearch::look(FrameDrawer& drawer, const plan::PlannedDraw& draw) {
    const BuiltProgram* built = drawer.programOf(draw);
    const gpu::Program* program = built ? programFor(*built) : nullptr;
    if (!program) return std::nullopt;
    const Output output = outputOf(built->interface.facts, draw.submission.topology);
    program->use();
    copyUniforms(*built, *program, gpu::reflect(*program));
    glEnable(GL_RASTERIZER_DISCARD);
    const GLuint all = counted(GL_PRIMITIVES_GENERATED, [&] { drawer.submit(draw); });
    const GLuint most = std::min(all, kMostVertices / output.corners);
    std::uint64_t lost = 0;
    const Result<gpu::Buffer> buffer = gpu::Buffer::create(
        std::max<std::size_t>(1, std::size_t{most} * output.corners) * kPositionFloats * sizeof(float),
        GL_STREAM_READ);
    if (buffer) {
        buffer->bindBase(GL_TRANSFORM_FEEDBACK_BUFFER, 0);
        const GLuint written = counted(GL_TRANSFORM_FEEDBACK_PRIMITIVES_WRITTEN, [&] {
            glBeginTransformFeedback(output.mode);
            drawer.submit(draw);
            glEndTransformFeedback();
        });
        lost = countLost(*buffer, std::min(written, most), output.corners);
        glBindBufferBase(GL_TRANSFORM_FEEDBACK_BUFFER, 0, 0);
    }
    glDisable(GL_RASTERIZER_DISCARD);
    built->program->use();
    if (lost == 0) return std::nullopt;
    return LostPrimitives{&draw, output.kind, lost, all};
}

}  // namespace glibra::render
