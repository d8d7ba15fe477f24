// Values that the runtime supplies under known names (language, 6).

#include <algorithm>

#include "base/text.h"
#include "glsl/rules/rules.h"
#include "glsl/types/builtins.h"

namespace glibra::glsl {
namespace {

bool isTextureMatrix(std::string_view name) {
    return name.find("TextureMatrix") != std::string_view::npos;
}

/// "gl_NormalMatrix" for "glibra_NormalMatrix". Users write all other names as they are.
std::string userSpelling(std::string_view name) {
    return name.starts_with("glibra_") ? "gl_" + std::string(name.substr(7)) : std::string(name);
}

std::string inputType(std::string_view name) {
    if (name == "FaceIndex" || name == "aFaceIndex") return "int";
    if (name == "Tangent" || name == "aTangent" || name == "aNormal" || name == "gl_Normal") return "vec3";
    if (name == "gl_FogCoord") return "float";
    return "vec4";
}

bool isMeshValue(std::string_view name) {
    return name == "Tangent" || name == "aTangent" || name == "FaceIndex" || name == "aFaceIndex";
}

bool fitsMeshValue(std::string_view name, const Variable& variable) {
    if (variable.isArray()) return false;
    if (name.ends_with("FaceIndex")) return variable.type == "int" || variable.type == "float";
    return variable.type == "vec3" || variable.type == "vec4";
}

class Supply {
  public:
    Supply(Unit& unit, TranslatedProgram& result, Report& report)
        : unit_(unit), result_(result), report_(report) {}

    void run() {
        for (const BuiltinUniform& row : builtinUniforms()) uniform(row);
        for (const BuiltinInput& row : builtinInputs()) input(row);
    }

  private:
    /// True if the stage uses the name without declaring it. Renames a gl_ name that is declared with its
    /// right type.
    bool isWanted(const std::string& name, std::string_view emitted, const std::string& type) {
        if (unit_.macros.contains(name)) return false;
        if (unit_.isDeclared(name)) {
            if (name.starts_with("gl_")) redeclared(name, emitted, type);
            return false;
        }
        if (!unit_.isUsed(name)) return false;
        if (name != emitted) rename(name, emitted);
        return true;
    }

    void rename(const std::string& name, std::string_view emitted) {
        unit_.renames[name] = emitted;
        result_.userNames[std::string(emitted)] = name;
    }

    void redeclared(const std::string& name, std::string_view emitted, const std::string& type) {
        const Variable* variable = unit_.variable(name);
        if (!variable || variable->type != type || variable->isArray() != isTextureMatrix(name))
            report_.reportOnce(
                unit_.path + name, "glsl-E03",
                name + " is redeclared with another type than " + type + "; leave the declaration out",
                unit_.place(unit_.declared.find(name)->second));
        else
            rename(name, emitted);
    }

    void uniform(const BuiltinUniform& row) {
        const std::string name = userSpelling(row.name);
        if (row.value == Builtin::currentColor || row.value == Builtin::pointSize) return;
        if (!isWanted(name, row.name, std::string(row.type))) return;
        unit_.declare("uniform " + std::string(row.type) + " " + std::string(row.name) +
                      (isTextureMatrix(name) ? "[8];" : ";"));
    }

    void input(const BuiltinInput& row) {
        const std::string name = userSpelling(row.name);
        if (isMeshValue(name)) {
            Variable* variable = unit_.variable(name);
            if (variable && variable->storage == Storage::uniform && fitsMeshValue(name, *variable))
                return declaredUniform(name, *variable);
        }
        // gl_Color in a fragment stage is a varying.
        const bool colour = name == "gl_Color" || name == "gl_SecondaryColor";
        if (colour && unit_.stage == Stage::fragment) return;
        if (unit_.stage != Stage::vertex) {
            if (unit_.isUsed(name) && !unit_.isUserName(name)) outside(name, unit_.uses[name].front());
            return;
        }
        const std::string type = inputType(name);
        if (!isWanted(name, row.name, type)) return;
        const std::string emitted(row.name);
        unit_.declare("in " + type + " " + emitted + ";");
        if (unit_.isWritten(name)) {
            const std::string copy = "glibra_copyOf" + name.substr(name.starts_with("gl_") ? 3 : 0);
            unit_.declare(type + " " + copy + " = " + emitted + ";");
            rename(name, copy);
            report_.report("glsl-W22", "input '" + name + "' is written to; a local copy is used",
                           unit_.place(unit_.writes[name].front()));
        }
    }

    void declaredUniform(const std::string& name, Variable& variable) {
        if (unit_.stage != Stage::vertex) return outside(name, variable.nameToken);
        variable.storage = Storage::input;
        variable.changed = true;
        variable.dropInitializer = true;
        report_.report("glsl-W15", "'" + name + "' declared uniform, treated as vertex input",
                       unit_.place(variable.nameToken));
    }

    void outside(const std::string& name, std::uint32_t at) {
        if (unit_.stage == Stage::compute) {
            report_.reportOnce(unit_.path + name, "glsl-E03",
                               name + " is a vertex input, and a compute stage has none; read a buffer",
                               unit_.place(at));
            return;
        }
        report_.reportOnce(
            unit_.path + name, "glsl-E03",
            name +
                " is a vertex input and only exists in the vertex stage; write it there to a varying of "
                "your own" +
                std::string(name.ends_with("FaceIndex") ? " (flat)" : "") + " and read that here",
            unit_.place(at));
    }

    Unit& unit_;
    TranslatedProgram& result_;
    Report& report_;
};

}  // namespace

void supplyBuiltins(ProgramUnits& program) {
    for (Unit& unit : program.units) Supply(unit, *program.result, program.report).run();
}

// The stages of ProgramRequest::suppliesFragment, suppliesFixedVertex and suppliesFullScreenVertex (language,
// 7.9).

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
