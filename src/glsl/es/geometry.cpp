#include "glsl/es/geometry.h"

#include <fmt/format.h>
#include <algorithm>
#include <array>
#include <charconv>
#include <optional>
#include <string_view>
#include <utility>

#include "glsl/parse/types.h"

namespace glibra::glsl {
namespace {

constexpr int kMostInputs = 16;  // of a vertex stage in GLSL ES 3.00 (gl_MaxVertexAttribs)

int cornersOf(std::string_view primitive) {
    constexpr std::array<std::pair<std::string_view, int>, 5> kCorners{
        {{"points", 1}, {"lines", 2}, {"lines_adjacency", 4}, {"triangles", 3}, {"triangles_adjacency", 6}}};
    for (const auto& [word, corners] : kCorners)
        if (word == primitive) return corners;
    return 0;
}

std::string vertexName(std::string_view name) {
    return fmt::format("glibra_v_{}", name);
}

/// "[3]" for each size.
std::string bracketed(const std::vector<std::string>& sizes) {
    std::string text;
    for (const std::string& each : sizes) text += "[" + each + "]";
    return text;
}

/// It is a variable of the stage from now on.
void makePlain(Variable& variable) {
    variable.storage = Storage::none;
    variable.interpolation.clear();
    variable.centroid = variable.sample = variable.invariant = false;
    variable.layout.clear();
    variable.changed = true;
}

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

}  // namespace

std::string GeometryInVertex::prepare() {
    corners_ = cornersOf(program_.geometryInput);
    if (corners_ == 0 || program_.maxVertices <= 0) return "its primitives are not known";
    prepareVertex();
    // Vertices without data are numbered; those of a mesh have lost their numbers.
    if (vertex_.isUsed("gl_VertexID") && !attributes_.empty()) return "gl_VertexID and vertex data before it";
    std::string problem = prepareGeometry();
    const auto inputs = static_cast<int>(attributes_.size()) * corners_;
    if (problem.empty() && inputs > kMostInputs)
        return fmt::format("a geometry stage that needs {} inputs of the vertex stage; {} are possible",
                           inputs, kMostInputs);
    return problem;
}

void GeometryInVertex::prepareVertex() {
    for (const auto& [name, at] : vertex_.declared) {
        const bool isOwn = vertex_.function(name) != nullptr || vertex_.firstVariable(name) != nullptr;
        if (isOwn && !isUniformOf(vertex_, name)) vertex_.renames[name] = vertexName(name);
    }
    vertex_.renames["main"] = vertexName("main");
    vertex_.renames["gl_Position"] = "glibra_vPosition";
    vertex_.renames["gl_PointSize"] = "glibra_vPointSize";
    vertex_.renames["gl_InstanceID"] = "glibra_Instance";
    vertex_.renames["gl_VertexID"] = "glibra_vertex";
    vertex_.declare("int glibra_vertex;");
    vertex_.declare("vec4 glibra_vPosition;");
    vertex_.declare("float glibra_vPointSize;");
    vertex_.declare("uniform int glibra_Instance;");
    for (Variable& each : vertex_.variables) {
        if (each.name.starts_with("gl_") || each.removed) continue;
        if (each.storage == Storage::input) {
            for (int corner = 0; corner < corners_; ++corner)
                vertex_.declare(fmt::format("layout(location = {}) in {} {}{}_{};",
                                            static_cast<int>(attributes_.size()) * corners_ + corner,
                                            each.type, kCornerInput, corner, each.name));
            attributes_.push_back({each.type, each.name});
            makePlain(each);
        }
    }
}

std::string GeometryInVertex::prepareGeometry() {
    for (const auto& [name, written] :
         std::initializer_list<std::pair<const char*, const char*>>{{"main", "glibra_g_main"},
                                                                    {"gl_in", "glibra_corners"},
                                                                    {"EmitVertex", "glibra_emit"},
                                                                    {"EndPrimitive", "glibra_end"},
                                                                    {"gl_PrimitiveIDIn", "gl_InstanceID"},
                                                                    {"gl_InvocationID", "glibra_invocation"}})
        geometry_.renames[name] = written;
    for (std::uint32_t i = 1; i < geometry_.view.size(); ++i)
        if (geometry_.text(i - 1) == "." &&
            (geometry_.text(i) == "gl_Position" || geometry_.text(i) == "gl_PointSize"))
            geometry_.edits.replace(geometry_.view[i].raw, geometry_.text(i) == "gl_Position"
                                                               ? "glibra_position"
                                                               : "glibra_pointSize");
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
        const bool isStruct = each.type.isStruct && each.declarators.empty() && each.name != kNone;
        const bool isBlock =
            each.kind == DeclarationKind::block && each.qualifiers.storage == Storage::uniform;
        if ((isStruct || isBlock) && hasTwin(vertex_, each, geometry_.text(each.name)))
            geometry_.remove(each.tokens);
        if (each.kind != DeclarationKind::layoutOnly) continue;
        if (const LayoutItem* item = each.qualifiers.item("invocations")) {
            const std::string number = textOf(geometry_, item->value);
            std::from_chars(number.data(), number.data() + number.size(), invocations_);
        }
        geometry_.remove(each.tokens);
    }
    for (Variable& each : geometry_.variables) {
        if (each.name.starts_with("gl_") || each.removed) continue;
        if (each.storage == Storage::uniform && isUniformOf(vertex_, each.name)) each.removed = true;
        if (each.storage != Storage::input) continue;
        const std::string* const location = each.layoutValue("location");
        const auto output = std::ranges::find_if(vertex_.variables, [&](const Variable& other) {
            const std::string* const own = other.layoutValue("location");
            return other.storage == Storage::output &&
                   (location && own ? *location == *own : other.name == each.name);
        });
        if (output == vertex_.variables.end()) return "inputs that the vertex stage does not have";
        passed_.push_back({vertexName(output->name), each.name});
        makePlain(each);
        each.typeSizes.clear();
        each.nameSizes = {std::to_string(corners_)};
        each.sizesChanged = true;
    }
    for (Variable& each : vertex_.variables)
        if (each.storage == Storage::output && !each.name.starts_with("gl_")) makePlain(each);
    geometry_.declare("struct glibra_Corner { vec4 glibra_position; float glibra_pointSize; };");
    geometry_.declare(fmt::format("glibra_Corner glibra_corners[{}];", corners_));
    geometry_.declare("int glibra_invocation;");
    geometry_.declare("void glibra_emit();");
    geometry_.declare("void glibra_end();");
    return {};
}

