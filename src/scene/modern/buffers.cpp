// Buffers and compute programs (language, 12.7).

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string>
#include <string_view>
#include <utility>

#include "base/number.h"
#include "base/suggest.h"
#include "base/text.h"
#include "geometry/shapes/primitive.h"
#include "glib/number.h"
#include "glib/syntax.h"
#include "glib/text.h"
#include "scene/classic/classic.h"
#include "scene/modern/modern.h"
#include "scene/primitives.h"
#include "scene/run/evaluate.h"
#include "scene/run/names.h"
#include "scene/run/statements.h"
#include "scene/run/uniforms.h"
#include "scene/statement_words.h"

namespace glibra::scene {
namespace {

using expression::Type;

constexpr double kMostBufferElements = 1 << 30;
constexpr double kMostNumbers = 1 << 26;                           ///< that an expression gives a buffer
constexpr std::uint64_t kLargestBuffer = std::uint64_t{1} << 30U;  // bytes
constexpr double kMostGroups = 2'147'483'647;
constexpr int kMostTiles = 65'536;

// ---- Buffers.

struct BasicType {
    std::string_view name;
    Type type;
};
constexpr BasicType kBasicTypes[] = {
    {"float", Type::number()},  {"int", Type::number()},    {"uint", Type::number()},
    {"vec2", Type::vector(2)},  {"vec3", Type::vector(3)},  {"vec4", Type::vector(4)},
    {"ivec2", Type::vector(2)}, {"ivec3", Type::vector(3)}, {"ivec4", Type::vector(4)},
    {"uvec2", Type::vector(2)}, {"uvec3", Type::vector(3)}, {"uvec4", Type::vector(4)},
    {"mat2", Type::matrix(2)},  {"mat3", Type::matrix(3)},  {"mat4", Type::matrix(4)},
    {"double", Type::number()},
};

std::optional<Type> basicType(std::string_view name) {
    for (const BasicType& each : kBasicTypes)
        if (each.name == name) return each.type;
    return std::nullopt;
}

/// The values after the name: [type] [size] [values | expression | file].
struct Parts {
    const Value *type = nullptr, *size = nullptr, *content = nullptr;
};
Parts partsOf(const Command& command) {
    Parts parts;
    std::size_t at = 1;
    const auto& values = command.values;
    if (at < values.size() && values[at].kind == Value::Kind::word) parts.type = &values[at++];
    if (at < values.size() && isNumeric(values[at])) parts.size = &values[at++];
    if (at < values.size()) parts.content = &values[at];
    return parts;
}

/// True for a basic type of integers.
bool isOfIntegers(std::string_view type) {
    return basicType(type) && (type.starts_with('i') || type.starts_with('u'));
}

/// The components of an expression of `i` for each element. They are computed again only if what the
/// expression reads has changed.
std::optional<BufferValues> computedElements(Interpreter& in, const Value& value, int count, bool areWhole) {
    ComputedElements& known = in.shared->computed.elements[writtenAt(in, value)];
    const auto readsOf = [&](std::span<const Environment::Slot> slots) {
        std::vector<double> reads;
        for (const Environment::Slot slot : slots) {
            const std::vector<double> values = in.names().valuesOf(slot);
            reads.insert(reads.end(), values.begin(), values.end());
        }
        return reads;
    };
    using expression::Depends;
    if (known.isSteady && known.count == static_cast<std::size_t>(count) &&
        readsOf(known.slots) == known.reads) {
        addDepends(in, known.depends);
        return known.values;
    }
    std::vector<Environment::Slot> slots;
    in.around.readSlots = &slots;
    const Depends before = std::exchange(in.shared->depends, Depends::nothing);
    std::optional<BufferValues> values;
    if (value.kind == Value::Kind::expression)
        values = elementsLater(in, value, count, kMostNumbers, areWhole);
    else if (auto numbers = elementsOf(in, value, {&value, 1}, count, kMostNumbers))
        values = std::move(*numbers);
    in.around.readSlots = nullptr;
    known.depends = in.shared->depends;
    in.shared->depends = before | known.depends;
    if (!values) return std::nullopt;
    std::ranges::sort(slots);
    slots.erase(std::unique(slots.begin(), slots.end()), slots.end());
    // Only variables are compared, so the expression must read nothing else that changes.
    constexpr auto kOthers = Depends::time | Depends::tick | Depends::frame | Depends::window |
                             Depends::mouse | Depends::model | Depends::camera;
    known.isSteady = !any(known.depends & kOthers);
    known.count = static_cast<std::size_t>(count);
    known.reads = readsOf(slots);
    known.slots = std::move(slots);
    known.values = *values;
    return values;
}

/// Fills `values` or `file` from the content that the statement gives. False with the reason reported.
bool readContent(Interpreter& in, const Command& command, const Parts& parts, Buffer& buffer) {
    const Value& content = *parts.content;
    const auto type = basicType(buffer.type);
    const std::size_t components = type ? type->size() : 1;
    if (content.kind == Value::Kind::word || content.kind == Value::Kind::text) {
        buffer.file = fileOf(in, content.text, in.place(content));
        return true;
    }
    if (content.kind == Value::Kind::list) {
        auto numbers = listOf(in, content);
        if (!numbers) return false;
        buffer.values = std::move(*numbers);
        if (buffer.count && type && buffer.values.size() > *buffer.count * components) {
            refuse(in, "glib-E26", command, content.position,
                   fmt::format("{} numbers, but {} elements of {} have {}", buffer.values.size(),
                               *buffer.count, buffer.type, *buffer.count * components));
            return false;
        }
        if (type && buffer.values.size() % components != 0) {
            refuse(in, "glib-E26", command, content.position,
                   fmt::format("{} numbers do not fill {} elements, which have {} each", buffer.values.size(),
                               buffer.type, components));
            return false;
        }
        if (isOfIntegers(buffer.type))
            for (Diagnostic& each : reportFirstCut(buffer.values.numbers(), in.place(content)))
                in.report(std::move(each));
        return true;
    }
    const auto count = static_cast<int>(buffer.count.value_or(0));
    auto values = computedElements(in, content, count, isOfIntegers(buffer.type));
    if (!values) return false;
    if (type && values->size() != *buffer.count * components) {
        refuse(in, "glib-E26", command, content.position,
               fmt::format("an element of {} has {} components; the expression gives {}", buffer.type,
                           components, values->size() / *buffer.count));
        return false;
    }
    buffer.values = std::move(*values);
    buffer.isComputed = true;
    return true;
}

void doBuffer(Interpreter& in, const Command& command) {
    const Value& target = command.values.front();
    if (!declareName(in, command, target.text, DeclaredName::Kind::buffer)) return;
    const Parts parts = partsOf(command);
    Buffer buffer;
    buffer.name = target.text;
    buffer.place = in.place(command);
    buffer.hasHistory = command.key("history") != nullptr;
    if (parts.type != nullptr) buffer.type = parts.type->text;
    const auto type = basicType(buffer.type);
    if (!in.names().declareBuffer(buffer.name, type)) {
        refuse(in, "glib-E36", command, target.position,
               fmt::format("'{}' has had another meaning in this scene", buffer.name));
        return;
    }
    if (parts.size != nullptr) {
        const auto size = wholeOf(in, *parts.size);
        if (!size) return;
        if (!(*size >= 1 && *size <= kMostBufferElements)) {
            refuse(in, *size > kMostBufferElements ? "glib-E15" : "glib-E05", command, parts.size->position,
                   fmt::format("the count {} is not between 1 and {}", glib::numberText(*size),
                               base::groupedText(static_cast<long long>(kMostBufferElements))));
            return;
        }
        buffer.count = static_cast<std::uint64_t>(*size);
    }
    if (parts.content != nullptr && !readContent(in, command, parts, buffer)) return;
    // What a structure takes is known when its shader is read.
    constexpr std::uint64_t kBytes = 4;
    const std::size_t components = type ? type->size() : 1;
    const std::uint64_t numbers =
        std::max<std::uint64_t>(buffer.count.value_or(0) * components, buffer.values.size());
    if (numbers * kBytes > kLargestBuffer) {
        refuse(in, "glib-E15", command, command.position,
               fmt::format("'{}' needs {} bytes; the limit is {}", buffer.name,
                           base::groupedText(numbers * kBytes), base::groupedText(kLargestBuffer)));
        return;
    }
    if (!chargeTexels(in, command, numbers * kBytes * (buffer.hasHistory ? 2 : 1))) return;
    if (buffer.count)
        in.names().setNumber(buffer.name + ".count", static_cast<double>(*buffer.count));
    else if (type && !buffer.file)
        in.names().setNumber(buffer.name + ".count", static_cast<double>(buffer.values.size() / components));
    else
        in.names().forget(buffer.name + ".count", "it is known only when a file or a shader is read");
    setObject(in, target.text, in.scene.buffers.add(std::move(buffer)));
}

// ---- Compute.

void doCompute(Interpreter& in, const Command& command) {
    in.state.computeFile = command.text().empty()
                               ? inlineShader(in, command)
                               : fileOf(in, command.text(), in.script->place(command.textPosition()));
}

/// Three counts from 1 to 2^31 - 1; missing ones are 1.
std::optional<std::array<std::uint64_t, 3>> groupCounts(Interpreter& in, const Command& command,
                                                        std::span<const Value> values) {
    const auto numbers = wholesOf(in, values);
    if (!numbers) return std::nullopt;
    if (numbers->empty() || numbers->size() > 3)
        return refuse(in, "glib-E26", command, values.front().position,
                      fmt::format("needs 1 to 3 numbers; the values here have {}", numbers->size()));
    std::array<std::uint64_t, 3> counts{1, 1, 1};
    for (std::size_t i = 0; i < numbers->size(); ++i) {
        const double whole = (*numbers)[i];
        if (!(whole >= 1 && whole <= kMostGroups))
            return refuse(in, "glib-E05", command, values.front().position,
                          fmt::format("the count {} is not between 1 and {}", glib::numberText(whole),
                                      base::groupedText(static_cast<long long>(kMostGroups))));
        counts.at(i) = static_cast<std::uint64_t>(whole);
    }
    return counts;
}

std::optional<decltype(Dispatch::groups)> groupsOf(Interpreter& in, const Command& command) {
    if (command.key("from") != nullptr) {
        const auto first = countFrom(in, command);
        if (!first) return std::nullopt;
        return GroupsFrom{*first};
    }
    const KeyedValues* over = command.key("over");
    if (over == nullptr) {
        const auto counts = groupCounts(in, command, std::span(command.values).subspan(1));
        if (!counts) return std::nullopt;
        return *counts;
    }
    const Value& first = over->values.front();
    if (isWindow(first))
        return refuse(in, "glib-E34", command, first.position,
                      "'window' is not a texture; write 'over (window)' for one invocation per pixel");
    if (first.kind != Value::Kind::word) {
        const auto counts = groupCounts(in, command, over->values);
        if (!counts) return std::nullopt;
        return Over{*counts};
    }
    const auto object = objectNamed(in, first);
    if (!object) return std::nullopt;
    return Over{*object};
}

void doDispatch(Interpreter& in, const Command& command) {
    if (!isOutsidePass(in, command)) return;
    const auto program = programNamed(in, command.values.front(), true);
    const auto groups = groupsOf(in, command);
    if (!program || !groups) return;
    Dispatch made;
    if (const KeyedValues* tiles = command.key("tiles")) {
        const auto count = integerIn(in, tiles->values.front(), command.word + ": tiles", 1, kMostTiles);
        if (!count) return;
        if (std::holds_alternative<GroupsFrom>(*groups)) {
            refuse(in, "glib-E32", command, tiles->position,
                   "'tiles' needs a number of groups that is known before; write the counts, or 'over', in "
                   "place of 'from'");
            return;
        }
        made.tiles = *count;
    }
    made.discards = command.key("discard") != nullptr;
    made.place = in.place(command);
    made.id = nextDrawId(in, made.place);
    made.program = *program;
    made.slots = currentSlots(in);
    made.sampling = in.state.sampling;
    made.uniforms = uniformsOf(in, *program, command.tags);
    made.groups = *groups;
    made.timerPeriod = in.state.timerPeriod;
    in.out.implicitPass.reset();
    in.out.nodes->add(std::move(made));
}

}  // namespace

void doClearObject(Interpreter& in, const Command& command) {
    if (!isOutsidePass(in, command)) return;
    const Value& name = command.values.front();
    const auto object = objectNamed(in, name);
    if (!object) return;
    if (name.path.size() > 1) {
        refuse(in, "glib-E34", command, name.position,
               fmt::format("'{}' is part of an object; Clear takes all of it", name.text));
        return;
    }
    ClearObject clear{in.place(command), {}};
    if (const auto* view = std::get_if<TextureView>(&*object))
        clear.object = view->texture;
    else
        clear.object = std::get<BufferView>(*object).buffer;
    in.out.implicitPass.reset();
    in.out.nodes->add(std::move(clear));
}

std::optional<CountFrom> countFrom(Interpreter& in, const Command& command) {
    const auto buffer = bufferNamed(in, command.key("from")->values.front());
    const KeyedValues* at = command.key("at");
    if (!buffer || at == nullptr) return buffer ? std::optional(CountFrom{*buffer}) : std::nullopt;
    constexpr auto kMostWords = static_cast<double>(kLargestBuffer / sizeof(std::uint32_t));
    const auto word = wholeIn(in, at->values.front(), command.word + ": at", 0, kMostWords);
    if (!word) return std::nullopt;
    return CountFrom{*buffer, static_cast<std::uint64_t>(*word)};
}

// ---- Mesh.

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
    const glib::StatementRow* const row = glib::findCommand(word.text);
    const bool isModel = row != nullptr && row->id == CommandId::obj;
    if (!isModel && (row == nullptr || glib::primitiveOf(row->id) == nullptr)) {
        return refuse(
            in, "glib-E16", command, word.position,
            fmt::format("'{}' is no shape{}", word.text, base::suggestion(word.text, meshShapes())));
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
    if (numbers->size() > argumentsOf(*row).size())
        return refuse(in, "glib-E26", command, rest.front().position,
                      fmt::format("{} takes at most {} numbers; the values here have {}", word.text,
                                  argumentsOf(*row).size(), numbers->size()));
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
        key += "\n" + (file.path.empty() ? file.name : file.path.generic_string());
    }
    const auto [known, isNew] = in.shared->computed.meshes.try_emplace(std::move(key));
    if (isNew) {
        if (const auto counts = countsOf(shape); counts && !countVertices(in, command, counts->vertices)) {
            in.shared->computed.meshes.erase(known);
            return nullptr;
        }
        Result<geometry::Mesh> mesh = makeMesh(in.scene, shareShape(in, std::move(shape)), true);
        for (const Diagnostic& each : mesh.diagnostics) in.reportOnce(each);
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
    const glib::CommandId made = shape->command;
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
        buffer.meshOf = made;
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

std::vector<std::string_view> bufferTypes() {
    std::vector<std::string_view> names;
    for (const BasicType& each : kBasicTypes) names.push_back(each.name);
    return names;
}

std::vector<std::string_view> meshShapes() {
    std::vector<std::string_view> names{"Obj"};
    for (const geometry::PrimitiveSpec* each : geometry::primitives()) names.push_back(each->names.front());
    return names;
}

std::span<const CommandAction> bufferActions() {
    static constexpr CommandAction kActions[] = {
        {CommandId::mesh, doMesh},
        {CommandId::buffer, doBuffer},
        {CommandId::compute, doCompute},
        {CommandId::dispatch, doDispatch, InList::isWrong, true},
    };
    return kActions;
}

}  // namespace glibra::scene
