#include "render/patch_split.h"

#include <algorithm>
#include <string>

namespace glibra::render {
namespace {

constexpr const char* kFirstPatch = "glibra_FirstPatch";

bool readsFirstPatch(const glsl::TranslatedStage& stage) {
    return stage.source.find(kFirstPatch) != std::string::npos;
}

/// A stage that reads the number of its primitive within the draw, which then has to stay one: a geometry or
/// fragment stage, or one that is not translated.
bool numbersWithinDraw(const glsl::TranslatedStage& stage) {
    return stage.source.find("gl_PrimitiveID") != std::string::npos && !readsFirstPatch(stage);
}

}  // namespace

int patchesAtOnce(const gpu::Capabilities& driver, const glsl::TranslatedProgram& program) {
    constexpr int kAll = 1 << 24;  // times 32 vertices a patch still fits an int
    const bool counts16 = driver.family.find("pipe") != std::string::npos;
    if (!counts16 || program.patchVertices == 0 ||
        std::any_of(program.stages.begin(), program.stages.end(), numbersWithinDraw))
        return kAll;
    const int side = driver.maxTessellationLevel + 1;  // vertices along a patch at the highest level
    return std::max(1, 65'536 / (side * side));
}

GLint firstPatchLocation(const glsl::TranslatedProgram& program) {
    if (std::none_of(program.stages.begin(), program.stages.end(), readsFirstPatch)) return -1;
    GLint inUse = 0;
    glGetIntegerv(GL_CURRENT_PROGRAM, &inUse);
    return glGetUniformLocation(static_cast<GLuint>(inUse), kFirstPatch);
}

}  // namespace glibra::render
