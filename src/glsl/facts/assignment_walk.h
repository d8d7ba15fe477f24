#pragma once
// The walk through the functions of a stage that findUnassigned (facts/assignment.h) makes. Its statements
// and expressions are in files of their own.

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "glsl/facts/assigned_parts.h"
#include "glsl/facts/formula.h"
#include "glsl/facts/unassigned.h"
#include "glsl/parse/unit.h"

namespace glibra::glsl {

/// What a call of a function does to the outputs of the stage.
struct CallEffect {
    std::vector<std::uint32_t> assigns;  ///< by output
    std::set<std::size_t> reads;         ///< outputs that it reads, or lets leave the stage
};

class AssignmentWalk {
  public:
    explicit AssignmentWalk(const Unit& unit) : unit_(unit), search_(unit) {}

    Assignments find();

  private:
    using Shape = AssignedVariable::Shape;
    enum class Direction { in, out, inOut };

    [[nodiscard]] std::string_view text(std::uint32_t at) const { return unit_.text(at); }
    [[nodiscard]] std::uint32_t match(std::uint32_t at) const { return search_.match(at); }
    [[nodiscard]] bool isWord(std::uint32_t at) const { return at < unit_.view.size() && search_.isWord(at); }
    [[nodiscard]] WordRole role(std::uint32_t at) const { return unit_.bodies.roles[at]; }

    // ---- Variables

    [[nodiscard]] std::vector<std::string_view> membersOfType(const std::string& type) const;
    void output(const std::string& name, const std::string& type, std::vector<std::string> sizes);

    /// The outputs of the stage that some statement writes. Those of a control stage belong to several
    /// invocations.
    void outputs();

    /// A block with the name of an instance counts as a structure.
    void block(const Declaration& declaration);
    void fragData();

    /// The variable that the word at `at` names; nothing if it is not followed.
    [[nodiscard]] std::optional<std::size_t> variableAt(std::uint32_t at) const;
    std::size_t add(AssignedVariable variable);
    void declareLocal(const Declaration& declaration, const Declarator& name);
    void read(std::size_t index, const AssignedPart& part, std::uint32_t at);
    void assign(std::size_t index, const AssignedPart& part);
    void deliver(const AssignedVariable& variable);

    // ---- Functions

    void function(const Declaration& declaration);

    /// What lacks its value where the function ends.
    void leave(const Declaration& declaration, std::size_t first);

    // ---- Statements

    [[nodiscard]] bool isTooMuch();
    void statements(Range range);

    /// The index of the ';' that ends a statement, or of the '}' that ends its block.
    [[nodiscard]] std::uint32_t expressionEnd(std::uint32_t at, std::uint32_t end) const;
    std::uint32_t statement(std::uint32_t at, std::uint32_t end);
    std::uint32_t afterStatement(std::uint32_t at, std::uint32_t end);
    [[nodiscard]] bool isDeclaration(std::uint32_t at, std::uint32_t end) const;
    std::uint32_t declaration(std::uint32_t at, std::uint32_t end);

    /// The parts between the ';' of a header, each a declaration or an expression.
    void header(Range range);
    std::uint32_t branch(std::uint32_t at, std::uint32_t end);

    /// Notes what the body of a loop assigns: a read on a condition may be one of a later round. The body
    /// itself counts as one more condition if it may have no round.
    void foresee(Range body, bool mayBeEmpty);
    [[nodiscard]] bool isAlwaysTrue(Range condition) const;
    [[nodiscard]] bool hasLogic(Range condition) const;

    /// The body of a loop whose condition has been evaluated. Gives the state after the loop; a `break`
    /// leaves it, too.
    std::uint32_t loop(std::uint32_t body, std::uint32_t end, Range condition, Range step, bool mayBeEmpty);
    std::uint32_t forLoop(std::uint32_t at, std::uint32_t end);

    /// About the end of the statement at `at`, without a walk through it.
    [[nodiscard]] std::uint32_t bodyEnd(std::uint32_t at, std::uint32_t end) const;
    std::uint32_t whileLoop(std::uint32_t at, std::uint32_t end);
    std::uint32_t doLoop(std::uint32_t at, std::uint32_t end);

    /// `for (int i = 0; i < n; ++i) a[i] = ...;` gives an array of up to n elements its values.
    void fill(const std::vector<Range>& parts, Range body);
    std::uint32_t switchOver(std::uint32_t at, std::uint32_t end);
    std::uint32_t label(std::uint32_t at, std::uint32_t end);
    std::uint32_t jump(std::uint32_t at, std::uint32_t end);

    // ---- Expressions

    void expression(Range range);

    /// Reads the subscripts after a name.
    void subscripts(Range suffix);
    std::uint32_t use(std::size_t index, std::uint32_t at, std::uint32_t end);
    [[nodiscard]] Direction directionOf(std::string_view function, std::size_t argument,
                                        std::size_t count) const;

    std::uint32_t call(std::uint32_t at);
    void effectsOf(std::string_view function);

    static constexpr int kMostData = 8;

    const Unit& unit_;
    TokenSearch search_;
    Assignments found_;
    std::unordered_map<std::string_view, const Declaration*> structures_;
    std::unordered_map<std::string_view, std::vector<const Declaration*>> functions_;
    std::map<std::string, std::size_t, std::less<>> outputs_;  ///< the first of `variables_`
    std::map<std::size_t, const Declaration*> blocks_;         ///< outputs that are blocks
    std::map<std::string_view, CallEffect> effects_;
    std::size_t outputCount_ = 0;
    std::vector<AssignedVariable> variables_;

    // Of the function that is being walked
    std::vector<std::unordered_map<std::string_view, std::optional<std::size_t>>> scopes_;
    AssignedState state_, exit_, breaks_, continues_, switch_;
    CallEffect effect_;
    std::map<std::size_t, int> foreseen_;  ///< variables that a loop assigns: the branches of a guarded read
    int branches_ = 0;                     ///< `if` and `switch` around the statement
    int conditional_ = 0;                  ///< operands around that may not be evaluated
    int depth_ = 0;
    bool isMain_ = false, hasReturn_ = false, hasDefault_ = false;
    bool gaveUp_ = false;  ///< the function is too large: all its variables may lack their values
};

}  // namespace glibra::glsl
