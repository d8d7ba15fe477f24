#pragma once
// The preprocessor's macros. The grammar sees the tokens of a source after macro expansion. Each of them
// remembers where it was written, so that edits go to the user's own text.

#include <map>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "glsl/read/token.h"

namespace glibra::glsl {

/// A token as the grammar sees it.
struct ViewToken {
    std::string_view text;
    std::uint32_t raw = 0;  ///< index of the token where it is spelled
    /// Index of the name of the outermost macro that it comes from; equal to `raw` outside macros.
    std::uint32_t site = 0;
    TokenKind kind = TokenKind::word;
    bool body = false;        ///< spelled in a macro's body
    bool objectSite = false;  ///< `site` is the name of a macro without parameters
    bool isName = false;      ///< a keyword of the target that this source uses as a name (markNames)
};

struct Macro {
    bool takesArguments = false;
    std::vector<std::string_view> parameters;
    std::vector<ViewToken> body;
};

/// The macros that are defined at the current line of a source.
class MacroTable {
  public:
    void define(std::string_view name, Macro macro) {
        macros_.insert_or_assign(std::string(name), std::move(macro));
    }
    void undefine(std::string_view name);
    [[nodiscard]] bool isDefined(std::string_view name) const { return macros_.find(name) != macros_.end(); }

    /// Appends the expansion of `tokens` to `out`. After kMostSteps steps names are no longer expanded.
    void expand(std::span<const ViewToken> tokens, std::vector<ViewToken>& out);

    /// True once there were so many steps that something was not expanded.
    [[nodiscard]] bool isExhausted() const { return steps_ > kMostSteps; }
    static constexpr std::size_t kMostSteps = 2'000'000;  // glsl-E11 states it

  private:
    void expandInto(std::span<const ViewToken> tokens, std::vector<ViewToken>& out, int depth);
    [[nodiscard]] std::vector<ViewToken> substitute(const Macro& macro,
                                                    const std::vector<std::span<const ViewToken>>& arguments,
                                                    const ViewToken& call, int depth);

    std::map<std::string, Macro, std::less<>> macros_;
    std::set<std::string, std::less<>> disabled_;
    std::size_t steps_ = 0;
};

/// Gives `value` the value of an #if or #elif expression in which macros and `defined` are already replaced.
/// Words count as 0. False if the tokens are not an expression.
bool evaluateCondition(std::span<const ViewToken> tokens, long long& value);

}  // namespace glibra::glsl
