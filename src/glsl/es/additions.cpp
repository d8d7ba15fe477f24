#include "glsl/es/additions.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <utility>

#include "glsl/facts/facts.h"
#include "glsl/parse/syntax.h"
#include "glsl/parse/types.h"
#include "glsl/parse/usage.h"
#include "glsl/read/source.h"

namespace glibra::glsl {

// ---- Borders

namespace {

/// Of the texels that are read one is outside.
constexpr const char* kNear =
    "bool glibra_isNear(vec4 border, vec2 size, vec2 at) { "
    "vec2 first = floor(at * size - .5 * border.w), last = first + border.w; "
    "return border.x > 0. && (first.x < 0. || last.x >= size.x) || "
    "border.y > 0. && (first.y < 0. || last.y >= size.y); }";
constexpr const char* kOutside =
    "bool glibra_isOutside(vec4 border, ivec2 size, ivec2 at) { "
    "return border.x > 0. && (at.x < 0 || at.x >= size.x) || border.y > 0. && (at.y < 0 || at.y >= size.y); "
    "}";

constexpr const char* kColor =
    "vec4 glibra_texel(vec4 b[2], sampler2D s, ivec2 at) { ivec2 size = textureSize(s, 0); "
    "return glibra_isOutside(b[0], size, at) ? b[1] : texelFetch(s, clamp(at, ivec2(0), size - 1), 0); }";
constexpr const char* kColorNear =
    "vec4 glibra_near(vec4 b[2], sampler2D s, vec2 p) { "
    "vec2 at = p * vec2(textureSize(s, 0)) - .5 * b[0].w, f = at - floor(at); ivec2 i = ivec2(floor(at)); "
    "if (b[0].w == 0.) return glibra_texel(b, s, i); "
    "return mix(mix(glibra_texel(b, s, i), glibra_texel(b, s, i + ivec2(1, 0)), f.x), "
    "mix(glibra_texel(b, s, i + ivec2(0, 1)), glibra_texel(b, s, i + 1), f.x), f.y); }";
constexpr const char* kDepth =
    "float glibra_texel(vec4 b[2], sampler2DShadow s, ivec2 at, float d) { ivec2 size = textureSize(s, 0); "
    "if (glibra_isOutside(b[0], size, at)) return float(b[0].z > 0. ? d <= b[1].x : d >= b[1].x); "
    "return textureLod(s, vec3((vec2(clamp(at, ivec2(0), size - 1)) + .5) / vec2(size), d), 0.); }";
constexpr const char* kDepthNear =
    "float glibra_near(vec4 b[2], sampler2DShadow s, vec3 p) { "
    "vec2 at = p.xy * vec2(textureSize(s, 0)) - .5 * b[0].w, f = at - floor(at); ivec2 i = ivec2(floor(at)); "
    "if (b[0].w == 0.) return glibra_texel(b, s, i, p.z); "
    "return mix(mix(glibra_texel(b, s, i, p.z), glibra_texel(b, s, i + ivec2(1, 0), p.z), f.x), "
    "mix(glibra_texel(b, s, i + ivec2(0, 1), p.z), glibra_texel(b, s, i + 1, p.z), f.x), f.y); }";

/// A function that reads.
struct Reader {
    std::string_view name, sampler, coordinates;
    std::string_view place;  ///< of the coordinates in the texture, by which glibra_near() is called
    bool takesNumber;        ///< a level or a bias after them
};
constexpr std::array kReaders = std::to_array<Reader>({
    {"texture", "sampler2D", "vec2", "p", false},
    {"texture", "sampler2D", "vec2", "p", true},
    {"textureLod", "sampler2D", "vec2", "p", true},
    {"textureProj", "sampler2D", "vec3", "p.xy / p.z", false},
    {"textureProj", "sampler2D", "vec4", "p.xy / p.w", false},
    {"texture", "sampler2DShadow", "vec3", "p", false},
    {"textureLod", "sampler2DShadow", "vec3", "p", true},
    {"textureProj", "sampler2DShadow", "vec4", "p.xyz / p.w", false},
});

std::string text(const Reader& reader) {
    const std::string value(reader.sampler == "sampler2D" ? "vec4 " : "float ");
    const std::string name(reader.name), place(reader.place);
    return value + "glibra_" + name + "(vec4 b[2], " + std::string(reader.sampler) + " s, " +
           std::string(reader.coordinates) + " p" + (reader.takesNumber ? ", float n" : "") + ") { " + value +
           "v = " + name + "(s, p" + (reader.takesNumber ? ", n" : "") + "); vec2 at = (" + place +
           ").xy; return glibra_isNear(b[0], vec2(textureSize(s, 0)), at) ? glibra_near(b, s, " + place +
           ") : v; }";
}

bool hasBorder(std::string_view type) {
    return type == "sampler2D" || type == "sampler2DShadow";
}

/// Declares what the border of a sampler is if that is a uniform; the border of a parameter is a parameter.
std::string borderOf(Unit& unit, Range argument) {
    constexpr const char* kNone = "vec4[2](vec4(0.), vec4(0.))";
    if (argument.end != argument.first + 1) return kNone;
    const std::string name(unit.text(argument.first));
    const bool isGlobal = unit.bodies.roles[argument.first] == WordRole::global;
    const Variable* const variable = isGlobal ? unit.firstVariable(name) : nullptr;
    if (variable != nullptr) unit.declare("uniform vec4 " + (kBorderOf + name) + "[2];");
    return isGlobal && variable == nullptr ? kNone : kBorderOf + name;
}

/// A call of a function of GLSL.
void readBorder(Unit& unit, const Call& call) {
    if (call.types.empty() || call.arguments.empty()) return;
    const std::string_view sampler = call.types.front().word, name = unit.text(call.name);
    if (!hasBorder(sampler) || (name != "texture" && name != "textureLod" && name != "textureProj")) return;
    const Range first = call.arguments.front();
    unit.declare(kNear);
    unit.declare(kOutside);
    const bool isColor = sampler == "sampler2D";
    unit.declare(isColor ? kColor : kDepth);
    unit.declare(isColor ? kColorNear : kDepthNear);
    for (const Reader& each : kReaders)
        if (each.name == name && each.sampler == sampler &&
            (unit.stage == Stage::fragment || name != "texture" || !each.takesNumber))
            unit.declare(text(each));
    unit.edits.replace(unit.view[call.name].raw, "glibra_" + std::string(name));
    unit.edits.before(unit.view[first.first].raw, borderOf(unit, first) + ", ");
}

}  // namespace

void passBorders(Unit& unit) {
    for (const Declaration& each : unit.syntax.declarations)
        for (const Parameter& parameter : each.parameters)
            if (hasBorder(parameter.type.name))
                unit.edits.before(
                    unit.view[parameter.qualifiers.tokens.empty() ? parameter.type.tokens.first
                                                                  : parameter.qualifiers.tokens.first]
                        .raw,
                    "vec4 " +
                        (parameter.name == kNone ? std::string()
                                                 : kBorderOf + std::string(unit.text(parameter.name))) +
                        "[2], ");
    for (const Call& each : unit.bodies.calls) {
        const std::string_view name = unit.text(each.name);
        if (unit.function(name) == nullptr) {
            readBorder(unit, each);
            continue;
        }
        for (std::size_t i = 0; i < each.arguments.size() && i < each.types.size(); ++i)
            if (hasBorder(each.types[i].word))
                unit.edits.before(unit.view[each.arguments[i].first].raw,
                                  borderOf(unit, each.arguments[i]) + ", ");
    }
}

// ---- Wide lines

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

// ---- Guards of loops

namespace {

constexpr double kMostCost = 1e5;

class LoopGuard {
  public:
    LoopGuard(Unit& unit, std::string_view cut, std::size_t before)
        : unit_(unit), cut_(cut), before_(before) {
        addCounted(loopsOf(unit).loops);
    }

