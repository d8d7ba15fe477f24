#pragma once
// The directives of one stage that decide what is compiled: #if and its kin, #define and #undef, in the order
// of its lines.

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "glsl/read/macros.h"

namespace glibra::glsl {

// ---- Conditions

struct Condition {
    long long value = 0;
    std::string error;          ///< what is wrong with the expression; empty if nothing is
    const Piece* at = nullptr;  ///< where that is; null: at its end
    /// The first name that is no macro and that the value depends on: it counts as 0.
    const Piece* unknown = nullptr;
};

/// The value of an expression in which macros and `defined` are already replaced. Operands that && or || do
/// not need are not evaluated.
Condition evaluateCondition(std::span<const Piece> pieces);

/// Gives `value` the value of an integer expression of the text, in which words count as 0. False if the
/// tokens are none.
bool evaluateCondition(std::span<const ViewToken> tokens, long long& value);

/// How strongly an operator of GLSL binds its two operands; 0 for all else.
int levelOf(std::string_view op);

/// Gives `value` the value of a decimal, octal or hexadecimal number; false for other text.
bool readInteger(std::string_view text, long long& value);

/// The value of a literal: "12u", "0x1F", "1.5e3", "2.lf"; nothing for other text.
std::optional<double> numberValue(std::string_view text);

// ---- Directives

/// A line of a file, whose tokens have their places.
struct SourceLine {
    std::span<const Token> tokens;
    std::vector<const Token*> significant;

    /// The significant token number `i`: 0 is the '#' of a directive, 1 its name; empty past the end.
    [[nodiscard]] std::string_view word(std::size_t i) const {
        return i < significant.size() ? significant[i]->text : std::string_view{};
    }
    /// That token, or the last one.
    [[nodiscard]] const Token& token(std::size_t i) const {
        return *significant[i < significant.size() ? i : significant.size() - 1];
    }
    /// The text between the quotes or angle brackets of an #include, or the word in place of them; empty if
    /// there is none.
    [[nodiscard]] std::string includedName() const;
    /// The text of a directive in one line, without comments.
    [[nodiscard]] std::string joined() const;
};

class Preprocessor {
  public:
    /// The expanded text goes to `stage.tokens`.
    Preprocessor(StageText& stage, Complain complain)
        : stage_(stage), complain_(complain), expander_(stage, std::move(complain)) {}

    Expander& expander() { return expander_; }
    /// False in branches that are not compiled.
    [[nodiscard]] bool active() const { return active_; }
    /// Performs #if, #ifdef, #ifndef, #elif, #else, #endif, #define and #undef; false for other directives.
    bool perform(std::string_view directive, const SourceLine& line);
    /// The tokens of a line from `first` on, with macros expanded.
    std::vector<Piece> expanded(const SourceLine& line, std::size_t first);
    /// Reports a branch that is not closed at the end of the source.
    void finish();

  private:
    struct Conditional {
        bool outer;  ///< true: the surrounding text is compiled
        bool taken;  ///< true: one of the branches so far was compiled
        bool hasElse = false;
        Token start{};
    };

    void conditional(std::string_view directive, const SourceLine& line);
    void nextBranch(std::string_view directive, const SourceLine& line);
    void branch(bool taken);
    bool condition(std::string_view directive, const SourceLine& line);
    bool hasName(std::string_view directive, const SourceLine& line);
    void evaluateDefined(std::vector<Piece>& pieces, std::string_view directive, const SourceLine& line);
    void define(const SourceLine& line);
    bool defineParameters(const SourceLine& line, Macro& macro, std::size_t& at);
    void defineBody(const SourceLine& line, Macro& macro, std::size_t first);
    void undefine(const SourceLine& line);
    void complain(std::string text, const Token& at) { complain_("glsl-E14", std::move(text), at); }

    StageText& stage_;
    Complain complain_;
    Expander expander_;
    std::vector<Conditional> conditionals_;
    bool active_ = true;
    bool reportedPasting_ = false;
};

}  // namespace glibra::glsl
