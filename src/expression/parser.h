#pragma once
// A recursive-descent parser that makes code at once. Each function reads one level of GLSL's grammar and
// returns the operand that its code leaves on the stack, or nothing after the first problem.

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "expression/builder.h"
#include "expression/functions.h"
#include "expression/lexer.h"

namespace glibra::expression {

/// "an" before vowels, else "a".
std::string_view article(std::string_view noun);

/// "red, green and blue", where " and " is given.
std::string joined(std::span<const std::string> words, std::string_view last);

class Parser {
  public:
    Parser(Code& code, const Names& names, const Wanted& wanted, const Limits& limits)
        : code_(code),
          names_(names),
          wanted_(wanted),
          limits_(limits),
          lexer_(code.text),
          build_(code, limits) {
        take();
    }

    /// Fills the code, or returns the first problem.
    std::optional<Problem> parse();

  private:
    using Parsed = std::optional<Operand>;

    /// Counts levels of nesting while it lives.
    class Level {
      public:
        explicit Level(Parser& parser) : parser_(parser) { ++parser_.depth_; }
        Level(const Level&) = delete;
        Level& operator=(const Level&) = delete;
        ~Level() { --parser_.depth_; }

      private:
        Parser& parser_;
    };

    // ---- Problems

    std::nullopt_t problem(Range range, const char* id, std::string text);
    std::nullopt_t unexpected(std::string_view expected);
    std::nullopt_t tooDeep();
    /// Checked after each operand, so that code beyond the limits is never run.
    Parsed withinLimits(Parsed operand);

    // ---- Tokens

    void take();
    bool takeIf(std::string_view sign);
    [[nodiscard]] Range since(std::uint32_t begin) const;
    [[nodiscard]] std::string_view textOf(Range range) const;

    // ---- The result (parse.cpp)

    [[nodiscard]] bool wants(const Type& type) const;
    void finish(Operand result);
    /// A choice whose words are all accepted here stands for its word.
    void wordOfChoice(Operand& result);

    // ---- Operators and components (parse_operators.cpp)

    Parsed expression();
    Parsed conditional(Operand condition);
    /// Operators of this precedence and above.
    Parsed binary(int least);
    Parsed operation(Operand left, const Token& sign, Operand right);
    Parsed shortCircuit(Operand left, const Token& sign, int precedence);
    Parsed unary();
    Parsed postfix();
    Parsed primary();
    Parsed component(const Operand& value);
    /// The subscript in brackets: a number. A constant one must be below `count`.
    Parsed subscript(std::size_t count);
    Parsed subscripted(const Operand& value);

    // ---- Names and words (parse_names.cpp)

    /// A word that is not known can only be compared with a choice; everywhere else it is an unknown name.
    bool settle(const Operand& operand);
    void unknownName(std::string_view name, Range range);
    /// Gives the word of a choice the number that the choice has for it.
    bool compareWithChoice(const Operand& choice, Operand& word);
    Parsed named(const Token& first);
    std::nullopt_t noSuchField(const std::string& path, const Symbol& symbol, const Token& field);
    /// Reports a name that is no value: an array, or an object with fields.
    std::nullopt_t noValue(const std::string& path, const Symbol& symbol, Range range);
    Parsed loaded(const std::string& path, Symbol symbol, const Parsed& index, Range range);
    /// A name that the caller does not know: a constant, or a word.
    Parsed unnamed(const Token& first);

    // ---- Calls (parse_calls.cpp)

    Parsed call(const Token& function);
    /// A function that takes the time as last argument.
    Parsed moving(std::vector<Operand> arguments, const Call& call, const Token& function, Range range);
    std::nullopt_t unknownFunction(const Token& function);
    std::nullopt_t noSuchForm(std::span<const FunctionRow> forms, std::span<const Type> types, Range range);
    std::optional<std::vector<Operand>> argumentList(const Token& function);

    Code& code_;
    const Names& names_;
    const Wanted& wanted_;
    const Limits& limits_;
    Lexer lexer_;
    Builder build_;
    Token token_;
    std::uint32_t lastEnd_ = 0;
    std::size_t depth_ = 0;
    std::optional<Problem> problem_;
};

}  // namespace glibra::expression
