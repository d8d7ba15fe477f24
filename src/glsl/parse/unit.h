#pragma once
// The stages of a program while they are translated.

#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "glsl/parse/syntax.h"
#include "glsl/parse/tree.h"
#include "glsl/read/report.h"
#include "glsl/read/stage_text.h"
#include "glsl/types/request.h"
#include "glsl/types/translated_program.h"

namespace glibra::glsl {

/// A variable at file scope as the rules change it. All rules work on these values, and the tokens are
/// changed once at the end, so that several rules can change one declaration.
struct Variable : ChangeableQualifiers {
    std::size_t declaration = 0;  ///< index into the syntax
    std::size_t declarator = 0;
    std::string name;             ///< the user's
    std::uint32_t nameToken = 0;  ///< view index

    std::string type;                                         ///< a word; empty for struct { ... }
    std::vector<std::string> typeSizes;                       ///< the texts in the brackets after the type
    std::vector<std::string> nameSizes;                       ///< the texts in the brackets after the name
    std::vector<std::pair<std::string, std::string>> layout;  ///< names and values; a value may be empty

    bool changed = false;  ///< the head of its declaration has to be written again
    bool removed = false;
    bool sizesChanged = false;
    bool dropInitializer = false;
    std::string initializer;  ///< " = ..." to be written after the name
    std::string after;        ///< to be written after the declaration's ';'

    [[nodiscard]] bool isArray() const { return !typeSizes.empty() || !nameSizes.empty(); }
    /// Sizes from the outermost to the innermost. Those after the name come first.
    [[nodiscard]] std::vector<std::string> sizes() const;
    [[nodiscard]] const std::string* layoutValue(std::string_view key) const;
    void removeLayout(std::string_view key);
    void setLayout(std::string key, std::string value);
};

/// One stage while it is translated: its text, what the parser found in it, and what the rules decided.
struct Unit : StageText {
    Syntax syntax;
    Bodies bodies;

    /// Names declared at file scope, also members of blocks without an instance name, and their view indices.
    std::map<std::string, std::uint32_t, std::less<>> declared;
    /// View indices of the uses of each name, except where a local declaration hides it and after a '.'.
    std::map<std::string, std::vector<std::uint32_t>, std::less<>> uses;
    /// Those of these uses that may change the variable.
    std::map<std::string, std::vector<std::uint32_t>, std::less<>> writes;

    std::vector<Variable> variables;  ///< file-scope variables, in order of declaration
    /// New spellings of words: `renames` everywhere except after a '.', `wordRenames` also there.
    std::map<std::string, std::string, std::less<>> renames, wordRenames;
    std::set<std::uint32_t> keptSpelling;  ///< tokens that `renames` leaves alone
    std::set<std::uint32_t> layoutWords;   ///< tokens of layout(...) that both leave alone

    bool isSupplied = false;            ///< the translator wrote the text
    std::vector<std::string> prologue;  ///< lines of GLSL before the user's text
    int mostVertices = 0;               ///< max_vertices of the emitted geometry stage; 0: not known
    int varyingComponents = 0;          ///< number of components of the outputs that the translator adds
    /// Statements to be executed after the user's main. If there are any, that is renamed to glibra_main.
    std::vector<std::string> mainEnd;

    [[nodiscard]] bool isUsed(std::string_view name) const { return uses.contains(name); }
    [[nodiscard]] bool isWritten(std::string_view name) const { return writes.contains(name); }
    [[nodiscard]] bool isDeclared(std::string_view name) const { return declared.contains(name); }
    /// True if the source declares the name anywhere: at file scope, as a local variable, parameter or macro.
    [[nodiscard]] bool isUserName(std::string_view name) const;
    [[nodiscard]] Variable* variable(std::string_view name);
    /// The first variable of that name, even if it has been removed; null if there is none.
    [[nodiscard]] const Variable* firstVariable(std::string_view name) const;
    /// The first definition of a function of that name, or null.
    [[nodiscard]] const Declaration* function(std::string_view name) const;
    /// The local variable or parameter of that name, if there is only one.
    [[nodiscard]] const LocalVariable* onlyLocal(std::string_view name) const;
    /// True if a token of the range is one of these words.
    [[nodiscard]] bool hasAny(Range range, std::initializer_list<std::string_view> words) const;
    /// Adds a line to the prologue if it is not there yet.
    void declare(const std::string& line);
    /// Removes the text of a range.
    void remove(Range range);
    /// Writes `type(...)` around a range.
    void convert(Range range, const std::string& type);
};

/// All stages of a program, and the result of their translation so far.
struct ProgramUnits {
    const ProgramRequest* request = nullptr;
    std::vector<Unit> units;  ///< in pipeline order
    TranslatedProgram* result = nullptr;
    Report report;

    [[nodiscard]] Unit* find(Stage stage);
    /// The nearest stage before `stage`, or null.
    [[nodiscard]] Unit* before(Stage stage);
    /// The last stage before rasterisation, or null.
    [[nodiscard]] Unit* lastBeforeRaster();
};

/// "dots.vert:4": the file name without folders, and the line.
std::string shortPlace(const Place& place);

/// The text of the given view tokens, with a blank between adjacent words.
std::string textOf(const Unit& unit, Range range);

}  // namespace glibra::glsl
