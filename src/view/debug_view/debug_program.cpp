#include "view/debug_view/debug_program.h"

#include <embedded/debug_shaders.h>
#include <fmt/format.h>
#include <algorithm>
#include <cmath>

#include "glsl/emit/emit.h"
#include "gpu/object/uniform.h"
#include "render/load/derived_program.h"
#include "render/load/gl_names.h"

namespace glibra::view {
namespace {

using Rgb = std::array<std::uint8_t, 3>;

constexpr Rgb kNothing{24, 24, 28};
constexpr Rgb kFront{70, 130, 220};
constexpr Rgb kBack{235, 120, 40};
constexpr std::array<Rgb, 9> kCounts{{{0, 0, 0},
                                      {20, 30, 110},
                                      {30, 80, 200},
                                      {30, 160, 180},
                                      {50, 180, 60},
                                      {220, 210, 40},
                                      {240, 140, 30},
                                      {220, 40, 30},
                                      {255, 255, 255}}};
constexpr double kFarthestGrey = .12;

bool isSomething(const float* rgba) {
    return rgba[3] > 0;
}

double shownNumber(DebugView kind, const float* rgba) {
    return rgba[kind == DebugView::depth ? 1 : 0];
}

Rgb colorOfCoordinates(const float* rgba) {
    const auto inside = [](double value) { return value >= 0 && value <= 1; };
    const auto part = [&](double value) { return inside(value) ? value : value - std::floor(value); };
    if (!std::isfinite(rgba[0]) || !std::isfinite(rgba[1])) return {255, 0, 255};
    return {asByte(part(rgba[0])), asByte(part(rgba[1])),
            asByte(inside(rgba[0]) && inside(rgba[1]) ? 0 : .5)};
}

Rgb texelColor(DebugView kind, const float* rgba, const ValueRange& range) {
    switch (kind) {
        case DebugView::coordinates:
            return colorOfCoordinates(rgba);
        case DebugView::facing:
            return rgba[0] > .5F ? kFront : kBack;
        case DebugView::depth: {
            const double extent = range.highest - range.lowest;
            const double part = extent > 0 ? (shownNumber(kind, rgba) - range.lowest) / extent : 0;
            const std::uint8_t grey = asByte(1 - (1 - kFarthestGrey) * part);
            return {grey, grey, grey};
        }
        default:
            return colorOfCount(rgba[0]);
    }
}

constexpr std::string_view kEyeOfFragment =
    "uniform mat4 glibra_debugProjectionInverse;\nuniform vec2 glibra_debugSize, glibra_debugToClip;\n"
    "vec3 glibra_debugEye(float depth) {\n"
    "    vec4 eye = glibra_debugProjectionInverse *\n"
    "               vec4(2. * gl_FragCoord.xy / glibra_debugSize - 1., dot(glibra_debugToClip, vec2(depth, "
    "1.)), 1.);\n"
    "    return eye.xyz / eye.w;\n}\n";

/// GLSL that is added to a fragment stage.
struct Addition {
    std::string declarations = "layout(location = 7) out vec4 glibra_debugNumber;\n";
    std::string before, body;
};

Addition fragmentAddition(bool maySetDepth, DebugView kind, DebugStages stages, bool isVertexAlone) {
    Addition add;
    if (stages == DebugStages::flatNormals) {
        add.declarations += kEyeOfFragment;
        add.body =
            "    vec3 eye = glibra_debugEye(gl_FragCoord.z);\n"
            "    glibra_debugNumber = vec4(normalize(cross(dFdx(eye), dFdy(eye))) * .5 + .5, 1.);\n";
        return add;
    }
    switch (kind) {
        case DebugView::coordinates:
            if (isVertexAlone) add.declarations += "in vec4 glibra_debugST;\n";
            add.body = isVertexAlone ? "    glibra_debugNumber = vec4(glibra_debugST.stp, 1.);\n"
                                     : "    glibra_debugNumber = vec4(vST.st, 0., 1.);\n";
            break;
        case DebugView::facing:
            add.body = "    glibra_debugNumber = vec4(gl_FrontFacing ? 1. : 0., 0., 0., 1.);\n";
            break;
        case DebugView::depth: {
            add.declarations += kEyeOfFragment;
            // The stage may write the depth under a condition, so it gets its value first.
            if (maySetDepth) add.before = "    gl_FragDepth = gl_FragCoord.z;\n";
            add.body = std::string("    float depth = ") + (maySetDepth ? "gl_FragDepth" : "gl_FragCoord.z") +
                       ";\n    glibra_debugNumber = vec4(depth, -glibra_debugEye(depth).z, 0., 1.);\n";
            break;
        }
        default:
            add.body = "    glibra_debugNumber = vec4(1.);\n";
    }
    return add;
}

/// The normal of a vertex is unknown if the vertex stage moves the vertex elsewhere than the matrices do.
constexpr std::string_view kNormalDeclarations =
    "in vec4 glibra_debugPosition;\nin vec3 glibra_debugNormal;\n"
    "uniform mat4 glibra_debugModelViewProjection;\nuniform mat3 glibra_debugNormalMatrix;\n"
    "out vec4 glibra_debugNormalOut;\n";
constexpr std::string_view kNormalBody =
    "    vec4 plain = glibra_debugModelViewProjection * glibra_debugPosition;\n"
    "    bool stays = length(gl_Position - plain) <= 1e-4 * length(plain);\n"
    "    vec3 normal = glibra_debugNormalMatrix * glibra_debugNormal;\n"
    "    bool isThere = stays && dot(normal, normal) > 0.;\n"
    "    glibra_debugNormalOut = isThere ? vec4(normalize(normal), 1.) : vec4(0.);\n";

std::string normalsGeometry(const std::string& version, bool fromVertices) {
    return version +
           (fromVertices ? "in vec4 glibra_debugNormalOut[3];\n"
                           "vec4 glibra_debugNormalOf(int corner) { return glibra_debugNormalOut[corner]; }\n"
                         : "vec4 glibra_debugNormalOf(int corner) { return vec4(0.); }\n") +
           std::string(debug_shaders::normals_geom());
}

/// A fragment stage that only writes the number.
std::string fragmentAlone(const glsl::TranslatedStage& like, DebugView kind, DebugStages stages,
                          bool isVertexAlone) {
    const Addition alone = fragmentAddition(false, kind, stages, isVertexAlone);
    return glsl::versionLine(like) + alone.declarations + "void main() {\n" + alone.body + "}\n";
}

std::optional<DebugProgram> link(const gpu::Context& context, const render::BuiltProgram& from,
                                 const StageTexts& texts) {
    std::optional<gpu::Program> program = linkStages(context.capabilities(), from, texts);
    if (!program) return std::nullopt;
    base::ActiveResources resources = gpu::reflect(*program);
    return DebugProgram{std::move(*program), std::move(resources)};
}

}  // namespace

std::string_view nameOf(DebugView kind) {
    constexpr std::array<std::string_view, kDebugViewCount> kNames{
        "picture", "normals", "texture coordinates", "facing", "overdraw", "layers", "depth"};
    return kNames.at(static_cast<std::size_t>(kind));
}

ValueRange rangeOf(DebugView kind, const TexelImage& numbers) {
    ValueRange range;
    for (std::size_t i = 0; i + 3 < numbers.rgba.size(); i += 4) {
        const float* texel = numbers.rgba.data() + i;
        const double number = shownNumber(kind, texel);
        if (!isSomething(texel) || !std::isfinite(number)) continue;
        range.lowest = range.isEmpty ? number : std::min(range.lowest, number);
        range.highest = range.isEmpty ? number : std::max(range.highest, number);
        range.isEmpty = false;
    }
    return range;
}

std::array<std::uint8_t, 3> colorOfCount(double count) {
    const double last = static_cast<double>(kCounts.size()) - 1;
    return kCounts.at(static_cast<std::size_t>(std::clamp(count, 0.0, last)));
}

std::vector<std::uint8_t> colorsOf(DebugView kind, const TexelImage& numbers) {
    const ValueRange range = rangeOf(kind, numbers);
    std::vector<std::uint8_t> bytes(numbers.rgba.size(), 255);
    for (std::size_t i = 0; i + 3 < bytes.size(); i += 4) {
        const float* texel = numbers.rgba.data() + i;
        const Rgb color = isSomething(texel) ? texelColor(kind, texel, range) : kNothing;
        std::copy(color.begin(), color.end(), bytes.begin() + static_cast<std::ptrdiff_t>(i));
    }
    return bytes;
}

std::string wordsOf(DebugView kind, const float* rgba) {
    if (!isSomething(rgba)) return "nothing is drawn here";
    switch (kind) {
        case DebugView::picture:
        case DebugView::normals:
            return {};
        case DebugView::coordinates:
            return fmt::format("s {:.4g}, t {:.4g}, p {:.4g}", rgba[0], rgba[1], rgba[2]);
        case DebugView::facing:
            return rgba[0] > .5F ? "front" : "back";
        case DebugView::depth:
            return fmt::format("depth {:.5g}, {:.4g} from the eye", rgba[0], rgba[1]);
        case DebugView::overdraw:
        case DebugView::layers:
            break;
    }
    return fmt::format("{:g} fragment{}", rgba[0], rgba[0] == 1 ? "" : "s");
}

void writeOnly(int output) {
    std::array<GLenum, kDebugOutput + 1> outputs{};
    outputs.fill(GL_NONE);
    outputs.at(static_cast<std::size_t>(output)) = GL_COLOR_ATTACHMENT0;
    glDrawBuffers(output + 1, outputs.data());
}

std::optional<gpu::Program> linkStages(const gpu::Capabilities& capabilities,
                                       const render::BuiltProgram& from, const StageTexts& texts,
                                       std::vector<std::string> captured) {
    std::vector<gpu::StageSource> stages;
    stages.reserve(texts.size());
    for (const auto& [stage, text] : texts) stages.push_back({stage, text});
    return gpu::buildProgram(capabilities, {.stages = stages,
                                            .vertexInputs = render::inputLocations(from),
                                            .fragmentOutputs = {},
                                            .captured = std::move(captured)})
        .program;
}

const glsl::TranslatedStage* stageOf(const render::BuiltProgram& built, glsl::Stage stage) {
    const auto& stages = built.interface.facts.stages;
    const auto found = std::ranges::find(stages, stage, &glsl::TranslatedStage::stage);
    return found == stages.end() ? nullptr : &*found;
}

bool hasStagesAfterVertices(const render::BuiltProgram& built) {
    return stageOf(built, glsl::Stage::geometry) != nullptr ||
           stageOf(built, glsl::Stage::tessEvaluation) != nullptr;
}

std::optional<DebugProgram> makeDebugProgram(const gpu::Context& context, const render::BuiltProgram& built,
                                             DebugView kind, DebugStages stages) {
    const bool isVertexAlone = !hasStagesAfterVertices(built);
    const bool asLines = stages == DebugStages::normalLines;
    const std::string& tessellated = built.interface.facts.tessellationOutput;
    if (asLines &&
        (stageOf(built, glsl::Stage::geometry) != nullptr || !(isVertexAlone || tessellated == "triangles")))
        return std::nullopt;
    StageTexts sources;
    std::string ownFragment;  // used if the scene's does not link with the additions
    for (const glsl::TranslatedStage& each : built.interface.facts.stages) {
        std::string source = each.source;
        const std::string version = glsl::versionLine(each);
        if (each.stage == glsl::Stage::vertex && isVertexAlone && asLines)
            source = glsl::wrappedMain(each, {kNormalDeclarations, "", kNormalBody});
        if (each.stage == glsl::Stage::vertex && isVertexAlone && !asLines && kind == DebugView::coordinates)
            source = glsl::wrappedMain(each, {"in vec4 glibra_debugCoordinates;\nout vec4 glibra_debugST;\n",
                                              "", "    glibra_debugST = glibra_debugCoordinates;\n"});
        if (each.stage == glsl::Stage::fragment && asLines) {
            sources.emplace_back(GL_GEOMETRY_SHADER, normalsGeometry(version, isVertexAlone));
            source = version + std::string(debug_shaders::normals_frag());
        } else if (each.stage == glsl::Stage::fragment) {
            const Addition add = fragmentAddition(each.facts.mayWriteDepth, kind, stages, isVertexAlone);
            source = glsl::wrappedMain(each, {add.declarations, add.before, add.body});
            ownFragment = fragmentAlone(each, kind, stages, isVertexAlone);
        }
        sources.emplace_back(render::glStage(each.stage), std::move(source));
    }
    const bool hasFragment = stageOf(built, glsl::Stage::fragment) != nullptr;
    const auto& all = built.interface.facts.stages;
    if (!hasFragment && !asLines && !all.empty())  // of a pass without colours
        sources.emplace_back(GL_FRAGMENT_SHADER, fragmentAlone(all.front(), kind, stages, isVertexAlone));
    std::optional<DebugProgram> made = link(context, built, sources);
    if (made || ownFragment.empty()) return made;
    for (auto& [stage, text] : sources)
        if (stage == GL_FRAGMENT_SHADER) text = ownFragment;
    return link(context, built, sources);
}

std::optional<DebugProgram> makeCoverageProgram(const gpu::Context& context,
                                                const render::BuiltProgram& built) {
    StageTexts sources;
    for (const glsl::TranslatedStage& each : built.interface.facts.stages)
        if (each.stage != glsl::Stage::fragment)
            sources.emplace_back(render::glStage(each.stage), each.source);
    if (sources.empty()) return std::nullopt;
    sources.emplace_back(GL_FRAGMENT_SHADER, fragmentAlone(built.interface.facts.stages.front(),
                                                           DebugView::layers, DebugStages::numbers, true));
    return link(context, built, sources);
}

void DebugProgram::set(std::string_view uniform, std::span<const double> values) const {
    for (const base::ActiveUniform& each : resources.uniforms)
        if (each.name == uniform) gpu::setUniform(program, each, values);
}

void DebugProgram::use(const render::BuiltProgram& from) const {
    program.use();
    render::copyUniforms(from, program, resources);
}

}  // namespace glibra::view
