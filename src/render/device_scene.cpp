#include "render/device_scene.h"

#include <algorithm>

#include "glsl/types/builtins.h"
#include "render/reuse.h"
#include "scene/primitives.h"

namespace glibra::render {
namespace {

/// The mesh attribute that feeds the vertex input of that name; nothing for names of the user's own.
std::optional<std::string_view> attributeOfInput(std::string_view input) {
    for (const glsl::BuiltinInput& each : glsl::builtinInputs())
        if (each.name == input) return each.attribute;
    return std::nullopt;
}

/// True if some program that draws the planned mesh declares that attribute as an integer input.
bool wantsIntegers(const plan::FramePlan& plan, plan::PlannedMeshIndex planned, std::string_view attribute,
                   const ProgramLibrary& programs) {
    for (const plan::PlannedPass& pass : plan.passes)
        for (const auto& step : pass.steps) {
            const auto* draw = std::get_if<plan::PlannedDraw>(&step);
            if (!draw || draw->mesh != planned) continue;
            const BuiltProgram* built = programs.find(plan.programs[draw->program].variant);
            if (!built) continue;
            for (const plan::ActiveInput& input : built->interface.inputs)
                if (input.integer && attributeOfInput(input.name) == attribute) return true;
        }
    return false;
}

/// The first draw of the planned mesh.
const scene::Draw* drawOf(const plan::FramePlan& plan, plan::PlannedMeshIndex planned) {
    for (const plan::PlannedPass& pass : plan.passes)
        for (const auto& step : pass.steps)
            if (const auto* draw = std::get_if<plan::PlannedDraw>(&step); draw && draw->mesh == planned)
                return draw->draw;
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

}  // namespace

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
    tell(shape, remarks);
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

void DeviceScene::tell(scene::ShapeIndex shape, Diagnostics* remarks) {
    const auto made = meshes_.find(shape);
    if (!remarks || made == meshes_.end() || made->second.areTold) return;
    made->second.areTold = true;
    append(*remarks, made->second.remarks);
}

const Bounds& DeviceScene::bounds(scene::ShapeIndex shape, bool withTangents, Diagnostics* remarks) {
    const auto [entry, isNew] = bounds_.try_emplace(shape);
    Bounds& bounds = entry->second;
    if (!isNew) {
        tell(shape, remarks);
        return bounds;
    }
    const std::string key = reuseKey(scene_, scene_.shapes[shape]);
    if (shared_ && !key.empty())
        if (const std::optional<Bounds> known = shared_->bounds.find(key)) return bounds = *known;
    const geometry::Mesh* made = mesh(shape, withTangents, remarks);
    if (!made) return bounds;
    const Bounds* earlier = previous_ ? previous_->boundsOfMesh(*made) : nullptr;
    bounds = earlier ? *earlier : boundsOf(*made);
    if (shared_ && !key.empty() && meshes_.at(shape).remarks.empty()) shared_->bounds.add(key, bounds, 1);
    return bounds;
}

const Bounds* DeviceScene::boundsOfMesh(const geometry::Mesh& mesh) const {
    for (const auto& [shape, made] : meshes_)
        if (made.mesh.get() == &mesh) return knownBounds(shape);
    return nullptr;
}

const Bounds* DeviceScene::knownBounds(scene::ShapeIndex shape) const {
    const auto found = bounds_.find(shape);
    return found == bounds_.end() ? nullptr : &found->second;
}

std::shared_ptr<const DeviceMesh> DeviceScene::earlierDeviceMesh(const std::string& key,
                                                                 const plan::FramePlan& plan,
                                                                 plan::PlannedMeshIndex planned) {
    if (key.empty()) return nullptr;
    if (previous_)
        for (const plan::PlannedMeshIndex i : previous_->deviceMeshes_.indices())
            if (previous_->deviceMeshes_[i] && previous_->deviceMeshKeys_[i] == key)
                return previous_->deviceMeshes_[i];
    std::shared_ptr<const DeviceMesh> found =
        shared_ ? shared_->deviceMeshes.find(key).value_or(nullptr) : nullptr;
    if (!found) return nullptr;
    stats_.add("meshes kept", 1);
    if (const scene::Draw* draw = drawOf(plan, planned))
        stats_.skip("mesh", draw->word + ": it is there already", draw->place);
    return found;
}

Diagnostics DeviceScene::upload(const plan::FramePlan& plan, plan::PlannedMeshIndex planned,
                                const ProgramLibrary& programs) {
    Diagnostics diagnostics;
    const plan::PlannedMesh& wanted = plan.meshes[planned];
    const bool withTangents = std::find(wanted.attributes.begin(), wanted.attributes.end(),
                                        geometry::kTangent) != wanted.attributes.end();
    std::string key = reuseKey(scene_, scene_.shapes[wanted.shape]);
    if (!key.empty())
        for (const std::string& each : wanted.attributes)
            key += (wantsIntegers(plan, planned, each, programs) ? " i" : " ") + each;
    deviceMeshKeys_[planned] = key;
    deviceMeshes_[planned] = earlierDeviceMesh(key, plan, planned);
    if (deviceMeshes_[planned]) return diagnostics;
    const geometry::Mesh* source = mesh(wanted.shape, withTangents, &diagnostics);
    if (!source || source->indices.empty()) return diagnostics;

    const StageTimer timer(stats_, "upload");
    auto uploaded = std::make_shared<DeviceMesh>();
    uploaded->vertexCount = source->vertexCount();
    uploaded->indexCount = static_cast<int>(source->indices.size());
    Result<gpu::Buffer> indices = gpu::Buffer::create(std::as_bytes(std::span(source->indices)));
    append(diagnostics, std::move(indices.diagnostics));
    if (!indices) return diagnostics;
    uploaded->indices = std::move(indices.value);
    for (const geometry::Attribute& each : source->attributes) {
        if (std::find(wanted.attributes.begin(), wanted.attributes.end(), each.name) ==
            wanted.attributes.end())
            continue;
        Result<gpu::Buffer> floats = gpu::Buffer::create(std::as_bytes(std::span(each.values)));
        append(diagnostics, std::move(floats.diagnostics));
        if (!floats) return diagnostics;
        DeviceMesh::Attribute attribute{each.name, each.components, std::move(*floats), std::nullopt};
        if (wantsIntegers(plan, planned, each.name, programs)) {
            std::vector<std::int32_t> values(each.values.size());
            std::transform(each.values.begin(), each.values.end(), values.begin(),
                           [](float value) { return static_cast<std::int32_t>(value); });
            Result<gpu::Buffer> integers = gpu::Buffer::create(std::as_bytes(std::span(values)));
            append(diagnostics, std::move(integers.diagnostics));
            attribute.integers = std::move(integers.value);
        }
        uploaded->attributes.push_back(std::move(attribute));
    }
    stats_.add("meshes", 1);
    stats_.add("vertices stored", uploaded->vertexCount);
    if (shared_ && !key.empty() && meshes_.at(wanted.shape).remarks.empty())
        shared_->deviceMeshes.add(key, uploaded, bytesOf(*uploaded));
    deviceMeshes_[planned] = std::move(uploaded);
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
    for (const plan::ActiveInput& input : built.interface.inputs) {
        const auto name = attributeOfInput(input.name);
        if (!name || input.location < 0) continue;
        for (const DeviceMesh::Attribute& each : mesh.attributes) {
            if (each.name != *name) continue;
            gpu::AttributeSource source;
            const bool integer = input.integer && each.integers;
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
