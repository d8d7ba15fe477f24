// The stages of ProgramRequest::suppliesFragment, suppliesFixedVertex and suppliesFullScreenVertex (language,
// 7.9).

#include <algorithm>

#include "base/text.h"
#include "glsl/rules/rules.h"

namespace glibra::glsl {
namespace {

bool namesColor(std::string_view name) {
    const std::string lower = base::lower(name);
    return lower.find("color") != std::string::npos || lower.find("colour") != std::string::npos;
}

/// True for an output of the stage that is a colour by its name and type.
bool isColor(const Unit& unit, const Variable& each) {
    const auto& qualifiers = unit.syntax.declarations[each.declaration].qualifiers;
    if (each.storage != Storage::output && !qualifiers.varyingWord) return false;
    return namesColor(each.name) && each.typeSizes.empty() && each.nameSizes.empty() &&
           (each.type == "vec3" || each.type == "vec4");
}

/// True if the stage declares `vST` with this storage, or as `varying`, which is neither an input nor an
/// output before the rules have run.
bool declaresPlace(const Unit& unit, Storage storage) {
    return std::ranges::any_of(unit.variables, [&](const Variable& each) {
        return each.name == "vST" &&
               (each.storage == storage || unit.syntax.declarations[each.declaration].qualifiers.varyingWord);
    });
}

}  // namespace

std::string suppliedColor(const Unit& last) {
    if (last.isUsed("gl_FrontColor")) return "gl_FrontColor";
    for (const Variable& each : last.variables)
        if (isColor(last, each)) return each.name;
    return {};
}

std::string defaultFragment(const Unit& last) {
    const std::string color = suppliedColor(last);
    std::string text = "#version 330 compatibility\n", value = "gl_Color";
    for (const Variable& each : last.variables)
        if (each.name == color && isColor(last, each)) {
            text += each.interpolation + " in " + each.type + " " + color + ";\n";
            value = each.type == "vec4" ? color : "vec4(" + color + ", 1.)";
        }
    return text + "void main() { gl_FragColor = " + value + "; }\n";
}

std::string fixedVertex(const Unit& fragment) {
    std::string text = "#version 330 compatibility\n";
    const bool givesPlace = declaresPlace(fragment, Storage::input);
    if (givesPlace) text += "out vec2 vST;\n";
    text += "void main() {\n    gl_Position = ftransform();\n";
    if (fragment.isUsed("gl_Color")) text += "    gl_FrontColor = gl_Color;\n";
    if (fragment.isUsed("gl_TexCoord")) text += "    gl_TexCoord[0] = gl_MultiTexCoord0;\n";
    if (givesPlace) text += "    vST = gl_MultiTexCoord0.st;\n";
    return text + "}\n";
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
