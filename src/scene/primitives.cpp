#include "scene/primitives.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <exception>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include "geometry/obj/obj_mesh.h"
#include "geometry/obj/obj_model.h"
#include "geometry/obj/shapefile.h"
#include "geometry/shapes/arrow.h"
#include "geometry/shapes/box.h"
#include "geometry/shapes/clouds.h"
#include "geometry/shapes/cone.h"
#include "geometry/shapes/cylinder.h"
#include "geometry/shapes/disk.h"
#include "geometry/shapes/quads.h"
#include "geometry/shapes/soccerball.h"
#include "geometry/shapes/sphere.h"
#include "geometry/shapes/teapot.h"
#include "geometry/shapes/torus.h"
#include "glib/command_table.h"
#include "glib/number.h"
#include "image/file.h"

namespace glibra::scene {
namespace {

namespace geo = glibra::geometry;
using geo::Counts;
using geo::Mesh;
using geo::Topology;
using glib::CommandId;

/// The arguments of a shape in the order of the command's row in glib's table. Sizes and counts are limited
/// once more here, so that no script made by hand can ask a factory for what its contract excludes.
class Arguments {
  public:
    explicit Arguments(std::span<const double> numbers) : numbers_(numbers) {}

    [[nodiscard]] double number(std::size_t index) const {
        return index < numbers_.size() ? numbers_[index] : 0;
    }
    [[nodiscard]] double size(std::size_t index) const { return std::abs(number(index)); }
    [[nodiscard]] int count(std::size_t index, int least = 1) const {
        constexpr double kMost = kMostCommandVertices;
        return static_cast<int>(std::clamp(number(index), static_cast<double>(least), kMost));
    }
    /// A count that no scene states; `fixed` is the language's.
    [[nodiscard]] int count(std::size_t index, int least, int fixed) const {
        return index < numbers_.size() ? count(index, least) : fixed;
    }
    [[nodiscard]] std::uint32_t seed(std::size_t index) const {
        return static_cast<std::uint32_t>(
            static_cast<std::int64_t>(std::clamp(number(index), -0x1p31, 0x1p32 - 1)));
    }

