#include "render/probe/patch_probe.h"

#include <algorithm>
#include <array>
#include <span>
#include <string>
#include <utility>

#include "glsl/emit/wrapped_main.h"
#include "gpu/object/buffer.h"
#include "gpu/object/program.h"
#include "gpu/object/query.h"
#include "gpu/object/reflection.h"
#include "gpu/object/uniform.h"
#include "render/draw/frame.h"
#include "render/draw/patch_split.h"
#include "render/load/derived_program.h"
#include "render/probe/probe_options.h"
#include "render/scene_renderer.h"

namespace glibra::render {
namespace {

constexpr int kLargestSide = 64;
constexpr int kMostPatches = 64;
constexpr std::size_t kPatchFloats = 8;  ///< per captured vertex: gl_Position, and the coordinate with a 0

/// The evaluation stage with its tessellation coordinate as an output.
std::string withCoordinate(const glsl::TranslatedStage& stage) {
    return glsl::wrappedMain(stage, {.declarations = "out vec4 glibra_coordinate;\n",
                                     .before = "",
                                     .after = "    glibra_coordinate = vec4(gl_TessCoord, 0.);\n"});
}

/// A program of the stages up to the evaluation stage, whose output is captured.
std::optional<gpu::Program> capturingPatches(const gpu::Capabilities& capabilities,
                                             const BuiltProgram& built) {
    std::vector<std::pair<GLenum, std::string>> sources;
    for (const glsl::TranslatedStage& each : built.interface.facts.stages) {
        if (each.stage == glsl::Stage::vertex) sources.emplace_back(GL_VERTEX_SHADER, each.source);
        if (each.stage == glsl::Stage::tessControl) sources.emplace_back(GL_TESS_CONTROL_SHADER, each.source);
        if (each.stage == glsl::Stage::tessEvaluation)
            sources.emplace_back(GL_TESS_EVALUATION_SHADER, withCoordinate(each));
    }
    std::vector<gpu::StageSource> stages;
    stages.reserve(sources.size());
    for (const auto& [stage, text] : sources) stages.push_back({stage, text});
    return gpu::buildProgram(capabilities, {.stages = stages,
                                            .vertexInputs = inputLocations(built),
                                            .fragmentOutputs = {},
                                            .captured = {"gl_Position", "glibra_coordinate"}})
        .program;
}

/// Draws one patch from the bound vertex array and index buffer, and reads its captured vertices.
budget::Patch capture(int firstIndex, int indices, GLenum primitives, const gpu::Buffer& buffer) {
    const gpu::Query written(GL_TRANSFORM_FEEDBACK_PRIMITIVES_WRITTEN);
    written.begin();
    glBeginTransformFeedback(primitives);
    glDrawElements(GL_PATCHES, indices, GL_UNSIGNED_INT,
                   // NOLINTNEXTLINE(performance-no-int-to-ptr): an offset into the buffer that is bound
                   reinterpret_cast<const void*>(static_cast<std::size_t>(firstIndex) * sizeof(GLuint)));
    glEndTransformFeedback();
    written.end();
    const auto count = static_cast<std::size_t>(written.result());
    budget::Patch patch{primitives == GL_LINES ? 2U : 3U, {}};
    std::vector<float> floats(count * patch.corners * kPatchFloats);
    if (!floats.empty()) buffer.read(0, std::as_writable_bytes(std::span(floats)));
    for (std::size_t i = 0; i < floats.size(); i += kPatchFloats)
        patch.vertices.push_back({{floats[i], floats[i + 1], floats[i + 2], floats[i + 3]},
                                  {floats[i + 4], floats[i + 5], floats[i + 6]}});
    return patch;
}

}  // namespace

struct PatchProbe::State {
    State(gpu::Context& withContext, RenderOptions withOptions, const scene::Scene& ofScene)
        : context(withContext), options(std::move(withOptions)), scene(ofScene) {}

    gpu::Context& context;
    const RenderOptions options;
    const scene::Scene& scene;
    Stats stats{};
    SharedParts parts{};
    std::optional<SceneRenderer> renderer{};
    std::vector<std::pair<const BuiltProgram*, gpu::Program>> programs{};
    std::optional<gpu::Buffer> buffer{};

