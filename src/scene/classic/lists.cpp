// glBegin ... glEnd (language, 4.7).

#include <fmt/format.h>

#include <array>
#include <string_view>

#include "base/text.h"
#include "scene/classic/classic.h"
#include "scene/primitives.h"

namespace glibra::scene {
namespace {

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
    const auto topology = geometry::listTopology(command.text);
    if (!topology) {
        in.reportAt(command, "glib-E08", fmt::format("unknown topology '{}'", command.text));
        return;
    }
    OpenList list;
    list.topology = *topology;
    list.word = command.text;
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

std::span<const CommandAction> listActions() {
    static constexpr CommandAction kActions[] = {
        {CommandId::glBegin, doGlBegin, InList::isWrong},
        {CommandId::glVertex, doGlVertex, InList::isPart},
        {CommandId::glNormal, doGlNormal, InList::isPart},
        {CommandId::glColor, doGlColor, InList::isPart},
        {CommandId::glTexCoord, doGlTexCoord, InList::isPart},
        {CommandId::glEnd, doGlEnd, InList::isPart, true},
    };
    return kActions;
}

void checkList(Interpreter& in) {
    if (in.list) in.report(diagnose("glib-E07", "glBegin without glEnd", in.list->place));
}

}  // namespace glibra::scene
