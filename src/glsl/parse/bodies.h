#pragma once
// What stands inside functions and initialisers: which words are local names, which types expressions have.

#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "glsl/parse/syntax.h"
#include "glsl/parse/types.h"
#include "glsl/read/macros.h"

namespace glibra::glsl {

/// A local variable or parameter as declared.
struct LocalVariable {
    std::uint32_t name = 0;  ///< view index
    Type type;
    std::string_view typeWord;
    bool isParameter = false;
    std::uint32_t constToken = kNone;  ///< the `const` of its declaration
    Range initializer;
};

/// A call of a function by name (not of a constructor), with what its arguments are.
struct Call {
    std::uint32_t name = 0;
    std::vector<Range> arguments;
    std::vector<Type> types;
};

/// A `return expression;` in a function of type `wanted`.
struct ReturnValue {
    Range expression;
    Type type;
    Type wanted;
};

/// A swizzle of a scalar, which only 4.20 and later take: object.member.
struct ScalarSwizzle {
    Range object;
    std::uint32_t member = 0;
    Type type;
};

enum class WordRole : std::uint8_t {
    none,
    global,            ///< a use of something that is not local
    local,             ///< a use of a local variable or parameter
    localDeclaration,  ///< the name in its declaration
    member,            ///< behind a '.'
    other              ///< part of a declaration at file scope, of a type, ...
};

struct Bodies {
    std::vector<WordRole> roles;         ///< by view index
    std::vector<std::uint32_t> matches;  ///< of every bracket its partner
    std::vector<LocalVariable> locals;
    std::vector<Call> calls;
    std::vector<ReturnValue> returns;
    std::vector<ScalarSwizzle> scalarSwizzles;
    std::map<std::string, std::uint32_t, std::less<>>
        localNames;  ///< locals, parameters, local structs: view index
    std::map<std::string, std::uint32_t, std::less<>> memberNames;  ///< members of structs and blocks
    std::vector<std::uint32_t> memberDeclarations;                  ///< the same, every one
};

/// Index of the matching bracket of every bracket, `view.size()` where there is none.
std::vector<std::uint32_t> matchBrackets(std::span<const ViewToken> view);

/// Walks all functions and initialisers. Bounded depth, linear in the number of tokens.
Bodies walkBodies(std::span<const ViewToken> view, const Syntax& syntax);

}  // namespace glibra::glsl
