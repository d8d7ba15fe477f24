#pragma once
// A recursive-descent parser that makes code at once. Each function reads one level of GLSL's grammar and
// returns the operand that its code leaves on the stack, or nothing after the first problem.

#include <cstddef>
#include <initializer_list>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "expression/expression.h"
#include "expression/functions.h"
#include "expression/problem.h"

namespace glibra::expression {

// Makes code while an expression is read: instructions are appended in the order of evaluation, and values
// that depend on nothing are computed at once.

/// A value that the code leaves on the stack.
struct Operand {
    Type type;
    Range range;
    std::size_t begin = 0;    ///< its first instruction
    bool isConstant = false;  ///< its code is one push
    /// A word that no name hides: its index is pushed. Text of a word that is not among those wanted.
    std::string_view unknownWord = {};
    /// The symbol, if the value is one of a choice.
    std::optional<std::size_t> choice = {};
};

struct MeasureCall;

class Builder {
  public:
    Builder(Code& code, const Limits& limits) : code_(code), limits_(limits) {}

    /// Added to ranges: where the body that is read begins (CalledBody).
    std::uint32_t textBegin = 0;

    /// While above 0, results need not be finite.
    int unchecked = 0;

    /// Appends an instruction that replaces `removed` numbers on the stack by `added`.
    void emit(Instruction instruction, Range range, std::size_t removed, std::size_t added);

    Operand pushed(std::span<const double> values, Type type, Range range);
    Operand pushed(double value, Type type, Range range) { return pushed({&value, 1}, type, range); }

    /// The operand that an instruction makes of operands that end the code. It is computed now if they are
    /// constant.
    Operand combined(std::initializer_list<Operand> from, Instruction instruction, Type type, Range range) {
        return combined(std::span<const Operand>(from.begin(), from.size()), instruction, type, range);
    }
    Operand combined(std::span<const Operand> from, Instruction instruction, Type type, Range range);

    /// The value of a constant operand.
    [[nodiscard]] std::span<const double> valueOf(const Operand& operand) const;
    void setValue(const Operand& operand, double value);

    /// The next instruction's index.
    [[nodiscard]] std::size_t end() const { return code_.instructions.size(); }
    /// How many numbers stand on the stack.
    [[nodiscard]] std::size_t depth() const { return depth_; }
    /// Appends a jump; jumpHere() says where it goes. The stack changes as emit() says.
    std::size_t emitJump(Op op, Range range, std::size_t removed);
    void jumpHere(std::size_t jump);
    /// The stack is lower by that many numbers from here on: another branch begins.
    void forget(std::size_t numbers) { depth_ -= numbers; }
    /// Removes instructions [first, last), which leave `numbers` on the stack.
    void erase(std::size_t first, std::size_t last, std::size_t numbers);

    /// The index of a name among those of the code.
    std::size_t use(std::string_view path, Symbol symbol);
    /// Keeps only the names that are still read, and collects what they depend on.
    void finishUses();

    /// False after a limit was passed; the code must not be run.
    [[nodiscard]] bool isWithinLimits() const { return steps_ <= limits_.steps && highest_ <= kMostDoubles; }

  private:
    bool fold(std::size_t first);

    Code& code_;
    const Limits& limits_;
    std::size_t depth_ = 0;
    std::size_t highest_ = 0;
    std::size_t steps_ = 0;
};

// Splits the text of an expression into tokens.

enum class TokenKind { end, number, name, sign, wrong };

struct Token {
    TokenKind kind = TokenKind::end;
    std::string_view text;
    Range range;
    double number = 0;
    const char* why = nullptr;  ///< of what is wrong

    [[nodiscard]] bool is(std::string_view sign) const { return kind == TokenKind::sign && text == sign; }
};

/// Blanks, ends of lines, backslashes before them, and comments separate tokens.
class Lexer {
  public:
    explicit Lexer(std::string_view text) : text_(text) {}
    Token next();
    /// The next token begins there, or after blanks.
    void goTo(std::size_t at) { at_ = at; }

  private:
    void skipBlanks();
    Token number();
    Token token(TokenKind kind, std::size_t length) const;
    [[nodiscard]] Token wrong(std::size_t length, const char* why) const;

    std::string_view text_;
    std::size_t at_ = 0;
};

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
          text_(code.text),
          lexer_(code.text),
          build_(code, limits) {
        take();
    }

    /// Fills the code, or returns the first problem.
    std::optional<Problem> parse();
    /// Reads the body of a function with parameters of these types, to find its problems.
    std::optional<Problem> parseBody(const std::shared_ptr<const Function>& function,
                                     std::span<const Type> types);

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

    /// What a parameter of the function that is read stands for.
    struct Argument {
        Operand operand;
        std::size_t place = 0;         ///< on the stack
        std::vector<double> constant;  ///< its value; such an argument is not on the stack
    };
    /// The function whose body is read.
    struct Frame {
        std::shared_ptr<const Function> function;
        std::vector<Argument> arguments;
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
    /// `measure`: the call that begins here, or null.
    Parsed primary(const MeasureCall* measure);
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
    /// A parameter of the function that is read; nothing if it has none of this name.
    Parsed parameter(const Token& name);
    /// What a path means where the text that is read stands.
    [[nodiscard]] std::optional<Symbol> find(std::string_view path) const;
    std::nullopt_t noSuchField(const std::string& path, const Symbol& symbol, const Token& field);
    /// Reports a name that is no value: an array, or an object with fields.
    std::nullopt_t noValue(const std::string& path, const Symbol& symbol, Range range);
    Parsed loaded(const std::string& path, Symbol symbol, const Parsed& index, Range range);
    /// A name that the caller does not know: a constant, or a word.
    Parsed unnamed(const Token& first);

    // ---- Calls

    /// A call that reads what a texture or buffer holds: a name of its own.
    Parsed measured(const MeasureCall& call);
    Parsed call(const Token& function);
    /// A function that takes the time as last argument.
    Parsed moving(std::vector<Operand> arguments, const Call& call, const Token& function, Range range);
    std::nullopt_t unknownFunction(const Token& function);
    std::nullopt_t noSuchForm(std::span<const FunctionRow> forms, std::span<const Type> types, Range range);
    std::optional<std::vector<Operand>> argumentList(const Token& function);
    /// A call of a function of the scene: its arguments, then its body.
    Parsed callOfScene(const std::shared_ptr<const Function>& function, const Token& name);
    std::nullopt_t recursion(const Token& name);
    std::optional<std::vector<Argument>> argumentsOfScene(const Function& function, const Token& name);
    /// Its result takes the place of the arguments on the stack.
    Parsed body(Frame frame, Range call);
    Parsed wholeBody();

    Code& code_;
    const Names& names_;
    const Wanted& wanted_;
    const Limits& limits_;
    std::string_view text_;  ///< that is read: that of the code, or the body of a function
    Lexer lexer_;
    Builder build_;
    Token token_;
    std::uint32_t lastEnd_ = 0;
    const Frame* frame_ = nullptr;  ///< null: no body is read
    Range callOfText_;              ///< that leads to the body that is read
    std::size_t bodyBytes_ = 0;     ///< of the bodies that have been read
    std::size_t depth_ = 0;
    std::optional<Problem> problem_;
};

}  // namespace glibra::expression
