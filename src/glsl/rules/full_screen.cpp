// The vertex stage of ProgramRequest::suppliesFullScreenVertex.

#include <algorithm>

#include "glsl/rules/rules.h"

namespace glibra::glsl {

std::string fullScreenVertex(const Unit& fragment) {
    // The fragment stage may declare `varying vec2 vST;`, which is not an input before the rules have run.
    const bool givesPlace =
        std::any_of(fragment.variables.begin(), fragment.variables.end(), [&](const Variable& each) {
            return each.name == "vST" &&
                   (each.storage == Storage::input ||
                    fragment.syntax.declarations[each.declaration].qualifiers.varyingWord);
        });
    // The corners (-1, -1), (3, -1) and (-1, 3) of the view volume's front side, so that the depth is 0.
    std::string text = "#version 330 core\n";
    if (givesPlace) text += "out vec2 vST;\n";
    text +=
        "void main() {\n"
        "    vec2 corner = 2. * vec2(gl_VertexID & 1, gl_VertexID >> 1);\n";
    if (givesPlace) text += "    vST = corner;\n";
    if (fragment.isUsed("gl_TexCoord")) text += "    gl_TexCoord[0] = vec4(corner, 0., 1.);\n";
    return text +
           "    gl_Position = vec4(2. * corner - 1., -1., 1.);\n"
           "}\n";
}

}  // namespace glibra::glsl
