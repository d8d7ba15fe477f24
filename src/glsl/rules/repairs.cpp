// Repairs mistakes in declarations that real shaders contain (language, 7.10).

#include <algorithm>

#include "glsl/read/words.h"
#include "glsl/rules/rules.h"
#include "glsl/types/builtins.h"

namespace glibra::glsl {
namespace {

class Repairs {
  public:
    Repairs(Unit& unit, const TokenWalk& walk, const std::string& geometryInput, Report& report)
        : unit_(unit), walk_(walk), primitive_(geometryInput), report_(report) {}

    void run() {
        strays();
        repeatedUniforms();
        falseConstants();
        constructorConstants();
        for (Variable& each : unit_.variables) writtenInput(each);
    }

  private:
    void strays() {
        for (const Declaration& each : unit_.syntax.declarations) {
            if (each.kind != DeclarationKind::stray || !each.qualifiers.tokens.empty()) continue;
            const ViewToken& token = unit_.view[each.tokens.first];
            if (token.text != ";") continue;
            unit_.edits.remove(token.raw);
            report_.report("glsl-W09", "stray ';' removed", unit_.place(each.tokens.first));
        }
    }

    void repeatedUniforms() {
        std::map<std::string, const Variable*> first;
        for (Variable& each : unit_.variables) {
            if (each.storage != Storage::uniform || each.removed) continue;
            const auto [found, isNew] = first.emplace(each.name, &each);
            if (isNew || found->second->type != each.type || found->second->sizes() != each.sizes() ||
                each.type.empty())
                continue;
            each.removed = true;
            const Place place = unit_.place(each.nameToken);
            report_.report("glsl-W21",
                           "uniform '" + each.name + "' declared again on line " +
                               std::to_string(place.line) + ", ignored",
                           place);
        }
    }

    /// The first word of the initialiser that is not a constant, or kNone.
    [[nodiscard]] std::uint32_t variableWord(Range range) {
        for (std::uint32_t i = range.first; i < range.end; ++i) {
            if (unit_.bodies.roles[i] != WordRole::global) continue;
            const std::string_view text = unit_.text(i);
            if (const Variable* variable = unit_.variable(text)) {
                if (variable->storage != Storage::constant) return i;
            } else if (unit_.isDeclared(text)) {
                const std::uint32_t at = unit_.declared.find(text)->second;
                if (unit_.text(at + 1) != "(" && isBlockMember(text)) return i;
            } else if (findBuiltinUniform(text) || findBuiltinInput(text)) {
                return i;
            }
        }
        return kNone;
    }
    [[nodiscard]] bool isBlockMember(std::string_view name) const {
        return unit_.bodies.memberNames.contains(name);
    }

    void falseConstants() {
        for (const Variable& each : unit_.variables) {
            if (each.storage != Storage::constant || each.removed) continue;
            const Range value =
                unit_.syntax.declarations[each.declaration].declarators[each.declarator].initializer;
            if (variableWord(value) == kNone) continue;
            // All variables of one declaration share its qualifiers.
            for (Variable& other : unit_.variables)
                if (other.declaration == each.declaration) {
                    other.storage = Storage::none;
                    other.changed = true;
                }
            report_.report("glsl-W10", "'" + each.name + "' depends on a uniform, 'const' dropped",
                           unit_.place(each.nameToken));
        }
    }

    /// Removes `const` from `const vec3(1.)`, `= const vec3[2](...)` and `= const 1.`
    void constructorConstants() {
        for (std::uint32_t i = 0; i < unit_.tokens.size(); ++i) {
            if (unit_.tokens[i].text != "const") continue;
            std::uint32_t next = walk_.next(i);
            const bool inInitialiser = walk_.text(walk_.previous(i)) == "=";
            if (!inInitialiser) {
                if (next == kNone || unit_.tokens[next].kind != TokenKind::word ||
                    isQualifierWord(walk_.text(next)))
                    continue;
                next = walk_.next(next);
                while (walk_.text(next) == "[" && walk_.match(next) != kNone)
                    next = walk_.next(walk_.match(next));
                if (walk_.text(next) != "(") continue;
            }
            unit_.edits.remove(i);
            report_.report("glsl-W20", "'const' inside an initialiser dropped", unit_.placeOfToken(i));
        }
    }

    void writtenInput(Variable& input) {
        if (input.storage != Storage::input || input.removed || !unit_.isWritten(input.name) ||
            input.type.empty())
            return;
        if (input.name.starts_with("gl_")) return;
        if (unit_.stage == Stage::tessControl || unit_.stage == Stage::tessEvaluation) return;
        const std::string copy = "glibra_" + input.name;
        std::string sizes, value = input.name;
        if (unit_.stage == Stage::geometry) {
            if (input.sizes().size() != 1) return;
            const int count = verticesOfPrimitive(primitive_);
            sizes = "[" + std::to_string(count) + "]";
            value = input.type + sizes + "(";
            for (int i = 0; i < count; ++i)
                value += (i ? ", " : "") + input.name + "[" + std::to_string(i) + "]";
            value += ")";
        } else {
            for (const std::string& each : input.sizes()) sizes += "[" + each + "]";
        }
        input.after += " " + input.type + " " + copy + sizes + " = " + value + ";";
        unit_.renames[input.name] = copy;
        unit_.keptSpelling.insert(unit_.view[input.nameToken].raw);
        report_.report("glsl-W22", "input '" + input.name + "' is written to; a local copy is used",
                       unit_.place(unit_.writes.find(input.name)->second.front()));
    }

    Unit& unit_;
    const TokenWalk& walk_;
    const std::string& primitive_;  ///< the input primitive of a geometry stage
    Report& report_;
};

}  // namespace

void repairDeclarations(Unit& unit, const TokenWalk& walk, const std::string& geometryInput, Report& report) {
    Repairs(unit, walk, geometryInput, report).run();
}

}  // namespace glibra::glsl
