#pragma once
// The stages of a program while they are translated.

#include <initializer_list>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "glsl/parse/tree.h"
#include "glsl/parse/variable.h"
#include "glsl/read/report.h"
#include "glsl/read/stage_text.h"
#include "glsl/types/request.h"
#include "glsl/types/translated_program.h"

namespace glibra::glsl {

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
