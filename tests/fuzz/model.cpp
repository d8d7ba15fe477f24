// Any bytes as an OBJ model and as a shapefile; a mesh that results is valid.

#include <cmath>
#include <span>

#include "check.h"
#include "geometry/obj/obj_model.h"
#include "geometry/obj/shapefile.h"

namespace {

void checkMesh(const glibra::geometry::Mesh& mesh) {
    using glibra::fuzz::check;
    const std::size_t vertices = mesh.vertexCount();
    for (const auto& attribute : mesh.attributes) {
        check(attribute.values.size() == vertices * static_cast<std::size_t>(attribute.components),
              "all attributes have as many vertices");
        for (const float value : attribute.values) check(std::isfinite(value), "a vertex is finite");
    }
    for (const std::uint32_t index : mesh.indices) check(index < vertices, "an index is that of a vertex");
    const auto corners =
        static_cast<std::size_t>(glibra::geometry::verticesPerPrimitive(mesh.topology, mesh.patchVertices));
    check((mesh.indices.size() - mesh.pointCount) % corners == 0, "primitives are whole");
}

}  // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace glibra;
    const Result<geometry::ObjModel> model = geometry::parseObj(fuzz::textOf(data, size), "nowhere/a.obj");
    fuzz::checkMessages(model.diagnostics);
    fuzz::check(model.value.has_value() != hasError(model.diagnostics), "a model or an error");
    if (model) {
        checkMesh(geometry::obj(*model));
        checkMesh(geometry::objPatch(*model, false));
        checkMesh(geometry::objAdj(*model));
        checkMesh(geometry::wireObj(*model));
        geometry::ObjModel split = *model;
        split.splitFaces.clear();
        split.splitTriangles.clear();
        fuzz::check(geometry::obj(split, false).indices.size() == geometry::obj(*model, false).indices.size(),
                    "a polygon of n corners has n - 2 triangles");
    }
    const Result<geometry::ObjModel> edges =
        geometry::parseObj(fuzz::textOf(data, size), "nowhere/a.obj", geometry::ObjElements::edges);
    fuzz::checkMessages(edges.diagnostics);
    if (edges) checkMesh(geometry::wireObj(*edges));
    const Result<geometry::Mesh> map =
        geometry::parseShp(std::as_bytes(std::span(data, size)), "nowhere/a.shp");
    fuzz::checkMessages(map.diagnostics);
    if (map) checkMesh(*map);
    return 0;
}
