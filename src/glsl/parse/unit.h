#pragma once
// One stage while it is being translated: its tokens, what the parser found in them, and the changes decided
// so far.

#include <deque>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "glsl/parse/bodies.h"
#include "glsl/parse/edits.h"
#include "glsl/parse/report.h"
#include "glsl/parse/syntax.h"
#include "glsl/parse/variables.h"
#include "glsl/read/macros.h"
#include "glsl/read/token.h"
#include "glsl/translate.h"

namespace glibra::glsl {

/// The version a source declares, after the tolerance of the language (7.2).
struct Dialect {
    int version = 330;    ///< a known desktop version
    int written = 330;    ///< the number that __VERSION__ gives
    bool given = false;   ///< there is a #version
    bool core = false;    ///< it says core
    std::string profile;  ///< "core", "compatibility" or empty, for sources that are not translated
    Place place;
};

struct Unit {
    Unit() = default;
    Unit(Unit&&) = default;  // not copied: tokens point into `storage`
    Unit& operator=(Unit&&) = default;
    Unit(const Unit&) = delete;
    Unit& operator=(const Unit&) = delete;
    ~Unit() = default;

    const ProgramRequest* request = nullptr;
    Stage stage = Stage::vertex;
    std::string path;
    std::vector<std::string> files;   ///< [0] is the stage's own
    std::deque<std::string> storage;  ///< what the tokens' texts point into

    Dialect dialect;
    std::vector<Token> tokens;
    std::vector<ViewToken> view;                ///< the active tokens after macro expansion
    std::set<std::string, std::less<>> macros;  ///< every name the source defines anywhere
    std::vector<std::string> extensions;        ///< #extension lines to be passed on

    Edits edits;
    Syntax syntax;
    Bodies bodies;

    /// Names declared at file scope, members of blocks without instance name included, and where (view
    /// index).
    std::map<std::string, std::uint32_t, std::less<>> declared;
    /// Uses of names that no local declaration hides, by name (view indices); members after '.' are not among
    /// them.
    std::map<std::string, std::vector<std::uint32_t>, std::less<>> uses;
    /// Of these uses, those that may change the variable.
    std::map<std::string, std::vector<std::uint32_t>, std::less<>> writes;

    std::vector<Variable> variables;  ///< file-scope variables, in order of declaration
    /// Words that get another spelling everywhere but behind a '.', and those that get it there too.
    std::map<std::string, std::string, std::less<>> renames, wordRenames;
    std::set<std::uint32_t> keptSpelling;  ///< tokens that `renames` leaves alone

    std::vector<std::string> prologue;  ///< lines of GLSL before the user's text
    int varyingComponents = 0;          ///< of glibra_Varyings as output
    std::vector<std::string> mainEnd;   ///< statements behind the user's main, which is glibra_main then

    [[nodiscard]] Place placeOfToken(std::uint32_t token) const;
    [[nodiscard]] Place place(std::uint32_t viewIndex) const { return placeOfToken(view[viewIndex].site); }
    [[nodiscard]] Place start() const { return {path, 1, 1}; }
    [[nodiscard]] std::string_view text(std::uint32_t viewIndex) const {
        return viewIndex < view.size() ? view[viewIndex].text : std::string_view{};
    }
    [[nodiscard]] bool isUsed(std::string_view name) const { return uses.find(name) != uses.end(); }
    [[nodiscard]] bool isWritten(std::string_view name) const { return writes.find(name) != writes.end(); }
    [[nodiscard]] bool isDeclared(std::string_view name) const {
        return declared.find(name) != declared.end();
    }
    /// Declared anywhere: file scope, local variable, parameter or macro.
    [[nodiscard]] bool isUserName(std::string_view name) const;
    [[nodiscard]] Variable* variable(std::string_view name);
    /// Adds a line to the prologue unless it is there.
    void declare(const std::string& line);
};

/// All stages of a program, and what translation finds out about them.
struct ProgramUnits {
    const ProgramRequest* request = nullptr;
    std::vector<Unit> units;  ///< in pipeline order
    TranslatedProgram* result = nullptr;
    Report report;

    [[nodiscard]] Unit* find(Stage stage);
    /// The stage in front of `stage`, or null.
    [[nodiscard]] Unit* before(Stage stage);
    /// The last stage before rasterisation, or null.
    [[nodiscard]] Unit* lastBeforeRaster();
};

/// "in dots.vert:4:1"-like words: file name without folders, and line.
std::string shortPlace(const Place& place);

/// Text of the given view tokens, with single blanks where words would run together.
std::string textOf(const Unit& unit, Range range);

}  // namespace glibra::glsl
