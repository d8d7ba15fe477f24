#include "glsl/es/parts.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <initializer_list>

#include "glsl/parse/types.h"
#include "glsl/parse/variables.h"

namespace glibra::glsl {
namespace {

bool isUniformOf(const Unit& unit, std::string_view name) {
    const Variable* const variable = unit.firstVariable(name);
    return variable != nullptr && variable->storage == Storage::uniform;
}

/// True if the stage has the same uniform block or structure.
bool hasTwin(const Unit& unit, const Declaration& wanted, std::string_view name) {
    return std::ranges::any_of(unit.syntax.declarations, [&](const Declaration& each) {
        return each.kind == wanted.kind && each.name != kNone && unit.text(each.name) == name;
    });
}

/// As many components as a type has.
std::string_view swizzleOf(std::string_view type) {
    constexpr std::string_view kAll = ".xyzw";
    const char last = type.empty() ? '4' : type.back();
    return kAll.substr(0, last >= '2' && last <= '4' ? static_cast<std::size_t>(last - '0') + 1 : 2);
}

}  // namespace

std::string emittedName(const Unit& unit, const std::string& name) {
    const auto renamed = unit.renames.find(name);
    return renamed == unit.renames.end() ? name : renamed->second;
}

void makePlain(Variable& variable) {
    variable.storage = Storage::none;
    variable.interpolation.clear();
    variable.patch = variable.centroid = variable.sample = variable.invariant = false;
    variable.layout.clear();
    variable.changed = true;
}

void makeArray(Variable& variable, int size) {
    makePlain(variable);
    variable.typeSizes.clear();
    variable.nameSizes = {std::to_string(size)};
    variable.sizesChanged = true;
}

Variable* outputFor(Unit& from, const Variable& input) {
    const std::string* const location = input.layoutValue("location");
    const auto output = std::ranges::find_if(from.variables, [&](const Variable& other) {
        const std::string* const own = other.layoutValue("location");
        return other.storage == Storage::output && !other.removed &&
               (location && own ? *location == *own : other.name == input.name);
    });
    return output == from.variables.end() ? nullptr : &*output;
}

void removeTwins(Unit& unit, const Unit& earlier) {
    for (const Declaration& each : unit.syntax.declarations) {
        const bool isStruct = each.type.isStruct && each.declarators.empty() && each.name != kNone;
        const bool isBlock =
            each.kind == DeclarationKind::block && each.qualifiers.storage == Storage::uniform;
        if ((isStruct || isBlock) && hasTwin(earlier, each, unit.text(each.name))) unit.remove(each.tokens);
    }
    for (Variable& each : unit.variables)
        if (each.storage == Storage::uniform && isUniformOf(earlier, each.name)) each.removed = true;
}

void prefixNames(Unit& unit, std::string_view prefix) {
    for (const auto& [name, at] : unit.declared) {
        const bool isOwn = unit.function(name) != nullptr || unit.firstVariable(name) != nullptr;
        if (isOwn && !isUniformOf(unit, name)) unit.renames[name] = fmt::format("{}_{}", prefix, name);
    }
    unit.renames["main"] = fmt::format("{}_main", prefix);
}

void renameCornerMembers(Unit& unit) {
    for (std::uint32_t i = 1; i < unit.view.size(); ++i)
        if (unit.text(i - 1) == "." && (unit.text(i) == "gl_Position" || unit.text(i) == "gl_PointSize"))
            unit.edits.replace(unit.view[i].raw,
                               unit.text(i) == "gl_Position" ? "glibra_position" : "glibra_pointSize");
}

void CornerStage::prepare(std::string_view instance) {
    prefixNames(*unit_, prefix_);
    unit_->renames["gl_Position"] = prefix_ + "Position";
    unit_->renames["gl_PointSize"] = prefix_ + "PointSize";
    unit_->declare(fmt::format("vec4 {}Position;", prefix_));
    unit_->declare(fmt::format("float {}PointSize;", prefix_));
    unit_->declare("struct glibra_Corner { vec4 glibra_position; float glibra_pointSize; };");
    unit_->declare(fmt::format("glibra_Corner {}[{}];", array_, corners_));
    if (unit_->stage != Stage::vertex) return;
    unit_->renames["gl_InstanceID"] = instance;
    unit_->renames["gl_VertexID"] = "glibra_vertex";
    unit_->declare("int glibra_vertex;");
}

void CornerStage::spreadInputs() {
    constexpr int kMostInputs = 16;  // of a vertex stage in GLSL ES 3.00 (gl_MaxVertexAttribs)
    std::vector<Variable*> inputs;
    for (Variable& each : unit_->variables)
        if (each.storage == Storage::input && !each.removed && !each.name.starts_with("gl_"))
            inputs.push_back(&each);
    const bool fits = static_cast<int>(inputs.size()) * corners_ <= kMostInputs;
    int location = 0;
    for (Variable* each : inputs) {
        for (int corner = 0; fits && corner < corners_; ++corner)
            unit_->declare(fmt::format("layout(location = {}) in {} {}{}_{};", location++, each->type,
                                       kCornerInput, corner, each->name));
        if (!fits) fetched_.push_back({each->name, each->type});
        attributes_.push_back(each->name);
        makePlain(*each);
    }
    if (fits) return;
    unit_->declare(fmt::format("uniform highp sampler2D {};", kFetchedInputs));
    unit_->declare(
        fmt::format("vec4 glibra_input(int at) {{ int width = textureSize({0}, 0).x; at += glibra_vertex * "
                    "{1}; return texelFetch({0}, ivec2(at % width, at / width), 0); }}",
                    kFetchedInputs, inputs.size()));
}

bool CornerStage::deliverTo(Unit& next) {
    bool hasAll = true;
    for (Variable& each : next.variables) {
        if (each.storage != Storage::input || each.patch || each.removed || each.name.starts_with("gl_"))
            continue;
        if (const Variable* output = outputFor(*unit_, each))
            passed_.push_back({emittedName(*unit_, output->name), emittedName(next, each.name)});
        else
            hasAll = false;
        makeArray(each, corners_);
    }
    for (Variable& each : unit_->variables)
        if (each.storage == Storage::output && !each.name.starts_with("gl_")) makePlain(each);
    return hasAll;
}

BlockPlace CornerStage::inputOfNext(const std::string& prefix) {
    return {prefix, fmt::format("[{}]", corners_), true, [this, prefix](const std::string& member) {
                passed_.push_back({prefix_ + "_" + member, prefix + member});
            }};
}

std::string CornerStage::run(int corner, const std::string& before) const {
    std::string text = before;
    for (std::size_t i = 0; i < fetched_.size(); ++i)
        text += fmt::format(" {} = {}(glibra_input({}){});", emittedName(*unit_, fetched_[i].name),
                            fetched_[i].type, i, swizzleOf(fetched_[i].type));
    if (fetched_.empty())
        for (const std::string& each : attributes_)
            text += fmt::format(" {} = {}{}_{};", emittedName(*unit_, each), kCornerInput, corner, each);
    text += fmt::format(
        " {0}_main(); {1}[{2}].glibra_position = {0}Position; {1}[{2}].glibra_pointSize = {0}PointSize;",
        prefix_, array_, corner);
    for (const auto& [from, to] : passed_) text += fmt::format(" {}[{}] = {};", to, corner, from);
    return text + "\n";
}

// ---- Geometry

int cornersOfInput(std::string_view primitive) {
    constexpr std::array<std::pair<std::string_view, int>, 5> kCorners{
        {{"points", 1}, {"lines", 2}, {"lines_adjacency", 4}, {"triangles", 3}, {"triangles_adjacency", 6}}};
    for (const auto& [word, corners] : kCorners)
        if (word == primitive) return corners;
    return 0;
}

static std::string_view nameOfKept(std::string_view name) {
    return name.starts_with("gl_") ? name.substr(3) : name;
}

std::string GeometryInVertex::prepare(const std::string& primitive, bool mayMeasure) {
    if (cornersOfInput(program_.geometryInput) == 0 || program_.maxVertices <= 0)
        return "its primitives are not known";
    for (const auto& [name, written] :
         std::initializer_list<std::pair<const char*, std::string>>{{"main", "glibra_g_main"},
                                                                    {"gl_in", "glibra_corners"},
                                                                    {"EmitVertex", "glibra_emit"},
                                                                    {"EndPrimitive", "glibra_end"},
                                                                    {"gl_PrimitiveIDIn", primitive},
                                                                    {"gl_InvocationID", "glibra_invocation"}})
        geometry_.renames[name] = written;
    renameCornerMembers(geometry_);
    if (geometry_.isWritten("gl_PrimitiveID")) {
        geometry_.renames["gl_PrimitiveID"] = "glibra_PrimitiveID";
        geometry_.declare("flat out int glibra_PrimitiveID;");
        keep("int", "glibra_PrimitiveID");
        if (fragment_ != nullptr) {
            fragment_->renames["gl_PrimitiveID"] = "glibra_PrimitiveID";
            fragment_->declare("flat in int glibra_PrimitiveID;");
        }
    }
    for (const Declaration& each : geometry_.syntax.declarations) {
        if (each.kind != DeclarationKind::layoutOnly) continue;
        if (const LayoutItem* item = each.qualifiers.item("invocations")) {
            const std::string number = textOf(geometry_, item->value);
            std::from_chars(number.data(), number.data() + number.size(), invocations_);
        }
        geometry_.remove(each.tokens);
    }
    constexpr int kFewMeasured = 8;  // vertices, all of which cost little more than to wait for their number
    isMeasured_ = mayMeasure && invocations_ == 1 && program_.maxVertices >= kFewMeasured &&
                  program_.maxVertices <= kMostMeasured;
    geometry_.declare("int glibra_invocation;");
    geometry_.declare("void glibra_emit();");
    geometry_.declare("void glibra_end();");
    return corners_.deliverTo(geometry_) ? "" : "inputs that the stage before it does not have";
}

int GeometryInVertex::cornersOfOutput() const {
    if (program_.geometryOutput == "points") return 1;
    return program_.geometryOutput == "line_strip" ? 2 : 3;
}

int GeometryInVertex::most() const {
    return std::max(1, program_.maxVertices - cornersOfOutput() + 1);
}

ExpandedGeometry GeometryInVertex::expansion() const {
    return {.corners = cornersOfInput(program_.geometryInput),
            .vertices = most() * cornersOfOutput() * invocations_,
            .ofPrimitive = cornersOfOutput(),
            .mostEmitted = isMeasured() ? program_.maxVertices : 0};
}

std::vector<GeometryInVertex::Kept> GeometryInVertex::kept() const {
    std::vector<Kept> result{{"vec4", "gl_Position", ""}};
    if (cornersOfOutput() == 1) result.push_back({"float", "gl_PointSize", ""});
    result.insert(result.end(), blockOutputs_.begin(), blockOutputs_.end());
    for (const Variable& each : geometry_.variables) {
        if (each.storage != Storage::output || each.removed || each.name.starts_with("gl_")) continue;
        result.push_back({each.type, emittedName(geometry_, each.name), bracketed(each.sizes())});
    }
    return result;
}

bool GeometryInVertex::isMeasured() const {
    // The three outputs of the strips must fit beside the others: WebGL 2 has 15 vectors.
    constexpr std::size_t kMostOutputs = 11;
    const std::vector<Kept> all = kept();
    return isMeasured_ && all.size() <= kMostOutputs && std::ranges::none_of(all, [](const Kept& each) {
               return !each.sizes.empty() || each.type.starts_with("mat");
           });
}

std::string GeometryInVertex::functions() const {
    const int corners = cornersOfOutput();
    std::string text, shift, first, second, third, itself;
    for (const Kept& each : kept()) {
        const std::string_view name = nameOfKept(each.name);
        for (const std::string_view copy : {"a", "b", "c", "kept"})
            text += fmt::format("{} glibra_{}_{}{};\n", each.type, copy, name, each.sizes);
        if (corners == 3) shift += fmt::format(" glibra_c_{0} = glibra_b_{0};", name);
        if (corners >= 2) shift += fmt::format(" glibra_b_{0} = glibra_a_{0};", name);
        shift += fmt::format(" glibra_a_{} = {};", name, each.name);
        first += fmt::format(" glibra_kept_{0} = glibra_a_{0};", name);
        second += fmt::format(" glibra_kept_{0} = glibra_b_{0};", name);
        third += fmt::format(" glibra_kept_{0} = glibra_c_{0};", name);
        itself += fmt::format(" glibra_kept_{} = {};", name, each.name);
    }
    text +=
        "int glibra_strip = 0, glibra_count = 0, glibra_want, glibra_corner;\nbool glibra_isFound = false;\n";
    std::string byVertex;
    if (isMeasured()) {
        text +=
            "uniform int glibra_Mode;\nuint glibra_begins[8];\nint glibra_emitted = 0;\n"
            "flat out uvec4 glibra_Begins;\nflat out uvec4 glibra_MoreBegins;\nflat out int "
            "glibra_Emitted;\n";
        byVertex = fmt::format(
            " if (glibra_Mode != 0) {{ if (glibra_strip++ == 0 && glibra_emitted < {})"
            " glibra_begins[glibra_emitted >> 5] |= 1u << uint(glibra_emitted & 31);"
            " if (glibra_emitted++ == glibra_want) {{{} glibra_isFound = true; }} return; }}",
            kMostMeasured, itself);
    }
    // Every second triangle of a strip has its first two corners in the other order (OpenGL 4.6
    // Core, 10.1.8).
    text += fmt::format(
        "void glibra_emit() {{{}{} if (++glibra_strip < {} || glibra_count++ != glibra_want) return;"
        " int corner = {};"
        " if (corner == {}) {{{} }} else if (corner == {}) {{{} }} else {{{} }} glibra_isFound = true; }}\n",
        byVertex, shift, corners,
        corners == 3 ? "(glibra_strip & 1) == 0 && glibra_corner < 2 ? 1 - glibra_corner : glibra_corner"
                     : "glibra_corner",
        corners - 1, first, corners - 2, second, third);
    return text + "void glibra_end() { glibra_strip = 0; }\n";
}

std::string GeometryInVertex::statements(const std::string& vertex) const {
    std::string text = fmt::format(
        " glibra_want = {2} / {0}; glibra_corner = {2} - {0} * glibra_want;"
        " glibra_invocation = glibra_want / {1}; glibra_want -= glibra_invocation * {1};\n",
        cornersOfOutput(), most(), vertex);
    if (cornersOfOutput() == 1 && !geometry_.isWritten("gl_PointSize"))
        text += " gl_PointSize = glibra_PointSize;";
    if (isMeasured())
        text +=
            " for (int i = 0; i < 8; ++i) glibra_begins[i] = 0u;\n"
            " if (glibra_Mode != 0) glibra_want = glibra_Mode == 1 ? gl_VertexID : -1;\n";
    text += " glibra_g_main();";
    for (const Kept& each : kept())
        text += fmt::format(" {} = glibra_kept_{};", each.name, nameOfKept(each.name));
    if (isMeasured())
        text +=
            "\n glibra_Begins = uvec4(glibra_begins[0], glibra_begins[1], glibra_begins[2], "
            "glibra_begins[3]);"
            " glibra_MoreBegins = uvec4(glibra_begins[4], glibra_begins[5], glibra_begins[6], "
            "glibra_begins[7]); glibra_Emitted = glibra_emitted;";
    return text + "\n if (!glibra_isFound) gl_Position = vec4(0., 0., 2., 1.);\n";
}

// ---- Tessellation

namespace {

using base::TessellationLayout;

/// What both stages have.
void renameBuiltins(Unit& unit, const std::string& in, int vertices) {
    for (const auto& [name, written] : std::initializer_list<std::pair<const char*, std::string>>{
             {"gl_in", in},
             {"gl_PatchVerticesIn", std::to_string(vertices)},
             {"gl_MaxPatchVertices", "32"},
             {"gl_PrimitiveID", "glibra_patch"},
             {"gl_TessLevelOuter", "glibra_Outer"},
             {"gl_TessLevelInner", "glibra_Inner"}})
        unit.renames[name] = written;
    unit.declare("int glibra_patch;");
    unit.declare("float glibra_Outer[4];");
    unit.declare("float glibra_Inner[2];");
    renameCornerMembers(unit);
    for (const Declaration& each : unit.syntax.declarations)
        if (each.kind == DeclarationKind::layoutOnly) unit.remove(each.tokens);
}

}  // namespace

void TessellationInVertex::readLayout() {
    using Domain = TessellationLayout::Domain;
    using Spacing = TessellationLayout::Spacing;
    for (const Declaration& each : evaluation_.syntax.declarations) {
        if (each.kind != DeclarationKind::layoutOnly) continue;
        const auto has = [&](const char* word) { return each.qualifiers.item(word) != nullptr; };
        if (has("quads")) layout_.domain = Domain::quads;
        if (has("isolines")) layout_.domain = Domain::isolines;
        if (has("fractional_even_spacing")) layout_.spacing = Spacing::fractionalEven;
        if (has("fractional_odd_spacing")) layout_.spacing = Spacing::fractionalOdd;
        if (has("cw")) layout_.isClockwise = true;
        if (has("point_mode")) layout_.asPoints = true;
    }
}

std::string TessellationInVertex::prepare(int geometry) {
    readLayout();
    inputs_.prepare("glibra_instance");
    vertex_.declare("int glibra_instance;");
    inputs_.spreadInputs();
    if (vertex_.isUsed("gl_VertexID") && inputs_.hasInputs()) return "gl_VertexID and vertex data before it";
    std::string problem = control_ != nullptr ? prepareControl() : std::string();
    if (geometry > 0) {
        primitives_ = CornerStage(evaluation_, "glibra_e", "glibra_corners", geometry);
        primitives_.prepare("");
    } else
        evaluation_.renames["main"] = "glibra_e_main";
    evaluation_.renames["gl_TessCoord"] = "glibra_TessCoord";
    evaluation_.declare("vec3 glibra_TessCoord;");
    renameBuiltins(evaluation_, control_ != nullptr ? "glibra_points" : "glibra_inputs",
                   control_ != nullptr ? points_ : corners_);
    removeTwins(evaluation_, vertex_);
    if (control_ != nullptr) {
        removeTwins(evaluation_, *control_);
        if (problem.empty()) problem = takeOutputs();
    } else if (!inputs_.deliverTo(evaluation_)) {
        problem = "inputs that the stage before it does not have";
    }
    return problem;
}

std::string TessellationInVertex::prepareControl() {
    Unit& control = *control_;
    if (points_ <= 0) return "the vertices of its patches are not known";
    const auto barriers = control.uses.find("barrier");
    hasBarrier_ = barriers != control.uses.end();
    if (hasBarrier_ && barriers->second.size() > 1) return "several barriers";
    prefixNames(control, "glibra_t");
    renameBuiltins(control, "glibra_inputs", corners_);
    control.renames["gl_out"] = "glibra_points";
    control.renames["gl_InvocationID"] = "glibra_invocation";
    control.renames["barrier"] = "glibra_barrier";
    control.declare("int glibra_invocation;");
    control.declare("void glibra_barrier() {}");
    control.declare(fmt::format("glibra_Corner glibra_points[{}];", points_));
    removeTwins(control, vertex_);
    return inputs_.deliverTo(control) ? "" : "inputs that the vertex stage does not have";
}

/// The inputs of the evaluation stage are the variables of the control stage.
std::string TessellationInVertex::takeOutputs() {
    for (Variable& each : evaluation_.variables) {
        if (each.storage != Storage::input || each.name.starts_with("gl_")) continue;
        const Variable* output = outputFor(*control_, each);
        if (output == nullptr) return "inputs that the control stage does not have";
        evaluation_.renames[each.name] = emittedName(*control_, output->name);
        each.removed = true;
    }
    for (Variable& each : control_->variables) {
        if (each.storage != Storage::output || each.name.starts_with("gl_")) continue;
        each.patch ? makePlain(each) : makeArray(each, points_);
    }
    return {};
}

BlockPlace TessellationInVertex::inputOf(Stage stage) {
    if (stage == Stage::tessEvaluation && control_ != nullptr) return {"glibra_o_", "", false};
    return inputs_.inputOfNext("glibra_p_");
}

BlockPlace TessellationInVertex::outputOf(Stage stage, bool isOfPatch) const {
    if (stage == Stage::vertex) return inputs_.output();
    return {"glibra_o_", isOfPatch ? "" : fmt::format("[{}]", points_)};
}

std::string TessellationInVertex::functions() const {
    return "uniform int glibra_Instance;\nuniform int glibra_Patches;\nuniform bool glibra_Measures;\n"
           "uniform highp sampler2D glibra_Coordinates;\n"
           "uniform int glibra_Count;\n"
           "out vec4 glibra_OuterLevels;\nout vec2 glibra_InnerLevels;\nint glibra_first, glibra_at;\n"
           "vec4 glibra_texel(int at) {\n"
           " int width = textureSize(glibra_Coordinates, 0).x;\n"
           " return texelFetch(glibra_Coordinates, ivec2(at % width, at / width), 0);\n}\n"
           // The last patch that begins at or before a vertex: those before it may be empty.
           "int glibra_patchOf(int vertex) {\n"
           " int low = 0, high = glibra_Count;\n"
           " while (high - low > 1) { int middle = (low + high) / 2; vec4 part = glibra_texel(middle);\n"
           "  if (int(part.z) * 65536 + int(part.w) <= vertex) low = middle; else high = middle; }\n"
           " return low;\n}\n";
}

std::string TessellationInVertex::statements() const {
    std::string text = areInSequence()
                           ? " int work = glibra_Measures ? gl_InstanceID : glibra_patchOf(gl_VertexID);\n"
                           : " int work = gl_InstanceID;\n";
    text +=
        " glibra_patch = work % glibra_Patches; glibra_instance = glibra_Instance + work / glibra_Patches;\n"
        " if (!glibra_Measures) { vec4 part = glibra_texel(work); glibra_first = int(part.x);"
        " glibra_at = gl_VertexID - int(part.z) * 65536 - int(part.w);"
        " if (glibra_at >= int(part.y)) { gl_Position = vec4(0., 0., 2., 1.); return; } }\n";
    for (int corner = 0; corner < corners_; ++corner)
        text +=
            inputs_.run(corner, fmt::format(" glibra_vertex = {} * glibra_patch + {};", corners_, corner));
    if (control_ == nullptr) return text;
    // After a barrier the invocations read what all of them wrote before it. So they run a second time.
    text += fmt::format(
        " for (int run = 0; run < {}; ++run)"
        " for (glibra_invocation = 0; glibra_invocation < {}; ++glibra_invocation)"
        " glibra_t_main();\n",
        hasBarrier_ ? 2 : 1, points_);
    return text +
           " glibra_OuterLevels = vec4(glibra_Outer[0], glibra_Outer[1], glibra_Outer[2], glibra_Outer[3]);"
           " glibra_InnerLevels = vec2(glibra_Inner[0], glibra_Inner[1]);"
           " if (glibra_Measures) { gl_Position = vec4(0., 0., 2., 1.); return; }\n";
}

std::string TessellationInVertex::coordinate(const std::string& vertex) const {
    return fmt::format(" glibra_TessCoord = glibra_texel(glibra_first + {}).xyz;", vertex);
}

}  // namespace glibra::glsl
