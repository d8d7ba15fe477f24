// Shader files, programs, and the other commands (language, 3.5 and 3.6).

#include <fmt/format.h>

#include <utility>

#include "scene/classic/classic.h"
#include "scene/run/statements.h"

namespace glibra::scene {
namespace {

glsl::Stage stageOf(CommandId id) {
    switch (id) {
        case CommandId::tessControl:
            return glsl::Stage::tessControl;
        case CommandId::tessEvaluation:
            return glsl::Stage::tessEvaluation;
        case CommandId::geometry:
            return glsl::Stage::geometry;
        case CommandId::fragment:
            return glsl::Stage::fragment;
        default:
            break;
    }
    return glsl::Stage::vertex;
}

}  // namespace

FileIndex inlineShader(Interpreter& in, const Command& command) {
    const std::string name = fmt::format("{} on line {}", command.word, command.position.line);
    return fileNamed(in, in.script->path + '\n' + name, [&] {
        FileReference file;
        file.name = name;
        file.path = in.script->path;
        file.place = in.place(command);
        file.text = std::string(static_cast<std::size_t>(command.bodyPosition.line - 1), '\n') + command.body;
        return file;
    });
}

namespace {

/// Keeps a text that shaders include by its name.
void doGlsl(Interpreter& in, const Command& command) {
    const Value& name = command.values.front();
    const FileReference& text = in.scene.files[inlineShader(in, command)];
    const auto [known, isNew] = in.scene.glslTexts.try_emplace(name.text, text);
    if (isNew || known->second.place == text.place) return;
    in.reportAt(
        name, "glib-E36",
        fmt::format("'{}' is declared on line {} already, as Glsl", name.text, known->second.place.line));
}

void doStage(Interpreter& in, const Command& command) {
    const glsl::Stage stage = stageOf(command.id);
    // In a modern scene the vertex stage of another program begins a new pipeline: stages between it and the
    // fragment stage that belong to an earlier program end.
    if (in.isModern && stage == glsl::Stage::vertex)
        for (const glsl::Stage each : std::exchange(in.state.stagesOfProgram, {}))
            if (each != glsl::Stage::vertex && each != glsl::Stage::fragment) in.state.stageFiles.erase(each);
    in.state.stagesOfProgram.erase(stage);
    if (command.isModern)
        in.state.stageFiles[stage] = inlineShader(in, command);
    else if (command.text().empty())
        in.state.stageFiles.erase(stage);
    else
        in.state.stageFiles[stage] = fileOf(in, command.text(), in.script->place(command.textPosition()));
}

void doProgram(Interpreter& in, const Command& command) {
    Program program;
    program.name = command.text();
    program.place = in.place(command);
    program.uniforms = command.uniforms;
    const bool computes = static_cast<bool>(in.state.computeFile);
    if (computes) {
        program.stages = {{glsl::Stage::compute, std::exchange(in.state.computeFile, {})}};
    } else {
        for (const auto& [stage, file] : in.state.stageFiles) {
            const bool isNew = in.state.stagesOfProgram.insert(stage).second;
            program.stages.push_back({stage, file, !isNew});
        }
        program.geometryInput = in.state.geometryInput;
        program.geometryOutput = in.state.geometryOutput;
        program.geometryVerticesOut = in.state.geometryVerticesOut;
        program.sharesGeometryWords = in.isModern && std::exchange(in.state.hasGeometryWordsOfProgram, true);
    }
    const ProgramIndex made = in.scene.programs.add(std::move(program));
    if (!computes) in.state.program = made;
    in.modern.programs[command.text()] = made;
    if (!command.tags.empty()) in.modern.programTags[made] = {&command, in.script, in.names().here()};
}

void doGeometryInput(Interpreter& in, const Command& command) {
    in.state.hasGeometryWordsOfProgram = false;
    in.state.geometryInput = command.text();
}
void doGeometryOutput(Interpreter& in, const Command& command) {
    in.state.hasGeometryWordsOfProgram = false;
    in.state.geometryOutput = command.text();
}
void doGeometryVerticesOut(Interpreter& in, const Command& command) {
    in.state.hasGeometryWordsOfProgram = false;
    in.state.geometryVerticesOut = command.numbers.empty() ? 0 : static_cast<int>(command.numbers[0]);
}

void doTimer(Interpreter& in, const Command& command) {
    if (!command.numbers.empty()) in.state.timerPeriod = command.numbers[0];
}

void doMessageBox(Interpreter& in, const Command& command) {
    if (in.scene.messages.size() < glib::kMostMessages) in.scene.messages.push_back(command.text());
    in.reportAt(command, "glib-N01", fmt::format("MessageBox: {}", command.text()));
}

}  // namespace

std::span<const CommandAction> programActions() {
    static constexpr CommandAction kActions[] = {
        {CommandId::vertex, doStage},
        {CommandId::tessControl, doStage},
        {CommandId::tessEvaluation, doStage},
        {CommandId::geometry, doStage},
        {CommandId::fragment, doStage},
        {.id = CommandId::glslText, .handler = doGlsl, .isModern = true},
        {CommandId::program, doProgram, InList::isWrong},
        {CommandId::geometryInput, doGeometryInput},
        {CommandId::geometryOutput, doGeometryOutput},
        {CommandId::geometryVerticesOut, doGeometryVerticesOut},
        {CommandId::timer, doTimer},
        {CommandId::messageBox, doMessageBox},
        {CommandId::gstap, doNothing},
        {CommandId::verbose, doNothing},
    };
    return kActions;
}

}  // namespace glibra::scene
