// Instances, Vertices, Attribute and TessLevels (language, 12.6).

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string>

#include "base/suggest.h"
#include "geometry/list_mesh.h"
#include "glib/statement_table.h"
#include "glib/text.h"
#include "scene/classic/classic.h"
#include "scene/count_limits.h"
#include "scene/modern/modern.h"
#include "scene/primitives.h"
#include "scene/run/evaluate.h"
#include "scene/run/names.h"
#include "scene/statement_words.h"

namespace glibra::scene {
namespace {

void doInstances(Interpreter& in, const Command& command) {
    LocalState& local = in.state.local;
    if (command.key("from") != nullptr) {
        if (const auto count = countFrom(in, command)) local.instancesFrom = *count;
        return;
    }
    const auto count = integerIn(in, command.values.front(), "Instances:", 0, kMostInstances);
    if (!count) return;
    local.instances = *count;
    local.instancesFrom = {};
}

/// How many elements the buffer has, as far as its declaration says it. Only `int` and `uint` count.
std::optional<std::uint64_t> declaredIndices(const Buffer& buffer) {
    if (buffer.count) return buffer.count;
    return buffer.file || buffer.type.empty() ? std::nullopt
                                              : std::optional<std::uint64_t>(buffer.values.size());
}

/// The buffer after the key `indices`. `wanted`: how many of its elements are drawn, if the statement says
/// it.
std::optional<BufferView> indexBuffer(Interpreter& in, const Command& command, const KeyedValues& key,
                                      std::optional<int> wanted) {
    const Value& name = key.values.front();
    const auto view = bufferNamed(in, name);
    if (!view) return std::nullopt;
    const Buffer& buffer = in.scene.buffers[view->buffer];
    if (!buffer.type.empty() && buffer.type != "uint" && buffer.type != "int")
        return refuse(in, "glib-E33", command, name.position,
                      fmt::format("'{}' holds {}, but indices are uint or int", name.text, buffer.type));
    const auto count = declaredIndices(buffer);
    if (count && wanted && static_cast<std::uint64_t>(*wanted) > *count)
        return refuse(in, "glib-E05", command, command.values.at(1).position,
                      fmt::format("{} indices are more than the {} of '{}'", *wanted, *count, name.text));
    return view;
}

void doVertices(Interpreter& in, const Command& command) {
    const auto words = geometry::kListTopologyWords;
    const auto index = wordOf(in, command.values.front(), words);
    if (!index) return;
    const std::string_view word = words[*index];
    const auto topology = geometry::listTopology(word);
    if (!topology) return;
    Shape shape;
    shape.command = CommandId::vertices;
    shape.bare = geometry::meshTopology(*topology);
    switch (*topology) {
        case geometry::ListTopology::points:
        case geometry::ListTopology::lines:
        case geometry::ListTopology::triangles:
        case geometry::ListTopology::linesAdjacency:
        case geometry::ListTopology::trianglesAdjacency:
        case geometry::ListTopology::patches:
            break;
        case geometry::ListTopology::quads:
            in.reportAt(command.values.front(), "glib-E32",
                        fmt::format("Vertices: there are no {0} without data; write triangles, or "
                                    "'Instances n' and triangle_strip 4",
                                    word));
            return;
        default:
            shape.strip = *topology;
    }
    const KeyedValues* from = command.key("from");
    const KeyedValues* indices = command.key("indices");
    Drawing drawing;
    std::optional<int> count;
    if (from != nullptr) {
        const auto counted = countFrom(in, command);
        if (!counted) return;
        drawing.verticesFrom = *counted;
    } else if (command.values.size() > 1) {
        count = integerIn(in, command.values[1], "Vertices:", 0, kMostVertices);
        if (!count) return;
    }
    if (indices != nullptr) {
        const auto buffer = indexBuffer(in, command, *indices, count);
        if (!buffer) return;
        drawing.indices = *buffer;
        drawing.drawsAllIndices = from == nullptr && !count;
    }
    shape.numbers = {static_cast<double>(count.value_or(0))};
    drawing.word = command.word;
    drawing.size = count ? fmt::format("{} {}", *count, word) : "as many vertices as the buffer says";
    drawing.shape = shareShape(in, std::move(shape));
    draw(in, command, drawing);
}

/// The mesh attribute of a role, in any case.
std::optional<std::string> roleNamed(Interpreter& in, const Value& value) {
    for (const std::string_view each : kAttributeRoles)
        if (glib::sameWord(each, value.text)) return std::string(each);
    const std::string hint = base::suggestion(value.text, kAttributeRoles);
    return in.reportAt(
        value, "glib-E16",
        fmt::format(
            "Attribute: there is no role '{}'{}", value.text,
            hint.empty() ? fmt::format("; the roles are {}", fmt::join(kAttributeRoles, ", ")) : hint));
}

void bind(Interpreter& in, AttributeBinding binding) {
    AttributeSet set;
    if (in.state.local.attributes) set = in.scene.attributeSets[in.state.local.attributes];
    std::erase_if(set.bindings, [&](const AttributeBinding& each) { return each.name == binding.name; });
    set.bindings.push_back(std::move(binding));
    in.state.local.attributes = shareAttributes(in, std::move(set));
}

/// The binding that holds before the list that is open; null if there is none.
const AttributeBinding* outerBinding(const Interpreter& in, const std::string& name) {
    if (!in.state.local.attributes) return nullptr;
    const auto& bindings = in.scene.attributeSets[in.state.local.attributes].bindings;
    const auto found = std::ranges::find(bindings, name, &AttributeBinding::name);
    return found == bindings.end() ? nullptr : &*found;
}

/// Attribute with numbers between glBegin and glEnd.
void setInList(Interpreter& in, const Command& command, const std::string& name,
               const std::vector<double>& numbers) {
    auto [extra, isNew] = in.list->extras.try_emplace(name);
    OpenList::Extra& values = extra->second;
    if (const AttributeBinding* outer = isNew ? outerBinding(in, name) : nullptr) {
        const auto* same = std::get_if<std::vector<double>>(&outer->source);
        if (same == nullptr && !in.list->vertices.empty()) {
            in.reportAt(
                command, "glib-E32",
                fmt::format("Attribute {}: the vertices before have it from line {}; state it before the "
                            "first glVertex, too",
                            name, outer->place.line));
            return;
        }
        if (same != nullptr) {
            std::copy(same->begin(), same->end(), values.before.begin());
            values.components = static_cast<int>(same->size());
        }
    }
    values.components = std::max(values.components, static_cast<int>(numbers.size()));
    values.current = {0, 0, 0, 1};
    std::ranges::copy(numbers, values.current.begin());
}

/// `offset` and `stride`. Nothing with the reason reported.
bool readBytes(Interpreter& in, const Command& command, ElementPart& part) {
    constexpr double kMostBytes = 1 << 30;
    for (const char* word : {"offset", "stride"}) {
        const KeyedValues* key = command.key(word);
        if (key == nullptr) continue;
        const bool isOffset = *word == 'o';
        const auto bytes = wholeIn(in, key->values.front(), fmt::format("Attribute: {}", word),
                                   isOffset ? 0 : 4, kMostBytes);
        if (!bytes) return false;
        const auto whole = static_cast<std::uint64_t>(*bytes);
        if (whole % 4 != 0) {
            refuse(in, "glib-E05", command, key->position,
                   fmt::format("{} counts bytes and is a multiple of 4, because numbers have 4 bytes", word));
            return false;
        }
        (isOffset ? part.offset : part.stride) = whole;
    }
    return true;
}

void doAttribute(Interpreter& in, const Command& command) {
    AttributeBinding binding;
    binding.name = command.values.front().text;
    binding.place = in.place(command);
    const std::span<const Value> values = std::span(command.values).subspan(1);
    if (const KeyedValues* as = command.key("as")) {
        auto role = roleNamed(in, as->values.front());
        if (!role) return;
        binding.source = std::move(*role);
        return bind(in, std::move(binding));
    }
    if (!values.empty() && values.front().kind == Value::Kind::word) {
        Value name = values.front();
        const auto member = takeMember(in, name, "Attribute");
        const auto buffer = member ? bufferNamed(in, name) : std::nullopt;
        if (!buffer || !readBytes(in, command, binding.part)) return;
        binding.source = *buffer;
        binding.part.member = *member;
        binding.isPerInstance = command.key("per") != nullptr || command.key("instance") != nullptr;
        if (in.list) {
            in.reportAt(command, "glib-E07", "Attribute: a vertex of a list takes numbers, not a buffer");
            return;
        }
        return bind(in, std::move(binding));
    }
    const auto numbers = floatsOf(in, values);
    if (!numbers) return;
    if (numbers->empty() || numbers->size() > 4) {
        in.reportAt(command, "glib-E26",
                    fmt::format("Attribute {}: an attribute has 1 to 4 numbers, not {}", binding.name,
                                numbers->size()));
        return;
    }
    if (in.list) return setInList(in, command, binding.name, *numbers);
    binding.source = *numbers;
    bind(in, std::move(binding));
}

void doTessLevels(Interpreter& in, const Command& command) {
    const auto levels = floatsOf(in, command.values, 6, "TessLevels");
    if (!levels) return;
    std::array<double, 6> made{};
    std::copy(levels->begin(), levels->end(), made.begin());
    in.state.local.tessellationLevels = made;
}

}  // namespace

std::span<const CommandAction> vertexActions() {
    static constexpr CommandAction kActions[] = {
        {CommandId::instances, doInstances},
        {CommandId::vertices, doVertices, InList::isWrong, true},
        {CommandId::attribute, doAttribute, InList::isPart},
        {CommandId::tessLevels, doTessLevels},
    };
    return kActions;
}

}  // namespace glibra::scene
