// A subroutine uniform becomes an int that counts the functions of its type, and a call of it the call of a
// function that chooses among them (language, 7.9). The functions of a type are counted over all stages, so
// that a uniform that several stages declare has one value. The declaration of a type becomes the prototypes
// of its functions in this stage and the function that chooses.

#include <algorithm>
#include <map>
#include <string>
#include <vector>

#include "glsl/parse/variables.h"
#include "glsl/rules/rules.h"

namespace glibra::glsl {
namespace {

/// The names of the functions of each subroutine type, in the order of the text.
using Functions = std::map<std::string, std::vector<std::string>, std::less<>>;

void addFunctions(const Unit& unit, Functions& to) {
    for (const Declaration& each : unit.syntax.declarations) {
        if (each.kind != DeclarationKind::function) continue;
        const Range types = each.qualifiers.subroutineTypes;
        for (std::uint32_t i = types.first; i < types.end; ++i) {
            if (unit.text(i) == ",") continue;
            std::vector<std::string>& names = to[std::string(unit.text(i))];
            const std::string name(unit.text(each.name));
            if (std::ranges::find(names, name) == names.end()) names.push_back(name);
        }
    }
}

class Subroutines {
  public:
    Subroutines(Unit& unit, const Functions& functions, TranslatedProgram& result)
        : unit_(unit), functions_(functions), result_(result) {
        addFunctions(unit, own_);
    }

    void run() {
        for (const Declaration& each : unit_.syntax.declarations) {
            if (!each.qualifiers.subroutine) continue;
            if (each.kind == DeclarationKind::variable)
                uniform(each);
            else if (!each.qualifiers.subroutineTypes.empty())
                unit_.remove(each.qualifiers.tokens);  // of a function
            else if (each.kind == DeclarationKind::prototype)
                type(each);
        }
    }

  private:
    static std::string chooserOf(std::string_view type) { return "glibra_call_" + std::string(type); }

    std::string textOfType(const TypeUse& type) const {
        return spelled(unit_, std::string(type.name)) + textOfSizes(type.dimensions);
    }
    std::string textOfSizes(const std::vector<Range>& sizes) const {
        std::string text;
        for (const Range each : sizes) text += "[" + textOf(unit_, each) + "]";
        return text;
    }

    void type(const Declaration& declaration) {
        unit_.remove(declaration.tokens);
        const auto own = own_.find(unit_.text(declaration.name));
        if (own != own_.end())
            unit_.edits.replace(unit_.view[declaration.tokens.first].raw, chooser(declaration, own->second));
    }

    /// The prototypes of these functions and the function that chooses among them.
    std::string chooser(const Declaration& declaration, const std::vector<std::string>& own) const {
        std::string parameters, values;
        for (std::size_t i = 0; i < declaration.parameters.size(); ++i) {
            const Parameter& each = declaration.parameters[i];
            const std::string name = "glibra_" + std::to_string(i);
            if (i > 0) parameters += ", ", values += ", ";
            parameters += textOf(unit_, each.qualifiers.tokens) + " " + textOfType(each.type) + " " + name +
                          textOfSizes(each.dimensions);
            values += name;
        }
        const std::string head = textOfType(declaration.type) + " ";
        const bool isVoid = declaration.type.name == "void";
        const auto call = [&](const std::string& function) {
            const std::string text = spelled(unit_, function) + "(" + values + ");";
            return isVoid ? text : "return " + text;
        };
        std::string text;
        for (const std::string& each : own) text += head + spelled(unit_, each) + "(" + parameters + "); ";
        const std::string type(unit_.text(declaration.name));
        const std::vector<std::string>& all = functions_.find(type)->second;
        text += head + chooserOf(type) + "(int glibra_which" + (parameters.empty() ? "" : ", ") + parameters +
                ") { ";
        for (std::size_t i = 1; i < own.size(); ++i) {
            const auto number = std::ranges::find(all, own[i]) - all.begin();
            text += "if (glibra_which == " + std::to_string(number) + ") { " + call(own[i]) +
                    (isVoid ? " return; } " : " } ");
        }
        return text + call(own.front()) + " }";
    }

    void uniform(const Declaration& declaration) {
        const auto found = functions_.find(declaration.type.name);
        if (found == functions_.end()) return;
        for (const Declarator& each : declaration.declarators) {
            const std::string name(unit_.text(each.name));
            Variable* variable = unit_.variable(name);
            if (variable == nullptr) continue;
            variable->type = "int";
            variable->subroutine = false;
            variable->layout.clear();
            variable->changed = true;
            DeclaredUniform& declared = result_.uniforms[name];
            if (declared.subroutines.empty()) declared.place = unit_.place(each.name);
            declared.subroutines = found->second;
            const auto uses = unit_.uses.find(name);
            if (uses == unit_.uses.end()) continue;
            for (const std::uint32_t use : uses->second) call(use, found->first);
        }
    }

    /// `shade[i](x)` becomes `glibra_call_Shade(shade[i], x)`.
    void call(std::uint32_t name, std::string_view type) {
        std::uint32_t open = name + 1;
        if (unit_.text(open) == "[") open = unit_.bodies.matches[open] + 1;
        if (unit_.text(open) != "(") return;
        unit_.edits.before(unit_.view[name].raw, chooserOf(type) + "(");
        unit_.edits.replace(unit_.view[open].raw, unit_.text(open + 1) == ")" ? "" : ", ");
    }

    Unit& unit_;
    const Functions& functions_;  ///< of all stages
    TranslatedProgram& result_;
    Functions own_;  ///< of this stage
};

}  // namespace

void resolveSubroutines(ProgramUnits& program) {
    Functions functions;
    for (const Unit& unit : program.units) addFunctions(unit, functions);
    if (functions.empty()) return;
    for (Unit& unit : program.units) Subroutines(unit, functions, *program.result).run();
}

}  // namespace glibra::glsl
