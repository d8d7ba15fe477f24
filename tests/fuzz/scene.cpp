// Any bytes as a scene: parsed and interpreted twice, with equal results. Every statement alone means what it
// means in the scene.

#include <algorithm>
#include <variant>
#include <vector>

#include "../glib/modern_syntax.h"
#include "base/texel_format.h"
#include "check.h"
#include "glib/lexer.h"
#include "glib/script.h"
#include "glib/statement_table.h"
#include "scene/interpret.h"
#include "text_mutator.h"

namespace {

using glibra::fuzz::check;

std::vector<std::size_t> lineLengths(std::string_view text) {
    std::vector<std::size_t> lengths;
    glibra::glib::LineSplitter lines(text);
    while (const auto line = lines.next()) lengths.push_back(line->end - line->begin);
    return lengths;
}

/// Every place is inside the text, or just after a line.
void checkPlaces(const glibra::Diagnostics& diagnostics, const std::vector<std::size_t>& lengths) {
    glibra::fuzz::checkMessages(diagnostics);
    for (const glibra::Diagnostic& each : diagnostics) {
        const auto line = static_cast<std::size_t>(each.place.line),
                   column = static_cast<std::size_t>(each.place.column);
        check(line <= std::max<std::size_t>(lengths.size(), 1), "a message is about a line that exists");
        check(column <= (lengths.empty() ? 0 : lengths[line - 1]) + 1,
              "a message is about a column that exists");
    }
}

/// The bytes of a statement give the same command again.
void checkAlone(const glibra::glib::Command& command, std::string_view text) {
    check(command.begin < command.end && command.end <= text.size(), "a statement has its bytes in the text");
    // Modern statements depend on the blocks around them and on the names before them.
    if (command.isModern) return;
    const glibra::glib::Script alone =
        glibra::glib::parse(text.substr(command.begin, command.end - command.begin), "nowhere/scene.glib");
    check(alone.commands.size() == 1, "a statement alone is one command");
    const glibra::glib::Command& again = alone.commands.front();
    // A Program without a name takes it from a file of an earlier statement.
    const bool takesName = command.id == glibra::glib::CommandId::program;
    check(again.id == command.id && again.numbers == command.numbers &&
              (takesName || again.text() == command.text()) && again.values.size() == command.values.size() &&
              again.uniforms.size() == command.uniforms.size(),
          "a statement alone means the same");
}

}  // namespace

const glibra::fuzz::Grammar& glibra::fuzz::grammar() {
    static const Grammar kGrammar = [] {
        Grammar made;
        for (const glib::StatementRow& row : glib::commandTable())
            for (const std::string_view name : row.names()) {
                if (name.empty()) continue;
                made.words.emplace_back(name);
                std::string& plain = made.statements.emplace_back(name);
                for (std::size_t i = 0; i < argumentsOf(row).size(); ++i) plain += i == 0 ? " 5" : " .5";
                for (const std::string& word : wordsOf(row))
                    made.statements.push_back(std::string(name) + " " + std::string(word));
            }
        for (const glib::TextureFormat& format : glib::textureFormats()) made.words.emplace_back(format.name);
        for (const char* word :
             {"true", "false", "<0 .5 1>", "{1 .5 0}", "[1 2 3]", "\"two words\"", "\\", "#", "on"})
            made.words.emplace_back(word);
        for (const glib::StatementRow& row : glib::statementTable()) {
            made.words.emplace_back(row.name);
            for (const std::string& word : glib::wordsOf(row)) made.words.push_back(word);
            // Every statement in all its forms.
            for (const glib::test::Samples& samples : glib::test::samplesOf(glib::syntaxOf(row).root)) {
                std::string& line = made.statements.emplace_back(row.name);
                for (const glib::test::Sample& each : samples) line += " " + each.text;
            }
        }
        for (const base::TexelFormatRow& row : base::texelFormats()) made.words.emplace_back(row.name);
        for (const char* line : {"Let a <0 1 2>",
                                 "Let b <red green blue>",
                                 "Let c {1 .5 0}",
                                 "Let d (2 * a + time)",
                                 "Let e[3] (i == 0 ? 1 : e[i - 1] / 2)",
                                 "Group g x 0 y (time)",
                                 "Draw g x (a)",
                                 "EndGroup",
                                 "Repeat 3 as k",
                                 "Repeat [p q] as w",
                                 "EndRepeat",
                                 "When (a > 1)",
                                 "Else",
                                 "EndWhen",
                                 "Set uA (model) uB [3 of (i)] uC a",
                                 "Material gold",
                                 "Use Fuzzed",
                                 "Fps 24",
                                 "Translate (a) (time) (1/3)",
                                 "Box (vec3(1, 2, 3))",
                                 "Camera eye LookAt 0 0 5 0 0 0 0 1 0 Perspective 50 .1 100",
                                 "Camera light[2] LookAt (i) 0 5 0 0 0 0 1 0 Ortho -1 1 -1 1 .1 9",
                                 "Camera r Reflect eye 0 1 0 -1 clip",
                                 "Camera s Shift eye .1 0 0",
                                 "Camera f Face 2 0 0 0 .1 9",
                                 "Program Fuzzed uM (eye.prev.view * model)",
                                 "Vertex inline",
                                 "EndVertex",
                                 "Include other.glib",
                                 "Pass window from eye clear {1 0 0}",
                                 "EndPass"})
            made.statements.emplace_back(line);
        made.statements.insert(
            made.statements.end(),
            {"Program Fuzzed uA .5 uB <0 1 2> uC {1 .5 0} uD [1 2 3 4] uE <true>",
             "Texture 5 \"no such.png\"", "LinesAdjacency [0 0 0] [1 0 0] [1 1 0] [0 1 0]", "}"});
        return made;
    }();
    return kGrammar;
}

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string_view text = glibra::fuzz::textOf(data, size);
    const std::vector<std::size_t> lengths = lineLengths(text);
    const glibra::glib::Script script = glibra::glib::parse(text, "nowhere/scene.glib");
    checkPlaces(script.diagnostics, lengths);
    for (std::size_t i = 0; i < std::min<std::size_t>(script.commands.size(), 8); ++i)
        checkAlone(script.commands[i], text);

    const glibra::scene::Scene scene = glibra::scene::interpret(script);
    checkPlaces(scene.diagnostics, lengths);
    for (const glibra::scene::Pass& pass : scene.frame.passes)
        for (const auto& step : pass.steps)
            if (const auto* draw = std::get_if<glibra::scene::Draw>(&step)) {
                check(draw->shape.position() < scene.shapes.size(), "a draw has a shape");
                check(!draw->program || draw->program.position() < scene.programs.size(),
                      "a draw has a program of the scene, or none");
            }
    glibra::scene::Interpretation later(script, {});
    for (const double time : {1.5, 0.}) checkPlaces(later.at({.time = time}).diagnostics, lengths);
    if (size % 4 != 0) return 0;
    const glibra::scene::Scene again = glibra::scene::interpret(script);
    check(scene.diagnostics.size() == again.diagnostics.size(), "a script means the same twice");
    check(scene.frame.passes.size() == again.frame.passes.size() &&
              scene.shapes.size() == again.shapes.size() && scene.programs.size() == again.programs.size(),
          "a script makes the same scene twice");
    return 0;
}
