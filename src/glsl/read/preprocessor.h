#pragma once
// Macros and conditional branches of one stage, in the order of its lines. They decide which tokens are
// compiled and what they expand to.

#include <span>
#include <string_view>
#include <vector>

#include "glsl/read/macros.h"
#include "glsl/read/stage_text.h"

namespace glibra::glsl {

/// A line of a file. `first` is the index of its first token among the tokens of the stage.
struct SourceLine {
    std::span<const Token> tokens;
    std::vector<const Token*> significant;
    std::uint32_t first = 0;

    /// The significant token number `i`: 0 is the '#' of a directive, 1 its name; empty past the end.
    [[nodiscard]] std::string_view word(std::size_t i) const {
        return i < significant.size() ? significant[i]->text : std::string_view{};
    }
};

class Preprocessor {
  public:
    explicit Preprocessor(StageText& stage) : stage_(stage) {}

    /// False in branches that are not compiled.
    [[nodiscard]] bool active() const { return active_; }
    /// Adds a token of compiled text.
    void text(const ViewToken& token) { pending_.push_back(token); }
    /// Expands the text added so far into the view of the stage.
    void flush();
    /// True if the macros expand to more than the limit; the view is not complete then.
    [[nodiscard]] bool isExhausted() const { return macros_.isExhausted(); }
    /// Performs #if, #ifdef, #ifndef, #elif, #else, #endif, #define and #undef; false for other directives.
    bool perform(std::string_view directive, const SourceLine& line);
    /// Gives `value` the integer with which the tokens of a line from `first` on begin; false if there is
    /// none.
    bool number(const SourceLine& line, std::size_t first, long long& value);

  private:
    struct Conditional {
        bool outer;  ///< true: the surrounding text is compiled
        bool taken;  ///< true: one of the branches so far was compiled
    };

    void conditional(std::string_view directive, const SourceLine& line);
    void branch(bool taken);
    void define(const SourceLine& line);
    [[nodiscard]] bool isDefined(std::string_view name) const;
    bool condition(const SourceLine& line);
    void predefined(ViewToken& token);

    StageText& stage_;
    MacroTable macros_;
    std::vector<ViewToken> pending_;
    std::vector<Conditional> conditionals_;
    bool active_ = true;
};

}  // namespace glibra::glsl
