#pragma once
// The scopes of a stage while it is parsed: what its names are, and of which types.

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "glsl/parse/tree.h"
#include "glsl/read/words.h"

namespace glibra::glsl {

/// The names that are visible at the current place of a stage, and their types.
class VisibleNames {
  public:
    VisibleNames(std::span<const ViewToken> view, Bodies& bodies) : view_(view), bodies_(bodies) {}

    /// Opens a scope that ends at the bracket `closesAt`, or, if `statement` is true, at the next ';'.
    void push(std::uint32_t closesAt, bool statement = false) {
        scopes_.push_back({closesAt, statement, {}, {}});
    }
    /// Closes the scope of that bracket, and those in it; `closesAt` is also where they end.
    void popTo(std::uint32_t closesAt) {
        const auto found = std::find_if(scopes_.rbegin(), scopes_.rend(),
                                        [&](const Scope& each) { return each.closesAt == closesAt; });
        if (found == scopes_.rend()) return;
        const auto keep = static_cast<std::size_t>(scopes_.rend() - found) - 1;
        while (scopes_.size() > keep) pop(closesAt);
        popStatement(closesAt);
    }
    void popStatement(std::uint32_t at) {
        while (!scopes_.empty() && scopes_.back().statement) pop(at);
    }
    void popAll(std::uint32_t at) {
        while (!scopes_.empty()) pop(at);
    }

    /// The last of Bodies::locals.
    void declareLocal() {
        const LocalVariable& variable = bodies_.locals.back();
        const std::string_view text = view_[variable.name].text;
        bodies_.roles[variable.name] = WordRole::localDeclaration;
        bodies_.localNames.emplace(text, variable.name);
        bodies_.meanings[variable.name] = variable.name;
        if (scopes_.empty()) return;
        locals_[text].push_back({variable.type, variable.name});
        scopes_.back().names.push_back(text);
        scopes_.back().locals.push_back(bodies_.locals.size() - 1);
    }
    void declareGlobal(std::uint32_t name, const Declaration& declaration, Type type,
                       std::size_t dimensions) {
        if (declaration.kind == DeclarationKind::block) type = typeOfStructure(view_[declaration.name].text);
        // A variable may be declared again, as an array with its size.
        Named& known = globals_.try_emplace(view_[name].text, Named{{}, name}).first->second;
        known.type = arrayOf(type, dimensions);
        bodies_.meanings[name] = known.at;
    }
    /// Declares the members of a block without an instance name, which are global names.
    void declareBlockMembers(const Declaration& block) {
        if (!block.declarators.empty()) return;
        for (const Declaration& member : block.members) {
            const Type type = typeOf(member.type);
            for (const Declarator& each : member.declarators)
                declareGlobal(each.name, member, type, each.dimensions.size());
        }
    }
    void addStructure(const Declaration& declaration) {
        std::unordered_map<std::string_view, Named> members;
        std::vector<std::uint32_t> names;
        for (const Declaration& member : declaration.members) {
            const Type type = typeOf(member.type);
            for (const Declarator& each : member.declarators) {
                members[view_[each.name].text] = {arrayOf(type, each.dimensions.size()), each.name};
                bodies_.meanings[each.name] = each.name;
                names.push_back(each.name);
            }
        }
        if (declaration.name == kNone) return;
        bodies_.meanings[declaration.name] = declaration.name;
        structureIndex_[view_[declaration.name].text] = {static_cast<std::int32_t>(structures_.size()),
                                                         declaration.name};
        structures_.push_back(std::move(members));
        bodies_.structures.push_back(std::move(names));
    }
    void addFunction(const Declaration& declaration) {
        if (declaration.name == kNone) return;
        bodies_.meanings[declaration.name] =
            functionNames_.try_emplace(view_[declaration.name].text, declaration.name).first->second;
        Overload overload;
        overload.at = declaration.name;
        overload.result = typeOf(declaration.type);
        for (const Parameter& each : declaration.parameters)
            overload.parameters.push_back(arrayOf(typeOf(each.type), each.dimensions.size()));
        functions_[view_[declaration.name].text].push_back(std::move(overload));
    }

    [[nodiscard]] bool isLocal(std::string_view name) const {
        const auto found = locals_.find(name);
        return found != locals_.end() && !found->second.empty();
    }
    [[nodiscard]] bool isKnown(std::string_view name) const {
        return isLocal(name) || globals_.contains(name);
    }
    [[nodiscard]] bool isStructure(std::string_view name) const { return structureIndex_.contains(name); }
    [[nodiscard]] bool isFunction(std::string_view name) const { return functions_.contains(name); }

