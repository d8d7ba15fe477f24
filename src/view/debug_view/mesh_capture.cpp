#include "view/debug_view/mesh_capture.h"

#include <fmt/format.h>
#include <glad/gl.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>
#include <optional>
#include <span>
#include <utility>

#include "glsl/facts/stage_variables.h"
#include "glsl/types/builtins.h"
#include "gpu/object/buffer.h"
#include "gpu/object/program.h"
#include "gpu/object/timer.h"
#include "gpu/object/uniform.h"
#include "plan/submission.h"
#include "render/load/derived_program.h"
#include "render/load/gl_names.h"
#include "view/debug_view/bound_target.h"
#include "view/debug_view/debug_program.h"
#include "view/scene/window_target.h"

namespace glibra::view {
namespace {

constexpr std::size_t kMostNumbers = 64;  ///< that every driver captures of a vertex (GL 4.1, table 6.39)
constexpr std::string_view kPositionName = "gl_Position";

/// A number of the program that is captured.
struct Captured {
    MeshColumn column;
    std::string name;  ///< in the program
};

std::size_t numbersOf(std::span<const Captured> all) {
    return all.empty() ? 0 : all.back().column.first + static_cast<std::size_t>(all.back().column.components);
}

bool add(std::vector<Captured>& all, std::string shown, std::string type, int components, std::string name) {
    const std::size_t first = numbersOf(all);
    if (first + static_cast<std::size_t>(components) > kMostNumbers) return false;
    all.push_back({{std::move(shown), std::move(type), components, first}, std::move(name)});
    return true;
}

struct Primitives {
    GLenum mode = GL_TRIANGLES;
    int corners = 3;
};
Primitives primitivesOf(std::string_view word) {
    if (word.starts_with("point")) return {GL_POINTS, 1};
    if (word.starts_with("line")) return {GL_LINES, 2};
    return {};
}
Primitives primitivesOf(geometry::Topology topology) {
    if (topology == geometry::Topology::lines) return {GL_LINES, 2};
    if (topology == geometry::Topology::triangles) return {};
    return {GL_POINTS, 1};
}

/// One program whose outputs are captured.
struct Wanted {
    MeshStage stage;
    StageTexts sources;
    std::vector<Captured> captured;
    Primitives primitives;
    bool asPoints = false;  ///< each vertex once, in the order of the indices
};

/// The vertex stage is replaced by one that passes its inputs on.
std::optional<Wanted> wantedInputs(const render::BuiltProgram& built) {
    const auto& stages = built.interface.facts.stages;
    if (stages.empty()) return std::nullopt;
    Wanted wanted;
    wanted.stage.title = "inputs";
    wanted.asPoints = true;
    wanted.primitives = {GL_POINTS, 1};
    std::string declarations = glsl::versionLine(stages.front());
    std::string body =
        "    gl_Position = vec4(0.);\n    glibra_vertex = gl_VertexID;\n    glibra_instance = "
        "gl_InstanceID;\n";
    declarations += "out int glibra_vertex;\nout int glibra_instance;\n";
    add(wanted.captured, "gl_VertexID", "int", 1, "glibra_vertex");
    add(wanted.captured, "gl_InstanceID", "int", 1, "glibra_instance");
    int number = 0;
    for (const base::ActiveInput& each : built.interface.inputs) {
        const bool isPlain = each.location >= 0 && each.arraySize == 1 && !each.type.word.empty() &&
                             (each.type.base == base::BaseType::floating || each.type.isInteger());
        if (!isPlain) continue;
        const std::string out = fmt::format("glibra_out{}", number++);
        if (!add(wanted.captured, plan::userNameOf(built.interface, each.name), each.type.word,
                 each.type.components(), out))
            break;
        const glsl::BuiltinInput* row = glsl::findBuiltinInput(each.name);
        const bool isPosition = row != nullptr && row->attribute == geometry::kPosition;
        if (isPosition || (wanted.stage.position < 0 && each.type.components() >= 3))
            wanted.stage.position = static_cast<int>(wanted.captured.size()) - 1;
        const std::string& in = each.name;
        // It keeps the name, which has its location.
        declarations += fmt::format("in {} {};\nout {} {};\n", each.type.word, in, each.type.word, out);
        body += fmt::format("    {} = {};\n", out, in);
    }
    wanted.sources.emplace_back(GL_VERTEX_SHADER, declarations + "void main() {\n" + body + "}\n");
    return wanted;
}

/// The outputs of the last of these stages.
std::vector<Captured> outputsOf(const glsl::TranslatedProgram& facts, const glsl::TranslatedStage& last) {
    std::vector<Captured> all;
    add(all, std::string(kPositionName), "vec4", 4, std::string(kPositionName));
    for (const glsl::StageVariable& each : glsl::stageVariables(last, facts.userNames)) {
        // GL names members of blocks by the block, which the expression does not tell.
        if (!each.isOutput || each.expression.find('.') != std::string::npos || each.type.starts_with("d") ||
            each.type.starts_with("b"))
            continue;
        const int elements = std::max(1, each.elements);
        const std::string type = each.elements > 0 ? fmt::format("{}[{}]", each.type, elements) : each.type;
        add(all, each.name, type, elements * each.components(), each.expression);
    }
    return all;
}

std::vector<Wanted> wantedOutputs(const render::BuiltProgram& built, const plan::PlannedDraw& draw,
                                  bool isReversed) {
    const glsl::TranslatedProgram& facts = built.interface.facts;
    std::vector<Wanted> all;
    StageTexts sources;
    for (const glsl::Stage stage : {glsl::Stage::vertex, glsl::Stage::tessControl,
                                    glsl::Stage::tessEvaluation, glsl::Stage::geometry}) {
        const glsl::TranslatedStage* translated = stageOf(built, stage);
        if (translated == nullptr) continue;
        sources.emplace_back(render::glStage(stage), translated->source);
        if (stage == glsl::Stage::tessControl) continue;
        Wanted wanted;
        wanted.sources = sources;
        wanted.captured = outputsOf(facts, *translated);
        wanted.stage.position = 0;
        wanted.stage.isClip = true;
        wanted.stage.isReversed = isReversed;
        if (stage == glsl::Stage::vertex) {
            const Primitives drawn = primitivesOf(draw.submission.topology);
            wanted.stage.title = "after the vertex stage";
            wanted.asPoints = hasStagesAfterVertices(built) || drawn.corners == 1;
            wanted.primitives = wanted.asPoints ? Primitives{GL_POINTS, 1} : drawn;
        } else {
            const bool isGeometry = stage == glsl::Stage::geometry;
            wanted.stage.title = isGeometry ? "after the geometry stage" : "after tessellation";
            wanted.primitives = primitivesOf(isGeometry ? facts.geometryOutput : facts.tessellationOutput);
        }
        all.push_back(std::move(wanted));
    }
    return all;
}

std::optional<gpu::Program> link(const gpu::Capabilities& capabilities, const render::BuiltProgram& built,
                                 const Wanted& wanted) {
    std::vector<std::string> names;
    for (const Captured& each : wanted.captured) names.push_back(each.name);
    return linkStages(capabilities, built, wanted.sources, std::move(names));
}

std::uint64_t counted(GLenum what, const auto& work) {
    const gpu::Query query(what);
    query.begin();
    work();
    query.end();
    return query.result();
}

double numberOf(float bits, char kind) {
    if (kind == 'i') return std::bit_cast<std::int32_t>(bits);
    if (kind == 'u') return std::bit_cast<std::uint32_t>(bits);
    return static_cast<double>(bits);
}

void take(MeshStage& stage, const gpu::Buffer& buffer) {
    std::vector<float> numbers(stage.rows * stage.rowSize);
    if (!numbers.empty()) buffer.read(0, std::as_writable_bytes(std::span(numbers)));
    stage.values.resize(numbers.size());
    for (const MeshColumn& each : stage.columns) {
        const char kind = each.type.front();  // int, ivec, uint, uvec
        for (std::size_t row = 0; row < stage.rows; ++row)
            for (std::size_t i = 0; i < static_cast<std::size_t>(each.components); ++i) {
                const std::size_t at = row * stage.rowSize + each.first + i;
                stage.values[at] = numberOf(numbers[at], kind);
            }
    }
}

/// Draws the draw in the state that is set and takes what its vertices are.
MeshStage capture(const gpu::Capabilities& capabilities, render::FrameDrawer& drawer,
                  const plan::PlannedDraw& draw, const render::BuiltProgram& built, Wanted wanted) {
    std::optional<gpu::Program> program = link(capabilities, built, wanted);
    if (!program && wanted.stage.isClip) {
        wanted.captured.resize(1);  // drivers refuse some outputs
        program = link(capabilities, built, wanted);
    }
    MeshStage stage = std::move(wanted.stage);
    for (Captured& each : wanted.captured) stage.columns.push_back(std::move(each.column));
    if (!program) {
        stage.problem = "the driver does not link these stages alone";
        return stage;
    }
    stage.rowSize = stage.columns.back().first + static_cast<std::size_t>(stage.columns.back().components);
    stage.corners = wanted.primitives.corners;
    plan::PlannedDraw drawn = draw;
    if (wanted.asPoints) drawn.submission = {geometry::Topology::points};
    program->use();
    render::copyUniforms(built, *program, gpu::reflect(*program));
    const auto submit = [&] { drawer.submit(drawn); };
    const auto corners = static_cast<std::uint64_t>(stage.corners);
    stage.allRows = counted(GL_PRIMITIVES_GENERATED, submit) * corners;
    const std::size_t most =
        kMostMeshRows / static_cast<std::size_t>(stage.corners) * static_cast<std::size_t>(stage.corners);
    const std::size_t rows = static_cast<std::size_t>(std::min<std::uint64_t>(stage.allRows, most));
    const Result<gpu::Buffer> buffer =
        gpu::Buffer::create(std::max<std::size_t>(1, rows) * stage.rowSize * sizeof(float), GL_STREAM_READ);
    if (!buffer) {
        stage.problem = "there is no memory for the vertices";
        return stage;
    }
    buffer->bindBase(GL_TRANSFORM_FEEDBACK_BUFFER, 0);
    const std::uint64_t written = counted(GL_TRANSFORM_FEEDBACK_PRIMITIVES_WRITTEN, [&] {
        glBeginTransformFeedback(wanted.primitives.mode);
        submit();
        glEndTransformFeedback();
    });
    glBindBufferBase(GL_TRANSFORM_FEEDBACK_BUFFER, 0, 0);
    stage.rows = static_cast<std::size_t>(std::min<std::uint64_t>(rows, written * corners));
    take(stage, *buffer);
    // Vertices in the order of the indices of a list are those of its primitives.
    if (wanted.asPoints && !draw.submission.strip)
        stage.corners = primitivesOf(draw.submission.topology).corners;
    return stage;
}

}  // namespace

std::vector<MeshStage> captureMesh(gpu::Context& context, render::LiveScene& scene, scene::StepIndex step,
                                   int width, int height, double time) {
    std::vector<MeshStage> stages;
    const Result<gpu::Target> window = windowTarget(context.capabilities(), scene.scene(), width, height);
    if (!window) return stages;
    render::FrameDrawer& drawer = scene.drawer();
    scene.drawOutOfSight(true);  // its vertices are wanted also where nothing of it can be seen
    drawer.setDrawHook([&](const plan::PlannedDraw& draw, bool, bool begins) {
        const render::BuiltProgram* built = drawer.programOf(draw);
        if (!begins || draw.step != step || built == nullptr) return;
        const KeptState kept;
        const GLboolean discards = glIsEnabled(GL_RASTERIZER_DISCARD);
        glEnable(GL_RASTERIZER_DISCARD);
        if (auto inputs = wantedInputs(*built))
            stages.push_back(capture(context.capabilities(), drawer, draw, *built, std::move(*inputs)));
        for (Wanted& each : wantedOutputs(
                 *built, draw, scene.plan().drawOf(draw).raster->depthOrder != base::DepthOrder::usual))
            stages.push_back(capture(context.capabilities(), drawer, draw, *built, std::move(each)));
        if (discards == GL_FALSE) glDisable(GL_RASTERIZER_DISCARD);
    });
    drawer.draw(*window, {scene.view(), width, height, {0, 0, width, height}, time});
    drawer.setDrawHook({});
    scene.drawOutOfSight(false);
    return stages;
}

std::string csvOf(const MeshStage& stage) {
    constexpr std::string_view kParts = "xyzw";
    std::string text = "vertex";
    for (const MeshColumn& each : stage.columns)
        for (int i = 0; i < each.components; ++i)
            text += each.components == 1 ? "," + each.name
                    : each.components <= 4
                        ? fmt::format(",{}.{}", each.name, kParts[static_cast<std::size_t>(i)])
                        : fmt::format(",{}[{}]", each.name, i);
    text += "\r\n";
    for (std::size_t row = 0; row < stage.rows; ++row) {
        text += std::to_string(row);
        for (std::size_t i = 0; i < stage.rowSize; ++i)
            text += fmt::format(",{}", static_cast<float>(stage.row(row)[i]));
        text += "\r\n";
    }
    return text;
}

}  // namespace glibra::view
