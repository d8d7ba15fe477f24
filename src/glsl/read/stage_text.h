#pragma once
// The text of one stage as it was read: its files, its tokens after macro expansion, and the changes decided
// for them.

#include <glibra/diagnostic.h>

#include <algorithm>
#include <cstdint>
#include <deque>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "glsl/read/edits.h"
#include "glsl/read/token.h"
#include "glsl/read/version.h"
#include "glsl/types/request.h"

namespace glibra::glsl {

/// The last part of a path.
inline std::string fileName(std::string_view path) {
    return std::string(path.substr(path.find_last_of("/\\") + 1));
}

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
