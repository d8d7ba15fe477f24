#pragma once
// A scene's text as a list of commands: what the parser makes, what the interpreter reads. No GL, no files.

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

/// One bracketed group of points as written: LinesAdjacency [x y z] [x y z] ...
struct PointGroup {
    std::vector<double> values;
    Position position;
};

/// How a uniform's value was written on a Program line (language, 5.2).
enum class UniformForm { number, list, range, truth, color };

/// One `tag value` pair of a Program statement. `values` are the numbers as written (for truth: 1 or 0);
/// what they mean depends on the linked program's type and is decided by plan.
struct UniformSpec {
    std::string tag;
    UniformForm form = UniformForm::number;
    std::vector<double> values;
    Position tagPosition;
    Position valuePosition;
};

/// One statement. Which of the members are filled is said by the command's row in the table:
/// - numbers: all numbers of the command, defaults filled in, in the table's order, in their ranges;
/// - text: file name (empty: none given), program name, topology or switch word, format of an empty texture,
///   MessageBox text;
/// - files: the six files of CubeMap;
/// - points: groups of LinesAdjacency and Triangles, each of 3 or 4 numbers;
/// - uniforms: the pairs of Program.
struct Command {
    CommandId id{};
    std::string word;  ///< as written
    Position position;
    std::vector<double> numbers;
    std::size_t givenNumbers = 0;  ///< how many of them stand in the file
    std::string text;
    Position textPosition;
    std::vector<std::string> files;
    std::vector<PointGroup> points;
    std::vector<UniformSpec> uniforms;
    std::size_t begin = 0;  ///< byte range of the statement in the file, for editing it in place
    std::size_t end = 0;
};

struct Script {
    std::string path;  ///< as given to the parser, used in every message
    std::vector<Command> commands;
    Diagnostics diagnostics;

    [[nodiscard]] Place place(Position position) const { return {path, position.line, position.column}; }
};

/// Reads a whole scene (language, sections 1, 3 and 5.1). Never throws on any bytes; goes on to the end of
/// the text, so that all messages come at once. Faulty statements are left out of `commands`.
Script parse(std::string_view text, std::string path);

}  // namespace glibra::glib
