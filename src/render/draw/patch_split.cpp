#include "render/draw/patch_split.h"

#include <glad/gl.h>

#include <algorithm>
#include <string>

namespace glibra::render {
namespace {

constexpr const char* kFirstPatch = "glibra_FirstPatch";
constexpr const char* kPatch = "glibra_Patch";  // in a geometry stage

bool reads(const glsl::TranslatedStage& stage, const char* name) {
    return stage.source.find(name) != std::string::npos;
}

bool anyReads(const glsl::TranslatedProgram& program, const char* name) {
    return std::ranges::any_of(program.stages,
                               [name](const glsl::TranslatedStage& each) { return reads(each, name); });
}

bool hasStage(const glsl::TranslatedProgram& program, glsl::Stage stage) {
    return std::ranges::any_of(program.stages,
                               [stage](const glsl::TranslatedStage& each) { return each.stage == stage; });
}

/// Without translation a stage reads the driver's numbers, those within one draw. A fragment stage after a
/// geometry stage gets what that stage writes.
bool numbersWithinDraw(const glsl::TranslatedProgram& program) {
    const bool hasGeometry = hasStage(program, glsl::Stage::geometry);
    return std::ranges::any_of(program.stages, [&](const glsl::TranslatedStage& each) {
        if (each.stage == glsl::Stage::geometry)
            return reads(each, "gl_PrimitiveIDIn") && !reads(each, kPatch);
        if (each.stage == glsl::Stage::fragment && hasGeometry) return false;
        return reads(each, "gl_PrimitiveID") && !reads(each, kFirstPatch);
    });
}

/// The location in the program in use, or -1.
GLint locationOf(const glsl::TranslatedProgram& program, const char* name) {
    if (!anyReads(program, name)) return -1;
    GLint inUse = 0;
    glGetIntegerv(GL_CURRENT_PROGRAM, &inUse);
    return glGetUniformLocation(static_cast<GLuint>(inUse), name);
}

/// The number of patches to draw per call, at least 1.
int patchesAtOnce(const gpu::Capabilities& driver, const glsl::TranslatedProgram& program,
                  int patchVertices) {
    constexpr int kAll = 1 << 24;  // times 32 vertices per patch still fits an int
    if (!driver.tessellatesInSoftware || numbersWithinDraw(program)) return kAll;
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
    for (int first = 0, patch = 0; first < indexCount; first += indices, patch += atOnce) {
        if (firstPatch >= 0) glUniform1i(firstPatch, patch);
        drawPart(first, std::min(indices, indexCount - first));
    }
}

}  // namespace glibra::render
