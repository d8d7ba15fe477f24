// Draws, and the state that decides how they are rasterised (language, 2.2, 3.3 and 11).

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <string_view>
#include <utility>

#include "base/hash.h"
#include "base/text.h"
#include "geometry/shapes/primitive.h"
#include "scene/classic/classic.h"
#include "scene/primitives.h"
#include "scene/run/camera_use.h"
#include "scene/run/statements.h"
#include "scene/run/uniforms.h"

namespace glibra::scene {
namespace {

std::uint64_t hashOf(const geometry::Mesh& mesh) {
    std::uint64_t hash = static_cast<std::uint64_t>(mesh.topology);
    hash = base::combined(hash, static_cast<std::uint64_t>(mesh.patchVertices));
    for (const geometry::Attribute& each : mesh.attributes)
        for (const float value : each.values) {
            std::uint32_t bits = 0;
            std::memcpy(&bits, &value, sizeof bits);
            hash = base::combined(hash, bits);
        }
    return base::combined(hash, mesh.indices.size());
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
void placeBySpace(Interpreter& in, Draw& made, RasterState& raster, CommandId command) {
    const geometry::PrimitiveSpec* spec = glib::primitiveOf(command);
    if (spec == nullptr || spec->space == geometry::Space::model) return;
    if (spec->space == geometry::Space::clip) {
        made.modelView = glm::dmat4(1);
        shareProjection(in, made,
                        in.scene.suppliesNames ? coveringSpace(in, currentAspect(in)) : ClipSpace{});
        return;
    }
    made.isSky = true;
    made.modelView[3] = {0, 0, 0, 1};
    // Clipping at the near and far plane is off, and the depth is that of the far plane.
    raster.depthClamp = true;
    raster.depthNear = raster.depthFar;
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
        file = reference.path.empty() ? "\n" + reference.name : reference.path.generic_string();
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
                    fmt::format("{} {} {} vertices; the limit is {}",
                                glib::primitiveOf(command.id) != nullptr ? textOf(command) : command.word,
                                what, base::groupedText(needed), base::groupedText(limit)));
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
    RasterState raster = state.raster;
    raster.lineWidth = state.pointsAndLines.lineWidth;
    raster.pointSize = state.pointsAndLines.pointSize;
    raster.pointSizeFromShader = state.pointsAndLines.pointSizeFromShader;
    if (!in.around.pass && !state.local.isBlendStated)
        raster.blendAll(state.target.textures.empty() ? base::kBlendOver : base::Blend{});
    lookAt(in, made, raster);
    placeBySpace(in, made, raster, in.scene.shapes[drawing.shape].command);
    if (in.around.pass && in.out.nodes->passes[in.around.pass->index].isReversed)
        raster.depthOrder = std::holds_alternative<ClipSpace>(*made.projection)
                                ? base::DepthOrder::reversedCover
                                : base::DepthOrder::reversed;
    made.raster = in.made.raster = raster;
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
    if (command.text().empty()) {
        const Place place = in.place(command);
        if (place.file == in.scene.path && in.scene.missingFiles.size() < glib::kMostMessages)
            in.scene.missingFiles.push_back({command.word, place, true});
        in.reportAt(command, "glib-E09",
                    fmt::format("{} needs a file name; only the interactive program works without one",
                                command.word));
        return;
    }
    Shape shape{
        command.id, {}, fileOf(in, command.text(), in.script->place(command.textPosition())), nullptr};
    draw(in, command,
         {shareShape(in, std::move(shape)), command.word, fmt::format("'{}'", command.text()), {}});
}

void doPointGroups(Interpreter& in, const Command& command) {
    const bool isTriangles = command.id == CommandId::triangles;
    std::vector<std::array<double, 4>> points(command.numbers.size() / 4);
    if (!countVertices(in, command, points.size())) return;
    for (std::size_t i = 0; i < points.size(); ++i)
        std::copy_n(command.numbers.begin() + static_cast<std::ptrdiff_t>(4 * i), 4, points[i].begin());
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

// ---- Lists of vertices.

/// True if a list is open. Otherwise reports glib-E07, but only once for consecutive statements.
bool isInside(Interpreter& in, const Command& command) {
    if (in.list) return true;
    if (!in.isOrphan)
        in.reportAt(command, "glib-E07", fmt::format("{} outside glBegin ... glEnd", command.word));
    in.isOrphan = true;
    return false;
}

template <std::size_t N>
void copy(const Command& command, std::array<double, N>& values) {
    for (std::size_t i = 0; i < N && i < command.numbers.size(); ++i) values[i] = command.numbers[i];
}

/// The name of the topology's primitives, for messages.
std::string_view primitiveOf(geometry::ListTopology topology) {
    using geometry::ListTopology;
    switch (topology) {
        case ListTopology::points:
            return "point";
        case ListTopology::lines:
        case ListTopology::lineStrip:
        case ListTopology::lineLoop:
            return "line";
        case ListTopology::quads:
        case ListTopology::quadStrip:
            return "quad";
        case ListTopology::polygon:
            return "polygon";
        case ListTopology::linesAdjacency:
        case ListTopology::lineStripAdjacency:
            return "line with adjacency";
        case ListTopology::trianglesAdjacency:
        case ListTopology::triangleStripAdjacency:
            return "triangle with adjacency";
        case ListTopology::patches:
            return "patch";
        case ListTopology::triangles:
        case ListTopology::triangleStrip:
        case ListTopology::triangleFan:
            break;
    }
    return "triangle";
}

void doGlBegin(Interpreter& in, const Command& command) {
    const auto topology = geometry::listTopology(command.text());
    if (!topology) {
        in.reportAt(command, "glib-E08", fmt::format("unknown topology '{}'", command.text()));
        return;
    }
    OpenList list;
    list.topology = *topology;
    list.word = command.text();
    list.place = in.place(command);
    for (int i = 0; i < 4; ++i) list.current.color[static_cast<std::size_t>(i)] = in.state.color[i];
    in.list = std::move(list);
}

void doGlVertex(Interpreter& in, const Command& command) {
    if (!isInside(in, command)) return;
    OpenList& list = *in.list;
    if (list.vertices.size() >= kMostListVertices) {
        if (!list.isFull)
            in.reportAt(command, "glib-E15",
                        fmt::format("glBegin: a list holds at most {} vertices",
                                    base::groupedText(kMostListVertices)));
        list.isFull = true;
        return;
    }
    geometry::ListVertex vertex = list.current;
    copy(command, vertex.position);
    list.vertices.push_back(vertex);
    for (auto& [name, extra] : list.extras) {
        extra.values.resize(list.vertices.size() - 1, extra.before);
        extra.values.push_back(extra.current);
    }
}

void doGlNormal(Interpreter& in, const Command& command) {
    if (!isInside(in, command)) return;
    copy(command, in.list->current.normal);
    in.list->hasNormals = true;
}

void doGlColor(Interpreter& in, const Command& command) {
    if (isInside(in, command)) copy(command, in.list->current.color);
}

void doGlTexCoord(Interpreter& in, const Command& command) {
    if (isInside(in, command)) copy(command, in.list->current.texCoord);
}

void doGlEnd(Interpreter& in, const Command& command) {
    if (!isInside(in, command)) return;
    const OpenList list = std::move(*in.list);
    in.list.reset();
    if (list.isFull || !countVertices(in, command, list.vertices.size())) return;
    geometry::ListMesh made =
        geometry::meshFromList(list.topology, list.vertices, list.hasNormals, in.state.patchVertices);
    const std::string_view primitive = primitiveOf(list.topology);
    if (made.mesh.indices.empty()) {
        in.reportAt(
            command, "glib-E07",
            fmt::format("glEnd: {} vertices are not enough for one {}", list.vertices.size(), primitive));
        return;
    }
    if (made.dropped > 0)
        in.reportAt(command, "glib-W33",
                    fmt::format("glEnd: {} of an incomplete {} ignored",
                                base::counted(made.dropped, "vertex", "vertices"), primitive));
    AttributeSet outer;
    if (in.state.local.attributes) outer = in.scene.attributeSets[in.state.local.attributes];
    for (const auto& [name, extra] : list.extras) {
        std::erase_if(outer.bindings, [&](const AttributeBinding& each) { return each.name == name; });
        geometry::Attribute attribute{name, extra.components, {}};
        for (std::size_t i = 0; i < list.vertices.size(); ++i) {
            const std::array<double, 4>& values = i < extra.values.size() ? extra.values[i] : extra.before;
            for (std::size_t k = 0; k < static_cast<std::size_t>(extra.components); ++k)
                attribute.values.push_back(static_cast<float>(values[k]));
        }
        std::erase_if(made.mesh.attributes, [&](const auto& other) { return other.name == name; });
        made.mesh.attributes.push_back(std::move(attribute));
    }
    Drawing drawing;
    drawing.word = list.word;
    drawing.size = fmt::format("{} vertices", list.vertices.size());
    if (made.color)
        drawing.color = glm::dvec4((*made.color)[0], (*made.color)[1], (*made.color)[2], (*made.color)[3]);
    drawing.shape = shapeOfMesh(in, CommandId::glBegin, std::move(made.mesh));
    const AttributeSetIndex attributes = in.state.local.attributes;
    if (attributes && !list.extras.empty()) in.state.local.attributes = shareAttributes(in, std::move(outer));
    draw(in, command, drawing);
    in.state.local.attributes = attributes;
}

}  // namespace

void checkList(Interpreter& in) {
    if (in.list) in.report(diagnose("glib-E07", "glBegin without glEnd", in.list->place));
}

std::span<const CommandAction> drawActions() {
    static constexpr CommandAction kActions[] = {
        {CommandId::glBegin, doGlBegin, InList::isWrong},
        {CommandId::glVertex, doGlVertex, InList::isPart},
        {CommandId::glNormal, doGlNormal, InList::isPart},
        {CommandId::glColor, doGlColor, InList::isPart},
        {CommandId::glTexCoord, doGlTexCoord, InList::isPart},
        {CommandId::glEnd, doGlEnd, InList::isPart, true},
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