    std::vector<std::uint32_t> run() {
        costOfFunction("main");  // finds the functions that it calls
        for (const Declaration& each : unit_.syntax.declarations)
            if (each.kind == DeclarationKind::function && each.code != kNone &&
                functions_.contains(text(each.name)))
                visit(each.code);
        return std::move(loops_);
    }

  private:
    [[nodiscard]] const Node& node(std::uint32_t id) const { return unit_.bodies.nodes[id]; }
    [[nodiscard]] std::string_view text(std::uint32_t at) const { return unit_.text(at); }
    [[nodiscard]] std::uint32_t raw(std::uint32_t at) const { return unit_.view[at].raw; }
    [[nodiscard]] bool isLoop(std::uint32_t id) const {
        return node(id).kind >= NodeKind::forLoop && node(id).kind <= NodeKind::doLoop;
    }
    [[nodiscard]] std::uint32_t bodyOf(const Node& loop) const {
        return loop.kind == NodeKind::doLoop ? loop.child : loop.lastChild;
    }

    /// Notes the constant numbers of rounds; 0 for those that compilers unroll, as they count natively.
    void addCounted(const std::vector<CountedLoop>& loops) {
        for (const CountedLoop& each : loops) {
            const double rounds = roundsOf(each, [](std::string_view) { return std::nullopt; });
            if (rounds > 0) rounds_[{each.place.line, each.place.column}] = isUnrolled(each) ? 0 : rounds;
            addCounted(each.inside);
        }
    }

