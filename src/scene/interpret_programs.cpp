// Shader files, programs, and the other commands (language, 3.5 and 3.6).

#include <fmt/format.h>

#include <utility>

#include "scene/state.h"

namespace glibra::scene {
namespace {

glsl::Stage stageOf(glib::CommandId id) {
    switch (id) {
        case glib::CommandId::tessControl:
            return glsl::Stage::tessControl;
        case glib::CommandId::tessEvaluation:
            return glsl::Stage::tessEvaluation;
        case glib::CommandId::geometry:
            return glsl::Stage::geometry;
        case glib::CommandId::fragment:
            return glsl::Stage::fragment;
        default:
            break;
    }
    return glsl::Stage::vertex;
}

}  // namespace

FileIndex inlineShader(Interpreter& in, const glib::Command& command) {
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
void doGlsl(Interpreter& in, const glib::Command& command) {
    const glib::Value& name = command.values.front();
    const FileReference& text = in.scene.files[inlineShader(in, command)];
    const auto [known, isNew] = in.scene.glslTexts.try_emplace(name.text, text);
    if (isNew || known->second.place == text.place) return;
    in.report(diagnose(
        "glib-E27",
        fmt::format("'{}' is declared on line {} already, as Glsl", name.text, known->second.place.line),
        in.script->place(name.position)));
}

void doStage(Interpreter& in, const glib::Command& command) {
    const glsl::Stage stage = stageOf(command.id);
    // In a modern scene the vertex stage of another program begins a new pipeline: stages between it and the
    // fragment stage that belong to an earlier program end.
    if (in.scene.isModern && stage == glsl::Stage::vertex)
        for (const glsl::Stage each : std::exchange(in.state.stagesOfProgram, {}))
            if (each != glsl::Stage::vertex && each != glsl::Stage::fragment) in.state.stageFiles.erase(each);
    in.state.stagesOfProgram.erase(stage);
    if (command.isModern)
        in.state.stageFiles[stage] = inlineShader(in, command);
    else if (command.text.empty())
        in.state.stageFiles.erase(stage);
    else
        in.state.stageFiles[stage] = fileOf(in, command.text, in.script->place(command.textPosition));
}

void doProgram(Interpreter& in, const glib::Command& command) {
    Program program;
    program.name = command.text;
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
        program.sharesGeometryWords =
            in.scene.isModern && std::exchange(in.state.hasGeometryWordsOfProgram, true);
    }
    const ProgramIndex made = in.scene.programs.add(std::move(program));
    if (!computes) in.state.program = made;
    in.modern.programs[command.text] = made;
    if (!command.tags.empty())
        in.modern.programTags[made] = {&command, in.script, in.shared->environment.here()};
}

void doGeometryInput(Interpreter& in, const glib::Command& command) {
    in.state.hasGeometryWordsOfProgram = false;
    in.state.geometryInput = command.text;
}
void doGeometryOutput(Interpreter& in, const glib::Command& command) {
    in.state.hasGeometryWordsOfProgram = false;
    in.state.geometryOutput = command.text;
}
void doGeometryVerticesOut(Interpreter& in, const glib::Command& command) {
    in.state.hasGeometryWordsOfProgram = false;
    in.state.geometryVerticesOut = command.numbers.empty() ? 0 : static_cast<int>(command.numbers[0]);
}

void doTimer(Interpreter& in, const glib::Command& command) {
    if (!command.numbers.empty()) in.state.timerPeriod = command.numbers[0];
}

void doMessageBox(Interpreter& in, const glib::Command& command) {
    if (in.scene.messages.size() < glib::kMostMessages) in.scene.messages.push_back(command.text);
    in.report(diagnose("glib-N01", fmt::format("MessageBox: {}", command.text), in.place(command)));
}

constexpr CommandAction kProgramActions[] = {
    {glib::CommandId::vertex, doStage},
    {glib::CommandId::tessControl, doStage},
    {glib::CommandId::tessEvaluation, doStage},
    {glib::CommandId::geometry, doStage},
    {glib::CommandId::fragment, doStage},
    {.id = glib::CommandId::glslText, .handler = doGlsl, .isModern = true},
    {glib::CommandId::program, doProgram, InList::isWrong},
    {glib::CommandId::geometryInput, doGeometryInput},
    {glib::CommandId::geometryOutput, doGeometryOutput},
    {glib::CommandId::geometryVerticesOut, doGeometryVerticesOut},
    {glib::CommandId::timer, doTimer},
    {glib::CommandId::messageBox, doMessageBox},
    {glib::CommandId::gstap, doNothing},
    {glib::CommandId::verbose, doNothing},
};

}  // namespace

std::span<const CommandAction> programActions() {
    return kProgramActions;
}

}  // namespace glibra::scene
