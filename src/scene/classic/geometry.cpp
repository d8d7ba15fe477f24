// Draws, and the state that decides how they are rasterised (language, 2.2, 3.3 and 11).

#include <fmt/format.h>

#include <cstring>
#include <string_view>
#include <utility>

#include "base/text.h"
#include "geometry/shapes/primitive.h"
#include "scene/classic/classic.h"
#include "scene/primitives.h"
#include "scene/run/camera_use.h"
#include "scene/run/statements.h"
#include "scene/run/uniforms.h"

namespace glibra::scene {
namespace {

std::uint64_t combine(std::uint64_t hash, std::uint64_t value) {
    hash ^= value + 0x9e3779b97f4a7c15U + (hash << 6U) + (hash >> 2U);
    return hash * 0xff51afd7ed558ccdU;
}

std::uint64_t hashOf(const geometry::Mesh& mesh) {
    std::uint64_t hash = static_cast<std::uint64_t>(mesh.topology);
    hash = combine(hash, static_cast<std::uint64_t>(mesh.patchVertices));
    for (const geometry::Attribute& each : mesh.attributes)
        for (const float value : each.values) {
            std::uint32_t bits = 0;
            std::memcpy(&bits, &value, sizeof bits);
            hash = combine(hash, bits);
        }
    return combine(hash, mesh.indices.size());
}

bool isSameMesh(const geometry::Mesh& a, const geometry::Mesh& b) {
    if (a.topology != b.topology || a.patchVertices != b.patchVertices || a.indices != b.indices ||
        a.attributes.size() != b.attributes.size())
        return false;
    for (std::size_t i = 0; i < a.attributes.size(); ++i) {
        const geometry::Attribute& x = a.attributes[i];
        const geometry::Attribute& y = b.attributes[i];
        if (x.name != y.name || x.components != y.components || x.values != y.values) return false;
    }
    return true;
}

/// A key that is equal for equal bindings.
std::vector<std::pair<std::string, std::vector<double>>> keyOfAttributes(const AttributeSet& set) {
    std::vector<std::pair<std::string, std::vector<double>>> key;
    for (const AttributeBinding& each : set.bindings) {
        std::string name = each.name + (each.isPerInstance ? " per instance" : "");
        std::vector<double> numbers;
        if (const auto* role = std::get_if<std::string>(&each.source)) {
            name += " as " + *role;
        } else if (const auto* given = std::get_if<std::vector<double>>(&each.source)) {
            numbers = *given;
        } else {
            const auto& view = std::get<BufferView>(each.source);
            name += view.isPrevious ? " previous buffer" : " buffer";
            name += fmt::format(" {} {} {}", each.part.member, each.part.offset, each.part.stride);
            numbers = {static_cast<double>(view.buffer.position())};
        }
        key.emplace_back(std::move(name), std::move(numbers));
    }
    return key;
}

/// Shapes that the view does not place as others.
void placeBySpace(Interpreter& in, Draw& made, CommandId command) {
    const geometry::PrimitiveSpec* spec = glib::primitiveOf(command);
    if (spec == nullptr || spec->space == geometry::Space::model) return;
    if (spec->space == geometry::Space::clip) {
        made.modelView = glm::dmat4(1);
        made.projection = in.scene.isModern ? coveringSpace(in, currentAspect(in)) : ClipSpace{};
        return;
    }
    made.isSky = true;
    made.modelView[3] = {0, 0, 0, 1};
    // Clipping at the near and far plane is off, and the depth is that of the far plane.
    made.raster.depthClamp = true;
    made.raster.depthNear = made.raster.depthFar;
}

}  // namespace

SlotTableIndex currentSlots(Interpreter& in) {
    if (!in.made.slotTable) in.made.slotTable = in.scene.slotTables.add(in.state.slots);
    return in.made.slotTable;
}

ShapeIndex shareShape(Interpreter& in, Shape shape) {
    std::string file;
    if (shape.file) {
        const FileReference& reference = in.scene.files[shape.file];
        file = reference.path.empty() ? "\n" + reference.name : reference.path.string();
    }
    if (shape.bare)
        file = fmt::format("\nvertices {} {}", static_cast<int>(*shape.bare),
                           shape.strip ? static_cast<int>(*shape.strip) : -1);
    ShapeIndex& index = in.made.shapes[{shape.command, shape.numbers, std::move(file)}];
    if (!index) index = in.scene.shapes.add(std::move(shape));
    return index;
}

AttributeSetIndex shareAttributes(Interpreter& in, AttributeSet set) {
    AttributeSetIndex& index = in.made.attributeSets[keyOfAttributes(set)];
    if (!index) index = in.scene.attributeSets.add(std::move(set));
    return index;
}

DrawId nextDrawId(Interpreter& in, const Place& place) {
    const int file = fileNumber(in);
    return {place.line, file, in.made.drawsOfLines[{file, place.line}]++};
}

ShapeIndex shapeOfMesh(Interpreter& in, CommandId command, geometry::Mesh mesh) {
    const std::uint64_t hash = hashOf(mesh);
    const auto [first, last] = in.made.listShapes.equal_range(hash);
    for (auto each = first; each != last; ++each) {
        const Shape& shape = in.scene.shapes[each->second];
        if (shape.command == command && isSameMesh(*shape.list, mesh)) return each->second;
    }
    const ShapeIndex index =
        in.scene.shapes.add({command, {}, {}, std::make_shared<const geometry::Mesh>(std::move(mesh))});
    in.made.listShapes.emplace(hash, index);
    return index;
}

bool countVertices(Interpreter& in, const Command& command, std::uint64_t vertices) {
    const auto refuse = [&](std::string_view what, std::uint64_t needed, std::uint64_t limit) {
        in.reportAt(command, "glib-E15",
                    fmt::format("{} {} {} vertices; the limit is {}", textOf(command), what,
                                base::groupedText(needed), base::groupedText(limit)));
        return false;
    };
    if (vertices > kMostCommandVertices) return refuse("needs", vertices, kMostCommandVertices);
    if (vertices > kMostSceneVertices - in.counts.vertices)
        return refuse("brings the scene to", in.counts.vertices + vertices, kMostSceneVertices);
    in.counts.vertices += vertices;
    return true;
}

void draw(Interpreter& in, const Command& command, const Drawing& drawing) {
    const State& state = in.state;
    if (in.around.block != nullptr && !in.around.pass) {
        currentPass(in, command);
        return;
    }
    for (const Command* each : state.local.rasterStatements) in.modern.rasterUsed.insert(each);
    Draw made;
    made.place = in.place(command);
    made.id = nextDrawId(in, made.place);
    made.word = drawing.word;
    made.shape = drawing.shape;
    made.program = state.program;
    made.color = drawing.color.value_or(state.color);
    made.raster = state.raster;
    made.raster.lineWidth = state.pointsAndLines.lineWidth;
    made.raster.pointSize = state.pointsAndLines.pointSize;
    made.raster.pointSizeFromShader = state.pointsAndLines.pointSizeFromShader;
    if (!in.around.pass && !state.local.isBlendStated)
        made.raster.blendAll(state.target.textures.empty() ? base::kBlendOver : base::Blend{});
    lookAt(in, made);
    placeBySpace(in, made, in.scene.shapes[drawing.shape].command);
    made.patchVertices = state.patchVertices;
    made.flatColors = state.flatColors;
    made.sampling = state.sampling;
    made.slots = currentSlots(in);
    made.uniforms = uniformsOf(in, state.program);
    made.timerPeriod = state.timerPeriod;
    made.givenNumbers = command.givenNumbers;
    made.instances = state.local.instances;
    made.instancesFrom = state.local.instancesFrom;
    made.verticesFrom = drawing.verticesFrom;
    made.indices = drawing.indices;
    made.drawsAllIndices = drawing.drawsAllIndices;
    made.attributes = state.local.attributes;
    made.tessellationLevels = state.local.tessellationLevels;
    if (in.scene.verbose) {
        const std::string program = state.program
                                        ? fmt::format("program '{}'", in.scene.programs[state.program].name)
                                        : "built-in program";
        in.report(
            diagnose("glib-N02", fmt::format("{}: {}, {}", drawing.word, drawing.size, program), made.place));
    }
    if (Pass* pass = currentPass(in, command)) pass->steps.emplace_back(std::move(made));
}

void doPrimitive(Interpreter& in, const Command& command) {
    Shape shape{command.id, command.numbers, {}, nullptr};
    const geometry::Counts counts = countsOf(shape).value_or(geometry::Counts{});
    if (!countVertices(in, command, counts.vertices)) return;
    std::string size;
    if (in.scene.verbose)
        size = fmt::format("{} vertices, {} {}", counts.vertices, counts.primitives,
                           geometry::wordsOf(topologyOf(command.id)));
    draw(in, command, {shareShape(in, std::move(shape)), command.word, size, {}});
}

namespace {

void doModel(Interpreter& in, const Command& command) {
    if (command.text.empty()) {
        const Place place = in.place(command);
        if (place.file == in.scene.path && in.scene.missingFiles.size() < glib::kMostMessages)
            in.scene.missingFiles.push_back({command.word, place, true});
        in.reportAt(command, "glib-E09",
                    fmt::format("{} needs a file name; only the interactive program works without one",
                                command.word));
        return;
    }
    Shape shape{command.id, {}, fileOf(in, command.text, in.script->place(command.textPosition)), nullptr};
    draw(in, command,
         {shareShape(in, std::move(shape)), command.word, fmt::format("'{}'", command.text), {}});
}

void doPointGroups(Interpreter& in, const Command& command) {
    if (!countVertices(in, command, command.points.size())) return;
    const bool isTriangles = command.id == CommandId::triangles;
    std::vector<std::array<double, 4>> points;
    points.reserve(command.points.size());
    for (const glib::PointGroup& each : command.points) {
        std::array<double, 4> point{0, 0, 0, 1};
        for (std::size_t i = 0; i < point.size() && i < each.values.size(); ++i) point[i] = each.values[i];
        points.push_back(point);
    }
    points.resize(points.size() - points.size() % (isTriangles ? 3 : 4));
    geometry::Mesh mesh =
        isTriangles ? geometry::trianglesList(points) : geometry::linesAdjacencyList(points);
    const std::string size =
        fmt::format("{} vertices, {} {}", points.size(), points.size() / (isTriangles ? 3 : 4),
                    geometry::wordsOf(mesh.topology));
    draw(in, command, {shapeOfMesh(in, command.id, std::move(mesh)), command.word, size, {}});
}

void doLineWidth(Interpreter& in, const Command& command) {
    if (!command.numbers.empty()) in.state.pointsAndLines.lineWidth = command.numbers[0];
}
void doPointSize(Interpreter& in, const Command& command) {
    if (!command.numbers.empty()) in.state.pointsAndLines.pointSize = command.numbers[0];
}
void doPointSizeMode(Interpreter& in, const Command& command) {
    in.state.pointsAndLines.pointSizeFromShader = command.numbers.empty() || command.numbers[0] != 0;
}
void doNumPatchVertices(Interpreter& in, const Command& command) {
    if (!command.numbers.empty()) in.state.patchVertices = static_cast<int>(command.numbers[0]);
}
void doFlat(Interpreter& in, const Command&) {
    in.state.flatColors = true;
}
void doSmooth(Interpreter& in, const Command&) {
    in.state.flatColors = false;
}

}  // namespace

std::span<const CommandAction> drawActions() {
    static constexpr CommandAction kActions[] = {
        {CommandId::obj, doModel, InList::goesFirst, true},
        {CommandId::wireObj, doModel, InList::goesFirst, true},
        {CommandId::objAdj, doModel, InList::goesFirst, true},
        {CommandId::objPatch, doModel, InList::goesFirst, true},
        {CommandId::shp, doModel, InList::goesFirst, true},
        {CommandId::linesAdjacency, doPointGroups, InList::goesFirst, true},
        {CommandId::triangles, doPointGroups, InList::goesFirst, true},
        {CommandId::lineWidth, doLineWidth},
        {CommandId::pointSize, doPointSize},
        {CommandId::pointSizeMode, doPointSizeMode},
        {CommandId::numPatchVertices, doNumPatchVertices},
        {CommandId::flat, doFlat},
        {CommandId::smooth, doSmooth},
    };
    return kActions;
}

}  // namespace glibra::scene
