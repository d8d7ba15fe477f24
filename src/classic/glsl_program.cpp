#include <fmt/format.h>
#include <glibra/classic/glsl_program.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <optional>
#include <span>
#include <utility>

#include "classic/gl_functions.h"
#include "classic/linked_program.h"
#include "glsl/emit/log.h"
#include "glsl/translate.h"

namespace glibra::classic {
namespace {

struct StageOfFile {
    std::string_view extension;
    glsl::Stage stage;
    GLenum type;
};
constexpr std::array<StageOfFile, 5> kStages{
    {{".vert", glsl::Stage::vertex, GL_VERTEX_SHADER},
     {".tcs", glsl::Stage::tessControl, GL_TESS_CONTROL_SHADER},
     {".tes", glsl::Stage::tessEvaluation, GL_TESS_EVALUATION_SHADER},
     {".geom", glsl::Stage::geometry, GL_GEOMETRY_SHADER},
     {".frag", glsl::Stage::fragment, GL_FRAGMENT_SHADER}}};

struct TopologyWord {
    GLenum topology;
    std::string_view word;
};
constexpr std::array<TopologyWord, 5> kGeometryInputs{{{GL_POINTS, "points"},
                                                       {GL_LINES, "lines"},
                                                       {GL_LINES_ADJACENCY, "lines_adjacency"},
                                                       {GL_TRIANGLES, "triangles"},
                                                       {GL_TRIANGLES_ADJACENCY, "triangles_adjacency"}}};
constexpr std::array<TopologyWord, 3> kGeometryOutputs{
    {{GL_POINTS, "points"}, {GL_LINE_STRIP, "line_strip"}, {GL_TRIANGLE_STRIP, "triangle_strip"}}};

/// Takes over the word of the topology; says so if it has none.
void setTopology(std::string& to, std::span<const TopologyWord> words, unsigned int topology,
                 const char* call, const char* does) {
    const auto found = std::ranges::find(words, topology, &TopologyWord::topology);
    if (found != words.end())
        to = found->word;
    else
        complainOf("GLSLProgram",
                   fmt::format("{}: {:#06x} is none that a geometry shader {}", call, topology, does));
}

template <class... Numbers>
std::array<double, sizeof...(Numbers)> doubles(Numbers... numbers) {
    return {static_cast<double>(numbers)...};
}

std::optional<std::string> textOfFile(const std::filesystem::path& path) {
    std::error_code error;
    if (!std::filesystem::is_regular_file(path, error)) return std::nullopt;
    std::ifstream file(path, std::ios::binary);
    if (!file) return std::nullopt;
    std::string text{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
    if (text.starts_with("\xEF\xBB\xBF")) text.erase(0, 3);
    return text;
}

glsl::Target targetOf(const Gl& gl) {
    glsl::Target target;
    target.version = std::clamp(10 * gl.version, 410, 450);
    target.lineDirectiveTakesFileName = gl.extensions.contains("GL_ARB_shading_language_include");
    if (const GLint most = gl.number(GL_MAX_GEOMETRY_OUTPUT_VERTICES); most > 0)
        target.maxGeometryOutputVertices = most;
    if (const GLint most = gl.number(GL_MAX_GEOMETRY_TOTAL_OUTPUT_COMPONENTS); most > 0)
        target.maxGeometryTotalOutputComponents = most;
    target.hasExtension = [&gl](std::string_view name) { return gl.extensions.contains(name); };
    return target;
}

/// A shader or program's log, by the function that gives it and the one that knows its length.
template <class Number, class Log>
std::string logOf(GLuint name, Number number, Log log) {
    GLint length = 0;
    number(name, GL_INFO_LOG_LENGTH, &length);
    std::string text(static_cast<std::size_t>(std::max(length, 1)), '\0');
    GLsizei written = 0;
    log(name, length, &written, text.data());
    text.resize(static_cast<std::size_t>(written));
    return text;
}

/// Where inputs are bound that give no location: the names of the book have the same one in all programs.
GLuint bookLocation(std::string_view book) {
    if (book == "aVertex") return 0;
    if (book == "aNormal") return 1;
    if (book == "aColor") return 2;
    return 3 + static_cast<GLuint>(book.back() - '0');  // aTexCoord0 to aTexCoord7
}

}  // namespace

struct __attribute__((visibility("hidden"))) GLSLProgram::State {
    bool isVerbose = false;
    bool isGstap = true;
    std::string geometryInput;
    std::string geometryOutput;

    Owner owner;
    GLuint program = 0;
    std::optional<ProgramValues> values;
    Diagnostics messages;
    bool toldInvalid = false;

    State() = default;
    State(const State&) = delete;
    State& operator=(const State&) = delete;
    ~State() { clear(); }

    void clear() {
        values.reset();
        if (program == 0) return;
        forget(owner.context(), program);
        if (owner.isCurrent()) owner.gl()->DeleteProgram(program);
        program = 0;
    }

