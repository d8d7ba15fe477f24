#pragma once
// The scopes of a stage while it is parsed: what its names are, and of which types.

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
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
        scopes_.push_back({closesAt, statement, {}});
    }
    void popTo(std::uint32_t closesAt) {
        const auto found = std::find_if(scopes_.rbegin(), scopes_.rend(),
                                        [&](const Scope& each) { return each.closesAt == closesAt; });
        if (found == scopes_.rend()) return;
        const auto keep = static_cast<std::size_t>(scopes_.rend() - found) - 1;
        while (scopes_.size() > keep) pop();
        popStatement();
    }
    void popStatement() {
        while (!scopes_.empty() && scopes_.back().statement) pop();
    }
    void popAll() {
        while (!scopes_.empty()) pop();
    }

    void declareLocal(std::uint32_t name, const Type& type) {
        const std::string_view text = view_[name].text;
        bodies_.roles[name] = WordRole::localDeclaration;
        bodies_.localNames.emplace(text, name);
        if (scopes_.empty()) return;
        locals_[text].push_back(type);
        scopes_.back().names.push_back(text);
    }
    void declareGlobal(std::string_view name, const Declaration& declaration, Type type,
                       std::size_t dimensions) {
        if (declaration.kind == DeclarationKind::block) type = typeOfStructure(view_[declaration.name].text);
        globals_[name] = arrayOf(type, dimensions);
    }
    /// Declares the members of a block without an instance name, which are global names.
    void declareBlockMembers(const Declaration& block) {
        if (!block.declarators.empty()) return;
        for (const Declaration& member : block.members) {
            const Type type = typeOf(member.type);
            for (const Declarator& each : member.declarators)
                declareGlobal(view_[each.name].text, member, type, each.dimensions.size());
        }
    }
    void addStructure(const Declaration& declaration) {
        std::unordered_map<std::string_view, Type> members;
        for (const Declaration& member : declaration.members) {
            const Type type = typeOf(member.type);
            for (const Declarator& each : member.declarators)
                members[view_[each.name].text] = arrayOf(type, each.dimensions.size());
        }
        if (declaration.name == kNone) return;
        structureIndex_[view_[declaration.name].text] = static_cast<std::int32_t>(structures_.size());
        structures_.push_back(std::move(members));
    }
    void addFunction(const Declaration& declaration) {
        if (declaration.name == kNone) return;
        Overload overload;
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
        if (const auto found = locals_.find(name); found != locals_.end() && !found->second.empty())
            return found->second.back();
        if (const auto found = globals_.find(name); found != globals_.end()) return found->second;
        return typeOfSuppliedName(name);
    }
    [[nodiscard]] Type typeOfStructure(std::string_view name) const {
        const auto found = structureIndex_.find(name);
        if (found == structureIndex_.end()) return {};
        Type type = scalarType(BaseType::structure);
        type.structure = found->second;
        return type;
    }
    [[nodiscard]] Type memberType(const Type& owner, std::string_view member) const {
        if (owner.arrayDepth > 0) return {};
        if (owner.base == BaseType::structure) {
            const auto& members = structures_[static_cast<std::size_t>(owner.structure)];
            const auto found = members.find(member);
            return found == members.end() ? Type{} : found->second;
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

  private:
    struct Scope {
        std::uint32_t closesAt;
        bool statement;
        std::vector<std::string_view> names;
    };
    struct Overload {
        Type result;
        std::vector<Type> parameters;
    };
    void pop() {
        for (const std::string_view each : scopes_.back().names) {
            std::vector<Type>& stack = locals_[each];
            if (!stack.empty()) stack.pop_back();
        }
        scopes_.pop_back();
    }

    std::span<const ViewToken> view_;
    Bodies& bodies_;
    std::vector<Scope> scopes_;
    std::unordered_map<std::string_view, std::vector<Type>> locals_;
    std::unordered_map<std::string_view, Type> globals_;
    std::unordered_map<std::string_view, std::int32_t> structureIndex_;
    std::vector<std::unordered_map<std::string_view, Type>> structures_;
    std::unordered_map<std::string_view, std::vector<Overload>> functions_;
};

}  // namespace glibra::glsl
