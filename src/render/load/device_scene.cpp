#include "render/load/device_scene.h"

#include <fmt/format.h>

#include <algorithm>
#include <new>
#include <span>
#include <utility>

#include "geometry/adjacency.h"
#include "plan/buffer_table.h"
#include "plan/submission.h"
#include "plan/uniform_names.h"
#include "render/load/reuse.h"
#include "scene/primitives.h"

namespace glibra::render {
namespace {

/// True if a program that draws the planned mesh declares that attribute as an integer input.
bool wantsIntegers(const plan::FramePlan& plan, plan::PlannedMeshIndex planned, std::string_view attribute,
                   const ProgramLibrary& programs) {
    bool isAny = false;
    plan.visitDraws([&](const plan::PlannedDraw& draw, const auto&...) {
        if (isAny || draw.mesh != planned || !draw.inputs) return;
        const BuiltProgram* built = programs.find(plan.programs[draw.program].variant);
        if (!built) return;
        const std::vector<plan::InputSource>& sources = plan.inputs[draw.inputs].sources;
        for (std::size_t i = 0; i < sources.size() && i < built->interface.inputs.size(); ++i) {
            const auto* name = std::get_if<std::string>(&sources[i].from);
            isAny |= name && *name == attribute && built->interface.inputs[i].type.isInteger();
        }
    });
    return isAny;
}

/// The first draw that uses the planned mesh.
const scene::Draw* drawOf(const plan::FramePlan& plan, plan::PlannedMeshIndex planned) {
    const scene::Draw* first = nullptr;
    plan.visitDraws([&](const plan::PlannedDraw& each, const scene::Draw& draw, const auto&) {
        if (first == nullptr && each.mesh == planned) first = &draw;
    });
    return first;
}

std::size_t bytesOf(const geometry::Mesh& mesh) {
    std::size_t bytes = mesh.indices.size() * sizeof(std::uint32_t);
    for (const geometry::Attribute& each : mesh.attributes) bytes += each.values.size() * sizeof(float);
    return bytes;
}

std::size_t bytesOf(const DeviceMesh& mesh) {
    std::size_t bytes = mesh.indices ? mesh.indices->size() : 0;
    for (const DeviceMesh::Attribute& each : mesh.attributes)
        bytes += each.floats.size() + (each.integers ? each.integers->size() : 0);
    return bytes;
}

bool hasName(const std::vector<std::string>& names, std::string_view name) {
    return std::find(names.begin(), names.end(), name) != names.end();
}

/// The wanted attributes of a mesh on the device, with these indices; `isInteger` says which attributes are
/// also needed as ints.
template <class IsInteger>
Result<DeviceMesh> copyToDevice(const geometry::Mesh& source, const std::vector<std::uint32_t>& indices,
                                const std::vector<std::string>& wanted, const IsInteger& isInteger) {
    DeviceMesh copy;
    copy.vertexCount = source.vertexCount();
    copy.indexCount = static_cast<int>(indices.size());
    copy.pointCount = static_cast<int>(source.pointCount);
    Diagnostics diagnostics;
    const auto upload = [&](auto values) {
        Result<gpu::Buffer> buffer = gpu::Buffer::create(std::as_bytes(values));
        append(diagnostics, std::move(buffer.diagnostics));
        return std::move(buffer.value);
    };
    copy.indices = upload(std::span(indices));
    if (!copy.indices) return diagnostics;
    for (const geometry::Attribute& each : source.attributes) {
        if (!hasName(wanted, each.name)) continue;
        std::optional<gpu::Buffer> floats = upload(std::span(each.values));
        if (!floats) return diagnostics;
        DeviceMesh::Attribute attribute{each.name, each.components, std::move(*floats), std::nullopt};
        if (isInteger(each.name)) {
            std::vector<std::int32_t> values(each.values.size());
            std::transform(each.values.begin(), each.values.end(), values.begin(),
                           [](float value) { return static_cast<std::int32_t>(value); });
            attribute.integers = upload(std::span(std::as_const(values)));
        }
        copy.attributes.push_back(std::move(attribute));
    }
    return {std::move(copy), std::move(diagnostics)};
}

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

void DeviceScene::forgetShapes() {
    keptMeshes_.clear();
    keptDeviceMeshes_.clear();
    for (auto& [shape, made] : meshes_)
        if (!made.key.empty() && made.mesh) keptMeshes_.try_emplace(made.key, std::move(made.mesh));
    for (const auto& [plan, parts] : plans_)
        for (const plan::PlannedMeshIndex i : parts.meshes.indices())
            if (parts.meshes[i] && !parts.keys[i].empty())
                keptDeviceMeshes_.try_emplace(parts.keys[i], parts.meshes[i]);
    meshes_.clear();
    bounds_.clear();
}

void DeviceScene::beginMoment(const plan::FramePlan& plan) {
    forgetShapes();
    plans_.erase(&plan);
}

void DeviceScene::noteWrites(const plan::FramePlan& plan) {
    plan.visitStatements([this](const auto& planned, const auto&) {
        for (const plan::TextureUse& each : planned.textures)
            if (each.isImage && each.view.texture) written_.insert(each.view.texture);
    });
    if (!scene_.isModern) return;
    for (const plan::PlannedPass& pass : plan.passes) {
        const scene::Pass& drawn = plan.passOf(pass);
        written_.insert(drawn.targets.begin(), drawn.targets.end());
        if (drawn.depth) written_.insert(drawn.depth->texture);
    }
}

Diagnostics DeviceScene::noteWritten(const plan::Object& object, gpu::BindingTracker& bindings) {
    if (!lasting_.contains(object)) changed_.insert(object);
    stored_.insert(object);
    const auto* texture = std::get_if<scene::TextureIndex>(&object);
    return texture != nullptr ? keepDeclared(*texture, bindings) : Diagnostics();
}

void DeviceScene::setLasting(const plan::Object& object) {
    lasting_.insert(object);
    changed_.erase(object);
    if (const auto* buffer = std::get_if<scene::BufferIndex>(&object)) buffers_.setLasting(*buffer);
}

Diagnostics DeviceScene::reset(const scene::ObjectView& object) {
    changed_.erase(plan::objectOf(object));
    stored_.erase(plan::objectOf(object));
    if (const auto* buffer = std::get_if<scene::BufferView>(&object)) return buffers_.reset(buffer->buffer);
    const scene::TextureIndex texture = std::get<scene::TextureView>(object).texture;
    if (!std::holds_alternative<scene::EmptySource>(scene_.textures[texture].source))
        return resetToFile(texture);
    clear(texture);
    if (!scene_.textures[texture].hasHistory) return {};
    exchange(texture);
    clear(texture);
    return {};
}

Diagnostics DeviceScene::prepare(const plan::FramePlan& plan, const ProgramLibrary& programs) {
    Diagnostics diagnostics;
    PlanParts& parts = plans_[&plan];
    parts.meshes.resize(plan.meshes.size());
    parts.keys.resize(plan.meshes.size());
    noteWrites(plan);
    for (const plan::PlannedMeshIndex each : plan.meshes.indices())
        append(diagnostics, upload(plan, each, programs));
    append(diagnostics, makeTextures(plan));
    append(diagnostics, buffers_.prepare(plan));
    append(diagnostics, checkElements(plan));
    append(diagnostics, checkIndices(plan));
    append(diagnostics, checkBufferTextures(plan));
    append(diagnostics, checkParts(plan));
    previous_ = nullptr;
    return diagnostics;
}

std::shared_ptr<const geometry::Mesh> DeviceScene::earlierMesh(const std::string& key) {
    if (key.empty()) return nullptr;
    if (const auto kept = keptMeshes_.find(key); kept != keptMeshes_.end()) return kept->second;
    if (previous_)
        for (const auto& [shape, made] : previous_->meshes_)
            if (made.key == key && made.mesh) return made.mesh;
    return shared_ ? shared_->meshes.find(key).value_or(nullptr) : nullptr;
}

const geometry::Mesh* DeviceScene::mesh(scene::ShapeIndex shape, bool withTangents, Diagnostics* remarks) {
    const bool isFile = bool(scene_.shapes[shape].file);
    const bool tangents = withTangents || !isFile;  // only models are made without
    const auto [known, isNew] = meshes_.try_emplace(shape);
    MadeMesh& made = known->second;
    if (isNew || (!made.withTangents && tangents && made.mesh)) make(shape, tangents, made);
    reportOnce(shape, remarks);
    return made.mesh.get();
}

void DeviceScene::make(scene::ShapeIndex shape, bool withTangents, MadeMesh& made) {
    const scene::Shape& wanted = scene_.shapes[shape];
    made = {};
    made.withTangents = withTangents;
    made.key = reuseKey(scene_, wanted);
    if (!made.key.empty() && withTangents) made.key += " t";
    made.mesh = earlierMesh(made.key);
    if (made.mesh) return;
    const StageTimer timer(stats_, "geometry");
    if (wanted.file) stats_.add("files read", 1);
    Result<geometry::Mesh> result = scene::makeMesh(scene_, shape, withTangents);
    made.remarks = std::move(result.diagnostics);
    if (!result) return;
    made.mesh = std::make_shared<const geometry::Mesh>(std::move(*result));
    if (shared_ && !made.key.empty() && made.remarks.empty())
        shared_->meshes.add(made.key, made.mesh, bytesOf(*made.mesh));
}

void DeviceScene::reportOnce(scene::ShapeIndex shape, Diagnostics* remarks) {
    const auto made = meshes_.find(shape);
    if (!remarks || made == meshes_.end() || made->second.areReported) return;
    made->second.areReported = true;
    append(*remarks, made->second.remarks);
}

const VertexBox& DeviceScene::bounds(scene::ShapeIndex shape, bool withTangents, Diagnostics* remarks) {
    const auto [entry, isNew] = bounds_.try_emplace(shape);
    VertexBox& bounds = entry->second;
    if (!isNew) {
        reportOnce(shape, remarks);
        return bounds;
    }
    const std::string key = reuseKey(scene_, scene_.shapes[shape]);
    if (shared_ && !key.empty())
        if (const std::optional<VertexBox> known = shared_->bounds.find(key)) return bounds = *known;
    const geometry::Mesh* made = mesh(shape, withTangents, remarks);
    if (!made) return bounds;
    const VertexBox* earlier = previous_ ? previous_->boundsOfMesh(*made) : nullptr;
    bounds = earlier ? *earlier : boundsOf(*made);
    if (shared_ && !key.empty() && meshes_.at(shape).remarks.empty()) shared_->bounds.add(key, bounds, 1);
    return bounds;
}

const VertexBox* DeviceScene::boundsOfMesh(const geometry::Mesh& mesh) const {
    for (const auto& [shape, made] : meshes_)
        if (made.mesh.get() == &mesh) return knownBounds(shape);
    return nullptr;
}

const VertexBox* DeviceScene::knownBounds(scene::ShapeIndex shape) const {
    const auto found = bounds_.find(shape);
    return found == bounds_.end() ? nullptr : &found->second;
}

std::shared_ptr<const DeviceMesh> DeviceScene::earlierDeviceMesh(const std::string& key,
                                                                 const plan::FramePlan& plan,
                                                                 plan::PlannedMeshIndex planned) {
    if (key.empty()) return nullptr;
    if (const auto kept = keptDeviceMeshes_.find(key); kept != keptDeviceMeshes_.end()) return kept->second;
    if (previous_)
        for (const auto& [earlier, parts] : previous_->plans_)
            for (const plan::PlannedMeshIndex i : parts.meshes.indices())
                if (parts.meshes[i] && parts.keys[i] == key) return parts.meshes[i];
    std::shared_ptr<const DeviceMesh> found =
        shared_ ? shared_->deviceMeshes.find(key).value_or(nullptr) : nullptr;
    if (!found) return nullptr;
    stats_.add("meshes kept", 1);
    if (const scene::Draw* draw = drawOf(plan, planned))
        stats_.skip("mesh", draw->word + ": already on the device", draw->place);
    return found;
}

Diagnostics DeviceScene::upload(const plan::FramePlan& plan, plan::PlannedMeshIndex planned,
                                const ProgramLibrary& programs) {
    const plan::PlannedMesh& wanted = plan.meshes[planned];
    PlanParts& parts = plans_.at(&plan);
    const scene::Shape& shape = scene_.shapes[wanted.shape];
    if (shape.bare) {
        DeviceMesh bare;
        bare.indexCount = shape.numbers.empty() ? 0 : static_cast<int>(shape.numbers.front());
        parts.meshes[planned] = std::make_shared<const DeviceMesh>(std::move(bare));
        return {};
    }
    const auto isInteger = [&](std::string_view attribute) {
        return wantsIntegers(plan, planned, attribute, programs);
    };
    std::string key = reuseKey(scene_, scene_.shapes[wanted.shape]);
    if (!key.empty())
        for (const std::string& each : wanted.attributes) key += (isInteger(each) ? " i" : " ") + each;
    if (!key.empty() && wanted.adjacency) key.append(" ").append(plan::wordOf(*wanted.adjacency));
    parts.keys[planned] = key;
    parts.meshes[planned] = earlierDeviceMesh(key, plan, planned);
    if (parts.meshes[planned]) return {};
    Diagnostics diagnostics;
    const geometry::Mesh* source =
        mesh(wanted.shape, hasName(wanted.attributes, geometry::kTangent), &diagnostics);
    if (!source || source->indices.empty()) return diagnostics;

    std::vector<std::uint32_t> adjacency;
    if (wanted.adjacency) {
        const StageTimer timer(stats_, "geometry");
        try {
            adjacency = geometry::adjacencyIndices(*source, *wanted.adjacency);
        } catch (const std::bad_alloc& problem) {
            const scene::Draw* draw = drawOf(plan, planned);
            diagnostics.push_back(diagnose("draw-E05",
                                           fmt::format("cannot find neighbours: {}", problem.what()),
                                           draw ? draw->place : Place{scene_.path, 1, 1}));
            return diagnostics;
        }
    }
    const StageTimer timer(stats_, "upload");
    Result<DeviceMesh> made =
        copyToDevice(*source, wanted.adjacency ? adjacency : source->indices, wanted.attributes, isInteger);
    append(diagnostics, std::move(made.diagnostics));
    if (!made) return diagnostics;
    const auto uploaded = std::make_shared<const DeviceMesh>(std::move(*made));
    stats_.add("meshes", 1);
    stats_.add("vertices stored", uploaded->vertexCount);
    if (shared_ && !key.empty() && meshes_.at(wanted.shape).remarks.empty())
        shared_->deviceMeshes.add(key, uploaded, bytesOf(*uploaded));
    parts.meshes[planned] = uploaded;
    return diagnostics;
}

const DeviceMesh* DeviceScene::deviceMesh(const plan::FramePlan& plan, plan::PlannedMeshIndex planned) const {
    const auto found = plans_.find(&plan);
    return found == plans_.end() ? nullptr : found->second.meshes[planned].get();
}

const gpu::VertexArray& DeviceScene::vertexArray(const plan::FramePlan& plan,
                                                 const plan::PlannedDraw& planned,
                                                 const BuiltProgram& built) {
    const plan::PlannedInputsIndex inputs = planned.inputs;
    const std::optional<Indices> own = indicesOf(plan.drawOf(planned));
    PlanParts& parts = plans_.at(&plan);
    std::vector<GLuint> buffers;
    if (inputs)
        for (const plan::InputSource& each : plan.inputs[inputs].sources)
            if (const auto* view = std::get_if<scene::BufferView>(&each.from)) {
                const gpu::Buffer* buffer = buffers_.buffer(*view);
                buffers.push_back(buffer ? buffer->id() : 0);
            }
    if (own) buffers.push_back(own->buffer->id());
    const auto known = parts.vertexArrays.find({planned.mesh, inputs, buffers});
    if (known != parts.vertexArrays.end()) return known->second;
    const DeviceMesh& mesh = *parts.meshes[planned.mesh];
    std::vector<gpu::AttributeSource> sources;
    const std::vector<plan::InputSource>& feeds = inputSources(plan, inputs, built);
    for (std::size_t i = 0; i < feeds.size(); ++i) {
        const base::ActiveInput& input = built.interface.inputs[i];
        if (input.location < 0) continue;
        if (const auto* name = std::get_if<std::string>(&feeds[i].from))
            addMeshSource(mesh, *name, input, sources);
        else if (const auto elements = elementsOf(plan, feeds[i]))
            addBufferSources(*elements, feeds[i].isPerInstance, input, sources);
    }
    const gpu::Buffer* indices = own ? own->buffer : mesh.indices ? &*mesh.indices : nullptr;
    return parts.vertexArrays.try_emplace({planned.mesh, inputs, buffers}, gpu::VertexArray(sources, indices))
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
        const auto found = std::find_if(table.columns.begin(), table.columns.end(),
                                        [&](const auto& each) { return each.name == part.member; });
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
