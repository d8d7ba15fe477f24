#include "editor/scene_check.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <glibra/diagnostic.h>

#include <array>
#include <cstdio>
#include <cstring>
#include <deque>
#include <memory>
#include <optional>
#include <ranges>
#include <set>
#include <span>
#include <sstream>
#include <string_view>
#include <utility>

#include "base/contained_call.h"
#include "base/packed.h"
#include "base/text.h"
#include "editor/declared_names.h"
#include "glib/limits.h"
#include "glsl/emit/log.h"
#include "glsl/read/token.h"
#include "glsl/translate.h"
#include "glsl/types/stage.h"
#include "glsl/types/translated_program.h"
#include "gpu/context/context.h"
#include "plan/frame_plan.h"
#include "render/check/scene_check.h"
#include "render/consequences.h"
#include "render/load/program_sources.h"
#include "render/scene_renderer.h"
#include "scene/interpret.h"
#include "system/memory.h"
#include "system/process.h"

namespace glibra::editor {
namespace {

// The front end of glslang, for machines without a graphics driver.

struct CloseStream {
    void operator()(std::FILE* each) const { std::fclose(each); }
};

/// What `glslangValidator` says of a shader, line by line as a driver would; empty if it finds nothing wrong,
/// or is not installed.
std::string frontEndLog(glsl::Stage stage, const std::string& source) {
    constexpr std::array kStages{"vert", "tesc", "tese", "geom", "frag", "comp"};
    if (system::findInPath("glslangValidator").empty()) return {};
    const std::unique_ptr<std::FILE, CloseStream> input(std::tmpfile()), output(std::tmpfile());
    if (!input || !output) return {};
    if (std::fwrite(source.data(), 1, source.size(), input.get()) != source.size() ||
        std::fseek(input.get(), 0, SEEK_SET) != 0)
        return {};
    system::Process process = system::startProgram(
        {"glslangValidator", "--stdin", "-l", "-S", kStages.at(static_cast<std::size_t>(stage))},
        {input.get(), output.get(), system::Stream::To::nothing});
    if (!process || waitFor(process).isGood() || std::fseek(output.get(), 0, SEEK_SET) != 0) return {};
    std::string log;
    std::array<char, 4096> buffer{};
    for (std::size_t count = 0; (count = std::fread(buffer.data(), 1, buffer.size(), output.get())) > 0;)
        log.append(buffer.data(), count);
    std::string kept;
    for (std::string_view rest = log; !rest.empty();) {
        const std::string_view line = base::nextLine(rest);
        if (!line.starts_with("ERROR: Linking") && line.find("compilation terminated") == line.npos)
            kept.append(line) += '\n';
    }
    if (kept.find("ERROR") != kept.npos) return kept;
    return log.find("Missing entry point") == log.npos
               ? ""
               : "ERROR: 0:1: 'main' : the shader has no such function\n";
}

}  // namespace

// What the process of its own answers.

void eachMember(auto& packed, base::Is<SceneProgram::Stage> auto& of) {
    packed.upTo(glsl::Stage::compute, of.stage);
    packed(of.file);
}
void eachMember(auto& packed, base::Is<SceneProgram> auto& of) {
    packed(of.name, of.file, of.line, of.stages);
}
void eachMember(auto& packed, base::Is<KnownName> auto& of) {
    packed(of.name, of.type, of.what, of.value, of.isStageVariable);
    packed.upTo(CodeLanguage::glib, of.in);
}
void eachMember(auto& packed, base::Is<SceneCheck> auto& of) {
    packed(of.diagnostics, of.files, of.names.programs, of.names.values);
}

namespace {

// ---- The errors that every driver reports because the text of a shader asks for it.

/// "error" and " no such thing" of `#error no such thing`; empty for lines without a directive.
struct Directive {
    std::string_view name;
    std::string text;
};

Directive directiveOf(std::span<const glsl::Token> line) {
    Directive directive;
    bool isDirective = false;
    for (const glsl::Token& each : line) {
        const bool counts = glsl::isSignificant(each.kind);
        if (!directive.name.empty()) {
            if (each.kind != glsl::TokenKind::splice)
                directive.text += each.kind == glsl::TokenKind::comment ? " " : each.text;
        } else if (counts && !isDirective) {
            isDirective = each.text == "#";
            if (!isDirective) return {};
        } else if (counts) {
            directive.name = each.text;
        }
    }
    return directive;
}

/// The log that a driver would write about the #error lines of a stage. The translator has resolved all
/// conditions, and its #line directives give the number of the line after them, and of its file.
std::string logOf(const glsl::TranslatedStage& stage) {
    std::string log;
    std::deque<std::string> storage;
    const std::vector<glsl::Token> tokens = glsl::lex(stage.source, storage);
    int number = 1, file = 0;
    for (auto begin = tokens.begin(); begin != tokens.end();) {
        const auto end = std::find_if(begin, tokens.end(), [](const glsl::Token& each) {
            return each.kind == glsl::TokenKind::newline;
        });
        const Directive directive = directiveOf({begin, end});
        if (directive.name == "error")
            log += fmt::format("{}:{}(1): error: #error{}\n", file, number, directive.text);
        // Comments of several lines are one token.
        for (auto each = begin; each != end; ++each)
            number += static_cast<int>(std::ranges::count(each->text, '\n'));
        ++number;
        if (directive.name == "line") std::istringstream(directive.text) >> number >> file;
        begin = end == tokens.end() ? end : end + 1;
    }
    return log;
}

/// The #error lines of all stages, and the #include lines that found no file, which become such lines: as
/// glsl-E01, with the texts and places that `glibra check` gives them. Empty if the program was not
/// translated.
Diagnostics errorDirectivesOf(const glsl::TranslatedProgram& program) {
    Diagnostics found;
    for (const glsl::TranslatedStage& each : program.stages)
        if (const std::string log = logOf(each); !log.empty())
            append(found, glsl::explainCompileLog(program, each, log));
    return found;
}

// ---- The programs of a scene.

constexpr std::size_t kLargestAnswer = std::size_t{32} << 20U;  // both answers of checkContained
constexpr double kSeconds = 10;

/// The variants of all programs: those that draws and dispatches use, then the others.
std::vector<plan::ProgramVariant> variantsOf(const scene::Scene& scene) {
    std::vector<plan::ProgramVariant> variants;
    std::set<scene::ProgramIndex> used;
    const auto add = [&](const plan::ProgramVariant& variant) {
        if (!variant.program) return;
        used.insert(variant.program);
        if (std::ranges::find(variants, variant) == variants.end()) variants.push_back(variant);
    };
    const auto addAll = [&](const scene::NodeList& nodes) {
        nodes.visitDraws([&](const scene::Draw& draw, const scene::Pass& pass) {
            add(plan::variantOf(scene, draw, pass));
        });
        for (const scene::Dispatch& each : nodes.dispatches) add({.program = each.program});
    };
    addAll(scene.frame);
    for (const scene::OnceBlock& each : scene.once) addAll(each.nodes);
    for (const scene::StepBlock& each : scene.steps) addAll(each.nodes);
    for (const scene::ProgramIndex each : scene.programs.indices())
        if (!used.contains(each))
            add({.program = each, .isFullScreen = !scene.programs[each].hasStage(glsl::Stage::vertex)});
    return variants;
}

/// Translates the programs as for a driver that can do all that GLSL 4.50 and its extensions have.
void translateAll(const scene::Scene& scene, const RenderOptions& options, bool asksFrontEnd,
                  render::Stats& stats, SceneCheck& check) {
    render::ProgramSources sources(scene, options, stats);
    for (const plan::ProgramVariant& each : variantsOf(scene)) {
        const scene::Program& program = scene.programs[each.program];
        const bool isDrawn = program.hasStage(glsl::Stage::fragment) &&
                             (program.hasStage(glsl::Stage::vertex) || each.isFullScreen);
        if (!isDrawn && !program.hasStage(glsl::Stage::compute)) continue;
        Diagnostics found;
        glsl::ProgramRequest request = sources.request(each, false, found);
        request.target.hasExtension = [](std::string_view) { return true; };
        if (!hasError(found)) {
            const glsl::TranslatedProgram translated = glsl::translate(request);
            append(found, translated.diagnostics);
            append(found, errorDirectivesOf(translated));
            for (const glsl::TranslatedStage& one : translated.stages)
                if (const std::string log =
                        asksFrontEnd && !hasError(found) ? frontEndLog(one.stage, one.source) : "";
                    !log.empty())
                    append(found, glsl::explainCompileLog(translated, one, log));
        }
        sources.hideTexts(each.program, found);
        append(check.diagnostics, std::move(found));
    }
    for (std::filesystem::path& each : sources.filesRead())
        if (std::ranges::find(check.files, each) == check.files.end()) check.files.push_back(std::move(each));
}

std::string valueText(const std::vector<double>& numbers, glib::UniformForm form) {
    std::string text;
    for (const double each : numbers) text += fmt::format("{}{:.6g}", text.empty() ? "" : " ", each);
    switch (form) {
        case glib::UniformForm::range:
            return "<" + text + ">";
        case glib::UniformForm::color:
            return "{" + text + "}";
        case glib::UniformForm::list:
            return "[" + text + "]";
        case glib::UniformForm::truth:
            return !numbers.empty() && numbers.front() != 0 ? "<true>" : "<false>";
        case glib::UniformForm::number:
            break;
    }
    return text;
}

/// A message about several places, each with its text once.
void removeEqual(Diagnostics& diagnostics) {
    std::set<std::string> seen;
    std::erase_if(diagnostics, [&](const Diagnostic& each) { return !seen.insert(toString(each)).second; });
}

}  // namespace

SceneNames namesOf(const scene::Scene& scene) {
    SceneNames names;
    for (const scene::Program& each : scene.programs) {
        SceneProgram program{each.name, each.place.file, each.place.line, {}};
        for (const scene::StageFile& stage : each.stages)
            if (!scene.files[stage.file].path.empty())
                program.stages.push_back({stage.stage, scene.files[stage.file].path});
        names.programs.push_back(std::move(program));
        for (const glib::UniformSpec& value : each.uniforms) {
            const KnownName name{value.tag, "uniform", "a uniform of " + each.name,
                                 value.word.empty() ? valueText(value.values, value.form) : value.word,
                                 CodeLanguage::glsl};
            names.values.push_back(name);
            names.values.push_back(name);
            names.values.back().in = CodeLanguage::glib;
        }
    }
    for (const scene::Variable& each : scene.variables)
        names.values.push_back({each.name, "variable", "a variable of the scene",
                                each.words.empty() ? valueText(each.written, each.form)
                                                   : fmt::format("<{}>", fmt::join(each.words, " ")),
                                CodeLanguage::glib});
    for (const auto& each : scene.functions)
        names.values.push_back({each->name,
                                fmt::format("{}({})", each->name, fmt::join(each->parameters, ", ")),
                                fmt::format("({}), line {}", each->body, each->origin.line),
                                {},
                                CodeLanguage::glib});
    return names;
}

namespace {

/// True for `out vec4 fColor`, which is no uniform and no block.
bool isStageVariable(std::string_view declaration) {
    static constexpr std::string_view kWords[] = {"in", "out", "attribute", "varying"};
    for (const auto& each : std::views::split(declaration, ' '))
        if (std::ranges::find(kWords, std::string_view(each.begin(), each.end())) != std::end(kWords))
            return true;
    return false;
}

}  // namespace

void addProgramNames(CodeContext& context, const std::vector<SceneProgram>& programs,
                     const std::filesystem::path& file,
                     const std::function<std::string(const std::filesystem::path&)>& textOf) {
    const bool isScene = context.language == CodeLanguage::glib;
    if (!isScene && !context.stage) context.stage = stageOfFile(file);
    for (const SceneProgram& program : programs) {
        const auto own = std::ranges::find(program.stages, file, &SceneProgram::Stage::file);
        if (!isScene && own == program.stages.end()) continue;
        if (isScene && !program.name.empty())
            context.names.push_back(
                {program.name, "Program", fmt::format("line {}", program.line), {}, CodeLanguage::glib});
        if (!isScene) context.stage = own->stage;
        for (const SceneProgram::Stage& each : program.stages) {
            if (each.file == file) continue;
            for (const DeclaredName& name : declaredNames(textOf(each.file)))
                if (name.isInterface)
                    context.names.push_back(
                        {name.name,
                         name.type,
                         fmt::format("{} in {}", name.declaration, each.file.filename().generic_string()),
                         {},
                         context.language,
                         isStageVariable(name.declaration)});
        }
    }
}

namespace {

SceneCheck withoutDriver(const std::filesystem::path& scene, const RenderOptions& options,
                         bool asksFrontEnd) {
    SceneCheck check;
    const auto text = options.texts.find(scene);
    if (text != options.texts.end() && text->second.size() > glib::kLargestFile) {
        check.diagnostics.push_back(
            diagnose("glib-E15",
                     fmt::format("the scene has more than {} bytes",
                                 base::groupedText(static_cast<long long>(glib::kLargestFile))),
                     {scene.generic_string(), 1, 1}));
        return check;
    }
    render::Stats stats;
    Result<render::InterpretedScene> interpreted = render::interpretFile(scene, options, stats);
    check.diagnostics = std::move(interpreted.diagnostics);
    if (interpreted) {
        // A scene with errors in its text is checked further, because its shaders may have errors too.
        check.names = namesOf(interpreted->scene);
        if (interpreted->source)
            for (const glib::Script* each : interpreted->source->scripts())
                if (each->path != scene.generic_string()) check.files.emplace_back(each->path);
        for (const scene::FileReference& each : interpreted->scene.files)
            append(check.diagnostics, each.remarks);
        for (const scene::Buffer& each : interpreted->scene.buffers)
            append(check.diagnostics, each.values.takeProblems());
        translateAll(interpreted->scene, options, asksFrontEnd, stats, check);
        scene::hideTexts(check.diagnostics, interpreted->scene.hiddenFiles);
    }
    removeEqual(check.diagnostics);
    render::applyStrict(check.diagnostics, options.strict);
    return check;
}

/// The messages with what a driver says. Nothing without a driver.
std::optional<Diagnostics> askDriver(const std::filesystem::path& scene, const RenderOptions& options) {
    Result<gpu::Context> context = gpu::openContext();
    if (!context) return std::nullopt;
    Diagnostics found = render::checkScene(*context, scene, options).diagnostics;
    removeEqual(found);
    return found;
}

/// A scene with the shader in its simplest program.
std::string sceneAround(const std::filesystem::path& shader, glsl::Stage stage) {
    using glsl::Stage;
    static constexpr std::pair<Stage, std::string_view> kWords[] = {{Stage::vertex, "Vertex"},
                                                                    {Stage::tessControl, "TessControl"},
                                                                    {Stage::tessEvaluation, "TessEvaluation"},
                                                                    {Stage::geometry, "Geometry"},
                                                                    {Stage::fragment, "Fragment"},
                                                                    {Stage::compute, "Compute"}};
    std::string scene;
    for (const auto& [each, word] : kWords) {
        const bool isNeeded = stage != Stage::compute && stage != Stage::fragment &&
                              (each == Stage::vertex || each == Stage::fragment ||
                               (each == Stage::tessEvaluation && stage == Stage::tessControl));
        if (each == stage)
            scene += fmt::format("{} \"{}\"\n", word, shader.filename().generic_string());
        else if (isNeeded)
            scene += fmt::format("{0} inline\n{1}End{0}\n", word, simplestShader(each));
    }
    return scene + "Let glibra_alone 1\nProgram Alone\n";  // a modern scene, which has buffers
}

enum class Asked { nobody, frontEnd, driver };

/// Checks a scene, or a shader that has none. Delivers what is known at once, then, if somebody is asked,
/// all: without a driver, what the front end says.
void checkFile(const std::filesystem::path& file, const RenderOptions& options, Asked asked,
               const std::function<void(const SceneCheck&)>& deliver) {
    const std::optional<glsl::Stage> stage = stageOfFile(file);
    std::filesystem::path scene = file;
    RenderOptions with = options;
    if (stage) {
        scene += ".glib";
        with.texts[scene] = sceneAround(file, *stage);
    }
    SceneCheck check;
    const auto checkText = [&](bool asksFrontEnd) {
        check = withoutDriver(scene, with, asksFrontEnd);
        if (!stage) return;
        check.names = {};
        std::erase(check.files, scene);
        if (!check.uses(file)) check.files.push_back(file);
    };
    const auto deliverOwn = [&] {
        if (stage)
            std::erase_if(check.diagnostics, [&](const Diagnostic& each) {
                // Its own program feeds none of its inputs, and sets none of its uniforms.
                const bool isOfProgram = each.severity != Severity::error &&
                                         (each.id == "glsl-W11" || !each.id.starts_with("glsl-"));
                return isOfProgram || each.place.file == scene || !check.uses(each.place.file);
            });
        deliver(check);
    };
    checkText(false);
    deliverOwn();
    if (asked == Asked::nobody) return;
    std::optional<Diagnostics> found;
    if (asked == Asked::driver) found = askDriver(scene, with);
    if (found)
        check.diagnostics = *std::move(found);
    else
        checkText(true);
    deliverOwn();
}

}  // namespace

std::string simplestShader(glsl::Stage stage) {
    switch (stage) {
        case glsl::Stage::vertex:
            return "#version 410\n\nvoid main() {\n"
                   "    gl_Position = uModelViewProjectionMatrix * aVertex;\n}\n";
        case glsl::Stage::tessControl:
            return "#version 410\nlayout(vertices = 3) out;\n\nvoid main() {\n"
                   "    gl_out[gl_InvocationID].gl_Position = gl_in[gl_InvocationID].gl_Position;\n"
                   "    gl_TessLevelOuter[0] = gl_TessLevelOuter[1] = gl_TessLevelOuter[2] = 4.;\n"
                   "    gl_TessLevelInner[0] = 4.;\n}\n";
        case glsl::Stage::tessEvaluation:
            return "#version 410\nlayout(triangles) in;\n\nvoid main() {\n"
                   "    gl_Position = gl_TessCoord.x * gl_in[0].gl_Position + gl_TessCoord.y * "
                   "gl_in[1].gl_Position +\n                  gl_TessCoord.z * gl_in[2].gl_Position;\n}\n";
        case glsl::Stage::geometry:
            return "#version 410\nlayout(triangles) in;\nlayout(triangle_strip, max_vertices = 3) out;\n\n"
                   "void main() {\n    for (int i = 0; i < 3; ++i) {\n"
                   "        gl_Position = gl_in[i].gl_Position;\n        EmitVertex();\n    }\n}\n";
        case glsl::Stage::compute:
            return "#version 430\nlayout(local_size_x = 64) in;\n\nvoid main() {\n}\n";
        case glsl::Stage::fragment:
            break;
    }
    return "#version 410\nout vec4 fColor;\n\nvoid main() {\n    fColor = vec4(1.);\n}\n";
}

SceneCheck checkScene(const std::filesystem::path& file, const RenderOptions& options, bool asksFrontEnd) {
    SceneCheck found;
    checkFile(file, options, asksFrontEnd ? Asked::frontEnd : Asked::nobody,
              [&](const SceneCheck& check) { found = check; });
    return found;
}

ContainedCheck checkContained(const std::filesystem::path& file, const RenderOptions& options) {
    const system::SharedMemory memory(kLargestAnswer);
    const std::span<std::byte> bytes = memory.bytes();
    ContainedCheck result;
    if (bytes.empty()) {
        result.failure = "there is no memory";
        return result;
    }
    // Half of the memory is for each answer: the one without a driver, and the one with it, which may fail.
    // The first bytes are the length of the answer. It is written last.
    const std::size_t half = bytes.size() / 2;
    const base::CallEnd end = base::runContained({.seconds = kSeconds}, [&] {
        std::byte* to = bytes.data();
        checkFile(file, options, Asked::driver, [&](const SceneCheck& check) {
            const std::string answer = base::packed(check, base::PackedText::utf8);
            const std::size_t length = answer.size();
            if (length + sizeof length <= half) {
                std::memcpy(to + sizeof length, answer.data(), length);
                std::memcpy(to, &length, sizeof length);
            }
            to += half;
        });
    });
    for (const std::size_t at : {half, std::size_t{0}}) {
        std::size_t length = 0;
        std::memcpy(&length, bytes.data() + at, sizeof length);
        if (length == 0 || length > half - sizeof length) continue;
        const auto* const begin = reinterpret_cast<const char*>(bytes.data()) + at + sizeof length;
        if (std::optional<SceneCheck> check = base::unpacked<SceneCheck>({begin, length})) {
            result.check = *std::move(check);
            return result;
        }
    }
    result.failure = end.kind == base::CallEnd::Kind::timedOut
                         ? fmt::format("checking the scene takes more than {} seconds", kSeconds)
                         : "checking the scene failed";
    return result;
}

}  // namespace glibra::editor