  private:
    std::span<const double> numbers_;
};
using A = const Arguments&;

/// `zeroes` has a bit for each argument that is a size: with a zero there the shape draws nothing.
struct PrimitiveRow {
    CommandId command;
    Topology topology;
    unsigned zeroes;
    Counts (*counts)(A);
    Mesh (*make)(A);
};

constexpr unsigned kNone3 = 0, kFirst = 1, kSecond = 2, kFirstTwo = 3, kFirstThree = 7;

constexpr PrimitiveRow kPrimitives[] = {
    {CommandId::box, Topology::triangles, kFirstThree, [](A) { return geo::boxCounts(); },
     [](A a) { return geo::box(a.size(0), a.size(1), a.size(2)); }},
    {CommandId::sphere, Topology::triangles, kFirst,
     [](A a) { return geo::sphereCounts(a.count(1, 3), a.count(2, 2)); },
     [](A a) { return geo::sphere(a.size(0), a.count(1, 3), a.count(2, 2)); }},
    {CommandId::cylinder, Topology::triangles, kFirstTwo,
     [](A a) { return geo::cylinderCounts(a.count(2, 3), a.count(3)); },
     [](A a) { return geo::cylinder(a.size(0), a.size(1), a.count(2, 3), a.count(3)); }},
    {CommandId::cone, Topology::triangles, kFirstTwo,
     [](A a) { return geo::coneCounts(a.count(2, 3), a.count(3)); },
     [](A a) { return geo::cone(a.size(0), a.size(1), a.count(2, 3), a.count(3)); }},
    {CommandId::torus, Topology::triangles, kFirstTwo,
     [](A a) { return geo::torusCounts(a.count(2, 3), a.count(3, 3)); },
     [](A a) { return geo::torus(a.size(0), a.size(1), a.count(2, 3), a.count(3, 3)); }},
    {CommandId::teapot, Topology::triangles, kNone3, [](A a) { return geo::teapotCounts(a.count(0, 2, 16)); },
     [](A a) { return geo::teapot(a.count(0, 2, 16)); }},
    {CommandId::soccerball, Topology::triangles, kFirst,
     [](A a) { return geo::soccerballCounts(a.count(1, 1, 8)); },
     [](A a) { return geo::soccerball(a.size(0), a.count(1, 1, 8)); }},
    {CommandId::diskXY, Topology::triangles, kSecond,
     [](A a) { return geo::diskXYCounts(a.count(2, 3), a.count(3)); },
     [](A a) { return geo::diskXY(a.number(0), a.size(1), a.count(2, 3), a.count(3)); }},
    {CommandId::quadXY, Topology::triangles, kSecond,
     [](A a) { return geo::quadCounts(a.count(2), a.count(3)); },
     [](A a) { return geo::quadXY(a.number(0), a.size(1), a.count(2), a.count(3)); }},
    {CommandId::quadXZ, Topology::triangles, kSecond,
     [](A a) { return geo::quadCounts(a.count(2), a.count(3)); },
     [](A a) { return geo::quadXZ(a.number(0), a.size(1), a.count(2), a.count(3)); }},
    {CommandId::quadYZ, Topology::triangles, kSecond,
     [](A a) { return geo::quadCounts(a.count(2), a.count(3)); },
     [](A a) { return geo::quadYZ(a.number(0), a.size(1), a.count(2), a.count(3)); }},
    {CommandId::quadBox, Topology::triangles, kNone3, [](A a) { return geo::quadBoxCounts(a.count(0)); },
     [](A a) { return geo::quadBox(a.count(0)); }},
    {CommandId::xarrow, Topology::triangles, kNone3,
     [](A a) { return geo::xarrowCounts(a.count(0, 2), a.count(1, 3, 24)); },
     [](A a) { return geo::xarrow(a.count(0, 2), a.count(1, 3, 24)); }},
    {CommandId::pointCloud, Topology::points, kNone3,
     [](A a) { return geo::cloudCounts(a.count(0), a.count(1), a.count(2)); },
     [](A a) { return geo::pointCloud(a.count(0), a.count(1), a.count(2)); }},
    {CommandId::jitterCloud, Topology::points, kNone3,
     [](A a) { return geo::cloudCounts(a.count(0), a.count(1), a.count(2)); },
     [](A a) { return geo::jitterCloud(a.count(0), a.count(1), a.count(2), a.seed(3)); }},
    {CommandId::wireSphere, Topology::lines, kFirst,
     [](A a) { return geo::wireSphereCounts(a.count(1, 3), a.count(2, 2)); },
     [](A a) { return geo::wireSphere(a.size(0), a.count(1, 3), a.count(2, 2)); }},
    {CommandId::wireTorus, Topology::lines, kFirstTwo,
     [](A a) { return geo::wireTorusCounts(a.count(2, 3), a.count(3, 3)); },
     [](A a) { return geo::wireTorus(a.size(0), a.size(1), a.count(2, 3), a.count(3, 3)); }},
    {CommandId::wireCylinder, Topology::lines, kFirstTwo,
     [](A a) { return geo::wireCylinderCounts(a.count(2, 3), a.count(3)); },
     [](A a) { return geo::wireCylinder(a.size(0), a.size(1), a.count(2, 3), a.count(3)); }},
    {CommandId::wireCone, Topology::lines, kFirstTwo,
     [](A a) { return geo::wireConeCounts(a.count(2, 3), a.count(3)); },
     [](A a) { return geo::wireCone(a.size(0), a.size(1), a.count(2, 3), a.count(3)); }},
    {CommandId::wireCube, Topology::lines, kFirst, [](A) { return geo::wireBoxCounts(); },
     [](A a) { return geo::wireBox(a.size(0), a.size(0), a.size(0)); }},
    {CommandId::wireBox, Topology::lines, kFirstThree, [](A) { return geo::wireBoxCounts(); },
     [](A a) { return geo::wireBox(a.size(0), a.size(1), a.size(2)); }},
    {CommandId::wireTeapot, Topology::lines, kNone3, [](A) { return geo::wireTeapotCounts(); },
     [](A) { return geo::wireTeapot(); }},
};

const PrimitiveRow* rowOf(CommandId command) {
    const auto* row = std::find_if(std::begin(kPrimitives), std::end(kPrimitives),
                                   [&](const PrimitiveRow& each) { return each.command == command; });
    return row == std::end(kPrimitives) ? nullptr : row;
}

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

/// The content of a model file as a mesh.
Result<Mesh> parseModel(CommandId command, std::vector<std::byte> bytes, const std::string& path,
                        bool withTangents) {
    if (command == CommandId::shp) return geo::parseShp(bytes, path);
    const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    Result<geo::ObjModel> model = geo::parseObj(text, path);
    if (!model) return std::move(model.diagnostics);
    std::vector<std::byte>().swap(bytes);  // a large text need not stand beside the mesh
    return {objMesh(command, *model, withTangents), std::move(model.diagnostics)};
}

Result<Mesh> readModel(const Shape& shape, const FileReference& file, bool withTangents) {
    Diagnostics diagnostics = file.remarks;
    if (file.path.empty()) return diagnostics;
    auto bytes = image::readFile(file.path, {file.name, file.place}, geo::kLargestModelFile);
    append(diagnostics, bytes.diagnostics);
    if (!bytes) return diagnostics;
    Result<Mesh> mesh = parseModel(shape.command, std::move(*bytes), file.path.string(), withTangents);
    append(diagnostics, std::move(mesh.diagnostics));
    if (!mesh) return diagnostics;
    if (mesh->vertexCount() > kMostCommandVertices) {
        diagnostics.push_back(
            error("glib-E15",
                  fmt::format("{} '{}' needs {} vertices; the limit is {}", glib::nameOf(shape.command),
                              file.name, glib::groupedText(static_cast<long long>(mesh->vertexCount())),
                              glib::groupedText(static_cast<long long>(kMostCommandVertices))),
                  file.place));
        return diagnostics;
    }
    mesh.diagnostics = std::move(diagnostics);
    return mesh;
}

Mesh primitiveMesh(const PrimitiveRow& row, const Shape& shape) {
    const Arguments arguments(shape.numbers);
    // Larger ones are refused by interpret; a script made by hand gets nothing for them.
    if (!drawsNothing(shape) && row.counts(arguments).vertices <= kMostCommandVertices)
        return row.make(arguments);
    Mesh nothing;
    nothing.topology = row.topology;
    return nothing;
}

}  // namespace

bool isPrimitive(CommandId command) {
    return rowOf(command) != nullptr;
}

Topology topologyOf(CommandId command) {
    if (const PrimitiveRow* row = rowOf(command)) return row->topology;
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
    return shape.list ? shape.list->topology : topologyOf(shape.command);
}

bool drawsNothing(const Shape& shape) {
    if (shape.list) return shape.list->indices.empty();
    const PrimitiveRow* row = rowOf(shape.command);
    if (row == nullptr) return false;
    const Arguments arguments(shape.numbers);
    for (std::size_t i = 0; i < 3; ++i)
        if ((row->zeroes >> i & 1U) != 0 && arguments.number(i) == 0) return true;
    return false;
}

std::optional<Counts> countsOf(const Shape& shape) {
    if (shape.list) {
        const int taken =
            std::max(1, geo::verticesPerPrimitive(shape.list->topology, shape.list->patchVertices));
        return Counts{shape.list->vertexCount(),
                      shape.list->indices.size() / static_cast<std::size_t>(taken)};
    }
    const PrimitiveRow* row = rowOf(shape.command);
    if (row == nullptr) return std::nullopt;
    if (drawsNothing(shape)) return Counts{};
    return row->counts(Arguments(shape.numbers));
}

Result<Mesh> makeMesh(const Scene& scene, ShapeIndex shape, bool withTangents) {
    const Shape& wanted = scene.shapes[shape];
    if (wanted.list) return *wanted.list;
    const Place place = wanted.file ? scene.files[wanted.file].place : Place{scene.path, 1, 1};
    try {
        const PrimitiveRow* row = rowOf(wanted.command);
        if (row != nullptr) return primitiveMesh(*row, wanted);
        if (wanted.file) return readModel(wanted, scene.files[wanted.file], withTangents);
        return error("glib-E09", fmt::format("{} without a file name", glib::nameOf(wanted.command)), place);
    } catch (const std::exception& problem) {
        return error("draw-E05", fmt::format("a mesh cannot be made: {}", problem.what()), place);
    }
}

}  // namespace glibra::scene
