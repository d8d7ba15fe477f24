// The vertex stage of ProgramRequest::suppliesFullScreenVertex.

#include <algorithm>

#include "glsl/rules/rules.h"

namespace glibra::glsl {

/// True if the stage declares `vST` with this storage, or as `varying`, which is neither an input nor an
/// output before the rules have run.
static bool declaresPlace(const Unit& unit, Storage storage) {
    return std::any_of(unit.variables.begin(), unit.variables.end(), [&](const Variable& each) {
        return each.name == "vST" &&
               (each.storage == storage || unit.syntax.declarations[each.declaration].qualifiers.varyingWord);
    });
}

bool lacksPlace(const Unit& vertex, const Unit& fragment) {
    return declaresPlace(fragment, Storage::input) && !declaresPlace(vertex, Storage::output);
}

std::string fullScreenVertex(const Unit& fragment) {
    const bool givesPlace = declaresPlace(fragment, Storage::input);
    // The corners (-1, -1), (3, -1) and (-1, 3), and (3, 3) for shapes of four vertices. The depth is that of
    // `FullScreen`, the middle.
    std::string text = "#version 330 core\n";
    if (givesPlace) text += "out vec2 vST;\n";
    text +=
        "void main() {\n"
        "    vec2 corner = 2. * vec2(gl_VertexID & 1, gl_VertexID >> 1);\n";
    if (givesPlace) text += "    vST = corner;\n";
    if (fragment.isUsed("gl_TexCoord")) text += "    gl_TexCoord[0] = vec4(corner, 0., 1.);\n";
    return text +
           "    gl_Position = vec4(2. * corner - 1., 0., 1.);\n"
           "}\n";
}

}  // namespace glibra::glsl
