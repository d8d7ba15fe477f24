#include "glsl/es/wide_lines.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cstddef>
#include <optional>
#include <set>
#include <string>
#include <string_view>

#include "glsl/parse/syntax.h"
#include "glsl/parse/types.h"
#include "glsl/read/source.h"

namespace glibra::glsl {
namespace {

/// GL_MAX_TRANSFORM_FEEDBACK_INTERLEAVED_COMPONENTS is at least as large (OpenGL ES 3.0, table 6.28).
constexpr int kMostCaptured = 64;
constexpr int kPositionComponents = 4;

/// What both main functions and the outputs need. Ends are numbers of the texture's texels at which the
/// outputs of a vertex begin; `at` counts components from there.
constexpr std::string_view kEndReaders = R"(uniform highp usampler2D glibra_Ends;
uniform int glibra_Wide, glibra_Pairs, glibra_Vertices;
uniform vec4 glibra_Line;
int glibra_lineFirst, glibra_lineLast;
float glibra_lineWay;
uint glibra_lineWord(int at) { return texelFetch(glibra_Ends, ivec2(at & 2047, at >> 11), 0).x; }
float glibra_lineNumber(int at) { return uintBitsToFloat(glibra_lineWord(at)); }
float glibra_lineBetween(int at) { return mix(glibra_lineNumber(glibra_lineFirst + at), glibra_lineNumber(glibra_lineLast + at), glibra_lineWay); }
vec4 glibra_linePlace(int end) { return vec4(glibra_lineNumber(end), glibra_lineNumber(end + 1), glibra_lineNumber(end + 2), glibra_lineNumber(end + 3)); }
)";

/// Clips a line to the planes of depth, in clip space; true if nothing is left of it. `p`, `q`: distances of
/// its ends from a plane.
constexpr std::string_view kDepthCut = R"(bool glibra_lineCut(float p, float q, inout vec2 range) {
 if (p < 0. && q < 0.) return true;
 if (p < 0.) range.x = max(range.x, p / (p - q));
 if (q < 0.) range.y = min(range.y, p / (p - q));
 return range.x > range.y;
}
)";

/// A line without samples covers whole columns of pixels, if x is its major axis: those whose diamond it
/// leaves (OpenGL 4.6 Core, 14.5.1). `end` is in pixels, with x in the direction of the line, and `slope`
/// that of y. Returns the edge of the column of `end` at which the columns begin or stop.
constexpr std::string_view kColumnEdge = R"(float glibra_lineColumn(vec2 end, float slope, bool isLast) {
 float column = floor(end.x), y = fract(end.y + slope * (column + .5 - end.x)) - .5;
 float leaves = column + .5 + min((.5 - y) / max(1. + slope, 1e-6), (.5 + y) / max(1. - slope, 1e-6));
 return (isLast ? leaves <= end.x : leaves > end.x) == isLast ? column + 1. : column;
}
)";

/// With samples, a line is a rectangle (14.5.4); without, a parallelogram whose ends are parallel to the
/// minor axis, and whose width counts along that (14.5.2). Its corners are anticlockwise. `glibra_Line`:
/// width and height of the viewport and width of the line, in pixels, and whether there are samples.
constexpr std::string_view kQuadMain = R"(void main() {{
 if (glibra_Wide == 0) {{ glibra_vertexMain(); return; }}
 gl_Position = vec4(0., 0., 2., 1.);
 int pair = gl_InstanceID % glibra_Pairs, data = (2 * glibra_Pairs + 2047) / 2048 * 2048 + gl_InstanceID / glibra_Pairs * glibra_Vertices * {0} + {1};
 glibra_lineFirst = data + int(glibra_lineWord(2 * pair)) * {0};
 glibra_lineLast = data + int(glibra_lineWord(2 * pair + 1)) * {0};
 vec4 p = glibra_linePlace(glibra_lineFirst), q = glibra_linePlace(glibra_lineLast);
 vec2 range = vec2(0., 1.), near = vec2(p.z + p.w, q.z + q.w), far = vec2(p.w - p.z, q.w - q.z);
 if (glibra_Wide == 2) near = vec2(p.z, q.z);
 if (glibra_Wide == 3) near = far = vec2(p.w, q.w) - 1e-5;
 if (glibra_lineCut(near.x, near.y, range) || glibra_lineCut(far.x, far.y, range)) return;
 vec4 from = mix(p, q, range.x), to = mix(p, q, range.y);
 vec2 a = (from.xy / from.w * .5 + .5) * glibra_Line.xy, b = (to.xy / to.w * .5 + .5) * glibra_Line.xy;
 bool hasSamples = glibra_Line.w > 0.;
 if (!hasSamples) {{ a = floor(a * 256. + .5) / 256.; b = floor(b * 256. + .5) / 256.; }}
 vec2 along = b - a;
 if (along == vec2(0.)) return;
 bool isEnd = gl_VertexID == 1 || gl_VertexID == 2 || gl_VertexID == 4;
 float hand = gl_VertexID == 0 || gl_VertexID == 1 || gl_VertexID == 3 ? -.5 : .5, part = isEnd ? 1. : 0.;
 vec2 window = isEnd ? b : a;
 if (hasSamples) {{
  window += hand * glibra_Line.z * vec2(-along.y, along.x) / length(along);
 }} else {{
  bool isSteep = abs(along.y) > abs(along.x);
  if (isSteep) {{ a = a.yx; b = b.yx; along = along.yx; }}
  float width = max(1., floor(glibra_Line.z + .5)), way = sign(along.x), slope = along.y / abs(along.x);
  a.x *= way;
  b.x *= way;
  float first = glibra_lineColumn(a, slope, false), last = glibra_lineColumn(b, slope, true);
  if (first >= last) return;
  float x = isEnd ? last : first, y = a.y + slope * (x - a.x);
  if (slope == 0.) y = ceil(y - .5 * width - .5) + .5 * width;
  part = (x - a.x) / (b.x - a.x);
  window = vec2(x * way, y + hand * width * (isSteep ? -way : way));
  if (isSteep) window = window.yx;
 }}
 float scale = (1. - part) * to.w + part * from.w;
 glibra_lineWay = mix(range.x, range.y, scale > 0. ? part * from.w / scale : step(.5, part));
 vec4 place = mix(p, q, glibra_lineWay);
 gl_Position = vec4((window / glibra_Line.xy * 2. - 1.) * place.w, place.zw);
{2}}}
)";

