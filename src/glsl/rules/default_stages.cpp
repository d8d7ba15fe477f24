// The stages of ProgramRequest::suppliesFragment and suppliesFixedVertex (language, 7.9).

#include <algorithm>

#include "glsl/rules/rules.h"

namespace glibra::glsl {
namespace {

bool namesColor(std::string name) {
    for (char& c : name)
        if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    return name.find("color") != std::string::npos || name.find("colour") != std::string::npos;
}

/// True for an output of the stage that is a colour by its name and type.
bool isColor(const Unit& unit, const Variable& each) {
    const auto& qualifiers = unit.syntax.declarations[each.declaration].qualifiers;
    if (each.storage != Storage::output && !qualifiers.varyingWord) return false;
    return namesColor(each.name) && each.typeSizes.empty() && each.nameSizes.empty() &&
           (each.type == "vec3" || each.type == "vec4");
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
    const bool givesPlace =
        std::any_of(fragment.variables.begin(), fragment.variables.end(), [&](const Variable& each) {
            return each.name == "vST" &&
                   (each.storage == Storage::input ||
                    fragment.syntax.declarations[each.declaration].qualifiers.varyingWord);
        });
    if (givesPlace) text += "out vec2 vST;\n";
    text += "void main() {\n    gl_Position = ftransform();\n";
    if (fragment.isUsed("gl_Color")) text += "    gl_FrontColor = gl_Color;\n";
    if (fragment.isUsed("gl_TexCoord")) text += "    gl_TexCoord[0] = gl_MultiTexCoord0;\n";
    if (givesPlace) text += "    vST = gl_MultiTexCoord0.st;\n";
    return text + "}\n";
}

}  // namespace glibra::glsl