std::string GeometryInVertex::pass(const std::string& block, const std::string& member) {
    passed_.push_back(
        {fmt::format("glibra_v_{}_{}", block, member), fmt::format("glibra_c_{}_{}", block, member)});
    return fmt::format("[{}]", corners_);
}

int GeometryInVertex::cornersOfOutput() const {
    if (program_.geometryOutput == "points") return 1;
    return program_.geometryOutput == "line_strip" ? 2 : 3;
}

int GeometryInVertex::most() const {
    return std::max(1, program_.maxVertices - cornersOfOutput() + 1);
}

ExpandedGeometry GeometryInVertex::expansion() const {
    return {corners_, most() * cornersOfOutput() * invocations_, cornersOfOutput()};
}

std::vector<GeometryInVertex::Kept> GeometryInVertex::kept() const {
    std::vector<Kept> result{{"vec4", "gl_Position", ""}};
    if (cornersOfOutput() == 1) result.push_back({"float", "gl_PointSize", ""});
    result.insert(result.end(), blockOutputs_.begin(), blockOutputs_.end());
    for (const Variable& each : geometry_.variables) {
        if (each.storage != Storage::output || each.removed || each.name.starts_with("gl_")) continue;
        const auto renamed = geometry_.renames.find(each.name);
        result.push_back({each.type, renamed == geometry_.renames.end() ? each.name : renamed->second,
                          bracketed(each.sizes())});
    }
    return result;
}

std::string GeometryInVertex::ending() const {
    const int corners = cornersOfOutput();
    std::string text, shift, first, second, third, result;
    const bool statesPointSize = corners == 1 && !geometry_.isWritten("gl_PointSize");
    constexpr const char* kPointSize = "uniform float glibra_PointSize;";
    if (statesPointSize && std::ranges::find(vertex_.prologue, kPointSize) == vertex_.prologue.end())
        text += std::string(kPointSize) + "\n";
    for (const Kept& each : kept()) {
        const std::string_view name = std::string_view(each.name).starts_with("gl_")
                                          ? std::string_view(each.name).substr(3)
                                          : std::string_view(each.name);
        for (const std::string_view copy : {"a", "b", "c", "kept"})
            text += fmt::format("{} glibra_{}_{}{};\n", each.type, copy, name, each.sizes);
        if (corners == 3) shift += fmt::format(" glibra_c_{0} = glibra_b_{0};", name);
        if (corners >= 2) shift += fmt::format(" glibra_b_{0} = glibra_a_{0};", name);
        shift += fmt::format(" glibra_a_{} = {};", name, each.name);
        first += fmt::format(" glibra_kept_{0} = glibra_a_{0};", name);
        second += fmt::format(" glibra_kept_{0} = glibra_b_{0};", name);
        third += fmt::format(" glibra_kept_{0} = glibra_c_{0};", name);
        result += fmt::format(" {} = glibra_kept_{};", each.name, name);
    }
    text +=
        "int glibra_strip = 0, glibra_count = 0, glibra_want, glibra_corner;\nbool glibra_isFound = false;\n";
    // Every second triangle of a strip has its first two corners in the other order (OpenGL 4.6
    // Core, 10.1.8).
    text += fmt::format(
        "void glibra_emit() {{{} if (++glibra_strip < {} || glibra_count++ != glibra_want) return;"
        " int corner = {};"
        " if (corner == {}) {{{} }} else if (corner == {}) {{{} }} else {{{} }} glibra_isFound = true; }}\n",
        shift, corners,
        corners == 3 ? "(glibra_strip & 1) == 0 && glibra_corner < 2 ? 1 - glibra_corner : glibra_corner"
                     : "glibra_corner",
        corners - 1, first, corners - 2, second, third);
    text += "void glibra_end() { glibra_strip = 0; }\nvoid main() {\n";
    for (int corner = 0; corner < corners_; ++corner) {
        for (const Attribute& each : attributes_)
            text += fmt::format(" {} = {}{}_{};", vertexName(each.name), kCornerInput, corner, each.name);
        text += fmt::format(
            " glibra_vertex = {} * gl_InstanceID + {}; {}(); glibra_corners[{}].glibra_position = "
            "glibra_vPosition; glibra_corners[{}].glibra_pointSize = "
            "glibra_vPointSize;",
            corners_, corner, vertexName("main"), corner, corner);
        for (const Passed& each : passed_) text += fmt::format(" {}[{}] = {};", each.to, corner, each.from);
        text += "\n";
    }
    text += fmt::format(
        " glibra_want = gl_VertexID / {0}; glibra_corner = gl_VertexID - {0} * glibra_want;"
        " glibra_invocation = glibra_want / {1}; glibra_want -= glibra_invocation * {1};\n",
        corners, most());
    if (statesPointSize) text += " gl_PointSize = glibra_PointSize;";
    return text + " glibra_g_main();" + result +
           "\n if (!glibra_isFound) gl_Position = vec4(0., 0., 2., 1.);\n}\n";
}

}  // namespace glibra::glsl