    /// The rounds of the short loops in a statement or expression, and in the functions that it calls.
    double costOf(std::uint32_t id) {
        if (id == kNone) return 0;
        const Node& it = node(id);
        double cost = 0;
        for (const std::uint32_t each : unit_.bodies.children(id)) cost += costOf(each);
        if (it.kind == NodeKind::call && unit_.bodies.roles[it.token] == WordRole::global)
            cost += costOfFunction(text(it.token));
        if (isLoop(id)) cost = roundsOfShort(it, cost).value_or(0);
        return std::min(cost, kMostCost);
    }

    double costOfFunction(std::string_view name) {
        const auto [known, isNew] = functions_.try_emplace(name, 0);
        if (!isNew) return known->second;
        double most = 0;
        for (const Declaration& each : unit_.syntax.declarations)
            if (each.kind == DeclarationKind::function && text(each.name) == name)
                most = std::max(most, costOf(each.code));
        return functions_[name] = most;
    }

    /// `inside`: of one round. Nothing if the loop is not short.
    [[nodiscard]] std::optional<double> roundsOfShort(const Node& loop, double inside) const {
        const Place place = unit_.place(loop.first);
        const auto known = rounds_.find({place.line, place.column});
        if (known == rounds_.end()) return std::nullopt;
        const double all = known->second * (1 + inside);
        return all <= kShortRounds ? std::optional(all) : std::nullopt;
    }

    void visit(std::uint32_t id) {
        for (const std::uint32_t each : unit_.bodies.children(id)) visit(each);  // inner brackets come first
        if (!isLoop(id)) return;
        const Node& loop = node(id);
        const std::uint32_t body = bodyOf(loop);
        const double inside = costOf(body);
        const bool isDo = loop.kind == NodeKind::doLoop;
        const std::uint32_t open = isDo ? node(body).end + 1 : loop.first + 1;
        if (roundsOfShort(loop, inside) || text(open) != "(" || unit_.bodies.matches[open] >= loop.end)
            return;
        loops_.push_back(loop.first);
        const std::size_t number = std::min<std::size_t>(before_ + loops_.size(), kMostSites);
        guard(conditionOf(unit_, loop, {open, unit_.bodies.matches[open] + 1}),
              fmt::format("((glibra_rounds += {0}) <= {1} || ({2} = {2} == 0 ? {3} : {2}) == -2)",
                          1 + static_cast<int>(inside), kRounds, cut_, number));
    }

    void guard(Range condition, const std::string& goesOn) {
        const std::uint32_t before = beforeValue(unit_, condition);
        const bool isEmpty = condition.end - condition.first <= 2;
        unit_.edits.after(raw(before), isEmpty ? " " + goesOn : " (");
        if (!isEmpty) unit_.edits.before(raw(condition.end - 1), ") && " + goesOn);
    }

    Unit& unit_;
    std::string_view cut_;
    std::size_t before_;
    std::map<std::pair<int, int>, double> rounds_;  ///< by line and column
    std::map<std::string_view, double> functions_;
    std::vector<std::uint32_t> loops_;
};

}  // namespace

std::vector<std::uint32_t> guardLoops(Unit& unit, std::string_view cut, std::size_t before) {
    std::vector<std::uint32_t> loops = LoopGuard(unit, cut, before).run();
    if (loops.empty()) return loops;
    unit.declare("int glibra_rounds = 0;");
    unit.declare(fmt::format("uniform int {};", kRounds));
    return loops;
}

}  // namespace glibra::glsl
