#include "scene/primitives.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <exception>
#include <string_view>
#include <utility>
#include <vector>

#include "base/text.h"
#include "geometry/obj/obj_model.h"
#include "geometry/obj/shapefile.h"
#include "geometry/shapes/primitive.h"
#include "glib/statement_table.h"
#include "image/file.h"
#include "scene/file_lookup.h"

namespace glibra::scene {
namespace {

namespace geo = glibra::geometry;
using geo::Counts;
using geo::Mesh;
using geo::PrimitiveSpec;
using geo::Topology;
using glib::CommandId;

Mesh objMesh(CommandId command, const geo::ObjModel& model, bool withTangents) {
    switch (command) {
        case CommandId::wireObj:
            return geo::wireObj(model, withTangents);
        case CommandId::objAdj:
            return geo::objAdj(model, withTangents);
        case CommandId::objPatch:
            return geo::objPatch(model, withTangents);
        default:
            break;
    }
    return geo::obj(model, withTangents);
}

/// Parses the content of a model file.
Result<Mesh> parseModel(CommandId command, std::vector<std::byte> bytes, const std::string& path,
                        bool withTangents) {
    if (command == CommandId::shp) return geo::parseShp(bytes, path);
    const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    Result<geo::ObjModel> model = geo::parseObj(
        text, path, command == CommandId::wireObj ? geo::ObjElements::edges : geo::ObjElements::faces);
    if (!model) return std::move(model.diagnostics);
    std::vector<std::byte>().swap(bytes);  // frees a large text before the mesh is made
    return {objMesh(command, *model, withTangents), std::move(model.diagnostics)};
}

Result<Mesh> readModel(const Shape& shape, const FileReference& file, const std::string& scenePath,
                       bool withTangents) {
    Diagnostics diagnostics = file.remarks;
    if (file.path.empty()) return diagnostics;
    auto bytes = image::readFile(file.source(), {file.name, file.place}, geo::kLargestModelFile);
    append(diagnostics, bytes.diagnostics);
    if (!bytes) return diagnostics;
    Result<Mesh> mesh =
        parseModel(shape.command, std::move(*bytes), file.path.generic_string(), withTangents);
    if (!mesh.diagnostics.empty() && !file.content &&
        !shownRoots(searchFolders(scenePath)).contains(file.path))
        hideTexts(mesh.diagnostics, {file.path.generic_string()});
    append(diagnostics, std::move(mesh.diagnostics));
    if (!mesh) return diagnostics;
    if (mesh->vertexCount() > kMostCommandVertices) {
        diagnostics.push_back(diagnose(
            "glib-E15",
            fmt::format("{} '{}' needs {} vertices; the limit is {}", glib::nameOf(shape.command), file.name,
                        base::groupedText(mesh->vertexCount()), base::groupedText(kMostCommandVertices)),
            file.place));
        return diagnostics;
    }
    mesh.diagnostics = std::move(diagnostics);
    return mesh;
}

Mesh primitiveMesh(const PrimitiveSpec& spec, const Shape& shape) {
    const std::vector<double> numbers = geo::completeNumbers(spec, shape.numbers);
    // The interpreter rejects larger shapes. Scenes made by hand get an empty mesh for them.
    if (!drawsNothing(shape) && spec.counts(numbers).vertices <= kMostCommandVertices)
        return spec.make(numbers);
    Mesh nothing;
    nothing.topology = spec.topology;
    return nothing;
}

}  // namespace

Topology topologyOf(CommandId command) {
    if (const PrimitiveSpec* spec = glib::primitiveOf(command)) return spec->topology;
    switch (command) {
        case CommandId::wireObj:
        case CommandId::shp:
            return Topology::lines;
        case CommandId::objAdj:
            return Topology::trianglesAdjacency;
        case CommandId::objPatch:
            return Topology::patches;
        case CommandId::linesAdjacency:
            return Topology::linesAdjacency;
        default:
            break;
    }
    return Topology::triangles;
}

Topology topologyOf(const Shape& shape) {
    if (shape.bare) return *shape.bare;
    return shape.list ? shape.list->topology : topologyOf(shape.command);
}

bool drawsNothing(const Shape& shape) {
    if (shape.list) return shape.list->indices.empty();
    const PrimitiveSpec* spec = glib::primitiveOf(shape.command);
    return spec != nullptr && geo::drawsNothing(*spec, shape.numbers);
}

std::optional<Counts> countsOf(const Shape& shape) {
    if (shape.list) {
        const int taken =
            std::max(1, geo::verticesPerPrimitive(shape.list->topology, shape.list->patchVertices));
        return Counts{shape.list->vertexCount(),
                      shape.list->indices.size() / static_cast<std::size_t>(taken)};
    }
    const PrimitiveSpec* spec = glib::primitiveOf(shape.command);
    if (spec == nullptr) return std::nullopt;
    if (drawsNothing(shape)) return Counts{};
    return spec->counts(geo::completeNumbers(*spec, shape.numbers));
}

Result<Mesh> makeMesh(const Scene& scene, ShapeIndex shape, bool withTangents) {
    const Shape& wanted = scene.shapes[shape];
    if (wanted.list) return *wanted.list;
    if (wanted.bare) return Mesh{.topology = *wanted.bare, .attributes = {}, .indices = {}};
    Place place = wanted.file ? scene.files[wanted.file].place : Place{scene.path, 1, 1};
    try {
        if (const PrimitiveSpec* spec = glib::primitiveOf(wanted.command))
            return primitiveMesh(*spec, wanted);
        if (wanted.file) return readModel(wanted, scene.files[wanted.file], scene.path, withTangents);
        return diagnose("glib-E09", fmt::format("{} needs a file name", glib::nameOf(wanted.command)), place);
    } catch (const std::exception& problem) {
        if (!wanted.file)
            scene.frame.visitDraws([&](const Draw& draw, const Pass&) {
                if (draw.shape == shape) place = draw.place;
            });
        return diagnose("draw-E05", "cannot make a mesh: " + base::reasonOf(problem), place);
    }
}

}  // namespace glibra::scene
