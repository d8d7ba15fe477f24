#include "render/load/device_scene.h"

#include <algorithm>
#include <utility>

#include "plan/buffers.h"

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
        } else if (const auto elements = elementsOf(plan, feeds[i]))
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

std::optional<DeviceScene::Elements> DeviceScene::elementsOf(const plan::FramePlan& plan,
                                                             const plan::InputSource& source) const {
    const auto* view = std::get_if<scene::BufferView>(&source.from);
    const plan::BufferLayout* layout = view != nullptr ? buffers_.layout(view->buffer) : nullptr;
    if (layout == nullptr || layout->pattern.element.empty()) return std::nullopt;
    const plan::MemoryPattern& pattern = layout->pattern;
    const scene::ElementPart& part = source.part;
    Elements elements{
        buffers_.buffer(*view), pattern.elementsAt + part.offset, pattern.stride, layout->elements, {}};
    std::size_t first = 0, count = pattern.element.size();
    if (!part.member.empty()) {
        const std::optional<base::StorageBlock> block = plan::blockOf(plan, view->buffer);
        const plan::BufferTable table =
            plan::tableOf(*layout, block ? &*block : nullptr, pattern.element.size());
        const auto found =
            std::ranges::find_if(table.columns, [&](const auto& each) { return each.name == part.member; });
        if (!block || found == table.columns.end()) return std::nullopt;
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

}  // namespace glibra::render
