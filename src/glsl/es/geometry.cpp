#include "glsl/es/geometry.h"

#include <fmt/format.h>
#include <algorithm>
#include <array>
#include <charconv>
#include <string_view>
#include <utility>

namespace glibra::glsl {

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

}  // namespace glibra::glsl
