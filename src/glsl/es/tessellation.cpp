#include "glsl/es/tessellation.h"

#include <fmt/format.h>

#include <algorithm>
#include <initializer_list>
#include <utility>

namespace glibra::glsl {
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
