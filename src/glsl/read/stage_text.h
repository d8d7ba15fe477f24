#pragma once
// The text of one stage as it was read: its files, its tokens after macro expansion, and the changes decided
// for them.

#include <glibra/diagnostic.h>

#include <algorithm>
#include <cstdint>
#include <deque>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "glsl/read/token.h"
#include "glsl/read/words.h"
#include "glsl/types/request.h"

namespace glibra::glsl {

/// The last part of a path.
inline std::string fileName(std::string_view path) {
    return std::string(path.substr(path.find_last_of("/\\") + 1));
}

// ---- Changes to the tokens. A change never contains a line end, so the user's line structure stays.

struct Edit {
    bool replaced = false;
    std::string text;    ///< in place of the token, if `replaced`
    std::string before;  ///< written before the token
    std::string after;   ///< written after the token
};

/// Edits of the tokens 0 ... n-1.
class Edits {
  public:
    void resize(std::size_t tokens) { index_.resize(tokens, -1); }

    void replace(std::uint32_t token, std::string text) {
        Edit& edit = of(token);
        edit.replaced = true;
        edit.text = std::move(text);
    }
    void remove(std::uint32_t token) { replace(token, {}); }
    /// Puts text before the token and before what is already there, so call it for the outermost text last.
    void before(std::uint32_t token, std::string_view text) { of(token).before.insert(0, text); }
    /// Puts text after the token and after what is already there.
    void after(std::uint32_t token, std::string_view text) { of(token).after += text; }

    /// The same inside of what is already there: for the smallest expression around a token.
    void rightBefore(std::uint32_t token, std::string_view text) { of(token).before += text; }
    void rightAfter(std::uint32_t token, std::string_view text) { of(token).after.insert(0, text); }

    /// The edit of a token, or null.
    [[nodiscard]] const Edit* find(std::uint32_t token) const {
        return index_[token] < 0 ? nullptr : &edits_[static_cast<std::size_t>(index_[token])];
    }

  private:
    Edit& of(std::uint32_t token) {
        if (index_[token] < 0) {
            index_[token] = static_cast<std::int32_t>(edits_.size());
            edits_.emplace_back();
        }
        return edits_[static_cast<std::size_t>(index_[token])];
    }

    std::vector<std::int32_t> index_;
    std::vector<Edit> edits_;
};

// ---- The text

/// A token in the text of a macro.
struct BodyPlace {
    std::string_view macro;  ///< the name of the macro
    std::int32_t line = 1;
    std::int32_t column = 1;
    std::uint16_t file = 0;
};

struct StageText {
    StageText() = default;
    StageText(StageText&&) noexcept = default;  // not copyable: tokens point into `storage`
    StageText& operator=(StageText&&) = default;
    StageText(const StageText&) = delete;
    StageText& operator=(const StageText&) = delete;
    ~StageText() = default;

    const ProgramRequest* request = nullptr;
    Stage stage = Stage::vertex;
    std::string path;
    int firstLine = 1;                ///< without blank lines before it, as before a shader in a script
    std::vector<std::string> files;   ///< [0] is the stage's own
    std::deque<std::string> storage;  ///< the strings that the tokens point into

    Dialect dialect;
    /// The text after preprocessing, with its line structure. Directives are gone, except #pragma, #error and
    /// the #line of the translator.
    std::vector<Token> tokens;
    std::vector<Token> written;         ///< the text as it is written, for --no-shim
    std::vector<BodyPlace> macroTexts;  ///< the texts of all macros
    std::vector<ViewToken> view;        ///< the tokens that the grammar sees
    std::set<std::string, std::less<>> macros;
    std::vector<std::string> extensions;  ///< #extension lines to be passed on
    /// The extensions that the source enables and that are available (extensions.h).
    std::set<std::string, std::less<>> enabled;
    std::span<const Constant> constants;                ///< that the scene gives; none for supplied stages
    std::set<std::string, std::less<>> namedConstants;  ///< those whose names the text has
    Edits edits;

    /// Adds the line "#extension NAME : BEHAVIOUR" to those to be passed on, if it is not there yet.
    void passExtension(std::string_view name, std::string_view behaviour) {
        std::string line = "#extension " + std::string(name) + " : " + std::string(behaviour);
        if (std::ranges::find(extensions, line) == extensions.end()) extensions.push_back(std::move(line));
    }

    [[nodiscard]] Place placeOfToken(std::uint32_t token) const {
        if (token >= tokens.size()) return start();
        const Token& at = tokens[token];
        return {files[at.file], at.line, at.column};
    }
    [[nodiscard]] Place place(std::uint32_t viewIndex) const { return placeOfToken(view[viewIndex].raw); }
    [[nodiscard]] Place start() const { return {path, firstLine, 1}; }
    /// The text of a view token; empty past the end.
    [[nodiscard]] std::string_view text(std::uint32_t viewIndex) const {
        return viewIndex < view.size() ? view[viewIndex].text : std::string_view{};
    }
};

}  // namespace glibra::glsl
