#pragma once
// The preprocessor's macros: what #define declares, and what a call of a macro expands to.

#include <cstdint>
#include <deque>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "glsl/read/token.h"

namespace glibra::glsl {

/// A token on its way through macro expansion.
struct Piece {
    Token token;
    /// Number of the token of the text that it is, or whose macro it comes from.
    std::uint32_t order = 0;
    bool blank = false;  ///< there is a blank before it
    /// The name of a macro that was met inside its own expansion: it is never expanded (C11, 6.10.3.4).
    bool painted = false;
};

/// A token in the text of a macro.
struct BodyToken {
    std::string_view text;
    TokenKind kind = TokenKind::word;
    int parameter = -1;          ///< the parameter that it names, or -1
    std::uint32_t body = kNone;  ///< Token::body of its copies
    bool blank = false;          ///< there is a blank before it
    bool isPasted = false;       ///< ## stands between it and the next one
    bool isAfterPaste = false;   ///< ## stands between the one before and it
};

struct Macro {
    bool takesArguments = false;
    std::vector<std::string_view> parameters;
    std::vector<BodyToken> body;
    std::int32_t line = 0;  ///< of its #define
    bool isPredefined = false;
    bool expanding = false;  ///< the tokens being read come from it

    /// True if a second #define of the same name may stand beside this one.
    [[nodiscard]] bool isSameAs(const Macro& other) const;
};

/// The macros that are defined at the current line of a source. Macros live as long as the table.
class MacroTable {
  public:
    void define(std::string_view name, Macro macro);
    void undefine(std::string_view name) { current_.erase(name); }
    /// The macro of that name, or null.
    [[nodiscard]] Macro* find(std::string_view name) {
        const auto found = current_.find(name);
        return found == current_.end() ? nullptr : found->second;
    }

  private:
    std::deque<Macro> all_;
    std::unordered_map<std::string_view, Macro*> current_;  ///< names point into the source
};

}  // namespace glibra::glsl
