#include "render/load/device_scene.h"

#include <algorithm>
#include <span>
#include <utility>

#include "glsl/types/builtins.h"
#include "render/load/reuse.h"
#include "scene/primitives.h"

namespace glibra::render {
namespace {

/// The mesh attribute that feeds the vertex input of that name; nothing for names that the user chose.
std::optional<std::string_view> attributeOfInput(std::string_view input) {
    for (const glsl::BuiltinInput& each : glsl::builtinInputs())
        if (each.name == input) return each.attribute;
    return std::nullopt;
}

/// True if a program that draws the planned mesh declares that attribute as an integer input.
bool wantsIntegers(const plan::FramePlan& plan, plan::PlannedMeshIndex planned, std::string_view attribute,
                   const ProgramLibrary& programs) {
    for (const plan::PlannedPass& pass : plan.passes)
        for (const auto& step : pass.steps) {
            const auto* draw = std::get_if<plan::PlannedDraw>(&step);
            if (!draw || draw->mesh != planned) continue;
            const BuiltProgram* built = programs.find(plan.programs[draw->program].variant);
            if (!built) continue;
            for (const base::ActiveInput& input : built->interface.inputs)
                if (input.type.isInteger() && attributeOfInput(input.name) == attribute) return true;
        }
    return false;
}

/// The first draw that uses the planned mesh.
const scene::Draw* drawOf(const plan::FramePlan& plan, plan::PlannedMeshIndex planned) {
    for (const plan::PlannedPass& pass : plan.passes)
        for (const auto& step : pass.steps)
            if (const auto* draw = std::get_if<plan::PlannedDraw>(&step); draw && draw->mesh == planned)
                return &plan.drawOf(*draw);
    return nullptr;
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

bool contains(const std::vector<std::string>& names, std::string_view name) {
    return std::find(names.begin(), names.end(), name) != names.end();
}

/// The indices and the wanted attributes of a mesh on the device; `isInteger` says which attributes are also
/// needed as ints.
template <class IsInteger>
Result<DeviceMesh> copyToDevice(const geometry::Mesh& source, const std::vector<std::string>& wanted,
                                const IsInteger& isInteger) {
    DeviceMesh copy;
    copy.vertexCount = source.vertexCount();
    copy.indexCount = static_cast<int>(source.indices.size());
    Diagnostics diagnostics;
    const auto upload = [&](auto values) {
        Result<gpu::Buffer> buffer = gpu::Buffer::create(std::as_bytes(values));
        append(diagnostics, std::move(buffer.diagnostics));
        return std::move(buffer.value);
    };
    copy.indices = upload(std::span(source.indices));
    if (!copy.indices) return diagnostics;
    for (const geometry::Attribute& each : source.attributes) {
        if (!contains(wanted, each.name)) continue;
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

}  // namespace

void DeviceScene::beginMoment() {
    keptMeshes_.clear();
    keptDeviceMeshes_.clear();
    for (auto& [shape, made] : meshes_)
        if (!made.key.empty() && made.mesh) keptMeshes_.try_emplace(made.key, std::move(made.mesh));
    for (const plan::PlannedMeshIndex i : deviceMeshes_.indices())
        if (deviceMeshes_[i] && !deviceMeshKeys_[i].empty())
            keptDeviceMeshes_.try_emplace(deviceMeshKeys_[i], deviceMeshes_[i]);
    meshes_.clear();
    bounds_.clear();
    deviceMeshes_.clear();
    deviceMeshKeys_.clear();
    vertexArrays_.clear();
}

Diagnostics DeviceScene::prepare(const plan::FramePlan& plan, const ProgramLibrary& programs) {
    Diagnostics diagnostics;
    deviceMeshes_.resize(plan.meshes.size());
    deviceMeshKeys_.resize(plan.meshes.size());
    for (const plan::PlannedPass& pass : plan.passes)
        for (const auto& step : pass.steps)
            if (const auto* draw = std::get_if<plan::PlannedDraw>(&step))
                for (const plan::TextureUse& use : draw->textures)
                    if (use.isImage) written_.insert(use.texture);
    for (const plan::PlannedMeshIndex each : plan.meshes.indices())
        append(diagnostics, upload(plan, each, programs));
    for (const scene::TextureIndex texture : plan.textures) append(diagnostics, makeTexture(texture));
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
        for (const plan::PlannedMeshIndex i : previous_->deviceMeshes_.indices())
            if (previous_->deviceMeshes_[i] && previous_->deviceMeshKeys_[i] == key)
                return previous_->deviceMeshes_[i];
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
    const auto isInteger = [&](std::string_view attribute) {
        return wantsIntegers(plan, planned, attribute, programs);
    };
    std::string key = reuseKey(scene_, scene_.shapes[wanted.shape]);
    if (!key.empty())
        for (const std::string& each : wanted.attributes) key += (isInteger(each) ? " i" : " ") + each;
    deviceMeshKeys_[planned] = key;
    deviceMeshes_[planned] = earlierDeviceMesh(key, plan, planned);
    if (deviceMeshes_[planned]) return {};
    Diagnostics diagnostics;
    const geometry::Mesh* source =
        mesh(wanted.shape, contains(wanted.attributes, geometry::kTangent), &diagnostics);
    if (!source || source->indices.empty()) return diagnostics;

    const StageTimer timer(stats_, "upload");
    Result<DeviceMesh> made = copyToDevice(*source, wanted.attributes, isInteger);
    append(diagnostics, std::move(made.diagnostics));
    if (!made) return diagnostics;
    const auto uploaded = std::make_shared<const DeviceMesh>(std::move(*made));
    stats_.add("meshes", 1);
    stats_.add("vertices stored", uploaded->vertexCount);
    if (shared_ && !key.empty() && meshes_.at(wanted.shape).remarks.empty())
        shared_->deviceMeshes.add(key, uploaded, bytesOf(*uploaded));
    deviceMeshes_[planned] = uploaded;
    return diagnostics;
}

const DeviceMesh* DeviceScene::deviceMesh(plan::PlannedMeshIndex planned) const {
    return deviceMeshes_[planned].get();
}

const gpu::VertexArray& DeviceScene::vertexArray(plan::PlannedMeshIndex planned,
                                                 plan::PlannedProgramIndex program,
                                                 const BuiltProgram& built) {
    const auto known = vertexArrays_.find({planned, program});
    if (known != vertexArrays_.end()) return known->second;
    const DeviceMesh& mesh = *deviceMeshes_[planned];
    std::vector<gpu::AttributeSource> sources;
    for (const base::ActiveInput& input : built.interface.inputs) {
        const auto name = attributeOfInput(input.name);
        if (!name || input.location < 0) continue;
        for (const DeviceMesh::Attribute& each : mesh.attributes) {
            if (each.name != *name) continue;
            gpu::AttributeSource source;
            const bool integer = input.type.isInteger() && each.integers;
            source.buffer = integer ? &*each.integers : &each.floats;
            source.type =
                integer ? gpu::AttributeSource::Type::integer : gpu::AttributeSource::Type::floating;
            source.location = static_cast<GLuint>(input.location);
            source.components = each.components;
            sources.push_back(source);
        }
    }
    return vertexArrays_.try_emplace({planned, program}, gpu::VertexArray(sources, &*mesh.indices))
        .first->second;
}

}  // namespace glibra::render
