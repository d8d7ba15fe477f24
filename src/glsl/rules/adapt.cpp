// Rewrites what 4.50 accepts but targets below 4.20, 4.30 and 4.40 do not (language, 7.10).

#include <algorithm>

#include "glsl/read/words.h"
#include "glsl/rules/rules.h"

namespace glibra::glsl {
namespace {

class Adaptation {
  public:
    explicit Adaptation(Unit& unit) : unit_(unit), version_(unit.request->target.version) {}

    void run() {
        for (Variable& each : unit_.variables) variable(each);
        for (const Declaration& each : unit_.syntax.declarations) {
            if (each.kind == DeclarationKind::block && version_ < 420) removeItem(each.qualifiers, "binding");
            if (each.kind == DeclarationKind::block) removeLocations(each);
            if (each.kind != DeclarationKind::variable || version_ >= 420) continue;
            for (const Declarator& name : each.declarators) braces(name.initializer, each.type.name);
        }
        if (version_ >= 420) return;
        for (const LocalVariable& each : unit_.bodies.locals) braces(each.initializer, each.typeWord);
        localConstants();
        scalarSwizzles();
        returns();
    }

  private:
    void variable(Variable& each) {
        if (each.removed) return;
        if (version_ < 430 && each.storage == Storage::uniform) each.removeLayout("location");
        if (version_ >= 420) return;
        if (each.type != "atomic_uint") each.removeLayout("binding");
        // layout(depth_less) is only a promise that makes drawing faster. The redeclaration with it
        // needs 4.20 too.
        if (each.name == "gl_FragDepth") each.removed = true;
        const Range tokens = unit_.syntax.declarations[each.declaration].qualifiers.tokens;
        if (tokens.end - tokens.first > 1)
            each.changed = true;  // so that it is written again in the order of the older versions
    }

    void removeItem(const Qualifiers& qualifiers, std::string_view name) {
        const LayoutItem* item = qualifiers.item(name);
        if (!item) return;
        if (qualifiers.layout.size() == 1) {
            for (const Range& each : qualifiers.layoutTokens) unit_.remove(each);
            return;
        }
        const bool last = unit_.text(item->tokens.end) != ",";
        unit_.remove(last ? Range{item->tokens.first - 1, item->tokens.end}
                          : Range{item->tokens.first, item->tokens.end + 1});
    }

    /// Before 4.40 blocks between stages had no locations. They are matched by name.
    void removeLocations(const Declaration& block) {
        if (block.qualifiers.storage != Storage::input && block.qualifiers.storage != Storage::output) return;
        removeItem(block.qualifiers, "location");
        for (const Declaration& member : block.members) removeItem(member.qualifiers, "location");
    }

    /// Writes `{ a, b }` as `type[](a, b)` and `{ { 1, 2 }, { 3, 4 } }` as `vec2[](vec2(1, 2), vec2(3, 4))`.
    void braces(Range initializer, std::string_view type) {
        if (initializer.empty() || unit_.text(initializer.first) != "{" || type.empty()) return;
        const bool array = isArrayInitializer(initializer);
        bool outermost = true;
        for (std::uint32_t i = initializer.first; i < initializer.end; ++i) {
            const ViewToken& token = unit_.view[i];
            if (token.text == "{") {
                unit_.edits.replace(token.raw, std::string(type) + (outermost && array ? "[](" : "("));
                outermost = false;
            }
            if (token.text != "}") continue;
            unit_.edits.replace(token.raw, ")");
            if (unit_.text(i - 1) == ",") unit_.edits.remove(unit_.view[i - 1].raw);
        }
    }
    /// True if name[ ] or type[ ] name comes before the '='.
    [[nodiscard]] bool isArrayInitializer(Range initializer) const {
        const std::uint32_t name = initializer.first - 2;
        return unit_.text(name) == "]" || (name > 0 && unit_.text(name - 1) == "]");
    }

    [[nodiscard]] bool isConstant(Range range, const std::set<std::string_view>& variables) {
        for (std::uint32_t i = range.first; i < range.end; ++i) {
            const std::string_view text = unit_.text(i);
            if (unit_.bodies.roles[i] == WordRole::local && variables.contains(text)) return false;
            if (unit_.bodies.roles[i] != WordRole::global) continue;
            const Variable* variable = unit_.variable(text);
            const bool supplied = text.starts_with("gl_") && !text.starts_with("gl_Max");
            if (supplied || (variable && variable->storage != Storage::constant)) return false;
            if (!variable && unit_.isDeclared(text) && !isStructure(text)) return false;
            if (!variable && typeOfSuppliedName(text).known()) return false;
        }
        return true;
    }
    [[nodiscard]] bool isStructure(std::string_view name) const {
        return std::ranges::any_of(unit_.syntax.declarations, [&](const Declaration& each) {
            return each.type.isStruct && each.type.name == name;
        });
    }

    /// A local `const` needed a constant initialiser.
    void localConstants() {
        std::set<std::string_view> variables, constants;
        for (const LocalVariable& each : unit_.bodies.locals)
            (each.constToken == kNone ? variables : constants).insert(unit_.text(each.name));
        for (const LocalVariable& each : unit_.bodies.locals) {
            if (each.constToken == kNone || each.initializer.empty() ||
                isConstant(each.initializer, variables))
                continue;
            unit_.edits.remove(unit_.view[each.constToken].raw);
            variables.insert(unit_.text(each.name));
        }
    }

    /// Writes `f.xxx` of a float as vec3(f), and `f.x` as f.
    void scalarSwizzles() {
        for (const ScalarSwizzle& each : unit_.bodies.scalarSwizzles) {
            unit_.remove({each.member - 1, each.member + 1});
            const auto size = static_cast<int>(unit_.text(each.member).size());
            if (size > 1) unit_.convert(each.object, wordOf(vectorType(each.type.base, size)));
        }
    }

    /// Returned values were not converted to the type of the function.
    void returns() {
        for (const ReturnValue& each : unit_.bodies.returns) {
            const bool converts = each.type.numeric() && each.wanted.numeric() && each.type.integral() &&
                                  each.wanted.base != each.type.base &&
                                  each.wanted.base != BaseType::boolean &&
                                  each.type.rows == each.wanted.rows && each.wanted.columns == 1;
            if (converts) unit_.convert(each.expression, wordOf(each.wanted));
        }
    }

    Unit& unit_;
    int version_;
};

}  // namespace

void adaptToTarget(Unit& unit) {
    if (unit.request->target.version < 440) Adaptation(unit).run();
}

}  // namespace glibra::glsl