    bool prepare();
    const gpu::Program* capturingFor(const BuiltProgram& built);
    std::optional<std::vector<budget::Patch>> capture(const plan::PlannedDraw& draw,
                                                      std::span<const budget::LevelValue> values);
};

/// Loads the scene at the first call. False if that fails.
bool PatchProbe::State::prepare() {
    if (renderer) return true;
    Result<SceneRenderer> made = SceneRenderer::of(context, {scene, nullptr, {}}, options, stats, &parts);
    const int level = context.capabilities().maxTessellationLevel;
    // Two triangles per square of the finest grid. Lines need less.
    const auto bytes = static_cast<std::size_t>(level + 1) * static_cast<std::size_t>(level + 1) * 6 *
                       kPatchFloats * sizeof(float);
    Result<gpu::Buffer> room = gpu::Buffer::create(bytes, GL_STREAM_READ);
    if (!made || !room) return false;
    renderer = std::move(made.value);
    buffer = std::move(room.value);
    return true;
}

const gpu::Program* PatchProbe::State::capturingFor(const BuiltProgram& built) {
    for (const auto& [known, program] : programs)
        if (known == &built) return &program;
    std::optional<gpu::Program> made = capturingPatches(context.capabilities(), built);
    if (!made) return nullptr;
    return &programs.emplace_back(&built, std::move(*made)).second;
}

std::optional<std::vector<budget::Patch>> PatchProbe::State::capture(
    const plan::PlannedDraw& draw, std::span<const budget::LevelValue> values) {
    const BuiltProgram* built = renderer->drawer().programOf(draw);
    const DeviceMesh* mesh = renderer->device().meshes().onDevice(renderer->plan(), draw.mesh);
    const int indices = draw.submission.patchVertices;
    const gpu::Program* program = built && mesh && indices > 0 ? capturingFor(*built) : nullptr;
    if (program == nullptr) return std::nullopt;
    const base::ActiveResources reflected = gpu::reflect(*program);
    copyUniforms(*built, *program, reflected);
    for (const base::ActiveUniform& each : reflected.uniforms)
        for (const budget::LevelValue& value : values)
            if (at(built->interface.uniforms, value.uniform).emittedName == each.emittedName)
                gpu::setUniform(*program, each, std::array{value.value});
    program->use();
    buffer->bindBase(GL_TRANSFORM_FEEDBACK_BUFFER, 0);
    glEnable(GL_RASTERIZER_DISCARD);
    const GLenum primitives = built->interface.facts.tessellationOutput == "lines" ? GL_LINES : GL_TRIANGLES;
    const int patches = mesh->indexCount / indices, stride = (patches - 1) / kMostPatches + 1;
    std::vector<budget::Patch> captured;
    for (int patch = 0; patch < patches; patch += stride) {
        setFirstPatch(built->interface.facts, patch);
        captured.push_back(render::capture(patch * indices, indices, primitives, *buffer));
    }
    glDisable(GL_RASTERIZER_DISCARD);
    glBindBufferBase(GL_TRANSFORM_FEEDBACK_BUFFER, 0, 0);
    built->program->use();
    return captured;
}

PatchProbe::PatchProbe(gpu::Context& context, const scene::Scene& scene, const RenderOptions& options,
                       int width, int height) {
    RenderOptions small = probeOptions(options, width, height, kLargestSide).options;
    state_ = std::make_unique<State>(context, std::move(small), scene);
}

PatchProbe::~PatchProbe() = default;

std::optional<std::vector<budget::Patch>> PatchProbe::patches(std::size_t pass, std::size_t step,
                                                              std::span<const budget::LevelValue> values) {
    if (!state_->prepare()) return std::nullopt;
    SceneRenderer& renderer = *state_->renderer;
    const scene::StepIndex wanted{pass, step};
    std::optional<std::vector<budget::Patch>> captured;
    renderer.drawer().setDrawHook([&](const plan::PlannedDraw& draw, bool, bool begins) {
        if (begins && draw.step == wanted) captured = state_->capture(draw, values);
    });
    const Result<image::Image> drawn = renderer.draw(state_->options.time, state_->stats);
    renderer.drawer().setDrawHook({});
    return drawn ? std::move(captured) : std::nullopt;
}

}  // namespace glibra::render