    [[nodiscard]] Type typeOf(const TypeUse& use) const {
        Type type = typeOfStructure(use.name);  // first: old versions leave words such as uvec2 to the user
        if (!type.known()) type = typeOfWord(use.name);
        if (type.known()) type.arrayDepth = static_cast<std::uint16_t>(use.dimensions.size());
        return type;
    }
    [[nodiscard]] Type typeOfName(std::string_view name) const {
        const Named* found = find(name);
        return found != nullptr ? found->type : typeOfSuppliedName(name);
    }
    /// The declaration of a name that is no member (Bodies::meanings), or kNone.
    [[nodiscard]] std::uint32_t meaningOf(std::string_view name) const {
        if (const Named* found = find(name)) return found->at;
        if (const auto found = functionNames_.find(name); found != functionNames_.end()) return found->second;
        const auto found = structureIndex_.find(name);
        return found != structureIndex_.end() ? found->second.at : kNone;
    }
    [[nodiscard]] Type typeOfStructure(std::string_view name) const {
        const auto found = structureIndex_.find(name);
        if (found == structureIndex_.end()) return {};
        Type type = scalarType(BaseType::structure);
        type.structure = found->second.index;
        return type;
    }
    /// Of the member that stands at `at`.
    Type memberType(const Type& owner, std::uint32_t at) {
        const std::string_view member = view_[at].text;
        if (owner.arrayDepth > 0) return {};
        if (owner.base == BaseType::structure) {
            const auto& members = structures_[static_cast<std::size_t>(owner.structure)];
            const auto found = members.find(member);
            if (found == members.end()) return {};
            bodies_.meanings[at] = found->second.at;
            return found->second.type;
        }
        if (!owner.numeric() || owner.matrix()) {
            // gl_in[i].gl_Position
            return member.starts_with("gl_") ? typeOfSuppliedName(member) : Type{};
        }
        const bool swizzle = !member.empty() && member.size() <= 4 &&
                             member.find_first_not_of("xyzwrgbastpq") == std::string_view::npos;
        if (!swizzle) return {};
        return vectorType(owner.base, static_cast<int>(member.size()));
    }
    /// The type that the user's function returns for these arguments, if that is certain.
    [[nodiscard]] Type returnType(std::string_view function, std::span<const Type> arguments) const {
        const auto found = functions_.find(function);
        if (found == functions_.end()) return {};
        const std::vector<Overload>& overloads = found->second;
        const bool same = std::ranges::all_of(
            overloads, [&](const Overload& each) { return each.result == overloads.front().result; });
        if (same) return overloads.front().result;
        for (const Overload& each : overloads)
            if (std::ranges::equal(each.parameters, arguments)) return each.result;
        return {};
    }
    /// The declaration of the user's function that such a call means: one with these types, else with as many
    /// parameters, else the first; kNone if there is none.
    [[nodiscard]] std::uint32_t overloadOf(std::string_view function, std::span<const Type> arguments) const {
        const auto found = functions_.find(function);
        if (found == functions_.end()) return kNone;
        const auto best = std::ranges::max_element(found->second, {}, [&](const Overload& each) {
            const bool isSame = std::ranges::equal(each.parameters, arguments);
            return isSame ? 2 : each.parameters.size() == arguments.size() ? 1 : 0;
        });
        return best->at;
    }

  private:
    struct Scope {
        std::uint32_t closesAt;
        bool statement;
        std::vector<std::string_view> names;
        std::vector<std::size_t> locals;  ///< of Bodies::locals
    };
    struct Named {
        Type type;
        std::uint32_t at = kNone;  ///< of its declaration
    };
    struct StructureName {
        std::int32_t index = -1;
        std::uint32_t at = kNone;
    };
    struct Overload {
        std::uint32_t at = kNone;
        Type result;
        std::vector<Type> parameters;
    };
    void pop(std::uint32_t at) {
        for (const std::string_view each : scopes_.back().names) {
            std::vector<Named>& stack = locals_[each];
            if (!stack.empty()) stack.pop_back();
        }
        for (const std::size_t each : scopes_.back().locals) bodies_.locals[each].scopeEnd = at;
        scopes_.pop_back();
    }
    /// A variable that is visible, or null.
    [[nodiscard]] const Named* find(std::string_view name) const {
        if (const auto found = locals_.find(name); found != locals_.end() && !found->second.empty())
            return &found->second.back();
        const auto found = globals_.find(name);
        return found != globals_.end() ? &found->second : nullptr;
    }

    std::span<const ViewToken> view_;
    Bodies& bodies_;
    std::vector<Scope> scopes_;
    std::unordered_map<std::string_view, std::vector<Named>> locals_;
    std::unordered_map<std::string_view, Named> globals_;
    std::unordered_map<std::string_view, std::uint32_t> functionNames_;
    std::unordered_map<std::string_view, StructureName> structureIndex_;
    std::vector<std::unordered_map<std::string_view, Named>> structures_;
    std::unordered_map<std::string_view, std::vector<Overload>> functions_;
};

}  // namespace glibra::glsl
