#include "render/device_scene.h"

#include <algorithm>

#include "glsl/builtins.h"
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
bool wantsIntegers(const plan::FramePlan& plan, std::size_t planned, std::string_view attribute,
                   const ProgramLibrary& programs) {
    for (const plan::PlannedPass& pass : plan.passes)
        for (const auto& step : pass.steps) {
            const auto* draw = std::get_if<plan::PlannedDraw>(&step);
            if (!draw || static_cast<std::size_t>(draw->mesh) != planned) continue;
            const BuiltProgram* built =
                programs.find(plan.programs[static_cast<std::size_t>(draw->program)].variant);
            if (!built) continue;
            for (const plan::ActiveInput& input : built->interface.inputs)
                if (input.integer && attributeOfInput(input.name) == attribute) return true;
        }
    return false;
}

}  // namespace

Diagnostics DeviceScene::prepare(const plan::FramePlan& plan, const ProgramLibrary& programs) {
    Diagnostics diagnostics;
    deviceMeshes_.resize(plan.meshes.size());
    deviceMeshKeys_.resize(plan.meshes.size());
    for (std::size_t i = 0; i < plan.meshes.size(); ++i) append(diagnostics, upload(plan, i, programs));
    for (const int texture : plan.textures) append(diagnostics, makeTexture(texture));
    previous_ = nullptr;
    return diagnostics;
}

bool DeviceScene::takeMesh(std::size_t planned, const std::string& key) {
    deviceMeshKeys_[planned] = key;
    if (!previous_ || key.empty()) return false;
    for (std::size_t i = 0; i < previous_->deviceMeshes_.size(); ++i)
        if (previous_->deviceMeshes_[i] && previous_->deviceMeshKeys_[i] == key) {
            deviceMeshes_[planned] = std::move(previous_->deviceMeshes_[i]);
            return true;
        }
    return false;
}

bool DeviceScene::takeTexture(int index, const std::string& key) {
    if (key.empty()) return false;
    textureKeys_[index] = key;
    if (!previous_) return false;
    for (const auto& [known, knownKey] : previous_->textureKeys_) {
        const auto found = previous_->textures_.find(known);
        if (knownKey != key || found == previous_->textures_.end()) continue;
        textures_.emplace(index, std::move(found->second));
        previous_->textures_.erase(found);
        return true;
    }
    return false;
}

const geometry::Mesh* DeviceScene::mesh(int shape, bool withTangents, Diagnostics& diagnostics) {
    const auto [entry, isNew] = meshes_.try_emplace(shape);
    if (isNew) {
        const std::string key = reuseKey(scene_, scene_.shapes[static_cast<std::size_t>(shape)]);
        if (!key.empty()) meshKeys_[shape] = key + (withTangents ? " t" : "");
        if (previous_ && !key.empty())
            for (auto& [known, mesh] : previous_->meshes_)
                if (mesh && previous_->meshKeys_[known] == meshKeys_[shape]) {
                    entry->second = std::move(mesh);
                    mesh.reset();
                    return &*entry->second;
                }
        const StageTimer timer(stats_, "geometry");
        Result<geometry::Mesh> made = scene::makeMesh(scene_, shape, withTangents);
        append(diagnostics, std::move(made.diagnostics));
        entry->second = std::move(made.value);
    }
    return entry->second ? &*entry->second : nullptr;
}

Diagnostics DeviceScene::upload(const plan::FramePlan& plan, std::size_t planned,
                                const ProgramLibrary& programs) {
    Diagnostics diagnostics;
    const plan::PlannedMesh& wanted = plan.meshes[planned];
    const bool withTangents = std::find(wanted.attributes.begin(), wanted.attributes.end(),
                                        geometry::kTangent) != wanted.attributes.end();
    std::string key = reuseKey(scene_, scene_.shapes[static_cast<std::size_t>(wanted.shape)]);
    if (!key.empty())
        for (const std::string& each : wanted.attributes)
            key += (wantsIntegers(plan, planned, each, programs) ? " i" : " ") + each;
    if (takeMesh(planned, key)) return diagnostics;
    const geometry::Mesh* source = mesh(wanted.shape, withTangents, diagnostics);
    if (!source || source->indices.empty()) return diagnostics;

    const StageTimer timer(stats_, "upload");
    auto uploaded = std::make_unique<DeviceMesh>();
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
    deviceMeshes_[planned] = std::move(uploaded);
    return diagnostics;
}

const DeviceMesh* DeviceScene::deviceMesh(int planned) const {
    return deviceMeshes_[static_cast<std::size_t>(planned)].get();
}

const gpu::VertexArray& DeviceScene::vertexArray(int planned, int program, const BuiltProgram& built) {
    const auto known = vertexArrays_.find({planned, program});
    if (known != vertexArrays_.end()) return known->second;
    const DeviceMesh& mesh = *deviceMeshes_[static_cast<std::size_t>(planned)];
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
