// Any bytes as the sources of a program's stages, and as a driver's log about them. A line "//@ STAGE NUMBER"
// begins a stage; the bits of the number choose the translation. Sources without such a line begin with a
// guess, so that the repository's shaders are inputs as they are.

#include <algorithm>
#include <array>
#include <charconv>
#include <deque>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "check.h"
#include "glsl/emit/log.h"
#include "glsl/es/es.h"
#include "glsl/facts/block_layout.h"
#include "glsl/read/token.h"
#include "glsl/read/words.h"
#include "glsl/translate.h"
#include "glsl/types/builtins.h"
#include "text_mutator.h"

namespace {

using namespace glibra::glsl;
using glibra::fuzz::check;

constexpr std::string_view kMark = "//@ ";
constexpr std::array<std::string_view, kStageCount> kStageWords{"vertex",   "control",  "evaluation",
                                                                "geometry", "fragment", "compute"};

Stage guess(std::string_view text) {
    const auto has = [&](std::string_view word) { return text.find(word) != text.npos; };
    if (has("gl_TessCoord")) return Stage::tessEvaluation;
    if (has("gl_TessLevel")) return Stage::tessControl;
    if (has("EmitVertex")) return Stage::geometry;
    if (has("local_size_")) return Stage::compute;
    return has("gl_Position") ? Stage::vertex : Stage::fragment;
}

struct Input {
    std::vector<StageSource> stages;
    unsigned choice = 0;
};

/// Reads "//@ STAGE NUMBER"; nothing for other lines.
std::optional<Stage> stageOf(std::string_view line, unsigned& choice) {
    if (!line.starts_with(kMark)) return std::nullopt;
    line.remove_prefix(kMark.size());
    const std::size_t blank = std::min(line.find(' '), line.size());
    const auto* const word = std::ranges::find(kStageWords, line.substr(0, blank));
    if (word == kStageWords.end()) return std::nullopt;
    unsigned number = 0;
    if (blank < line.size()) std::from_chars(line.data() + blank + 1, line.data() + line.size(), number);
    choice ^= number;
    return static_cast<Stage>(word - kStageWords.begin());
}

Input inputOf(std::string_view text) {
    Input input;
    const auto begin = [&](Stage stage) -> StageSource& {
        for (StageSource& each : input.stages)
            if (each.stage == stage) return each;
        return input.stages.emplace_back(StageSource{stage, "nowhere/stage.glsl", {}});
    };
    StageSource* current = text.starts_with(kMark) ? nullptr : &begin(guess(text));
    while (!text.empty()) {
        const std::size_t end = std::min(text.find('\n'), text.size() - 1) + 1;
        if (const auto stage = stageOf(text.substr(0, end), input.choice))
            current = &begin(*stage);
        else if (current)
            current->text += text.substr(0, end);
        else
            current = &begin(Stage::fragment);
        text.remove_prefix(end);
    }
    std::ranges::sort(input.stages, {}, &StageSource::stage);
    // A compute stage beside others is refused at once, which is seldom interesting.
    if (input.stages.size() > 1 && input.stages.back().stage == Stage::compute && input.choice % 8 != 7)
        input.stages.pop_back();
    return input;
}

/// The driver gets no macros and no branches: of all directives only these.
void checkDirectives(const TranslatedStage& stage) {
    constexpr std::array<std::string_view, 5> kPassed{"version", "extension", "line", "pragma", "error"};
    std::deque<std::string> storage;
    bool atStart = true;
    const std::vector<Token> tokens = lex(stage.source, storage);
    for (std::size_t i = 0; i < tokens.size(); ++i) {
        if (atStart && tokens[i].text == "#") {
            std::size_t name = i + 1;
            while (name < tokens.size() && tokens[name].kind == TokenKind::blank) ++name;
            check(name < tokens.size() && std::ranges::find(kPassed, tokens[name].text) != kPassed.end(),
                  "a directive is left for the driver");
        }
        if (tokens[i].kind == TokenKind::newline) atStart = true;
        if (isSignificant(tokens[i].kind)) atStart = false;
    }
}

void checkPlaces(const LineMap& map) {
    const auto names = [&](const LineOrigin& origin) {
        return origin.file < static_cast<int>(map.files.size());
    };
    for (const LineOrigin& origin : map.lines) check(names(origin), "an origin names a file");
    for (const std::vector<ColumnShift>& line : map.columns)
        for (const ColumnShift& each : line)
            check(names(each.line) && each.line.file >= 0 && each.line.line > 0 && each.user > 0 &&
                      each.macro < static_cast<int>(map.macros.size()),
                  "a column comes from the source");
    for (const MacroPlace& each : map.macros)
        check(names(each.line) && each.line.file >= 0 && !each.name.empty(), "a macro stands in a file");
}

}  // namespace

