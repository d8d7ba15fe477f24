#include "render/probe/patch_probe.h"

#include <algorithm>
#include <array>
#include <span>
#include <string>
#include <utility>

#include "glsl/emit/wrapped_main.h"
#include "gpu/object/query.h"
#include "gpu/object/reflection.h"
#include "gpu/object/uniform.h"
#include "render/draw/frame.h"
#include "render/draw/patch_split.h"
#include "render/load/derived_program.h"
#include "render/probe/probe_options.h"

namespace glibra::render {
namespace {

constexpr int kLargestSide = 64;
constexpr int kMostPatches = 64;
constexpr std::size_t kPatchFloats = 8;  ///< per captured vertex: gl_Position, and the coordinate with a 0

/// A program of the stages up to the evaluation stage, whose output is captured with its tessellation
/// coordinate.
std::optional<gpu::Program> capturingPatches(const gpu::Capabilities& capabilities,
                                             const BuiltProgram& built) {
    std::vector<glsl::TranslatedStage> stages = built.interface.facts.stages;
    std::erase_if(stages, [](const glsl::TranslatedStage& each) {
        return each.stage == glsl::Stage::geometry || each.stage == glsl::Stage::fragment;
    });
    for (glsl::TranslatedStage& each : stages)
        if (each.stage == glsl::Stage::tessEvaluation)
            each.source =
                glsl::wrappedMain(each, {.declarations = "out vec4 glibra_coordinate;\n",
                                         .before = "",
                                         .after = "    glibra_coordinate = vec4(gl_TessCoord, 0.);\n"});
    return capturingProgram(capabilities, built, stages, {"gl_Position", "glibra_coordinate"});
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

PatchProbe::PatchProbe(gpu::Context& context, const scene::Scene& scene, const RenderOptions& options,
                       int width, int height)
    : context_(context),
      scene_(scene),
      options_(probeOptions(options, width, height, kLargestSide).options) {}

bool PatchProbe::prepare() {
    if (loaded_) return true;
    auto made = SceneState::load(context_, {scene_, nullptr, {}}, options_, stats_, &parts_);
    const int level = context_.capabilities().maxTessellationLevel;
    // Two triangles per square of the finest grid. Lines need less.
    const auto bytes = static_cast<std::size_t>(level + 1) * static_cast<std::size_t>(level + 1) * 6 *
                       kPatchFloats * sizeof(float);
    Result<gpu::Buffer> room = gpu::Buffer::create(bytes, GL_STREAM_READ);
    if (!made || !room) return false;
    loaded_ = std::move(*made);
    buffer_ = std::move(room.value);
    return true;
}

const gpu::Program* PatchProbe::capturingFor(const BuiltProgram& built) {
    for (const auto& [known, program] : programs_)
        if (known == &built) return &program;
    std::optional<gpu::Program> made = capturingPatches(context_.capabilities(), built);
    if (!made) return nullptr;
    return &programs_.emplace_back(&built, std::move(*made)).second;
}

std::optional<std::vector<budget::Patch>> PatchProbe::capture(const plan::PlannedDraw& draw,
                                                              std::span<const budget::LevelValue> values) {
    const BuiltProgram* built = loaded_->drawer->programOf(draw);
    const DeviceMesh* mesh = loaded_->device.meshes().onDevice(loaded_->plan, draw.mesh);
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
    buffer_->bindBase(GL_TRANSFORM_FEEDBACK_BUFFER, 0);
    glEnable(GL_RASTERIZER_DISCARD);
    const GLenum primitives = built->interface.facts.tessellationOutput == "lines" ? GL_LINES : GL_TRIANGLES;
    const int patches = mesh->indexCount / indices, stride = (patches - 1) / kMostPatches + 1;
    std::vector<budget::Patch> captured;
    for (int patch = 0; patch < patches; patch += stride) {
        setFirstPatch(built->interface.facts, patch);
        captured.push_back(render::capture(patch * indices, indices, primitives, *buffer_));
    }
    glDisable(GL_RASTERIZER_DISCARD);
    glBindBufferBase(GL_TRANSFORM_FEEDBACK_BUFFER, 0, 0);
    built->program->use();
    return captured;
}

std::optional<std::vector<budget::Patch>> PatchProbe::patches(std::size_t pass, std::size_t step,
                                                              std::span<const budget::LevelValue> values) {
    if (!prepare()) return std::nullopt;
    SceneState& state = *loaded_;
    state.forgetDrawn();
    const scene::StepIndex wanted{pass, step};
    std::optional<std::vector<budget::Patch>> captured;
    state.drawer->setDrawHook([&](const plan::PlannedDraw& draw, bool, bool begins) {
        if (begins && draw.step == wanted) captured = capture(draw, values);
    });
    const Result<image::Image> drawn = state.draw(options_.time, stats_);
    state.drawer->setDrawHook({});
    return drawn ? std::move(captured) : std::nullopt;
}

}  // namespace glibra::render
