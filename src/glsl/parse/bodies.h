#pragma once
// The content of functions and initialisers: which words are local names, and which types expressions have.

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "glsl/parse/syntax.h"
#include "glsl/parse/types.h"
#include "glsl/read/token.h"

namespace glibra::glsl {

/// A local variable or parameter as declared.
struct LocalVariable {
    std::uint32_t name = 0;  ///< view index
    Type type;
    std::string_view typeWord;
    bool isParameter = false;
    std::uint32_t constToken = kNone;  ///< the `const` of its declaration, or kNone
    Range initializer;
};

/// A call of a function, not of a constructor, and the types of its arguments.
struct Call {
    std::uint32_t name = 0;
    std::vector<Range> arguments;
    std::vector<Type> types;
};

/// A `return expression;` in a function that returns `wanted`.
struct ReturnValue {
    Range expression;
    Type type;
    Type wanted;
};

/// object[...] in an expression.
struct Subscript {
    Range object;
    std::uint32_t open = 0;  ///< the '['
    Type type;               ///< of the object
};

/// An operator between two types that it cannot join.
struct OperandMismatch {
    std::uint32_t op = 0;
    Type left, right;
};

/// A swizzle of a scalar, object.member, which only versions from 4.20 on accept.
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
    member,            ///< after a '.'
    other              ///< part of a declaration: a type, a qualifier, a name at file scope
};

struct Bodies {
    std::vector<WordRole> roles;         ///< by view index
    std::vector<std::uint32_t> matches;  ///< of a bracket: the index of its partner; the number of all tokens
                                         ///< if it has none, and for other tokens
    std::vector<LocalVariable> locals;
    std::vector<Call> calls;
    std::vector<ReturnValue> returns;
    std::vector<ScalarSwizzle> scalarSwizzles;
    std::vector<OperandMismatch> mismatches;
    std::vector<Subscript> subscripts;
    /// Names of local variables, parameters and local structs, with the view index of the first of each name.
    std::map<std::string, std::uint32_t, std::less<>> localNames;
    /// Names of members of structs and blocks, likewise.
    std::map<std::string, std::uint32_t, std::less<>> memberNames;
    std::vector<std::uint32_t> memberDeclarations;  ///< view indices of all of these members
};

}  // namespace glibra::glsl
