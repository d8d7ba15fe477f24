#pragma once
// Macros and conditions of one stage, in the order of its lines: what is compiled and what it expands to.

#include <span>
#include <string_view>
#include <vector>

#include "glsl/parse/unit.h"
#include "glsl/read/macros.h"

namespace glibra::glsl {

/// A line of a file. `first` is the index that its first token has among the tokens of the stage.
struct SourceLine {
    std::span<const Token> tokens;
    std::vector<const Token*> significant;
    std::uint32_t first = 0;

    /// The significant word number `i`: 0 is the '#' of a directive, 1 its name; empty behind the end.
    [[nodiscard]] std::string_view word(std::size_t i) const {
        return i < significant.size() ? significant[i]->text : std::string_view{};
    }
};

class Preprocessor {
  public:
    explicit Preprocessor(Unit& unit) : unit_(unit) {}

    /// False in branches that are not compiled.
    [[nodiscard]] bool active() const { return active_; }
    /// A token of compiled text.
    void text(const ViewToken& token) { pending_.push_back(token); }
    /// Ends the text so far: it is expanded into the view of the unit.
    void flush();
    /// Obeys #if, #ifdef, #ifndef, #elif, #else, #endif, #define, #undef; false for other directives.
    bool perform(std::string_view directive, const SourceLine& line);
    /// The value of the integer that the words of a line from `first` on begin with; false if there is none.
    bool number(const SourceLine& line, std::size_t first, long long& value);

  private:
    struct Conditional {
        bool outer;  ///< the surrounding text is compiled
        bool taken;  ///< one of the branches was
    };

    void conditional(std::string_view directive, const SourceLine& line);
    void branch(bool taken);
    void define(const SourceLine& line);
    [[nodiscard]] bool isDefined(std::string_view name) const;
    bool condition(const SourceLine& line);
    void predefined(ViewToken& token);

    Unit& unit_;
    MacroTable macros_;
    std::vector<ViewToken> pending_;
    std::vector<Conditional> conditionals_;
    bool active_ = true;
};

}  // namespace glibra::glsl
