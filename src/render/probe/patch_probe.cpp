#include "render/probe/patch_probe.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>
#include <span>
#include <string>
#include <string_view>

#include "base/text.h"
#include "glsl/emit/emit.h"
#include "gpu/object/timer.h"
#include "gpu/object/uniform.h"
#include "render/draw/frame.h"
#include "render/draw/work_share.h"
#include "render/load/derived_program.h"

namespace glibra::render {

// ---- Options

ProbeOptions probeOptions(const RenderOptions& options, int width, int height, int largestSide) {
    ProbeOptions probe{options, std::max(1., static_cast<double>(std::max(width, height)) / largestSide)};
    RenderOptions& small = probe.options;
    small.width = std::max(1, static_cast<int>(std::lround(width / probe.shrink)));
    small.height = std::max(1, static_cast<int>(std::lround(height / probe.shrink)));
    small.maxError = 0;
    small.samples = 1;
    small.tileSize = 0;
    small.wantedObjects.clear();
    small.labels = LabelCorner::none;
    small.axes = small.checkNan = small.strict = false;
    return probe;
}

std::vector<double> momentsOf(const RenderOptions& options) {
    if (options.lastTime <= options.time) return {options.time};
    return {options.time, (options.time + options.lastTime) / 2, options.lastTime};
}

// ---- Patches

namespace {

constexpr int kLargestSide = 64;
constexpr std::size_t kMostPatches = 64, kMostLookedAt = 1024;
constexpr double kLowLevel = 4, kHighLevel = 16;  ///< that show which of many patches are worst
constexpr std::size_t kPatchFloats = 8;  ///< per captured vertex: gl_Position, and the coordinate with a 0

constexpr const char* kLevel = "glibra_level";
constexpr const char* kInstance = "glibra_instance";

/// Where a declaration may stand in a translated source: after its #version and #extension lines.
std::size_t beginOfDeclarations(std::string_view source) {
    std::size_t begin = 0;
    for (std::size_t at = 0; at < source.size();) {
        const std::size_t end = std::min(source.find('\n', at), source.size() - 1) + 1;
        const std::string_view line = source.substr(at, end - at);
        if (line.starts_with("#version") || line.starts_with("#extension")) begin = end;
        at = end;
    }
    return begin;
}

bool isWordAt(std::string_view source, std::size_t at, std::string_view word) {
    return (at == 0 || !base::isOfName(source[at - 1])) &&
           (at + word.size() == source.size() || !base::isOfName(source[at + word.size()]));
}

/// A vertex stage whose instance has the number of a uniform: captured instances are drawn one by one.
void numberInstances(std::string& source) {
    constexpr std::string_view kWord = "gl_InstanceID";
    bool isRead = false;
    for (std::size_t at = source.find(kWord); at != std::string::npos; at = source.find(kWord, at)) {
        if (isWordAt(source, at, kWord)) {
            source.replace(at, kWord.size(), kInstance);
            isRead = true;
        }
        at += kWord.size();
    }
    if (isRead) source.insert(beginOfDeclarations(source), std::string("uniform int ") + kInstance + ";\n");
}

/// Ends the main of a source with statements, in its own body: barrier() may stand in no other function.
/// False if main may return before its end.
bool endMain(std::string& source, std::string_view statements) {
    constexpr std::string_view kMain = "main";
    std::size_t at = source.find(kMain);
    while (at != std::string::npos && !isWordAt(source, at, kMain)) at = source.find(kMain, at + 1);
    const std::size_t open = at == std::string::npos ? at : source.find('{', at);
    if (open == std::string::npos) return false;
    std::size_t end = open;
    for (int depth = 0; end < source.size(); ++end) {
        depth += source[end] == '{' ? 1 : source[end] == '}' ? -1 : 0;
        if (depth == 0) break;
    }
    if (end == source.size() ||
        std::string_view(source).substr(open, end - open).find("return") != std::string_view::npos)
        return false;
    source.insert(end, statements);
    return true;
}

/// A control stage that gives all patches the level of a uniform, if that is above 0. The number of isolines
/// stays. False if the stage cannot be changed.
bool replaceLevels(glsl::TranslatedStage& stage, bool areLines) {
    std::string statements = std::string("    if (") + kLevel + " > 0.) {\n";
    for (const char* each : {"Outer[1]", "Outer[0]", "Outer[2]", "Outer[3]", "Inner[0]", "Inner[1]"}) {
        statements += std::string("        gl_TessLevel") + each + " = " + kLevel + ";\n";
        if (areLines) break;
    }
    statements += "    }\n";
    const std::string declaration = std::string("uniform float ") + kLevel + ";\n";
    if (stage.source.find("barrier") == std::string::npos) {
        stage.source = glsl::wrappedMain(stage, {declaration, "", statements});
        return true;
    }
    stage.source.insert(beginOfDeclarations(stage.source), declaration);
    return endMain(stage.source, statements);
}

bool hasControlStage(const BuiltProgram& built) {
    return std::ranges::any_of(built.interface.facts.stages, [](const glsl::TranslatedStage& each) {
        return each.stage == glsl::Stage::tessControl;
    });
}

bool makesLines(const BuiltProgram& built) {
    return built.interface.facts.tessellationOutput == "lines";
}

/// A program of the stages up to the evaluation stage, whose output is captured with its tessellation
/// coordinate.
std::optional<gpu::Program> capturingPatches(const gpu::Capabilities& capabilities,
                                             const BuiltProgram& built) {
    std::vector<glsl::TranslatedStage> stages = built.interface.facts.stages;
    std::erase_if(stages, [](const glsl::TranslatedStage& each) {
        return each.stage == glsl::Stage::geometry || each.stage == glsl::Stage::fragment;
    });
    for (glsl::TranslatedStage& each : stages) {
        if (each.stage == glsl::Stage::vertex) numberInstances(each.source);
        if (each.stage == glsl::Stage::tessControl && !replaceLevels(each, makesLines(built)))
            return std::nullopt;
        if (each.stage == glsl::Stage::tessEvaluation)
            each.source =
                glsl::wrappedMain(each, {.declarations = "out vec4 glibra_coordinate;\n",
                                         .before = "",
                                         .after = "    glibra_coordinate = vec4(gl_TessCoord, 0.);\n"});
    }
    return capturingProgram(capabilities, built, stages, {"gl_Position", "glibra_coordinate"});
}

/// Sets the levels of draws without a control stage.
void setDefaultLevels(std::array<float, 6> levels, bool areLines, double all) {
    if (all > 0)
        for (std::size_t i = areLines ? 1 : 0; i < levels.size(); ++i) levels[i] = static_cast<float>(all);
    glPatchParameterfv(GL_PATCH_DEFAULT_OUTER_LEVEL, levels.data());
    glPatchParameterfv(GL_PATCH_DEFAULT_INNER_LEVEL, levels.data() + 4);
}

/// Submits `count` vertices of one instance, from the one with the number `first`.
void submit(const FrameDrawer::Elements& elements, int first, int count, int instance) {
    // NOLINTNEXTLINE(performance-no-int-to-ptr): an offset into the buffer that is bound
    const auto* at = reinterpret_cast<const void*>(static_cast<std::size_t>(elements.offset) +
                                                   static_cast<std::size_t>(first) * sizeof(GLuint));
    const auto begin = static_cast<GLuint>(instance);
    if (elements.areIndexed && instance == 0)
        glDrawElements(GL_PATCHES, count, GL_UNSIGNED_INT, at);
    else if (elements.areIndexed)
        glDrawElementsInstancedBaseInstance(GL_PATCHES, count, GL_UNSIGNED_INT, at, 1, begin);
    else if (instance == 0)
        glDrawArrays(GL_PATCHES, first, count);
    else
        glDrawArraysInstancedBaseInstance(GL_PATCHES, first, count, 1, begin);
}

/// The primitives that `draw` writes into the buffer.
template <class Draw>
budget::Patch captured(GLenum primitives, const gpu::Buffer& buffer, const Draw& draw) {
    const gpu::Query written(GL_TRANSFORM_FEEDBACK_PRIMITIVES_WRITTEN);
    written.begin();
    glBeginTransformFeedback(primitives);
    draw();
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

PatchProbe::PatchProbe(const SceneState& state, std::vector<double> moments)
    : state_(state),
      options_(probeOptions(state.conductor.options, state.width, state.height, kLargestSide).options),
      moments_(std::move(moments)) {}

bool PatchProbe::prepare() {
    if (loaded_) return true;
    const Conductor& conductor = state_.conductor;
    auto made = SceneState::load(conductor.context, {conductor.scene, conductor.source, conductor.inputs},
                                 options_, stats_, &parts_);
    const int level = conductor.context.capabilities().maxTessellationLevel;
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
    std::optional<gpu::Program> made = capturingPatches(state_.conductor.context.capabilities(), built);
    if (!made) return nullptr;
    return &programs_.emplace_back(&built, std::move(*made)).second;
}

PatchProbe::Captured PatchProbe::capture(const plan::PlannedDraw& draw, const budget::Levels& levels,
                                         const FrameDrawer::Elements& elements,
                                         const std::vector<Place>& places) {
    const BuiltProgram& built = *loaded_->conductor.drawer->programOf(draw);
    const gpu::Program* program = capturingFor(built);
    if (program == nullptr) return std::nullopt;
    program->use();
    const base::ActiveResources reflected = gpu::reflect(*program);
    copyUniforms(built, *program, reflected);
    for (const base::ActiveUniform& each : reflected.uniforms)
        for (const budget::LevelValue& value : levels.values)
            if (at(built.interface.uniforms, value.uniform).emittedName == each.emittedName)
                gpu::setUniform(*program, each, std::array{value.value});
    glUniform1f(glGetUniformLocation(program->id(), kLevel), static_cast<float>(levels.all));
    const GLint instance = glGetUniformLocation(program->id(), kInstance);
    std::array<float, 6> stated{1, 1, 1, 1, 1, 1};
    if (const auto& given = loaded_->conductor.plan.drawOf(draw).tessellationLevels)
        std::ranges::transform(*given, stated.begin(), [](double each) { return static_cast<float>(each); });
    const bool areLines = makesLines(built);
    if (!hasControlStage(built)) setDefaultLevels(stated, areLines, levels.all);
    buffer_->bindBase(GL_TRANSFORM_FEEDBACK_BUFFER, 0);
    glEnable(GL_RASTERIZER_DISCARD);
    std::vector<budget::Patch> found;
    const int vertices = draw.submission.patchVertices;
    for (const Place& each : places) {
        // At another moment a buffer may give the draw fewer of them.
        if ((each.patch + 1) * vertices > elements.count || each.instance >= elements.instances) continue;
        setFirstPatch(built.interface.facts, each.patch);
        glUniform1i(instance, each.instance);
        found.push_back(captured(areLines ? GL_LINES : GL_TRIANGLES, *buffer_,
                                 [&] { submit(elements, each.patch * vertices, vertices, each.instance); }));
    }
    glDisable(GL_RASTERIZER_DISCARD);
    glBindBufferBase(GL_TRANSFORM_FEEDBACK_BUFFER, 0, 0);
    if (!hasControlStage(built)) setDefaultLevels(stated, areLines, 0);
    built.program->use();
    return found;
}

PatchProbe::Captured PatchProbe::worst(const plan::PlannedDraw& draw, const FrameDrawer::Elements& elements,
                                       std::vector<Place>& places) {
    const Captured stated = capture(draw, {}, elements, places);
    const Captured low = capture(draw, {{}, kLowLevel}, elements, places);
    const Captured high = capture(draw, {{}, kHighLevel}, elements, places);
    if (!stated || !low || !high) return std::nullopt;
    const glm::dvec2 size(options_.width, options_.height);
    const auto errorOf = [&](const budget::Patch& coarse, const budget::Patch& fine) {
        if (coarse.vertices.empty() || fine.vertices.empty()) return 0.;
        return budget::patchError(coarse, fine, size).value_or(std::numeric_limits<double>::infinity());
    };
    std::vector<std::pair<double, std::size_t>> ranks;
    for (std::size_t i = 0; i < places.size(); ++i)
        ranks.emplace_back(-errorOf((*stated)[i], (*high)[i]) - errorOf((*low)[i], (*high)[i]), i);
    std::ranges::stable_sort(ranks, {}, [](const auto& each) { return each.first; });
    std::vector<Place> kept;
    for (std::size_t i = 0; i < std::min(kMostPatches, ranks.size()); ++i)
        kept.push_back(places[ranks[i].second]);
    places = std::move(kept);
    return std::vector<budget::Patch>();
}

PatchProbe::Captured PatchProbe::captureChosen(const plan::PlannedDraw& draw, const budget::Levels& levels) {
    const BuiltProgram* built = loaded_->conductor.drawer->programOf(draw);
    const int vertices = draw.submission.patchVertices;
    if (built == nullptr || vertices <= 0 ||
        loaded_->conductor.device.meshes().onDevice(loaded_->conductor.plan, draw.mesh) == nullptr)
        return std::nullopt;
    const FrameDrawer::Elements elements = loaded_->conductor.drawer->submittedBy(draw);
    const bool readsBase = std::ranges::any_of(built->interface.facts.stages, [](const auto& each) {
        return each.source.find("gl_BaseInstance") != std::string::npos;
    });
    if (elements.instances > 1 && (glDrawArraysInstancedBaseInstance == nullptr || readsBase))
        return std::nullopt;
    auto [known, isNew] = places_.try_emplace(draw.step);
    if (isNew) {
        const auto each = static_cast<std::size_t>(elements.count / vertices);
        const std::size_t all = each * static_cast<std::size_t>(elements.instances);
        const std::size_t stride = all > kMostLookedAt ? (all - 1) / kMostLookedAt + 1 : 1;
        for (std::size_t i = 0; i < all; i += stride)
            known->second.push_back({static_cast<int>(i % each), static_cast<int>(i / each)});
        if (known->second.size() > kMostPatches && !worst(draw, elements, known->second)) return std::nullopt;
    }
    return capture(draw, levels, elements, known->second);
}

std::optional<std::vector<budget::Patch>> PatchProbe::patches(std::size_t pass, std::size_t step,
                                                              const budget::Levels& levels) {
    if (!prepare()) return std::nullopt;
    SceneState& state = *loaded_;
    const scene::StepIndex wanted{pass, step};
    std::vector<budget::Patch> all;
    for (const double moment : moments_) {
        state.conductor.forgetDrawn();
        Captured found;
        state.conductor.drawer->setDrawHook([&](const plan::PlannedDraw& draw, bool, bool begins) {
            if (begins && draw.step == wanted) found = captureChosen(draw, levels);
        });
        const Result<image::Image> drawn = state.draw(moment, stats_);
        state.conductor.drawer->setDrawHook({});
        if (!drawn || !found) return std::nullopt;
        std::ranges::move(*found, std::back_inserter(all));
    }
    return all;
}

}  // namespace glibra::render
