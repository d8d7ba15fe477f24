#pragma once
// A scene's text as a list of commands. The parser makes it, the interpreter reads it.

#include <glibra/diagnostic.h>

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "glib/command_id.h"

namespace glibra::glib {

/// A place inside the scene's own file.
struct Position {
    int line = 1;
    int column = 1;
};

/// One bracketed group of LinesAdjacency [x y z] [x y z] ..., as written.
struct PointGroup {
    std::vector<double> values;
    Position position;
};

/// How the value of a uniform is written on a Program line (language, 5.2).
enum class UniformForm { number, list, range, truth, color };

/// One `tag value` pair of a Program statement. `values` are the numbers as written (for truth: 1 or 0).
/// Their meaning depends on the type in the linked program; src/plan decides it.
struct UniformSpec {
    std::string tag;
    UniformForm form = UniformForm::number;
    std::vector<double> values;
    Position tagPosition;
    Position valuePosition;
};

/// One statement. The form in the command's row decides which members are filled:
/// - numbers: all numbers of the command in the order of the row, defaults filled in, inside their limits;
/// - text: file name (empty if none is given), program name, topology or switch word, format of an empty
///   texture, MessageBox text;
/// - files: the six files of CubeMap;
/// - points: groups of LinesAdjacency and Triangles, each of 3 or 4 numbers;
/// - uniforms: the pairs of Program.
struct Command {
    CommandId id{};
    std::string word;  ///< as written
    Position position;
    std::vector<double> numbers;
    std::size_t givenNumbers = 0;  ///< how many of the numbers stand in the file
    std::string text;
    Position textPosition;
    std::vector<std::string> files;
    std::vector<PointGroup> points;
    std::vector<UniformSpec> uniforms;
    std::size_t begin = 0;  ///< byte range of the statement in the file, for editing it in place
    std::size_t end = 0;
};

struct Script {
    std::string path;  ///< as given to the parser; used in every message
    std::vector<Command> commands;
    Diagnostics diagnostics;

    [[nodiscard]] Place place(Position position) const { return {path, position.line, position.column}; }
};

/// Reads a whole scene (language, 1, 3 and 5.1). The text may hold any bytes. Parsing goes on to the end of
/// the text, so that all messages come at once; faulty statements are not in `commands`.
Script parse(std::string_view text, std::string path);

}  // namespace glibra::glib
