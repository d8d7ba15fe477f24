#pragma once
// Brings shader code into a form that stays the same when somebody adds statements without effect, puts
// independent statements or operands of a sum or a product into another order, writes a function out where it
// is called, gives a value a name that is used once, or writes a constant differently. It is a form for
// comparing, not a program: products of matrices are sorted, too.

#include <cstddef>
#include <cstdint>
#include <deque>
#include <functional>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "glsl/parse/tree.h"

namespace glibra::classroom {

/// A line of one of several files.
struct CodeLine {
    std::int32_t number = 1;
    std::uint32_t file = 0;
};

/// A token of code, without blanks and comments.
struct CodeToken {
    std::string_view text;
    std::uint32_t code = 0;  ///< what it is compared by
    CodeLine line;
    bool isWord = false, isNumber = false;
};

/// Something that stands outside of all functions and structures.
struct CodeItem {
    std::size_t begin = 0, end = 0;           ///< of its tokens
    std::vector<std::string_view> names{};    ///< that it declares
    bool isFunction = false;                  ///< with a body
    std::span<const CodeToken> parameters{};  ///< of a function, also without a body
};
std::vector<CodeItem> itemsOf(std::span<const CodeToken> tokens);

/// True for a word that the text may declare, and that is no member.
bool isVariableName(std::span<const CodeToken> tokens, std::size_t index);
/// True for a name that is declared there: after a type, as x of "vec3 x".
bool isDeclaredName(std::span<const CodeToken> tokens, std::size_t index);
/// The variable that the assignment at `sign` changes: a of `a.b[i] = c` and `++a`.
std::string_view targetOf(std::span<const CodeToken> tokens, std::size_t begin, std::size_t sign);

/// The functions that a text defines or declares, and the structures, whose constructors are called likewise;
/// true: a call may have an effect besides its value.
using OwnFunctions = std::map<std::string_view, bool>;
OwnFunctions ownFunctions(std::span<const CodeToken> tokens);

/// Removes statements and words that only say how exactly is computed.
void dropPrecisions(std::vector<CodeToken>& code);
/// Leaves out global declarations of uniforms, inputs and outputs, and sets what the others are compared by.
std::vector<CodeToken> comparedCode(std::span<const CodeToken> tokens, const OwnFunctions& own);
inline constexpr std::uint32_t kNameCode = 1, kNumberCode = 2;
/// What words and signs that are neither are compared by.
std::uint32_t codeOfText(std::string_view text);
/// A sign that the code does not have.
CodeToken sign(std::string_view text, CodeLine line);

/// True for the built-in functions whose call has an effect besides its value.
bool hasEffect(std::string_view builtIn);
/// True if code calls such a function; if it does, or assigns anything.
bool callsWithEffect(std::span<const CodeToken> code, const OwnFunctions& own);
bool hasEffect(std::span<const CodeToken> code, const OwnFunctions& own);

/// What "a += b" assigns to a: "a + (b)". Of "a = b" it is b.
std::vector<CodeToken> assignedBy(std::span<const CodeToken> target, const CodeToken& by,
                                  std::span<const CodeToken> value);

/// Moves variables that stand outside of functions and that one function alone mentions to its beginning.
std::vector<CodeToken> withLocalVariables(const std::vector<CodeToken>& tokens);

/// Splits the declarations of several local variables: "float a, b = 2.;" is "float a; float b = 2.;".
std::vector<CodeToken> withoutLists(std::span<const CodeToken> tokens);

/// Removes from the functions of a text what has no effect: statements after return, discard, break or
/// continue, what a constant condition keeps from running, expressions that assign nothing, assignments of a
/// variable to itself, and variables that are never read with all that is assigned to them; also the words of
/// conditions that always hold, and the braces of blocks that nothing controls.
std::vector<CodeToken> withoutDeadCode(std::vector<CodeToken> tokens, const OwnFunctions& own);

/// Writes functions out where they are called: those that `mayInline`, that return at their end alone, and
/// that are not recursive. Parameters are replaced by their arguments if these are short or used once, and
/// become variables otherwise; so do variables of the function, with names that `names` keeps. Also replaces
/// variables that are set once and used once by their values, and declares variables where they are set
/// first. Code that would grow to more than a few times
/// its size stays.
std::vector<CodeToken> withoutDetours(std::vector<CodeToken> tokens, const OwnFunctions& own,
                                      const std::function<bool(const CodeItem& function)>& mayInline,
                                      std::deque<std::string>& names);

/// Puts the statements of each block into an order that depends on nothing but their code and what they read
/// and write: each stands as soon before the first one that needs it as the others let it. Nothing passes a
/// return, a discard or a call with an effect.
std::vector<CodeToken> inStatementOrder(const std::vector<CodeToken>& tokens, const OwnFunctions& own);

/// Sorts the operands of sums and products, computes with numbers, drops what adds 0 or multiplies by 1 and
/// parentheses around one operand, and writes "a += b" as "a = a + b" (assignedBy). All numbers are compared
/// by `number`.
std::vector<CodeToken> inOrder(const std::vector<CodeToken>& tokens, std::uint32_t number);

// Code as a tree of statements and expressions, for what changes it.

using Code = std::vector<CodeToken>;

/// The tree of glsl/parse/tree.h, whose places are the indices of the tokens.
class CodeTree {
  public:
    /// Of a text, or of one statement. `code` has to outlive the tree.
    enum class Of { text, statement };
    explicit CodeTree(std::span<const CodeToken> code, Of of = Of::text);

