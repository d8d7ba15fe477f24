#pragma once
// The content of functions and initialisers as a tree of statements and expressions, with the role of every
// word and the type of every expression. What the parser cannot read becomes a node of the kind `unknown`;
// the places of all nodes are view indices.

#include <cstddef>
#include <cstdint>
#include <deque>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "glsl/parse/syntax.h"
#include "glsl/parse/types.h"
#include "glsl/read/token.h"

namespace glibra::glsl {

enum class NodeKind : std::uint8_t {
    // Statements, with the ';' that ends them
    block,        ///< { statements }
    branch,       ///< if: the condition, a statement, and that of `else` if there is one
    forLoop,      ///< the parts between the ';', and the body
    whileLoop,    ///< the condition, the body
    doLoop,       ///< the body, and the condition unless that is missing
    choice,       ///< switch: the value, the body
    label,        ///< case, default: the value, if there is one
    jump,         ///< return, discard, break, continue: the value, if there is one
    declaration,  ///< its declarators; `token` is the index into Bodies::declarations
    declarator,   ///< a name: its initialiser, if there is one
    evaluation,   ///< an expression
    empty,        ///< a lone ';', or nothing where something could stand
    // Expressions. `token` is the name, number, operator or opening bracket.
    number,
    name,
    call,        ///< of a function or constructor: its arguments
    arrayCall,   ///< vec3[2](a, b): its arguments
    method,      ///< object.length(): the object
    subscript,   ///< the object, the subscript
    member,      ///< the object
    prefix,      ///< the operand, which all operators from `first` on apply to
    step,        ///< operand++, operand--
    chain,       ///< operands with operators of one strength between them: a + b - c. See operatorBefore.
    selection,   ///< a ? b : c
    assignment,  ///< the target, the value
    group,       ///< ( ... )
    list,        ///< { ... }
    sequence,    ///< expressions with commas between them, or something unknown
    unknown
};

/// The tokens first ... end - 1 of a statement or expression. Nodes are numbered; kNone is none.
struct Node {
    NodeKind kind = NodeKind::unknown;
    std::uint32_t first = 0, end = 0;
    std::uint32_t token = kNone;
    std::uint32_t child = kNone, lastChild = kNone, next = kNone, parent = kNone;
    Type type{};  ///< of an expression

    [[nodiscard]] Range range() const { return {first, end}; }
};

/// A local variable or parameter as declared.
struct LocalVariable {
    std::uint32_t name = 0;  ///< view index
    Type type;
    std::string_view typeWord;
    bool isParameter = false;
    std::uint32_t constToken = kNone;  ///< the `const` of its declaration, or kNone
    Range initializer;
    std::uint32_t value = kNone;     ///< the node of the initialiser
    std::uint32_t scopeEnd = kNone;  ///< the token before which its scope ends; kNone: that of the file
};

/// A call of a function, not of a constructor, and the types of its arguments.
struct Call {
    std::uint32_t name = 0;
    std::vector<Range> arguments;
    std::vector<Type> types;
    std::uint32_t function = kNone;  ///< the name in the declaration of the overload that is called
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
    /// The children of a node in their order.
    class Children {
      public:
        struct Iterator {
            const std::vector<Node>* nodes;
            std::uint32_t at;
            using difference_type = std::ptrdiff_t;
            using value_type = std::uint32_t;
            std::uint32_t operator*() const { return at; }
            Iterator& operator++() {
                at = (*nodes)[at].next;
                return *this;
            }
            void operator++(int) { ++*this; }
            bool operator==(const Iterator& other) const { return at == other.at; }
        };
        Children(const std::vector<Node>& nodes, std::uint32_t first) : nodes_(&nodes), first_(first) {}
        [[nodiscard]] Iterator begin() const { return {nodes_, first_}; }
        [[nodiscard]] Iterator end() const { return {nodes_, kNone}; }

      private:
        const std::vector<Node>* nodes_;
        std::uint32_t first_;
    };
    [[nodiscard]] Children children(std::uint32_t node) const { return {nodes, nodes[node].child}; }
    /// The child of that number, or kNone.
    [[nodiscard]] std::uint32_t child(std::uint32_t node, int number) const {
        std::uint32_t at = nodes[node].child;
        while (number-- > 0 && at != kNone) at = nodes[at].next;
        return at;
    }
    [[nodiscard]] int childCount(std::uint32_t node) const {
        int count = 0;
        for (std::uint32_t at = nodes[node].child; at != kNone; at = nodes[at].next) ++count;
        return count;
    }

    std::vector<Node> nodes;
    std::vector<std::uint32_t> nodeOf;     ///< by view index: the node of a name in an expression, or kNone
    std::deque<Declaration> declarations;  ///< of local variables

    std::vector<WordRole> roles;  ///< by view index
    /// By view index: the first declaration of the stage that a name means, which of functions is that of all
    /// of its overloads; its own index in its declaration. kNone if there is none.
    std::vector<std::uint32_t> meanings;
    /// Of the structures and blocks, by Type::structure: the view indices of their members.
    std::vector<std::vector<std::uint32_t>> structures;
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

// Reads the statements and expressions of a stage into a tree (tree.h).

/// Parses all functions and initialisers, and sets Declaration::code and Declarator::value. The depth is
/// limited, and the time is linear in the number of tokens.
Bodies parseBodies(std::span<const ViewToken> view, Syntax& syntax);

}  // namespace glibra::glsl
