// A subroutine uniform stands for its first function (language, 7.9). The declaration of its type becomes the
// prototype of that function, so that calls may come before the definition.

#include <map>

#include "glsl/rules/rules.h"

namespace glibra::glsl {
namespace {

class Subroutines {
  public:
    Subroutines(Unit& unit, Report& report) : unit_(unit), report_(report) {}

    void run() {
        findFunctions();
        for (const Declaration& each : unit_.syntax.declarations) {
            if (!each.qualifiers.subroutine) continue;
            if (each.kind == DeclarationKind::prototype && each.qualifiers.subroutineTypes.empty())
                type(each);
            if (each.kind == DeclarationKind::function ||
                (each.kind == DeclarationKind::prototype && !each.qualifiers.subroutineTypes.empty()))
                remove(each.qualifiers.tokens);
            if (each.kind == DeclarationKind::variable) uniform(each);
        }
    }

  private:
    void findFunctions() {
        for (const Declaration& each : unit_.syntax.declarations) {
            if (each.kind != DeclarationKind::function || each.qualifiers.subroutineTypes.empty()) continue;
            const Range types = each.qualifiers.subroutineTypes;
            for (std::uint32_t i = types.first; i < types.end; ++i)
                first_.emplace(unit_.text(i), unit_.text(each.name));
        }
    }

    void remove(Range range) {
        std::vector<std::uint32_t> tokens;
        if (!editableTokens(unit_, range, tokens)) return;
        for (const std::uint32_t each : tokens) unit_.edits.remove(each);
    }

    void type(const Declaration& declaration) {
        const auto found = first_.find(unit_.text(declaration.name));
        if (found == first_.end()) return remove(declaration.tokens);
        remove(declaration.qualifiers.tokens);
        unit_.edits.replace(unit_.view[declaration.name].site, std::string(found->second));
    }

    void uniform(const Declaration& declaration) {
        const auto found = first_.find(declaration.type.name);
        if (found == first_.end()) return;
        for (const Declarator& each : declaration.declarators) {
            const std::string name(unit_.text(each.name));
            report_.report("glsl-W19",
                           "subroutine uniform '" + name + "' uses its first function '" +
                               std::string(found->second) + "'",
                           unit_.place(each.name));
            if (Variable* variable = unit_.variable(name)) variable->removed = true;
            const auto uses = unit_.uses.find(name);
            if (uses == unit_.uses.end()) continue;
            for (const std::uint32_t use : uses->second) {
                unit_.edits.replace(unit_.view[use].site, std::string(found->second));
                if (unit_.text(use + 1) == "[") remove({use + 1, unit_.bodies.matches[use + 1] + 1});
            }
        }
    }

    Unit& unit_;
    Report& report_;
    std::map<std::string_view, std::string_view> first_;  ///< the first function of each subroutine type
};

}  // namespace

void resolveSubroutines(Unit& unit, Report& report) {
    Subroutines(unit, report).run();
}

}  // namespace glibra::glsl
