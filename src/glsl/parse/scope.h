#pragma once
// The names that are visible at the current place of a stage, and their types.

#include <map>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "glsl/parse/bodies.h"
#include "glsl/parse/syntax.h"
#include "glsl/parse/types.h"

namespace glibra::glsl {

class Names {
  public:
    Names(std::span<const ViewToken> view, Bodies& bodies) : view_(view), bodies_(bodies) {}

    /// Opens a scope that ends at the bracket `closesAt`, or, if `statement` is true, at the next ';'.
    void push(std::uint32_t closesAt, bool statement = false);
    void popTo(std::uint32_t closesAt);
    void popStatement();
    void popAll();

    void declareLocal(std::uint32_t name, const Type& type);
    void declareGlobal(std::string_view name, const Declaration& declaration, Type type,
                       std::size_t dimensions);
    /// Declares the members of a block without an instance name, which are global names.
    void declareBlockMembers(const Declaration& block);
    void addStructure(const Declaration& declaration);
    void addFunction(const Declaration& declaration);

    [[nodiscard]] bool isLocal(std::string_view name) const;
    [[nodiscard]] bool isKnown(std::string_view name) const;
    [[nodiscard]] bool isStructure(std::string_view name) const { return structureIndex_.contains(name); }
    [[nodiscard]] bool isFunction(std::string_view name) const { return functions_.contains(name); }
    [[nodiscard]] Type typeOf(const TypeUse& use) const;
    [[nodiscard]] Type typeOfName(std::string_view name) const;
    [[nodiscard]] Type typeOfStructure(std::string_view name) const;
    [[nodiscard]] Type memberType(const Type& owner, std::string_view member) const;
    /// The type that the user's function returns for these arguments, if that is certain.
    [[nodiscard]] Type returnType(std::string_view function, std::span<const Type> arguments) const;

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
    void pop();

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
