// Shader files, programs, and the other commands (language, 3.5 and 3.6).

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "glsl/read/macros.h"
#include "glsl/read/words.h"
#include "scene/classic/classic.h"
#include "scene/run/evaluate.h"
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

/// What the value of a constant must not change with: its shaders would be compiled for every frame.
const char* movesWith(expression::Depends depends) {
    using expression::Depends;
    if (changesWithTime(depends)) return "the time";
    if (any(depends & Depends::mouse)) return "the mouse";
    return any(depends & Depends::camera) ? "the camera" : nullptr;
}

/// What a constant is that is given like this. Nothing with the reason reported.
std::optional<glsl::Constant> constantFrom(Interpreter& in, const std::string& name, const std::string& type,
                                           const Value& value) {
    const auto refuse = [&](const char* id, const std::string& text) {
        return in.reportAt(value, id, fmt::format("const {}: {}", name, text));
    };
    if (value.kind == Value::Kind::range)
        return refuse("glib-E19", fmt::format("a range stands in Let; write 'Let {0} {1}' and 'const {0} "
                                              "({0})'",
                                              name, glib::written(value)));
    const DependsOnly collected(in);
    const auto given = constantOf(in, {&value, 1});
    if (!given) return std::nullopt;
    if (const char* what = movesWith(collected.depends()))
        return in.reportAt(
            value, "glib-E39",
            fmt::format("const {0} follows {1}, so the shaders would be compiled for every frame; make it a "
                        "uniform variable: {0} ({2})",
                        name, what, value.text));
    glsl::Constant constant;
    constant.name = name;
    constant.type = type.empty() && given->type.isMatrix() ? expression::name(given->type) : type;
    constant.isBoolean = given->type.kind == expression::Kind::boolean;
    constant.components.assign(given->all().begin(), given->all().end());
    if (glsl::textOf(constant, constant.type)) return constant;
    return refuse("glib-E33", fmt::format("{} is no {}", glsl::valueText(constant),
                                          type.empty() ? "value of GLSL" : type));
}

/// `const [type] name value`. Reports what is wrong with it.
void addConstant(Interpreter& in, const Command& command, const KeyedValues& written, Program& program) {
    const bool isTyped = written.values.size() > 2;
    const Value& name = written.values[isTyped ? 1 : 0];
    const Value& value = written.values.back();
    const bool isLost = value.kind == Value::Kind::text;  // of a faulty statement, which was reported
    if (glsl::keywordSince(name.text) != 0 || glsl::isReservedMacro(name.text) || name.text == "defined" ||
        name.text == "main" || name.text.starts_with("gl_") || name.text.starts_with("glibra_")) {
        if (!isLost)
            in.reportAt(name, "glib-E36",
                        fmt::format("'{}' has a meaning of its own in GLSL; choose another name", name.text));
        return;
    }
    const auto isSame = [&](const auto& each) { return each.name == name.text; };
    if (isLost && std::ranges::any_of(program.constants, isSame)) return;
    const bool isUniform =
        std::ranges::any_of(program.uniforms, [&](const auto& each) { return each.tag == name.text; }) ||
        std::ranges::any_of(command.tags, [&](const auto& each) { return each.key == name.text; });
    if (isUniform || std::ranges::any_of(program.constants, isSame)) {
        in.reportAt(name, "glib-E18",
                    fmt::format("Program: '{}' given twice{}", name.text,
                                isUniform ? ", as a constant and as a uniform variable" : ""));
        return;
    }
    std::optional<glsl::Constant> constant;
    if (!isLost)
        constant = constantFrom(in, name.text, isTyped ? written.values[0].text : std::string(), value);
    // The shaders have the name, so that its mistake is the only one.
    if (!constant) constant = glsl::Constant{name.text, {}, false, {}};
    program.constants.push_back(*std::move(constant));
    program.constantPlaces.push_back(in.place(name));
}

void doProgram(Interpreter& in, const Command& command) {
    Program program;
    program.name = command.text();
    program.place = in.place(command);
    program.uniforms = command.uniforms;
    for (const KeyedValues& each : command.keys) addConstant(in, command, each, program);
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
