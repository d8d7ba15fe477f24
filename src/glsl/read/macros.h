#pragma once
// The preprocessor's macros: what #define declares, and what a call of a macro expands to.

#include <cstdint>
#include <deque>
#include <functional>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "glsl/read/stage_text.h"
#include "glsl/read/token.h"
#include "glsl/read/words.h"
#include "glsl/types/request.h"

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

// ---- Predefined macros
// The macros that exist without a #define (GLSL 4.60, 3.3 and 3.4; GLSL ES 1.00, 3.4).

/// The text of a predefined macro whose value is the same in every line: __VERSION__, GL_ES, the profiles
/// and the extensions. Nothing for other names, and for macros that the dialect does not have.
std::optional<std::string> predefinedMacro(std::string_view name, const Dialect& dialect,
                                           const Target& target);

/// True for __LINE__ and __FILE__, whose value depends on the place.
bool isPlaceMacro(std::string_view name);

/// True for names that a source must neither define nor undefine: those of all predefined macros, and those
/// that begin with GL_.
bool isReservedMacro(std::string_view name);

// ---- Expansion
// Expands macros as C does (C11, 6.10.3): arguments are expanded first, the result is read again together
// with the text that follows, and a macro is not expanded inside itself. Tokens never grow together.

/// Reports a mistake at the place of a token.
using Complain = std::function<void(const char* id, std::string text, const Token& at)>;

class Expander {
  public:
    /// The expanded text goes to `stage.tokens`.
    Expander(StageText& stage, Complain complain) : stage_(stage), complain_(std::move(complain)) {}

    MacroTable& macros() { return macros_; }
    /// The constant that the scene gives of that name, or null. The text then has the name.
    const Constant* constantNamed(std::string_view name);
    /// Makes the constant a macro, which `type` (empty: any) says how to write. False, with glsl-E18, if the
    /// value is none of that type.
    bool defineConstant(const Constant& constant, std::string_view type, const Token& at);
    /// The macro of that name, also a predefined one; null if there is none.
    Macro* find(std::string_view name);
    [[nodiscard]] bool isDefined(std::string_view name);

    /// Adds a token of the text. Tokens of directives and synthetic ones are not looked into.
    void add(const Token& token) { input_.push_back(token); }
    /// Expands the text. `more` adds further tokens; it returns false at the end of the source.
    void run(const std::function<bool()>& more);
    /// Expands the tokens of a directive.
    std::vector<Piece> expand(std::vector<Piece> pieces);

    /// The value of __FILE__ from here on.
    void setFileNumber(long long number) { fileNumber_ = number; }
    /// True once there was so much to expand that something was left as it is.
    [[nodiscard]] bool isExhausted() const { return steps_ > kMostSteps; }
    static constexpr std::size_t kMostSteps = 2'000'000;  // glsl-E11 states it
    static constexpr int kDeepestCalls = 200;

  private:
    /// Tokens that are read before the text: the result of a macro, or an argument.
    struct Context {
        std::vector<Piece> pieces;
        std::size_t at = 0;
        Macro* macro = nullptr;
    };
    /// What is read: the contexts from `base` on, and the text after them if `text`.
    struct Reach {
        std::size_t base = 0;
        bool text = false;
    };
    using Pieces = std::vector<Piece>;

    void drain(Reach reach, Pieces& out);
    /// Puts the piece into `out`, or the result of the macro that it calls before what is read next.
    void name(Piece piece, Reach reach, Pieces& out);
    [[nodiscard]] Piece placeMacro(const Piece& piece);
    void push(Pieces pieces, Macro* macro);
    void popExhausted(std::size_t base);
    bool takeParenthesis(Reach reach);
    bool takeArguments(Reach reach, std::vector<Pieces>& arguments);
    bool next(Reach reach, Piece& piece);
    bool nextOfText(Piece& piece);
    Pieces substitute(const Macro& macro, const std::vector<Pieces>& arguments, const Piece& call);
    void paste(Pieces& pieces, std::size_t left, Piece right);
    bool countStep();

    /// Gives a `const` variable with the name of a constant of the scene its value. Reports glsl-E18 for
    /// other declarations of the name. False if the name is no constant, or not declared here.
    bool declaresConstant(const Token& name);
    void writeConstant(const Constant& constant, const std::string& type, const Token& name);
    /// Reads ahead to the next significant token of the text; null at its end.
    const Token* nextSignificant();

    void keepLineEnds(const Token& token, std::uint32_t order);
    void flush(const Pieces& result);
    void write(const Token& token);
    void writeBlank(const Token& before);

    StageText& stage_;
    Complain complain_;
    MacroTable macros_;
    std::vector<Context> contexts_;
    std::vector<Token> input_;
    std::size_t at_ = 0;
    std::uint32_t firstOrder_ = 0;  ///< order of input_[0]
    const std::function<bool()>* more_ = nullptr;
    std::vector<Piece> lineEnds_;                  ///< line ends and directives inside the current call
    std::set<std::string, std::less<>> declared_;  ///< constants that are variables of the text
    std::set<std::uint32_t> reported_;             ///< wrong calls in the texts of macros
    bool afterCall_ = false;
    std::size_t steps_ = 0;
    int depth_ = 0;
    bool isExhausted_ = false;
    long long fileNumber_ = 0;
};

}  // namespace glibra::glsl