const glibra::fuzz::Grammar& glibra::fuzz::grammar() {
    static const Grammar kGrammar = [] {
        Grammar made;
        for (const std::string_view word : keywords()) made.words.emplace_back(word);
        for (const BuiltinUniform& row : builtinUniforms()) made.words.emplace_back(row.name);
        for (const BuiltinInput& row : builtinInputs()) made.words.emplace_back(row.name);
        for (const char* word : {"gl_Position",
                                 "gl_Vertex",
                                 "gl_Normal",
                                 "gl_MultiTexCoord0",
                                 "gl_FrontColor",
                                 "gl_BackColor",
                                 "gl_Color",
                                 "gl_TexCoord",
                                 "gl_FragColor",
                                 "gl_FragData",
                                 "gl_FragCoord",
                                 "gl_FragDepth",
                                 "gl_PositionIn",
                                 "gl_VerticesIn",
                                 "gl_in",
                                 "gl_out",
                                 "gl_InvocationID",
                                 "gl_TessCoord",
                                 "gl_TessLevelOuter",
                                 "gl_TessLevelInner",
                                 "gl_PrimitiveIDIn",
                                 "gl_ClipDistance",
                                 "gl_ClipVertex",
                                 "gl_LightSource",
                                 "gl_FrontMaterial",
                                 "gl_ModelViewMatrix",
                                 "gl_NormalMatrix",
                                 "ftransform()",
                                 "texture2D",
                                 "texture2DLod",
                                 "shadow2D",
                                 "textureCube",
                                 "texture3D",
                                 "EmitVertex()",
                                 "EndPrimitive()",
                                 "noise3",
                                 "dFdx",
                                 "main",
                                 "0x7FFFFFFF",
                                 "4294967295u",
                                 "1.lf",
                                 "/*",
                                 "*/",
                                 "//",
                                 "##",
                                 "\\",
                                 "?",
                                 ":",
                                 "++",
                                 "<<=",
                                 "&&",
                                 "^^"})
            made.words.emplace_back(word);
        for (const std::string_view stage : kStageWords)
            for (const char* number : {"0", "1", "2", "12", "16", "31", "128", "256"})
                made.statements.push_back(std::string(kMark) + std::string(stage) + " " + number);
        for (const char* version :
             {"110", "120", "130", "150 compatibility", "330", "400", "430 core", "450", "300 es"})
            made.statements.push_back(std::string("#version ") + version);
        made.statements.insert(
            made.statements.end(),
            {"#extension GL_EXT_geometry_shader4 : enable",
             "#define F(a,b) a##b",
             "#define G(x) F(x,x) G(x)",
             "#define H F",
             "#define J() -G(-x) H",
             "H(a b,",
             "G((1, 2)) J()(",
             "#elif defined F || __VERSION__ / 0 > 1 << 2",
             "#define F(a,b) a-b",
             "__LINE__ __FILE__ GL_ES GL_core_profile",
             "#undef F",
             "#if defined(F) && 1 < 2",
             "#ifdef F",
             "#else",
             "#elif 0",
             "#endif",
             "#include \"other.glsl\"",
             "#line 7",
             "#pragma optionNV",
             "#error not here",
             "layout(triangles) in;",
             "layout(vertices = 4) out;",
             "layout(triangle_strip, max_vertices = 200) out;",
             "layout(quads, equal_spacing, ccw) in;",
             "in Block { vec3 a; flat int b; } block[];",
             "uniform struct S { vec4 a[3]; } s;",
             "layout(local_size_x = 8, local_size_y = N) in;",
             "shared S a[4][N];",
             "a[i][gl_LocalInvocationIndex].a[i++] += a[0][1].a[2];",
             "#define AT(a, k) a[k].a[(k)]",
             "const int N = 1 << 3;",
             "layout(std430, row_major) readonly buffer B { mat3 m; S s[2][3]; S rest[]; } b;",
             "layout(std140, binding = 2) uniform U { layout(offset = 64) dvec3 d; bool f[N]; };",
             "layout(r32ui, binding = N) coherent uniform uimage2DArray images[N];",
             "layout(binding = 0, offset = 8) uniform atomic_uint counter;",
             "layout(std430) buffer;",
             "imageStore(images[0], ivec3(1), uvec4(atomicAdd(b.rest[i].a, 1)));",
             "varying vec2 vST;",
             "subroutine vec4 Kind(vec3 a);",
             "for (int i = 0; i < 4; i++) { gl_Position = gl_in[i].gl_Position; }",
             "void main() {",
             "}"});
        made.separators = " \t,;()[]{}<>=+-*/.&|!?:";
        return made;
    }();
    return kGrammar;
}

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string text(glibra::fuzz::textOf(data, size));
    Input input = inputOf(text);
    if (input.stages.empty()) return 0;
    ProgramRequest request;
    request.name = "Fuzzed";
    request.place = {"nowhere/scene.glib", 1, 1};
    request.stages = std::move(input.stages);
    request.target.version = (input.choice & 1U) ? 410 : 450;
    request.target.lineDirectiveTakesFileName = (input.choice & 2U) != 0;
    request.shim = (input.choice & 12U) != 12;
    request.tiled = (input.choice & 16U) != 0;
    request.flatColors = (input.choice & 32U) != 0;
    request.acceptsStorage = (input.choice & 128U) != 0;
    request.suppliesFullScreenVertex = (input.choice & 256U) != 0;
    request.colorTargets = (input.choice & 64U) ? 4 : 1;
    request.include = [&](std::string_view name, std::string_view) -> std::optional<IncludedFile> {
        if (name.size() % 2) return std::nullopt;
        return IncludedFile{"nowhere/" + std::string(name), text};
    };
    const TranslatedProgram program = translate(request);
    glibra::fuzz::checkMessages(program.diagnostics);
    check(program.stages.empty() || !glibra::hasError(program.diagnostics), "an error leaves no source");
    for (const TranslatedStage& stage : program.stages) {
        const auto lines = static_cast<std::size_t>(std::ranges::count(stage.source, '\n'));
        check(stage.lineMap.lines.size() >= lines, "every emitted line has an origin");
        check(stage.lineMap.columns.size() <= stage.lineMap.lines.size(), "columns belong to lines");
        checkPlaces(stage.lineMap);
        if (request.shim) checkDirectives(stage);
        glibra::fuzz::checkMessages(explainCompileLog(program, stage, text));
    }
    for (const MemoryBlock& block : program.memory.blocks) {
        const glibra::Result<MemoryLayout> layout = layoutOf(block, program.memory.structures);
        check(layout || !layout.diagnostics.empty(), "a block without a layout has a message");
        if (!layout) continue;
        for (const MemoryField& field : layout->fields)
            check(field.offset >= 0 && (layout->stride > 0 || field.offset < layout->size),
                  "a field lies in its block");
    }
    glibra::fuzz::checkMessages(explainLinkLog(program, text, request.place));
    const EsProgram es = toEs(program);
    glibra::fuzz::checkMessages(es.diagnostics);
    for (const TranslatedStage& stage : es.stages) checkPlaces(stage.lineMap);
    if (size % 4 != 0) return 0;
    const TranslatedProgram again = translate(request);
    check(again.stages.size() == program.stages.size() &&
              again.diagnostics.size() == program.diagnostics.size(),
          "a program is translated the same way twice");
    for (std::size_t i = 0; i < program.stages.size(); ++i)
        check(again.stages[i].source == program.stages[i].source, "a stage is translated the same way twice");
    return 0;
}