/// An input of the fragment stage.
struct CapturedInput {
    std::string name;
    Type type;
    std::string word;  ///< of the type
    bool isFlat = false;
    int elements = 0;  ///< of an array; 0: it is none
};

/// The declared inputs that the stage uses; nothing if there are some whose components are not known.
std::optional<std::vector<CapturedInput>> capturedInputsOf(const TranslatedStage& stage) {
    const ProgramRequest request;
    StageText text;
    text.request = &request;
    Report ignored;  // the source has been translated already
    readSource({stage.stage, stage.path, stage.source}, text, ignored);
    std::vector<CapturedInput> inputs;
    for (const Declaration& each : parseSyntax(text.view).declarations) {
        if (each.kind != DeclarationKind::variable || each.qualifiers.storage != Storage::input) continue;
        for (const Declarator& declarator : each.declarators) {
            CapturedInput input{std::string(text.text(declarator.name)), typeOfWord(each.type.name),
                                std::string(each.type.name), each.qualifiers.interpolation == "flat"};
            std::size_t uses = 0;
            for (std::uint32_t i = 0; i < text.view.size(); ++i) uses += text.text(i) == input.name;
            if (uses < 2) continue;
            std::vector<Range> sizes = each.type.dimensions;
            sizes.insert(sizes.end(), declarator.dimensions.begin(), declarator.dimensions.end());
            if (each.type.isStruct || !input.type.numeric() || sizes.size() > 1) return std::nullopt;
            if (!sizes.empty()) {
                const std::string_view digits = text.text(sizes[0].first);
                std::from_chars(digits.data(), digits.data() + digits.size(), input.elements);
                if (sizes[0].end != sizes[0].first + 1 || input.elements < 1) return std::nullopt;
            }
            inputs.push_back(std::move(input));
        }
    }
    return inputs;
}

/// The value of one element of an output, whose components begin at `at`.
std::string capturedValueOf(const CapturedInput& output, int at) {
    std::string text = output.word + "(";
    for (int i = 0; i < output.type.components(); ++i, ++at) {
        if (i > 0) text += ", ";
        if (output.type.integral())
            text += fmt::format("glibra_lineWord(glibra_lineLast + {})", at);  // whose bits constructors keep
        else if (output.isFlat)
            text += fmt::format("glibra_lineNumber(glibra_lineLast + {})", at);
        else
            text += fmt::format("glibra_lineBetween({})", at);
    }
    return text + ")";
}

}  // namespace

WideLines widenLines(std::vector<TranslatedStage>& stages, const ExpandedGeometry& expanded) {
    const auto at = [&](Stage stage) { return std::ranges::find(stages, stage, &TranslatedStage::stage); };
    const auto vertex = at(Stage::vertex), fragment = at(Stage::fragment);
    if (vertex == stages.end()) return {};
    WideLines wide;
    if (expanded.measuresLevels) {
        wide.captured.assign(kLevelOutputs.begin(), kLevelOutputs.end());
        wide.components = kLevelComponents;
    }
    const int begin = wide.components;
    wide.captured.emplace_back("gl_Position");
    wide.components += kPositionComponents;
    std::string outputs;
    std::optional<std::vector<CapturedInput>> inputs(std::in_place);
    if (fragment != stages.end()) inputs = capturedInputsOf(*fragment);
    if (inputs)
        for (const CapturedInput& each : *inputs) {
            wide.captured.push_back(each.name);
            for (int i = 0; i < std::max(1, each.elements); ++i) {
                outputs += fmt::format(" {}{} = {};\n", each.name,
                                       each.elements > 0 ? fmt::format("[{}]", i) : std::string(),
                                       capturedValueOf(each, wide.components - begin));
                wide.components += each.type.components();
            }
        }
    if (expanded.mostEmitted > 0 || !inputs || wide.components > kMostCaptured) {
        wide = {};
        vertex->source += fmt::format("void main() {{ {}(); }}\n", kVertexMain);
    } else {
        vertex->source += kEndReaders;
        vertex->source += kDepthCut;
        vertex->source += kColumnEdge;
        vertex->source += fmt::format(fmt::runtime(kQuadMain), wide.components, begin, outputs);
    }
    const auto lines = static_cast<std::size_t>(std::ranges::count(vertex->source, '\n'));
    vertex->lineMap.lines.resize(lines);
    vertex->lineMap.columns.resize(lines);
    return wide;
}

}  // namespace glibra::glsl
