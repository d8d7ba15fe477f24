#include "render/draw/patch_split.h"

#include <glad/gl.h>

#include <algorithm>
#include <optional>
#include <string>

#include "gpu/object/query.h"

namespace glibra::render {
namespace {

constexpr const char* kFirstPatch = "glibra_FirstPatch";
constexpr const char* kFirstPrimitive = "glibra_FirstPrimitive";

bool reads(const glsl::TranslatedStage& stage, const char* name) {
    return stage.source.find(name) != std::string::npos;
}

bool anyReads(const glsl::TranslatedProgram& program, const char* name) {
    return std::any_of(program.stages.begin(), program.stages.end(),
                       [name](const glsl::TranslatedStage& each) { return reads(each, name); });
}

bool hasStage(const glsl::TranslatedProgram& program, glsl::Stage stage) {
    return std::any_of(program.stages.begin(), program.stages.end(),
                       [stage](const glsl::TranslatedStage& each) { return each.stage == stage; });
}

/// Without translation a stage reads the driver's numbers, those within one draw. A fragment stage after a
/// geometry stage gets what that stage writes.
bool numbersWithinDraw(const glsl::TranslatedProgram& program) {
    const bool hasGeometry = hasStage(program, glsl::Stage::geometry);
    return std::any_of(program.stages.begin(), program.stages.end(), [&](const glsl::TranslatedStage& each) {
        if (each.stage == glsl::Stage::geometry)
            return reads(each, "gl_PrimitiveIDIn") && !reads(each, kFirstPrimitive);
        if (each.stage == glsl::Stage::fragment && hasGeometry) return false;
        return reads(each, "gl_PrimitiveID") && !reads(each, kFirstPatch);
    });
}

bool countsPrimitives(const gpu::Capabilities& driver) {
    return driver.hasExtension("GL_ARB_pipeline_statistics_query");
}

/// The location in the program in use, or -1.
GLint locationOf(const glsl::TranslatedProgram& program, const char* name) {
    if (!anyReads(program, name)) return -1;
    GLint inUse = 0;
    glGetIntegerv(GL_CURRENT_PROGRAM, &inUse);
    return glGetUniformLocation(static_cast<GLuint>(inUse), name);
}

/// Counts the primitives that reach the geometry stage of the program in use.
class PrimitiveCount {
  public:
    PrimitiveCount() {
        GLint program = 0;
        glGetIntegerv(GL_CURRENT_PROGRAM, &program);
        glGetProgramiv(static_cast<GLuint>(program), GL_GEOMETRY_SHADER_INVOCATIONS, &invocations_);
    }
    void begin() const { query_.begin(); }
    [[nodiscard]] GLint end() const {
        query_.end();
        return static_cast<GLint>(query_.result()) / std::max(1, invocations_);
    }

  private:
    gpu::Query query_{GL_GEOMETRY_SHADER_INVOCATIONS};
    GLint invocations_ = 1;  ///< per primitive
};

/// The number of patches to draw per call, at least 1.
int patchesAtOnce(const gpu::Capabilities& driver, const glsl::TranslatedProgram& program,
                  int patchVertices) {
    constexpr int kAll = 1 << 24;  // times 32 vertices per patch still fits an int
    if (!driver.isSoftware || numbersWithinDraw(program) ||
        (anyReads(program, kFirstPrimitive) && !countsPrimitives(driver)))
        return kAll;
    // The vertices along one side of a patch at the highest level; without a control stage all levels are 1.
    const int side = hasStage(program, glsl::Stage::tessControl) ? driver.maxTessellationLevel + 1 : 2;
    const int most = std::max(1, 65'536 / (side * side));
    return anyReads(program, kFirstPatch) ? std::min(most, std::max(1, 1024 / patchVertices)) : most;
}

}  // namespace

void setFirstPatch(const glsl::TranslatedProgram& program, int patch) {
    if (const GLint location = locationOf(program, kFirstPatch); location >= 0) glUniform1i(location, patch);
}

void drawPatches(const gpu::Capabilities& driver, const glsl::TranslatedProgram& program, int patchVertices,
                 int indexCount, const std::function<void(int first, int count)>& drawPart) {
    const int atOnce = patchesAtOnce(driver, program, patchVertices);
    const int indices = atOnce * patchVertices;
    const GLint firstPatch = locationOf(program, kFirstPatch);
    const GLint firstPrimitive = locationOf(program, kFirstPrimitive);
    std::optional<PrimitiveCount> count;
    if (firstPrimitive >= 0) {
        glUniform1i(firstPrimitive, 0);
        if (indices < indexCount) count.emplace();
    }
    GLint primitives = 0;
    for (int first = 0, patch = 0; first < indexCount; first += indices, patch += atOnce) {
        if (firstPatch >= 0) glUniform1i(firstPatch, patch);
        if (count) count->begin();
        drawPart(first, std::min(indices, indexCount - first));
        if (!count) continue;
        primitives += count->end();
        glUniform1i(firstPrimitive, primitives);
    }
}

}  // namespace glibra::render
