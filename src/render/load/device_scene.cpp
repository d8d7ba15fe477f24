#include "render/load/device_scene.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <utility>

#include "base/suggest.h"
#include "base/text.h"
#include "glib/number.h"
#include "plan/buffers.h"
#include "plan/submission.h"

namespace glibra::render {
namespace {

/// How the numbers of a buffer reach an input of that type.
gpu::AttributeSource::Type sourceTypeOf(plan::NumberKind kind, const base::ValueType& input) {
    using Type = gpu::AttributeSource::Type;
    const bool isFloat = kind == plan::NumberKind::floating || kind == plan::NumberKind::doublePrecision;
    if (isFloat) return Type::floating;
    const bool isSigned = kind == plan::NumberKind::integer;
    if (!input.isInteger()) return isSigned ? Type::integerAsFloat : Type::unsignedAsFloat;
    return isSigned ? Type::integer : Type::unsignedInteger;
}

void addMeshSource(const DeviceMesh& mesh, const std::string& name, const base::ActiveInput& input,
                   std::vector<gpu::AttributeSource>& sources) {
    for (const DeviceMesh::Attribute& each : mesh.attributes) {
        if (each.name != name) continue;
        gpu::AttributeSource source;
        const bool integer = input.type.isInteger() && each.integers;
        source.buffer = integer ? &*each.integers : &each.floats;
        source.type = integer ? gpu::AttributeSource::Type::integer : gpu::AttributeSource::Type::floating;
        source.location = static_cast<GLuint>(input.location);
        source.components = each.components;
        sources.push_back(source);
    }
}

}  // namespace

void DeviceScene::inherit(DeviceScene& previous) {
    meshes_.inherit(&previous.meshes_);
    textures_.inherit(&previous.textures_);
}

void DeviceScene::beginMoment(const plan::FramePlan& plan) {
    meshes_.forgetShapes();
    forget(plan);
}

void DeviceScene::forget(const plan::FramePlan& plan) {
    vertexArrays_.erase(&plan);
    meshes_.forget(plan);
}

Diagnostics DeviceScene::followSizes(Resized& resized) {
    Diagnostics diagnostics = textures_.followSizes(resized);
    targets_.forget(textures_.takeGone());
    if (buffers_.followSizes()) {
        resized = {true, true};
        vertexArrays_.clear();
    }
    return diagnostics;
}

Diagnostics DeviceScene::prepare(const plan::FramePlan& plan, const ProgramLibrary& programs,
                                 std::span<const plan::FramePlan* const> others) {
    noteWrites(plan);
    Diagnostics diagnostics = meshes_.prepare(plan, programs);
    append(diagnostics, textures_.prepare(plan));
    targets_.forget(textures_.takeGone());
    append(diagnostics, buffers_.prepare(plan, others));
    append(diagnostics, checkElements(plan));
    append(diagnostics, checkIndices(plan));
    append(diagnostics, buffers_.checkTexels(plan));
    append(diagnostics, textures_.checkParts(plan));
    meshes_.inherit(nullptr);
    textures_.inherit(nullptr);
    return diagnostics;
}

ObjectState& DeviceScene::state(const plan::Object& object) {
    if (const auto* buffer = std::get_if<scene::BufferIndex>(&object)) return buffers_.state(*buffer);
    return textures_.state(std::get<scene::TextureIndex>(object));
}

Diagnostics DeviceScene::noteWritten(const plan::Object& object, gpu::BindingTracker& bindings) {
    state(object).noteWritten();
    const auto* texture = std::get_if<scene::TextureIndex>(&object);
    if (texture == nullptr) return buffers_.keepGiven(std::get<scene::BufferIndex>(object));
    return textures_.keepDeclared(*texture, bindings);
}

Diagnostics DeviceScene::reset(const plan::Object& object) {
    state(object).noteReset();
    if (const auto* buffer = std::get_if<scene::BufferIndex>(&object)) return buffers_.reset(*buffer);
    return textures_.reset(std::get<scene::TextureIndex>(object));
}

void DeviceScene::takeOver(DeviceScene& previous, const plan::Object& object) {
    state(object).isWritten = true;
    if (const auto* buffer = std::get_if<scene::BufferIndex>(&object))
        return buffers_.takeOver(previous.buffers_, *buffer);
    textures_.takeOver(previous.textures_, std::get<scene::TextureIndex>(object));
}

void DeviceScene::bind(const plan::TextureUse& use, gpu::BindingTracker& bindings) {
    if (use.buffer.buffer) return buffers_.bind(use, bindings);
    textures_.bind(use, bindings);
}

/// The last source as one for each corner of a primitive, which is an instance.
static void spreadCorners(int corners, const DeviceMesh& mesh, std::vector<gpu::AttributeSource>& sources) {
    if (corners == 0 || sources.empty()) return;
    gpu::AttributeSource source = sources.back();
    if (source.divisor != 0) return;
    sources.pop_back();
    const std::size_t size =
        source.stride != 0 ? source.stride : static_cast<std::size_t>(source.components) * sizeof(float);
    source.stride = size * static_cast<std::size_t>(corners);
    // A single one is that of all instances.
    source.divisor = mesh.indexCount == corners ? 1U << 30U : 1;
    for (int corner = 0; corner < corners; ++corner) {
        sources.push_back(source);
        ++source.location;
        source.offset += size;
    }
}

const gpu::VertexArray& DeviceScene::vertexArray(const plan::FramePlan& plan,
                                                 const plan::PlannedDraw& planned,
                                                 const BuiltProgram& built) {
    const plan::PlannedInputsIndex inputs = planned.inputs;
    const std::optional<Indices> own = indicesOf(plan.drawOf(planned));
    auto& made = vertexArrays_[&plan];
    std::vector<GLuint> buffers;
    if (inputs)
        for (const plan::InputSource& each : plan.inputs[inputs].sources)
            if (const auto* view = std::get_if<scene::BufferView>(&each.from)) {
                const gpu::Buffer* buffer = buffers_.buffer(*view);
                buffers.push_back(buffer ? buffer->id() : 0);
            }
    if (own) buffers.push_back(own->buffer->id());
    const auto known = made.find({planned.mesh, inputs, buffers});
    if (known != made.end()) return known->second;
    const DeviceMesh& mesh = *meshes_.onDevice(plan, planned.mesh);
    std::vector<gpu::AttributeSource> sources;
    const std::vector<plan::InputSource>& feeds = inputSources(plan, inputs, built);
    for (std::size_t i = 0; i < feeds.size(); ++i) {
        const base::ActiveInput& input = built.interface.inputs[i];
        if (input.location < 0) continue;
        if (const auto* name = std::get_if<std::string>(&feeds[i].from)) {
            addMeshSource(mesh, *name, input, sources);
            spreadCorners(built.interface.facts.expanded.corners, mesh, sources);
        } else if (const auto elements = elementsOf(feeds[i]))
            addBufferSources(*elements, feeds[i].isPerInstance, input, sources);
    }
    const bool isExpanded = plan.meshes[planned.mesh].isExpanded;
    const gpu::Buffer* indices = own ? own->buffer : mesh.indices && !isExpanded ? &*mesh.indices : nullptr;
    return made.try_emplace({planned.mesh, inputs, buffers}, gpu::VertexArray(sources, indices))
        .first->second;
}

const std::vector<plan::InputSource>& DeviceScene::inputSources(const plan::FramePlan& plan,
                                                                plan::PlannedInputsIndex inputs,
                                                                const BuiltProgram& built) {
    if (inputs) return plan.inputs[inputs].sources;
    const auto [entry, isNew] = suppliedSources_.try_emplace(&built);
    if (isNew) entry->second = plan::inputSources(scene_, {}, built.interface);
    return entry->second;
}

std::optional<DeviceScene::Elements> DeviceScene::elementsOf(const plan::InputSource& source) const {
    const auto* view = std::get_if<scene::BufferView>(&source.from);
    const plan::BufferLayout* layout = view != nullptr ? buffers_.layout(view->buffer) : nullptr;
    if (layout == nullptr || layout->pattern.element.empty()) return std::nullopt;
    const plan::MemoryPattern& pattern = layout->pattern;
    const scene::ElementPart& part = source.part;
    Elements elements{
        buffers_.buffer(*view), pattern.elementsAt + part.offset, pattern.stride, layout->elements, {}};
    std::size_t first = 0, count = pattern.element.size();
    if (!part.member.empty()) {
        const plan::BufferTable table = plan::tableOf(*layout, pattern.element.size());
        const auto found =
            std::ranges::find_if(table.columns, [&](const auto& each) { return each.name == part.member; });
        if (!layout->block || found == table.columns.end()) return std::nullopt;
        first = found->first;
        count = found->count;
    }
    if (part.stride != 0) elements.stride = part.stride;
    if (!part.isBytes()) {
        elements.numbers.assign(pattern.element.begin() + static_cast<std::ptrdiff_t>(first),
                                pattern.element.begin() + static_cast<std::ptrdiff_t>(first + count));
        return elements;
    }
    // Numbers one after another, as in glVertexAttribPointer.
    const plan::MemoryNumber& begin = pattern.element[first];
    const std::uint64_t end = pattern.elementsAt + layout->elements * pattern.stride;
    const std::uint64_t at = elements.at + begin.offset + plan::sizeOf(begin.kind);
    elements.count = at > end ? 0 : (end - at) / elements.stride + 1;
    constexpr std::uint64_t kMostNumbers = 16;  // of a mat4
    for (std::uint64_t i = 0; i < kMostNumbers; ++i)
        elements.numbers.push_back({begin.offset + i * plan::sizeOf(begin.kind), begin.kind});
    return elements;
}

void DeviceScene::addBufferSources(const Elements& elements, bool isPerInstance,
                                   const base::ActiveInput& input,
                                   std::vector<gpu::AttributeSource>& sources) {
    if (elements.buffer == nullptr) return;
    const auto rows = static_cast<std::size_t>(input.type.rows);
    for (std::size_t column = 0; column < static_cast<std::size_t>(input.type.columns); ++column) {
        const std::size_t first = column * rows;
        if (first >= elements.numbers.size()) return;
        gpu::AttributeSource source;
        source.buffer = elements.buffer;
        source.location = static_cast<GLuint>(input.location) + static_cast<GLuint>(column);
        source.components = static_cast<int>(std::min(rows, elements.numbers.size() - first));
        source.offset = elements.at + elements.numbers[first].offset;
        source.stride = elements.stride;
        source.divisor = isPerInstance ? 1 : 0;
        source.type = sourceTypeOf(elements.numbers[first].kind, input.type);
        sources.push_back(source);
    }
}

// The indices that `Vertices ... indices BUFFER` reads, and the elements that draws take from buffers
// (language, 12.6).

namespace {

constexpr double kRestartAt = std::numeric_limits<std::uint32_t>::max();
constexpr double kRestartOfInts = -1;

/// The buffers that nodes of the plan write to.
std::set<scene::BufferIndex> writtenBuffers(const plan::FramePlan& plan) {
    std::set<scene::BufferIndex> written;
    for (const plan::NodeAccess& node : plan.accesses)
        for (const plan::Object& each : node.written)
            if (const auto* buffer = std::get_if<scene::BufferIndex>(&each)) written.insert(*buffer);
    return written;
}

}  // namespace

std::optional<DeviceScene::Indices> DeviceScene::indicesOf(const scene::Draw& draw) const {
    const plan::BufferLayout* layout = draw.indices.buffer ? buffers_.layout(draw.indices.buffer) : nullptr;
    const gpu::Buffer* buffer = layout != nullptr ? buffers_.buffer(draw.indices) : nullptr;
    if (buffer == nullptr) return std::nullopt;
    const plan::MemoryPattern& pattern = layout->pattern;
    if (pattern.element.size() != 1 || pattern.stride != sizeof(GLuint) ||
        pattern.elementsAt % sizeof(GLuint) != 0)
        return std::nullopt;
    const plan::NumberKind kind = pattern.element.front().kind;
    if (kind != plan::NumberKind::integer && kind != plan::NumberKind::unsignedInteger) return std::nullopt;
    // Vertices are counted by ints.
    const std::uint64_t most = std::numeric_limits<int>::max();
    return Indices{buffer, pattern.elementsAt, static_cast<int>(std::min(layout->elements, most))};
}

std::optional<std::string> DeviceScene::elementsProblem(const plan::FramePlan& plan,
                                                        const plan::PlannedDraw& planned) const {
    const scene::Draw& draw = plan.drawOf(planned);
    const scene::Shape& shape = scene_.shapes[draw.shape];
    if (!planned.inputs) return std::nullopt;
    std::uint64_t vertices = 0, instances = 0;  // 0: not known here
    if (!draw.instancesFrom) instances = static_cast<std::uint64_t>(draw.instances);
    if (shape.bare && !draw.verticesFrom && !draw.indices.buffer && !shape.numbers.empty())
        vertices = static_cast<std::uint64_t>(shape.numbers[0]);
    for (const plan::InputSource& each : plan.inputs[planned.inputs].sources) {
        const std::optional<Elements> of = elementsOf(each);
        const std::uint64_t needed = each.isPerInstance ? instances : vertices;
        if (!of || needed <= of->count) continue;
        return fmt::format("{}: {} {} are more than the {} elements of '{}'", draw.word,
                           base::groupedText(needed), each.isPerInstance ? "instances" : "vertices",
                           base::groupedText(of->count),
                           scene_.buffers[std::get<scene::BufferView>(each.from).buffer].name);
    }
    return std::nullopt;
}

Diagnostics DeviceScene::membersProblems(const plan::FramePlan& plan,
                                         const plan::PlannedDraw& planned) const {
    Diagnostics problems;
    if (!planned.inputs) return problems;
    const scene::Draw& draw = plan.drawOf(planned);
    for (const plan::InputSource& each : plan.inputs[planned.inputs].sources) {
        const auto* view = std::get_if<scene::BufferView>(&each.from);
        const plan::BufferLayout* layout = view != nullptr ? buffers_.layout(view->buffer) : nullptr;
        if (layout == nullptr || each.part.member.empty() || elementsOf(each)) continue;
        std::string advice =
            "; its members have names where a block of a program holds it, and otherwise 'offset' and "
            "'stride' "
            "say which numbers are meant";
        if (layout->block) {
            const plan::BufferTable table = plan::tableOf(*layout, layout->pattern.element.size());
            std::vector<std::string_view> names;
            for (const plan::BufferColumn& column : table.columns) names.push_back(column.name);
            advice = base::suggestion(each.part.member, names);
            if (advice.empty()) advice = fmt::format("; its members are {}", fmt::join(names, ", "));
        }
        problems.push_back(
            diagnose("draw-E12",
                     fmt::format("{}: an attribute reads the member '{}' of buffer '{}', which has "
                                 "none of that name{}",
                                 draw.word, each.part.member, scene_.buffers[view->buffer].name, advice),
                     draw.place));
    }
    return problems;
}

Diagnostics DeviceScene::checkElements(const plan::FramePlan& plan) const {
    Diagnostics diagnostics;
    std::set<std::pair<int, std::string>> reported;  // of a statement in a Repeat
    plan.visitDraws([&](const plan::PlannedDraw& planned, const scene::Draw& draw, const auto&) {
        std::optional<std::string> problem = elementsProblem(plan, planned);
        for (Diagnostic& each : membersProblems(plan, planned))
            if (reported.emplace(draw.place.line, each.text).second) diagnostics.push_back(std::move(each));
        if (problem && reported.emplace(draw.place.line, *problem).second)
            diagnostics.push_back(diagnose("memory-E13", std::move(*problem), draw.place));
    });
    return diagnostics;
}

Diagnostics DeviceScene::checkIndices(const plan::FramePlan& plan) {
    Diagnostics diagnostics;
    std::optional<std::set<scene::BufferIndex>> written;
    plan.visitDraws([&](const plan::PlannedDraw& planned, const scene::Draw& draw, const auto&) {
        const scene::BufferIndex index = draw.indices.buffer;
        if (!index || buffers_.layout(index) == nullptr) return;  // reported
        if (!written) written = writtenBuffers(plan);
        const bool isAsDeclared = !written->contains(index) && !buffers_.state(index).lasts;
        if (auto problem = indexProblem(plan, planned, isAsDeclared))
            diagnostics.push_back(diagnose("memory-E13", std::move(*problem), draw.place));
    });
    return diagnostics;
}

std::optional<std::string> DeviceScene::indexProblem(const plan::FramePlan& plan,
                                                     const plan::PlannedDraw& planned, bool isAsDeclared) {
    const scene::Draw& draw = plan.drawOf(planned);
    const plan::BufferLayout& layout = *buffers_.layout(draw.indices.buffer);
    const std::string& name = scene_.buffers[draw.indices.buffer].name;
    const std::optional<Indices> indices = indicesOf(draw);
    if (!indices)
        return fmt::format(
            "{}: indices are uint or int, one after another; {} lays out buffer '{}' otherwise", draw.word,
            layout.from, name);
    const std::vector<double>& numbers = scene_.shapes[draw.shape].numbers;
    const auto given =
        draw.drawsAllIndices || numbers.empty() ? std::uint64_t{0} : static_cast<std::uint64_t>(numbers[0]);
    if (given > layout.elements)
        return fmt::format("{}: {} indices are more than the {} of buffer '{}'", draw.word,
                           base::groupedText(given), base::groupedText(layout.elements), name);
    if (layout.elements == 0)
        return fmt::format("{}: buffer '{}' is empty, so it has no indices", draw.word, name);
    if (!isAsDeclared || !planned.inputs) return std::nullopt;
    std::optional<std::uint64_t> vertices;  // of the shortest buffer with attributes
    scene::BufferIndex shortest;
    for (const plan::InputSource& each : plan.inputs[planned.inputs].sources) {
        const std::optional<Elements> of = each.isPerInstance ? std::nullopt : elementsOf(each);
        if (!of || (vertices && *vertices <= of->count)) continue;
        vertices = of->count;
        shortest = std::get<scene::BufferView>(each.from).buffer;
    }
    if (!vertices) return std::nullopt;
    const bool restarts = planned.submission.topology != geometry::Topology::patches;
    const std::uint64_t count = draw.drawsAllIndices || draw.verticesFrom ? layout.elements : given;
    const auto beyond = firstIndexFrom(draw.indices.buffer, count, *vertices, restarts);
    if (!beyond) return std::nullopt;
    return fmt::format("{}: element {} of '{}' is vertex {}, but '{}' has {} elements", draw.word,
                       base::groupedText(beyond->element), name, glib::numberText(beyond->vertex),
                       scene_.buffers[shortest].name, base::groupedText(*vertices));
}

std::optional<DeviceScene::IndexAt> DeviceScene::firstIndexFrom(scene::BufferIndex buffer,
                                                                std::uint64_t count, std::uint64_t limit,
                                                                bool restarts) {
    const scene::Buffer& declared = scene_.buffers[buffer];
    const std::size_t head = buffers_.layout(buffer)->pattern.head.size();
    // Values that the statement does not give are zero.
    std::vector<double> ofFile;
    std::span<const double> values;
    if (declared.file) {
        if (!checkedIndices_.emplace(buffer, count, limit).second) return std::nullopt;
        values = ofFile = buffers_.read({buffer}, head, count);
    } else {
        values = std::span(declared.values.numbers()).subspan(std::min(head, declared.values.size()));
    }
    for (std::size_t i = 0; i < values.size() && i < count; ++i) {
        const double vertex = values[i];
        const bool isRestart = restarts && (vertex == kRestartAt || vertex == kRestartOfInts);
        if (!isRestart && !(vertex >= 0 && vertex < static_cast<double>(limit))) return IndexAt{i, vertex};
    }
    return std::nullopt;
}

}  // namespace glibra::render