    /// What stands outside of functions.
    [[nodiscard]] std::span<const glsl::Declaration> declarations() const { return syntax_.declarations; }
    /// In the order of the text.
    [[nodiscard]] std::span<const glsl::LocalVariable> locals() const { return bodies_.locals; }
    /// The bodies of the functions, with their braces, in the order of the text; the statement.
    [[nodiscard]] const std::vector<std::uint32_t>& functions() const { return functions_; }
    /// The variables with an initialiser, local ones too, by the index of their name: its node.
    [[nodiscard]] std::map<std::uint32_t, std::uint32_t> initializers() const;

    [[nodiscard]] const glsl::Node& node(std::uint32_t id) const { return bodies_.nodes[id]; }
    [[nodiscard]] glsl::Bodies::Children children(std::uint32_t id) const { return bodies_.children(id); }
    [[nodiscard]] std::uint32_t child(std::uint32_t id, int number) const {
        return bodies_.child(id, number);
    }
    [[nodiscard]] bool is(std::uint32_t id, glsl::NodeKind kind) const {
        return id != glsl::kNone && node(id).kind == kind;
    }
    /// Of the token that a node stands for.
    [[nodiscard]] std::string_view text(std::uint32_t id) const { return code_[node(id).token].text; }
    /// Of the token before a node: the operator before an operand of a chain.
    [[nodiscard]] std::string_view before(std::uint32_t id) const {
        return node(id).first > 0 ? code_[node(id).first - 1].text : std::string_view{};
    }
    [[nodiscard]] std::span<const CodeToken> code(std::uint32_t id) const {
        return code_.subspan(node(id).first, node(id).end - node(id).first);
    }

    /// The tokens first ... end - 1, with what `change` makes of each of these nodes in their place.
    template <class Nodes, class Change>
    [[nodiscard]] Code changed(std::size_t first, std::size_t end, const Nodes& nodes,
                               const Change& change) const {
        Code made;
        const auto add = [&](std::span<const CodeToken> more) {
            made.insert(made.end(), more.begin(), more.end());
        };
        for (const std::uint32_t each : nodes) {
            if (node(each).first < first || node(each).end > end) continue;  // what is no code
            add(code_.subspan(first, node(each).first - first));
            add(change(each));
            first = node(each).end;
        }
        add(code_.subspan(first, end - first));
        return made;
    }

  private:
    std::span<const CodeToken> code_;
    glsl::Syntax syntax_;
    glsl::Bodies bodies_;
    std::vector<std::uint32_t> functions_;
};

// The blocks of functions as lists of statements, for what changes the code of a whole block.

/// Calls `change` with the statements of every block of every function, inner blocks first, and of `switch`
/// with those between labels. What is no function stays. Blocks that are nested deeper than anybody writes
/// stay, too.
Code withBlocks(std::span<const CodeToken> tokens,
                const std::function<void(std::vector<Code>& statements)>& change);

/// True if `a` comes before `b`, by what tokens are compared by.
bool isBefore(const Code& a, const Code& b);

/// The parts between the commas outside of brackets, up to the end or to a bracket that closes.
std::vector<std::span<const CodeToken>> splitAtCommas(std::span<const CodeToken> list);

/// The tokens one after another.
Code joinedCode(const std::vector<Code>& parts);

}  // namespace glibra::classroom
