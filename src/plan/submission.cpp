#include "plan/submission.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>

namespace glibra::plan {
namespace {

using geometry::Topology;
using glib::CommandId;

/// What is known of a geometry command without making its mesh. `sizes` are the arguments that must not be
/// zero; `relative` is the command that draws the same as lines, or of lines as triangles.
struct ShapeRow {
    CommandId command;
    Topology topology;
    std::array<int, 3> sizes;  ///< indices into Shape::numbers, -1: no more
    std::string_view lines;    ///< for a program that wants lines
    std::string_view triangles;
};
constexpr int kNo = -1;
constexpr std::array<ShapeRow, 28> kShapes{{
    {CommandId::box, Topology::triangles, {0, 1, 2}, "WireBox", ""},
    {CommandId::sphere, Topology::triangles, {0, kNo, kNo}, "WireSphere", ""},
    {CommandId::cylinder, Topology::triangles, {0, 1, kNo}, "WireCylinder", ""},
    {CommandId::cone, Topology::triangles, {0, 1, kNo}, "WireCone", ""},
    {CommandId::torus, Topology::triangles, {0, 1, kNo}, "WireTorus", ""},
    {CommandId::teapot, Topology::triangles, {kNo, kNo, kNo}, "WireTeapot", ""},
    {CommandId::soccerball, Topology::triangles, {0, kNo, kNo}, "", ""},
    {CommandId::diskXY, Topology::triangles, {1, kNo, kNo}, "", ""},
    {CommandId::quadXY, Topology::triangles, {1, kNo, kNo}, "", ""},
    {CommandId::quadXZ, Topology::triangles, {1, kNo, kNo}, "", ""},
    {CommandId::quadYZ, Topology::triangles, {1, kNo, kNo}, "", ""},
    {CommandId::quadBox, Topology::triangles, {kNo, kNo, kNo}, "", ""},
    {CommandId::xarrow, Topology::triangles, {kNo, kNo, kNo}, "", ""},
    {CommandId::pointCloud, Topology::points, {kNo, kNo, kNo}, "", ""},
    {CommandId::jitterCloud, Topology::points, {kNo, kNo, kNo}, "", ""},
    {CommandId::wireSphere, Topology::lines, {0, kNo, kNo}, "", "Sphere"},
    {CommandId::wireTorus, Topology::lines, {0, 1, kNo}, "", "Torus"},
    {CommandId::wireCylinder, Topology::lines, {0, 1, kNo}, "", "Cylinder"},
    {CommandId::wireCone, Topology::lines, {0, 1, kNo}, "", "Cone"},
    {CommandId::wireCube, Topology::lines, {0, kNo, kNo}, "", "Box"},
    {CommandId::wireBox, Topology::lines, {0, 1, 2}, "", "Box"},
    {CommandId::wireTeapot, Topology::lines, {kNo, kNo, kNo}, "", "Teapot"},
    {CommandId::obj, Topology::triangles, {kNo, kNo, kNo}, "WireObj", ""},
    {CommandId::wireObj, Topology::lines, {kNo, kNo, kNo}, "", "Obj"},
    {CommandId::objAdj, Topology::trianglesAdjacency, {kNo, kNo, kNo}, "WireObj", "Obj"},
    {CommandId::objPatch, Topology::patches, {kNo, kNo, kNo}, "WireObj", "Obj"},
    {CommandId::shp, Topology::lines, {kNo, kNo, kNo}, "", ""},
    {CommandId::linesAdjacency, Topology::linesAdjacency, {kNo, kNo, kNo}, "", ""},
}};
constexpr int kObjPatchVertices = 3;

const ShapeRow* rowOf(CommandId command) {
    const auto* row = std::find_if(kShapes.begin(), kShapes.end(),
                                   [&](const ShapeRow& each) { return each.command == command; });
    return row == kShapes.end() ? nullptr : row;
}

/// "; use ObjAdj": a command that delivers the wanted kind, where there is an obvious one.
std::string recommendation(CommandId command, std::string_view wanted) {
    const ShapeRow* row = rowOf(command);
    std::string_view word;
    if (wanted == wordOf(Topology::trianglesAdjacency)) word = "ObjAdj";
    if (wanted == wordOf(Topology::linesAdjacency)) word = "LinesAdjacency";
    if (wanted == wordOf(Topology::points)) word = "PointCloud";
    if (wanted == wordOf(Topology::lines) && row != nullptr) word = row->lines;
    if (wanted == wordOf(Topology::triangles) && row != nullptr) word = row->triangles;
    return word.empty() ? std::string() : fmt::format("; use {}", word);
}

int patchVerticesOf(const scene::Shape& shape, const scene::Draw& draw) {
    if (shape.list != nullptr && shape.list->patchVertices > 0) return shape.list->patchVertices;
    return shape.command == CommandId::objPatch ? kObjPatchVertices : draw.patchVertices;
}

}  // namespace

geometry::Topology topologyOf(const scene::Shape& shape) {
    if (shape.list != nullptr) return shape.list->topology;
    const ShapeRow* row = rowOf(shape.command);
    return row != nullptr ? row->topology : Topology::triangles;
}

std::string_view wordOf(Topology topology) {
    switch (topology) {
        case Topology::points:
            return "points";
        case Topology::lines:
            return "lines";
        case Topology::linesAdjacency:
            return "lines_adjacency";
        case Topology::triangles:
            return "triangles";
        case Topology::trianglesAdjacency:
            return "triangles_adjacency";
        case Topology::patches:
            break;
    }
    return "patches";
}

bool drawsNothing(const scene::Shape& shape) {
    if (shape.list != nullptr) return shape.list->indices.empty();
    const ShapeRow* row = rowOf(shape.command);
    if (row == nullptr) return false;
    return std::any_of(row->sizes.begin(), row->sizes.end(), [&](int index) {
        return index >= 0 && static_cast<std::size_t>(index) < shape.numbers.size() &&
               shape.numbers[static_cast<std::size_t>(index)] == 0;
    });
}

std::string stageFileName(const scene::Scene& scene, const scene::Program& program, glsl::Stage stage) {
    for (const scene::StageFile& each : program.stages) {
        if (each.stage != stage || each.file < 0) continue;
        const std::string& name = scene.files.at(static_cast<std::size_t>(each.file)).name;
        return name.substr(name.find_last_of("/\\") + 1);
    }
    return {};
}

Result<Submission> submissionOf(const scene::Scene& scene, const scene::Draw& draw,
                                const scene::Program* program, const ProgramInterface& interface) {
    const scene::Shape& shape = scene.shapes.at(static_cast<std::size_t>(draw.shape));
    const Topology topology = topologyOf(shape);
    const bool isTessellated = program != nullptr && program->hasStage(glsl::Stage::tessEvaluation);
    const std::string& word = draw.word;

    Submission submission{topology, 0};
    std::string_view delivered = wordOf(topology);
    if (!isTessellated) {
        if (topology == Topology::patches)
            return error("draw-E04",
                         fmt::format("{} needs a TessEvaluation stage",
                                     shape.command == CommandId::glBegin ? "gl_patches" : word),
                         draw.place);
    } else {
        if (topology == Topology::patches) {
            submission.patchVertices = patchVerticesOf(shape, draw);
        } else {
            const int wanted = geometry::verticesPerPrimitive(topology);
            const bool controlFits =
                topology == Topology::triangles && interface.facts.patchVertices == wanted;
            if (draw.patchVertices != wanted && !controlFits)
                return error("draw-E03",
                             fmt::format("{} delivers {}, but the patch size is {}; write "
                                         "'NumPatchVertices {}'",
                                         word, delivered, draw.patchVertices, wanted),
                             draw.place);
            submission = {Topology::patches, wanted};
        }
        delivered = interface.facts.tessellationOutput;
    }

    const std::string& wanted = interface.facts.geometryInput;
    if (program != nullptr && !wanted.empty() && !delivered.empty() && wanted != delivered) {
        const std::string file = stageFileName(scene, *program, glsl::Stage::geometry);
        return error("draw-E02",
                     fmt::format("{} delivers {}{}, but {} wants {}{}", word, delivered,
                                 isTessellated ? " after tessellation" : "",
                                 file.empty() ? "the geometry stage" : file, wanted,
                                 isTessellated ? "" : recommendation(shape.command, wanted)),
                     draw.place);
    }
    return submission;
}

bool ignoresPointSize(const scene::Draw& draw, const scene::Program* program,
                      const ProgramInterface& interface, const Submission& submission) {
    if (program == nullptr || draw.raster.pointSizeFromShader || !interface.facts.writesPointSize)
        return false;
    const std::string_view points = wordOf(Topology::points);
    if (program->hasStage(glsl::Stage::geometry))
        return program->geometryOutput.empty() || program->geometryOutput == points;
    if (program->hasStage(glsl::Stage::tessEvaluation)) return interface.facts.tessellationOutput == points;
    return submission.topology == Topology::points;
}

}  // namespace glibra::plan
