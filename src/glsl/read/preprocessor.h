#pragma once
// The directives of one stage that decide what is compiled: #if and its kin, #define and #undef, in the order
// of its lines.

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "glsl/read/expander.h"

namespace glibra::glsl {

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
