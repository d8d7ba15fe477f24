// Mesh: the vertices and indices of a shape as buffers (language, 12.7).

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/suggest.h"
#include "geometry/shapes/primitive.h"
#include "scene/classic/classic.h"
#include "scene/modern/modern.h"
#include "scene/primitives.h"
#include "scene/run/evaluate.h"
#include "scene/run/names.h"
#include "scene/run/statements.h"

namespace glibra::scene {
namespace {

/// A buffer of a mesh: its part of the name, its type, and what the attribute does not fill.
struct MeshPartRow {
    std::string_view name;
    const char* type;
    std::array<double, 4> missing;
};
constexpr MeshPartRow kMeshParts[] = {
    {geometry::kPosition, "vec4", {0, 0, 0, 1}}, {geometry::kNormal, "vec4", {0, 0, 0, 0}},
    {geometry::kTexCoord, "vec4", {0, 0, 0, 1}}, {geometry::kTangent, "vec4", {0, 0, 0, 0}},
    {geometry::kColor, "vec4", {1, 1, 1, 1}},    {geometry::kFaceIndex, "float", {0, 0, 0, 0}},
};
constexpr MeshPartRow kMeshIndex{"index", "uint", {0, 0, 0, 0}};

std::vector<double> elementsOf(const geometry::Attribute& attribute, const MeshPartRow& row) {
    const std::size_t taken = std::string_view(row.type) == "float" ? 1 : 4;
    const auto given = static_cast<std::size_t>(attribute.components);
    const std::size_t count = attribute.values.size() / given;
    std::vector<double> values(count * taken);
    for (std::size_t i = 0; i < count; ++i)
        for (std::size_t k = 0; k < taken; ++k)
            values[i * taken + k] =
                k < given ? static_cast<double>(attribute.values[i * given + k]) : row.missing.at(k);
    return values;
}

MeshContent contentOf(const geometry::Mesh& mesh) {
    MeshContent content;
    content.vertices = mesh.vertexCount();
    const int taken = std::max(1, geometry::verticesPerPrimitive(mesh.topology, mesh.patchVertices));
    content.primitives =
        (mesh.indices.size() - mesh.pointCount) / static_cast<std::size_t>(taken) + mesh.pointCount;
    for (const MeshPartRow& row : kMeshParts)
        if (const geometry::Attribute* attribute = mesh.attribute(row.name); attribute != nullptr)
            content.parts.push_back({std::string(row.name), row.type, elementsOf(*attribute, row)});
    content.parts.push_back({std::string(kMeshIndex.name), kMeshIndex.type,
                             std::vector<double>(mesh.indices.begin(), mesh.indices.end())});
    return content;
}

/// The shape that the statement names. Nothing with the reason reported.
std::optional<Shape> shapeOf(Interpreter& in, const Command& command) {
    const Value& word = command.values[1];
    const std::span<const Value> rest = std::span(command.values).subspan(2);
    const glib::CommandRow* const row = glib::findCommand(word.text);
    const bool isModel = row != nullptr && row->id == CommandId::obj;
    if (!isModel && (row == nullptr || glib::primitiveOf(row->id) == nullptr)) {
        std::vector<std::string_view> names{"Obj"};
        for (const geometry::PrimitiveSpec* each : geometry::primitives())
            names.push_back(each->names.front());
        return refuse(in, "glib-E16", command, word.position,
                      fmt::format("'{}' is no shape{}", word.text, base::suggestion(word.text, names)));
    }
    const bool hasFile = rest.size() == 1 &&
                         (rest.front().kind == Value::Kind::word || rest.front().kind == Value::Kind::text);
    if (hasFile != isModel)
        return refuse(in, "glib-E32", command, word.position,
                      isModel ? "Obj needs a file" : fmt::format("{} takes no file", word.text));
    Shape shape;
    shape.command = row->id;
    if (isModel) {
        shape.file = fileOf(in, rest.front().text, in.place(rest.front()));
        return shape;
    }
    Command made = command;
    made.id = row->id;
    made.word = word.text;
    const auto numbers = evaluatedNumbers(in, rest);
    if (!numbers) return std::nullopt;
    if (numbers->size() > row->arguments.size())
        return refuse(in, "glib-E26", command, rest.front().position,
                      fmt::format("{} takes at most {} numbers; the values here have {}", word.text,
                                  row->arguments.size(), numbers->size()));
    if (!fillNumbers(in, *row, *numbers, made)) return std::nullopt;
    shape.numbers = made.numbers;
    return shape;
}

/// Makes the mesh once for all frames. Null with the reason reported.
const MeshContent* meshOf(Interpreter& in, const Command& command, Shape shape) {
    std::string key = fmt::format("{}", static_cast<int>(shape.command));
    for (const double each : shape.numbers) key += fmt::format(" {}", each);
    if (shape.file) {
        const FileReference& file = in.scene.files[shape.file];
        key += "\n" + (file.path.empty() ? file.name : file.path.string());
    }
    const auto [known, isNew] = in.shared->computed.meshes.try_emplace(std::move(key));
    if (isNew) {
        if (const auto counts = countsOf(shape); counts && !countVertices(in, command, counts->vertices)) {
            in.shared->computed.meshes.erase(known);
            return nullptr;
        }
        Result<geometry::Mesh> mesh = makeMesh(in.scene, shareShape(in, std::move(shape)), true);
        for (const Diagnostic& each : mesh.diagnostics) in.report(each);
        if (mesh) known->second = contentOf(*mesh);
    }
    if (!known->second) ++in.problems;
    return known->second ? &*known->second : nullptr;
}

void doMesh(Interpreter& in, const Command& command) {
    const Value& target = command.values.front();
    if (!declareName(in, command, target.text, DeclaredName::Kind::mesh)) return;
    auto shape = shapeOf(in, command);
    if (!shape) return;
    const MeshContent* const mesh = meshOf(in, command, *std::move(shape));
    if (mesh == nullptr) return;
    Environment& names = in.names();
    if (!names.declareMesh(target.text)) {
        refuse(in, "glib-E36", command, target.position,
               fmt::format("'{}' has had another meaning in this scene", target.text));
        return;
    }
    names.setNumber(target.text + ".vertices", static_cast<double>(mesh->vertices));
    names.setNumber(target.text + ".primitives", static_cast<double>(mesh->primitives));
    for (const MeshContent::Part& each : mesh->parts) {
        Buffer buffer;
        buffer.name = target.text + "." + each.name;
        buffer.place = in.place(command);
        buffer.type = each.type;
        const bool isVector = buffer.type == "vec4";
        buffer.values = each.values;
        if (buffer.values.empty()) continue;  // of a shape without extent
        const std::size_t count = buffer.values.size() / (isVector ? 4 : 1);
        buffer.count = count;
        constexpr std::uint64_t kBytes = 4;
        if (!chargeTexels(in, command, buffer.values.size() * kBytes)) return;
        names.declareBuffer(buffer.name, isVector ? expression::Type::vector(4) : expression::Type::number());
        names.setNumber(buffer.name + ".count", static_cast<double>(count));
        std::string name = buffer.name;
        in.modern.names.insert_or_assign(std::move(name),
                                         DeclaredName{DeclaredName::Kind::buffer, in.place(command), &command,
                                                      in.scene.buffers.add(std::move(buffer))});
    }
}

}  // namespace

std::span<const CommandAction> meshActions() {
    static constexpr CommandAction kActions[] = {{CommandId::mesh, doMesh}};
    return kActions;
}

}  // namespace glibra::scene
