#include "view/lens/lens_program.h"

#include <embedded/lens_shaders.h>
#include <algorithm>
#include <cctype>
#include <string>
#include <vector>

#include "gpu/reflection.h"
#include "gpu/uniform.h"
#include "render/derived_program.h"
#include "render/gl_names.h"

namespace glibra::view {
namespace {

bool hasStage(const render::BuiltProgram& built, glsl::Stage stage) {
    const auto& stages = built.interface.facts.stages;
    return std::any_of(stages.begin(), stages.end(),
                       [&](const glsl::TranslatedStage& each) { return each.stage == stage; });
}

/// True if the source has that name as a word of its own.
bool hasWord(std::string_view source, std::string_view word) {
    const auto isPart = [&](std::size_t at) {
        return at < source.size() &&
               (std::isalnum(static_cast<unsigned char>(source[at])) != 0 || source[at] == '_');
    };
    for (std::size_t at = source.find(word); at != std::string_view::npos; at = source.find(word, at + 1))
        if ((at == 0 || !isPart(at - 1)) && !isPart(at + word.size())) return true;
    return false;
}

/// "#version 450 core\n" of the source.
std::string versionLine(std::string_view source) {
    const std::size_t at = source.find("#version");
    if (at == std::string_view::npos) return "#version 410 core\n";
    return std::string(source.substr(at, source.find('\n', at) - at)) + "\n";
}

/// The source with its main under another name, which `main` calls between `before` and `after`.
std::string wrapped(std::string_view source, std::string_view declarations, std::string_view before,
                    std::string_view after) {
    const std::size_t at = source.find("#version");
    const std::size_t behind =
        at == std::string_view::npos ? 0 : std::min(source.size(), source.find('\n', at) + 1);
    std::string text(source.substr(0, behind));
    text += "#define main glibra_sceneMain\n";
    text += source.substr(behind);
    text += "\n#undef main\n";
    text += declarations;
    text += "void main() {\n";
    text += before;
    text += "    glibra_sceneMain();\n";
    text += after;
    text += "}\n";
    return text;
}

constexpr std::string_view kEyeOfFragment =
    "uniform mat4 glibra_lensProjectionInverse;\nuniform vec2 glibra_lensSize;\n"
    "vec3 glibra_lensEye(float depth) {\n"
    "    vec4 eye = glibra_lensProjectionInverse *\n"
    "               vec4(2. * gl_FragCoord.xy / glibra_lensSize - 1., 2. * depth - 1., 1.);\n"
    "    return eye.xyz / eye.w;\n}\n";

/// What is added to a fragment stage.
struct Addition {
    std::string declarations = "layout(location = 7) out vec4 glibra_lens;\n";
    std::string before, body;
};

Addition fragmentAddition(std::string_view source, Lens lens, LensStages stages, bool isVertexAlone) {
    Addition add;
    if (stages == LensStages::flatNormals) {
        add.declarations += kEyeOfFragment;
        add.body =
            "    vec3 eye = glibra_lensEye(gl_FragCoord.z);\n"
            "    glibra_lens = vec4(normalize(cross(dFdx(eye), dFdy(eye))) * .5 + .5, 1.);\n";
        return add;
    }
    switch (lens) {
        case Lens::coordinates:
            if (isVertexAlone) add.declarations += "in vec4 glibra_lensST;\n";
            add.body = isVertexAlone ? "    glibra_lens = vec4(glibra_lensST.stp, 1.);\n"
                                     : "    glibra_lens = vec4(vST.st, 0., 1.);\n";
            break;
        case Lens::facing:
            add.body = "    glibra_lens = vec4(gl_FrontFacing ? 1. : 0., 0., 0., 1.);\n";
            break;
        case Lens::depth: {
            // It may be written under a condition.
            const bool maySetDepth = hasWord(source, "gl_FragDepth");
            add.declarations += kEyeOfFragment;
            if (maySetDepth) add.before = "    gl_FragDepth = gl_FragCoord.z;\n";
            add.body = std::string("    float depth = ") + (maySetDepth ? "gl_FragDepth" : "gl_FragCoord.z") +
                       ";\n    glibra_lens = vec4(depth, -glibra_lensEye(depth).z, 0., 1.);\n";
            break;
        }
        default:
            add.body = "    glibra_lens = vec4(1.);\n";
    }
    return add;
}

/// Vertices whose stage moves them elsewhere than the matrices do have no normal that anybody knows.
constexpr std::string_view kNormalDeclarations =
    "in vec4 glibra_lensPosition;\nin vec3 glibra_lensNormal;\n"
    "uniform mat4 glibra_lensModelViewProjection;\nuniform mat3 glibra_lensNormalMatrix;\n"
    "out vec4 glibra_lensNormalOut;\n";
constexpr std::string_view kNormalBody =
    "    vec4 plain = glibra_lensModelViewProjection * glibra_lensPosition;\n"
    "    bool stays = length(gl_Position - plain) <= 1e-4 * length(plain);\n"
    "    vec3 normal = glibra_lensNormalMatrix * glibra_lensNormal;\n"
    "    bool isThere = stays && dot(normal, normal) > 0.;\n"
    "    glibra_lensNormalOut = isThere ? vec4(normalize(normal), 1.) : vec4(0.);\n";

std::string normalsGeometry(const std::string& version, bool fromVertices) {
    return version +
           (fromVertices ? "in vec4 glibra_lensNormalOut[3];\n"
                           "vec4 glibra_lensNormalOf(int corner) { return glibra_lensNormalOut[corner]; }\n"
                         : "vec4 glibra_lensNormalOf(int corner) { return vec4(0.); }\n") +
           std::string(lens_shaders::normals_geom());
}

std::optional<LensProgram> link(const gpu::Context& context,
                                const std::vector<std::pair<GLenum, std::string>>& sources) {
    std::vector<gpu::StageSource> stages;
    stages.reserve(sources.size());
    for (const auto& [stage, text] : sources) stages.push_back({stage, text});
    gpu::BuildOutcome built = gpu::buildProgram(
        context.capabilities(), {.stages = stages, .vertexInputs = {}, .fragmentOutputs = {}});
    if (!built.program) return std::nullopt;
    base::ActiveResources resources = gpu::reflect(*built.program);
    return LensProgram{std::move(*built.program), std::move(resources)};
}

}  // namespace

bool hasStagesBehindVertices(const render::BuiltProgram& built) {
    return hasGeometryStage(built) || hasStage(built, glsl::Stage::tessEvaluation);
}
bool hasGeometryStage(const render::BuiltProgram& built) {
    return hasStage(built, glsl::Stage::geometry);
}

std::optional<LensProgram> makeLensProgram(const gpu::Context& context, const render::BuiltProgram& built,
                                           Lens lens, LensStages stages) {
    const bool isVertexAlone = !hasStagesBehindVertices(built);
    const bool asLines = stages == LensStages::normalLines;
    const std::string& tessellated = built.interface.facts.tessellationOutput;
    if (asLines && (hasGeometryStage(built) || !(isVertexAlone || tessellated == "triangles")))
        return std::nullopt;
    std::vector<std::pair<GLenum, std::string>> sources;
    std::string ownFragment;  // if the scene's does not link with ours
    for (const glsl::TranslatedStage& each : built.interface.facts.stages) {
        std::string source = each.source;
        const std::string version = versionLine(source);
        if (each.stage == glsl::Stage::vertex && isVertexAlone && asLines)
            source = wrapped(source, kNormalDeclarations, "", kNormalBody);
        if (each.stage == glsl::Stage::vertex && isVertexAlone && !asLines && lens == Lens::coordinates)
            source = wrapped(source, "in vec4 glibra_lensCoordinates;\nout vec4 glibra_lensST;\n", "",
                             "    glibra_lensST = glibra_lensCoordinates;\n");
        if (each.stage == glsl::Stage::fragment && asLines) {
            sources.emplace_back(GL_GEOMETRY_SHADER, normalsGeometry(version, isVertexAlone));
            source = version + std::string(lens_shaders::normals_frag());
        } else if (each.stage == glsl::Stage::fragment) {
            const Addition add = fragmentAddition(source, lens, stages, isVertexAlone);
            source = wrapped(source, add.declarations, add.before, add.body);
            const Addition alone = fragmentAddition("", lens, stages, isVertexAlone);
            ownFragment = version + alone.declarations + "void main() {\n" + alone.body + "}\n";
        }
        sources.emplace_back(render::glStage(each.stage), std::move(source));
    }
    std::optional<LensProgram> made = link(context, sources);
    if (made || ownFragment.empty()) return made;
    for (auto& [stage, text] : sources)
        if (stage == GL_FRAGMENT_SHADER) text = ownFragment;
    return link(context, sources);
}

void LensProgram::set(std::string_view uniform, std::span<const double> values) const {
    for (const base::ActiveUniform& each : resources.uniforms)
        if (each.name == uniform) gpu::setUniform(program, each, values);
}

void LensProgram::copyUniforms(const render::BuiltProgram& from) const {
    render::copyUniforms(from, program, resources);
}

}  // namespace glibra::view
