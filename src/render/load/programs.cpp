#include "render/load/programs.h"

#include <fmt/format.h>
#include <algorithm>
#include <charconv>
#include <cstddef>
#include <string_view>
#include <utility>

#include "glsl/emit/log.h"
#include "glsl/es/parts.h"
#include "glsl/facts/stage_variables.h"
#include "glsl/types/translated_program.h"
#include "gpu/object/uniform.h"
#include "plan/accesses.h"
#include "plan/submission.h"
#include "render/load/gl_names.h"

namespace glibra::render {
namespace {

// Anisotropic filters of Mesa's software drivers read every texel that a pixel covers. Where a texture has no
// coarser level left, those are millions: a plane to the horizon takes minutes.

/// How texture() is bounded in the shaders of a scene.
struct FilterBound {
    bool repeats = false;  ///< one of the textures with `aniso` repeats; otherwise coordinates are clamped
};

inline constexpr int kMostTexels = 1024;

/// A sampler that the functions below pass on, and the type of its coordinates.
struct PassedSampler {
    std::string_view suffix, coordinates;
    bool takesBias;
};
constexpr std::array<PassedSampler, 7> kColorSamplers{{{"1D", "float", true},
                                                       {"3D", "vec3", true},
                                                       {"Cube", "vec3", true},
                                                       {"1DArray", "vec2", true},
                                                       {"2DArray", "vec3", true},
                                                       {"CubeArray", "vec4", true},
                                                       {"2DRect", "vec2", false}}};
constexpr std::array<PassedSampler, 6> kShadowSamplers{{{"1D", "vec3", true},
                                                        {"2D", "vec3", true},
                                                        {"Cube", "vec4", true},
                                                        {"1DArray", "vec3", true},
                                                        {"2DArray", "vec4", false},
                                                        {"2DRect", "vec3", false}}};

/// The gradients make an ellipse of half axes `w` around the pixel, in texels of the coarsest level. The
/// driver takes gradients from the coordinates in every texture function, so the four pixels of a quad decide
/// together, and those that cover too much give it constant coordinates. `{3}` wraps the coordinates.
constexpr std::string_view kBounded =
    "vec4 glibra_bounded(sampler2D s, vec2 p{0}) {{ "
    "vec2 dx = dFdx(p), dy = dFdy(p); "
    "int last = textureQueryLevels(s) - 1; "
    "vec2 size = vec2(textureSize(s, last)), w = sqrt(dx * dx + dy * dy) * size; "
    "float wide = step({2}., (2. * w.x + 1.) * (2. * w.y + 1.)); "
    "wide = max(wide, fwidth(wide)); wide = max(wide, fwidth(wide)); "
    "vec4 all = texture(s, wide > 0. ? vec2(0.) : p{1}), few = vec4(0.); "
    "for (int i = 0; i < 16; ++i) {{ "
    "vec2 at = p + (float(i % 4) - 1.5) * .25 * dx + (float(i / 4) - 1.5) * .25 * dy; "
    "few += texelFetch(s, min(ivec2({3} * size), ivec2(size) - 1), last) * .0625; }} "
    "return wide > 0. ? few : all; }} ";

std::string passedOn(std::string_view value, const std::string& sampler, const PassedSampler& row) {
    std::string text = fmt::format("{0} glibra_bounded({1} s, {2} p) {{ return texture(s, p); }} ", value,
                                   sampler, row.coordinates);
    if (row.takesBias)
        text += fmt::format("{0} glibra_bounded({1} s, {2} p, float b) {{ return texture(s, p, b); }} ",
                            value, sampler, row.coordinates);
    return text;
}

std::string functions(bool repeats) {
    const char* wrapped = repeats ? "fract(at)" : "clamp(at, vec2(0.), vec2(1.))";
    std::string text = fmt::format(fmt::runtime(kBounded), "", "", kMostTexels, wrapped);
    text += fmt::format(fmt::runtime(kBounded), ", float b", ", b", kMostTexels, wrapped);
    for (const std::string_view prefix : {"", "i", "u"}) {
        const std::string value = fmt::format("{}vec4", prefix);
        for (const PassedSampler& each : kColorSamplers)
            text += passedOn(value, fmt::format("{}sampler{}", prefix, each.suffix), each);
        if (!prefix.empty())
            text += passedOn(value, fmt::format("{}sampler2D", prefix), {"2D", "vec2", true});
    }
    for (const PassedSampler& each : kShadowSamplers)
        text += passedOn("float", fmt::format("sampler{}Shadow", each.suffix), each);
    return text +
           "float glibra_bounded(samplerCubeArrayShadow s, vec4 p, float c) { return texture(s, p, c); }";
}

/// The number of the #version line; 0 without one.
int versionOf(std::string_view source) {
    constexpr std::string_view kWord = "#version ";
    int version = 0;
    if (source.starts_with(kWord))
        std::from_chars(source.data() + kWord.size(), source.data() + source.size(), version);
    return version;
}

/// The byte and the number of the line after the #version and #extension lines.
struct Spot {
    std::size_t byte = 0, line = 0;
};
Spot afterExtensions(std::string_view source) {
    Spot spot;
    while (spot.byte < source.size()) {
        const std::size_t end = source.find('\n', spot.byte);
        if (end == std::string_view::npos) break;
        const std::string_view line = source.substr(spot.byte, end - spot.byte);
        if (!line.empty() && !line.starts_with("#version") && !line.starts_with("#extension")) break;
        spot = {end + 1, spot.line + 1};
    }
    return spot;
}

/// The bound of a scene with `aniso` at a texture or sampler; nothing for other scenes.
std::optional<FilterBound> filterBoundOf(const scene::Scene& scene) {
    std::optional<FilterBound> bound;
    const auto look = [&](const base::SamplerState& state) {
        if (state.anisotropy <= 1) return;
        if (!bound) bound = FilterBound{};
        bound->repeats = bound->repeats || base::repeats(state.wrap[0]) || base::repeats(state.wrap[1]);
    };
    for (const scene::Texture& each : scene.textures) look(each.sampler);
    for (const scene::Sampler& each : scene.samplers) look(each.state);
    return bound;
}

/// Rewrites a fragment stage so that texture() of a sampler2D reads 16 texels of the coarsest level, evenly
/// over the pixel, where that covers more than kMostTexels of them. All other pixels keep their bytes. Does
/// nothing for other stages and below GLSL 4.30. Returns whether it has changed the stage.
bool boundFilter(glsl::TranslatedStage& stage, const FilterBound& bound) {
    constexpr int kWithLevels = 430;  // textureQueryLevels()
    if (stage.stage != glsl::Stage::fragment || versionOf(stage.source) < kWithLevels ||
        stage.source.find("texture") == std::string::npos)
        return false;
    const Spot spot = afterExtensions(stage.source);
    stage.source.insert(spot.byte, functions(bound.repeats) + "\n#define texture glibra_bounded\n");
    const auto at = static_cast<std::ptrdiff_t>(std::min(spot.line, stage.lineMap.lines.size()));
    stage.lineMap.lines.insert(stage.lineMap.lines.begin() + at, 2, glsl::LineOrigin{});
    stage.lineMap.columns.insert(stage.lineMap.columns.begin() +
                                     std::min(at, static_cast<std::ptrdiff_t>(stage.lineMap.columns.size())),
                                 2, std::vector<glsl::ColumnShift>{});
    return true;
}

glsl::Target glslTargetOf(const gpu::Capabilities& capabilities) {
    glsl::Target target;
    target.version = capabilities.isEs ? 450 : std::clamp(capabilities.glslVersion, 410, 450);
    target.lineDirectiveTakesFileName = capabilities.hasExtension("GL_ARB_shading_language_include");
    target.maxGeometryOutputVertices = capabilities.maxGeometryOutputVertices;
    target.maxGeometryTotalOutputComponents = capabilities.maxGeometryTotalOutputComponents;
    target.hasExtension = [&capabilities](std::string_view name) {
        // Without OpenGL 4.3 there is nothing to bind storage with, and without 4.2 no images, whatever
        // shaders may say.
        const bool isStorage =
            name == "GL_ARB_shader_storage_buffer_object" || name == "GL_ARB_shader_atomic_counters";
        const bool isImage = name == "GL_ARB_shader_image_load_store";
        return capabilities.hasExtension(name) && (capabilities.compute || !isStorage) &&
               (capabilities.atLeast(4, 2) || !isImage);
    };
    return target;
}

/// The name that the user wrote. An emitted name may be "glibra_x" or "block.glibra_x[2].glibra_y", and the
/// translator may have renamed any part of it.
std::string userName(const std::string& emitted, const glsl::TranslatedProgram& facts) {
    if (const auto whole = facts.userNames.find(emitted); whole != facts.userNames.end())
        return whole->second;
    std::string name;
    for (std::size_t begin = 0; begin < emitted.size();) {
        const std::size_t end = std::min(emitted.find_first_of(".[]", begin), emitted.size());
        const std::string part = emitted.substr(begin, end - begin);
        const auto renamed = facts.userNames.find(part);
        name += renamed == facts.userNames.end() ? part : renamed->second;
        if (end < emitted.size()) name += emitted[end];
        begin = end + 1;
    }
    return name;
}

/// The values of all uniforms of the default block, which no draw has set yet.
std::vector<InitialValue> initialValues(const BuiltProgram& built) {
    std::vector<InitialValue> values;
    for (std::size_t i = 0; i < built.interface.uniforms.size(); ++i) {
        const base::ActiveUniform& uniform = built.interface.uniforms[i];
        const bool isOpaque =
            uniform.type.base == base::BaseType::sampler || uniform.type.base == base::BaseType::image;
        if (uniform.block >= 0 || isOpaque) continue;
        for (int element = 0; element < std::max(1, uniform.arraySize); ++element)
            values.push_back(
                {plan::UniformIndex(i), element, gpu::getUniform(*built.program, uniform, element)});
    }
    return values;
}

/// The active outputs of the fragment stage by its text, for drivers that do not list them.
std::vector<base::ActiveOutput> declaredOutputs(const glsl::TranslatedProgram& translated,
                                                const gpu::Program& program) {
    std::vector<base::ActiveOutput> outputs;
    for (const glsl::TranslatedStage& stage : translated.stages) {
        if (stage.stage != glsl::Stage::fragment) continue;
        for (const glsl::StageVariable& each : glsl::stageVariables(stage, translated.userNames)) {
            const int location = each.isOutput ? gpu::outputLocation(program, each.expression) : -1;
            if (location < 0) continue;
            const bool isInteger = each.type.starts_with('i'), isUnsigned = each.type.starts_with('u');
            base::ValueType type{.word = each.type};
            type.rows = each.components();
            if (isInteger) type.base = base::BaseType::integer;
            if (isUnsigned) type.base = base::BaseType::unsignedInteger;
            outputs.push_back({each.expression, location, type, std::max(1, each.elements)});
        }
    }
    return outputs;
}

/// One input for the corners of a primitive, at the location of the first (glsl::ExpandedGeometry).
void collapseCorners(std::vector<base::ActiveInput>& inputs, int corners) {
    std::vector<base::ActiveInput> whole;
    for (base::ActiveInput& each : inputs) {
        const std::size_t end = each.name.find('_', std::string_view(glsl::kCornerInput).size());
        if (!each.name.starts_with(glsl::kCornerInput) || end == std::string::npos) continue;
        each.name.erase(0, end + 1);
        each.location -= each.location % corners;
        if (std::ranges::find(whole, each.name, &base::ActiveInput::name) == whole.end())
            whole.push_back(std::move(each));
    }
    inputs = std::move(whole);
}

/// Completes the interface of a program that was linked, or failed.
void completeInterface(BuiltProgram& built, glsl::TranslatedProgram facts, bool isBuiltin) {
    for (base::ActiveUniform& each : built.interface.uniforms) each.name = userName(each.emittedName, facts);
    built.interface.facts = std::move(facts);
    built.interface.usable = built.program.has_value();
    built.interface.isBuiltin = isBuiltin;
}

}  // namespace

ProgramLibrary::ProgramLibrary(const gpu::Context& context, const scene::Scene& scene,
                               const RenderOptions& options, bool tiled, Stats& stats, SharedParts* shared)
    : context_(context),
      scene_(scene),
      options_(options),
      tiled_(tiled),
      stats_(stats),
      shared_(shared),
      sources_(scene, options, stats) {}

/// Components of a GLSL type.
static int rowsOf(const std::string& type) {
    const char last = type.empty() ? '1' : type.back();
    return last >= '2' && last <= '4' ? last - '0' : 1;
}

glsl::ProgramRequest ProgramLibrary::request(const plan::ProgramVariant& variant, Diagnostics& diagnostics) {
    glsl::ProgramRequest request = sources_.request(variant, tiled_, diagnostics);
    request.target = glslTargetOf(context_.capabilities());
    request.reversesOrder = isReversed_;
    if (context_.capabilities().isEs)
        request.draws = plan::drawFormsOf(scene_, variant.program, context_.capabilities().widestLine());
    return request;
}

bool ProgramLibrary::compile(const plan::ProgramVariant& variant, const glsl::TranslatedProgram& translated,
                             BuiltProgram& built, Diagnostics& diagnostics) {
    const Place programPlace = variant.program ? scene_.programs[variant.program].place : Place{};
    const StageTimer timer(stats_, "compile");
    std::vector<gpu::StageSource> stages;
    for (const glsl::TranslatedStage& each : translated.stages)
        stages.push_back({glStage(each.stage), each.source});
    gpu::ProgramSource source{.stages = stages};
    if (translated.expanded.measuresLevels)
        source.captured.assign(glsl::kLevelOutputs.begin(), glsl::kLevelOutputs.end());
    if (translated.expanded.mostEmitted > 0)
        source.captured.assign(glsl::kStripOutputs.begin(), glsl::kStripOutputs.end());
    if (!translated.wideLines.captured.empty()) source.captured = translated.wideLines.captured;
    gpu::BuildOutcome outcome = gpu::buildProgram(context_.capabilities(), source);
    for (std::size_t i = 0; i < outcome.stages.size(); ++i) {
        if (outcome.stages[i].compiled) continue;
        Diagnostics found = glsl::explainCompileLog(translated, translated.stages[i], outcome.stages[i].log);
        if (!hasError(found))
            found.push_back(diagnose("glsl-E01",
                                     "the driver does not compile the shader: " + outcome.stages[i].log,
                                     {translated.stages[i].path, translated.stages[i].firstLine, 1}));
        append(diagnostics, std::move(found));
    }
    if (!outcome.program && !hasError(diagnostics)) {
        append(diagnostics, glsl::explainLinkLog(translated, outcome.linkLog, programPlace));
        if (!hasError(diagnostics))
            diagnostics.push_back(diagnose(
                "glsl-E02", "the driver does not link the program: " + outcome.linkLog, programPlace));
    }
    stats_.add("programs", 1);
    if (!outcome.program) return false;
    static_cast<base::ActiveResources&>(built.interface) = gpu::reflect(*outcome.program);
    if (translated.expanded.corners > 0) collapseCorners(built.interface.inputs, translated.expanded.corners);
    for (const auto& [name, type] : translated.expanded.fetched)
        built.interface.inputs.push_back({.name = name, .type = {.rows = rowsOf(type), .word = type}});
    // Nobody but the drawer gives these a texture (PatchDivider, FetchedInputs, LineWidener).
    std::erase_if(built.interface.uniforms, [](const base::ActiveUniform& each) {
        return each.emittedName == glsl::kCoordinates || each.emittedName == glsl::kFetchedInputs ||
               each.emittedName == glsl::kLineEnds;
    });
    if (!context_.capabilities().atLeast(4, 3))
        built.interface.outputs = declaredOutputs(translated, *outcome.program);
    built.program = std::move(outcome.program);
    for (const glsl::InitialValue& value : translated.initialValues)
        for (const base::ActiveUniform& each : built.interface.uniforms)
            if (each.emittedName == value.uniform) gpu::setUniform(*built.program, each, value.numbers);
    for (const base::ActiveUniform& each : built.interface.uniforms)
        if (each.emittedName == glsl::kRounds)
            gpu::setUniform(*built.program, each, std::array{double{glsl::kMostRounds}});
    takeRecord(glsl::kUndefinedBlock, glsl::kNumbersPerSite * translated.undefinedSites.size(), built,
               diagnostics);
    return true;
}

void ProgramLibrary::build(const plan::ProgramVariant& variant, BuiltProgram& built) {
    const Translation& translation = translationOf(variant);
    Diagnostics diagnostics = translation.diagnostics;
    glsl::TranslatedProgram translated;
    if (translation.program) {
        translated = *translation.program;
        for (Diagnostic& each : translated.diagnostics)
            if (each.id != "glsl-W11")
                continue;
            else if (variant.isFill)
                each.text +=
                    "; Fill leaves out the stages before an earlier Program, so write them again "
                    "before this one";
            else if (translated.suppliesVertexStage && each.suggestion.empty())
                each.text += "; the vertex stage that covers the target gives vST alone";
        append(diagnostics, std::move(translated.diagnostics));
    }
    if (!hasError(diagnostics)) {
        if (const auto bound = context_.capabilities().isSoftware ? filterBoundOf(scene_) : std::nullopt)
            for (glsl::TranslatedStage& each : translated.stages)
                if (boundFilter(each, *bound) && variant.program)
                    stats_.skip(
                        "texels",
                        fmt::format("aniso on a software driver: a pixel that covers more than {} texels "
                                    "of the coarsest level reads 16 of them",
                                    kMostTexels),
                        scene_.programs[variant.program].place);
        built.key = keyOf(variant, translated);
        if (BuiltProgram* earlier = earlierByKey(built.key)) {
            built.program = std::exchange(earlier->program, std::nullopt);
            // A copy: the earlier library's plan may still be read.
            static_cast<base::ActiveResources&>(built.interface) = earlier->interface;
            built.remarks = std::move(earlier->remarks);
            built.initialValues = std::move(earlier->initialValues);
        } else if (scene_.suppliesNames || !borrow(variant, built)) {
            if (!compile(variant, translated, built, built.remarks)) built.refused = translated.stages;
            if (scene_.suppliesNames && built.program) built.initialValues = initialValues(built);
        }
        append(diagnostics, built.remarks);
    }
    const bool isBuiltin = !variant.program;
    sources_.hideTexts(variant.program, diagnostics);
    if (!sources_.hiddenSource(variant.program).empty()) built.refused.clear();
    if (BuiltProgram* earlier = built.program ? nullptr : lastGoodOf(variant)) {
        built.program = std::exchange(earlier->program, std::nullopt);
        built.interface = std::move(earlier->interface);
        built.interface.facts.diagnostics = std::move(diagnostics);
        built.key = std::move(earlier->key);
        built.remarks = std::move(earlier->remarks);
        built.initialValues = std::move(earlier->initialValues);
        built.isLastGood = true;
        return;
    }
    translated.diagnostics = std::move(diagnostics);
    completeInterface(built, std::move(translated), isBuiltin);
}

bool ProgramLibrary::observe(const BuiltProgram& program, const glsl::MainWrapper& fragment) {
    const auto known = std::ranges::find_if(
        programs_, [&](const KnownProgram& each) { return each.second.get() == &program; });
    if (known == programs_.end()) return false;
    glsl::TranslatedProgram stages = program.interface.facts;
    stages.diagnostics.clear();
    for (glsl::TranslatedStage& each : stages.stages)
        if (each.stage == glsl::Stage::fragment) each.source = glsl::wrappedMain(each, fragment);
    auto built = std::make_unique<BuiltProgram>();
    if (!compile(known->first, stages, *built, built->remarks)) return false;
    if (scene_.suppliesNames) built->initialValues = initialValues(*built);
    completeInterface(*built, std::move(stages), program.interface.isBuiltin);
    observed_.emplace(known->first, std::move(built));
    return true;
}

const plan::ProgramInterface& ProgramLibrary::interfaceOf(const plan::ProgramVariant& variant) {
    if (const BuiltProgram* known = find(variant)) return known->interface;
    programs_.emplace_back(variant, std::make_unique<BuiltProgram>());
    build(variant, *programs_.back().second);
    return programs_.back().second->interface;
}

const BuiltProgram* ProgramLibrary::find(const plan::ProgramVariant& variant) const {
    if (observed_ && observed_->first == variant) return observed_->second.get();
    for (const auto& [known, built] : programs_)
        if (known == variant) return built.get();
    return nullptr;
}

bool ProgramLibrary::mayWriteImages(scene::ProgramIndex program) {
    const Translation& translation = translationOf(plan::plainVariant(scene_, program));
    return translation.program != nullptr && plan::writesMemory(*translation.program);
}

}  // namespace glibra::render