    bool fail(std::string text, Place place = {}) {
        messages.push_back(withoutId(Severity::error, std::move(text), std::move(place)));
        return false;
    }

    bool build(std::vector<std::pair<std::string, std::string>> texts);
    bool compile(const glsl::TranslatedProgram& translated);
    void report() const;
    /// True with a program; else says once that there is none.
    bool isUsable(const char* call);
};

bool GLSLProgram::State::build(std::vector<std::pair<std::string, std::string>> texts) {
    glsl::ProgramRequest request;
    for (auto& [path, text] : texts) {
        const std::string extension = std::filesystem::path(path).extension().generic_string();
        const auto stage = std::ranges::find(kStages, extension, &StageOfFile::extension);
        if (stage == kStages.end())
            return fail("the extension says no stage; .vert, .tcs, .tes, .geom and .frag do", {path, 1, 1});
        if (std::ranges::find(request.stages, stage->stage, &glsl::StageSource::stage) !=
            request.stages.end())
            return fail("the program has two files of this stage", {path, 1, 1});
        request.name += (request.name.empty() ? "" : " ") + path;
        request.stages.push_back({stage->stage, path, std::move(text)});
    }
    std::ranges::sort(request.stages, {}, &glsl::StageSource::stage);
    if (request.stages.empty() || request.stages.front().stage != glsl::Stage::vertex)
        return fail("the program has no vertex shader (.vert)");
    if (!owner.open("GLSLProgram")) return fail("no usable OpenGL context is current on this thread");
    request.place = {request.stages.front().path, 1, 1};
    request.include = [](std::string_view name, std::string_view from) -> std::optional<glsl::IncludedFile> {
        const std::filesystem::path path = std::filesystem::path(from).parent_path() / name;
        if (auto text = textOfFile(path)) return glsl::IncludedFile{path.generic_string(), std::move(*text)};
        return std::nullopt;
    };
    request.target = targetOf(*owner.gl());
    request.shim = isGstap;
    request.acceptsStorage = owner.gl()->version >= 43;
    request.geometryInput = geometryInput;
    request.geometryOutput = geometryOutput;
    const glsl::TranslatedProgram translated = glsl::translate(request);
    messages = translated.diagnostics;
    return !hasError(messages) && compile(translated);
}

bool GLSLProgram::State::compile(const glsl::TranslatedProgram& translated) {
    const Gl& gl = *owner.gl();
    std::vector<GLuint> shaders;
    const auto end = [&](bool isGood) {
        for (const GLuint each : shaders) gl.DeleteShader(each);
        return isGood;
    };
    for (const glsl::TranslatedStage& stage : translated.stages) {
        const auto type = std::ranges::find(kStages, stage.stage, &StageOfFile::stage);
        const GLuint shader = shaders.emplace_back(gl.CreateShader(type->type));
        const char* text = stage.source.data();
        const auto length = static_cast<GLint>(stage.source.size());
        gl.ShaderSource(shader, 1, &text, &length);
        gl.CompileShader(shader);
        GLint isCompiled = 0;
        gl.GetShaderiv(shader, GL_COMPILE_STATUS, &isCompiled);
        if (isCompiled != 0) continue;
        Diagnostics found =
            glsl::explainCompileLog(translated, stage, logOf(shader, gl.GetShaderiv, gl.GetShaderInfoLog));
        if (!hasError(found))
            fail("the driver does not compile the shader", {stage.path, stage.firstLine, 1});
        append(messages, std::move(found));
    }
    if (hasError(messages)) return end(false);

    program = gl.CreateProgram();
    for (const GLuint each : shaders) gl.AttachShader(program, each);
    for (const glsl::BuiltinInput& each : glsl::builtinInputs())
        if (const std::string book = bookName(each.name);
            book == "aVertex" || book == "aNormal" || book == "aColor" || book.starts_with("aTexCoord"))
            gl.BindAttribLocation(program, bookLocation(book), std::string(each.name).c_str());
    gl.LinkProgram(program);
    GLint isLinked = 0;
    gl.GetProgramiv(program, GL_LINK_STATUS, &isLinked);
    if (isLinked == 0) {
        append(messages,
               glsl::explainLinkLog(translated, logOf(program, gl.GetProgramiv, gl.GetProgramInfoLog),
                                    translated.place));
        if (!hasError(messages)) fail("the driver does not link the program", translated.place);
        gl.DeleteProgram(program);
        program = 0;
        return end(false);
    }
    values.emplace(gl, program, translated, isGstap);
    LinkedProgram facts;
    facts.inputs = values->inputs();
    for (const glsl::TranslatedStage& each : translated.stages)
        if (each.stage == glsl::Stage::tessEvaluation) facts.hasTessellation = true;
    remember(owner.context(), program, std::move(facts));
    return end(true);
}

void GLSLProgram::State::report() const {
    for (const Diagnostic& each : messages)
        if (isVerbose || each.severity == Severity::error)
            std::fputs((glibra::toString(each) + "\n").c_str(), stderr);
    if (isVerbose && values) std::fputs(values->list().c_str(), stderr);
}

bool GLSLProgram::State::isUsable(const char* call) {
    if (values && !gpu::isForked()) return true;
    if (!std::exchange(toldInvalid, true))
        complainOf("GLSLProgram", gpu::isForked()
                                      ? gpu::forkedText()
                                      : fmt::format("{} without a valid program has no effect", call));
    return false;
}

GLSLProgram::GLSLProgram() : state_(std::make_unique<State>()) {}
GLSLProgram::~GLSLProgram() = default;
GLSLProgram::GLSLProgram(GLSLProgram&&) noexcept = default;
GLSLProgram& GLSLProgram::operator=(GLSLProgram&&) noexcept = default;

bool GLSLProgram::Create(const char* file1, const char* file2, const char* file3, const char* file4,
                         const char* file5) {
    std::vector<std::pair<std::string, std::string>> texts;
    for (const char* each : {file1, file2, file3, file4, file5}) {
        if (each == nullptr) continue;
        std::optional<std::string> text = textOfFile(each);
        if (!text) {
            state_->clear();
            state_->messages.clear();
            state_->fail("the file cannot be read", {each, 1, 1});
            state_->report();
            return false;
        }
        texts.emplace_back(each, std::move(*text));
    }
    return CreateFromText(texts);
}

bool GLSLProgram::CreateFromText(const std::vector<std::pair<std::string, std::string>>& texts) {
    state_->clear();
    state_->messages.clear();
    state_->toldInvalid = false;
    const bool isBuilt = state_->build(texts);
    state_->report();
    return isBuilt;
}

bool GLSLProgram::IsValid() const {
    return state_->values.has_value();
}

void GLSLProgram::SetVerbose(bool isOn) {
    state_->isVerbose = isOn;
}
void GLSLProgram::SetGstap(bool isOn) {
    state_->isGstap = isOn;
}
void GLSLProgram::SetInputTopology(unsigned int topology) {
    setTopology(state_->geometryInput, kGeometryInputs, topology, "SetInputTopology", "takes");
}
void GLSLProgram::SetOutputTopology(unsigned int topology) {
    setTopology(state_->geometryOutput, kGeometryOutputs, topology, "SetOutputTopology", "makes");
}

void GLSLProgram::SetAttribute(const char* name, int value) {
    if (state_->isUsable("SetAttribute")) state_->values->setInput(name, doubles(value));
}
void GLSLProgram::SetAttribute(const char* name, float value) {
    if (state_->isUsable("SetAttribute")) state_->values->setInput(name, doubles(value));
}
void GLSLProgram::SetAttribute(const char* name, float x, float y, float z) {
    if (state_->isUsable("SetAttribute")) state_->values->setInput(name, doubles(x, y, z));
}
void GLSLProgram::SetAttribute(const char* name, const float* values) {
    if (state_->isUsable("SetAttribute")) state_->values->setInput(name, values);
}
void GLSLProgram::SetAttribute(const char* name, const Vec3& value) {
    SetAttribute(name, value.x, value.y, value.z);
}

void GLSLProgram::SetUniform(const char* name, int value) {
    if (state_->isUsable("SetUniform")) state_->values->set(name, doubles(value));
}
void GLSLProgram::SetUniform(const char* name, float value) {
    if (state_->isUsable("SetUniform")) state_->values->set(name, doubles(value));
}
void GLSLProgram::SetUniform(const char* name, float x, float y, float z) {
    if (state_->isUsable("SetUniform")) state_->values->set(name, doubles(x, y, z));
}
void GLSLProgram::SetUniform(const char* name, const float* values) {
    if (state_->isUsable("SetUniform")) state_->values->set(name, values);
}
void GLSLProgram::SetUniform(const char* name, const Vec3& value) {
    SetUniform(name, value.x, value.y, value.z);
}
void GLSLProgram::SetUniform(const char* name, const Matrix4& value) {
    if (!state_->isUsable("SetUniform")) return;
    glm::dmat4 matrix;
    for (int i = 0; i < 4; ++i)
        for (int j = 0; j < 4; ++j) matrix[j][i] = static_cast<double>(value.GetElement(i, j));
    state_->values->set(name, matrix);
}

void GLSLProgram::Use() {
    if (!state_->isUsable("Use")) {
        if (state_->owner.isCurrent()) state_->owner.gl()->UseProgram(0);
        return;
    }
    state_->owner.gl()->UseProgram(state_->program);
    state_->values->use();
}

void GLSLProgram::UseFixedFunction() {
    const bool isKnown = state_->owner.gl() != nullptr && !gpu::isForked();
    const Gl* gl = isKnown ? state_->owner.gl() : glOfThread("GLSLProgram");
    if (gl != nullptr) gl->UseProgram(0);
}

unsigned int GLSLProgram::Id() const {
    return state_->program;
}

const Diagnostics& GLSLProgram::Messages() const {
    return state_->messages;
}

}  // namespace glibra::classic
