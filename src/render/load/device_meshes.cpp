#include "render/load/device_meshes.h"

#include <fmt/format.h>

#include <algorithm>
#include <new>
#include <span>
#include <utility>

#include "base/text.h"
#include "geometry/adjacency.h"
#include "plan/submission.h"
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
    return std::ranges::find(names, name) != names.end();
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

/// A mesh with a vertex for each index.
geometry::Mesh expanded(const geometry::Mesh& mesh, const std::vector<std::uint32_t>& indices) {
    geometry::Mesh result;
    result.pointCount = mesh.pointCount;
    for (const geometry::Attribute& each : mesh.attributes) {
        geometry::Attribute& made = result.attributes.emplace_back(each.name, each.components);
        const auto size = static_cast<std::size_t>(each.components);
        made.values.reserve(indices.size() * size);
        for (const std::uint32_t index : indices) {
            const auto first = each.values.begin() + static_cast<std::ptrdiff_t>(index * size);
            made.values.insert(made.values.end(), first, first + static_cast<std::ptrdiff_t>(size));
        }
    }
    return result;
}

}  // namespace

void DeviceMeshes::forgetShapes() {
    keptMeshes_.clear();
    keptDeviceMeshes_.clear();
    for (auto& [shape, made] : meshes_)
        if (!made.key.empty() && made.mesh) keptMeshes_.try_emplace(made.key, std::move(made.mesh));
    for (const auto& [plan, meshes] : plans_)
        for (const Uploaded& each : meshes)
            if (each.mesh && !each.key.empty()) keptDeviceMeshes_.try_emplace(each.key, each.mesh);
    meshes_.clear();
    bounds_.clear();
}

std::shared_ptr<const geometry::Mesh> DeviceMeshes::earlierMesh(const std::string& key) {
    if (key.empty()) return nullptr;
    if (const auto kept = keptMeshes_.find(key); kept != keptMeshes_.end()) return kept->second;
    if (previous_)
        for (const auto& [shape, made] : previous_->meshes_)
            if (made.key == key && made.mesh) return made.mesh;
    return shared_ ? shared_->meshes.find(key).value_or(nullptr) : nullptr;
}

const geometry::Mesh* DeviceMeshes::mesh(scene::ShapeIndex shape, bool withTangents, Diagnostics* remarks) {
    const bool isFile = bool(scene_.shapes[shape].file);
    const bool tangents = withTangents || !isFile;  // only models are made without
    const auto [known, isNew] = meshes_.try_emplace(shape);
    Made& made = known->second;
    if (isNew || (!made.withTangents && tangents && made.mesh)) make(shape, tangents, made);
    reportOnce(shape, remarks);
    return made.mesh.get();
}

void DeviceMeshes::make(scene::ShapeIndex shape, bool withTangents, Made& made) {
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

void DeviceMeshes::reportOnce(scene::ShapeIndex shape, Diagnostics* remarks) {
    const auto made = meshes_.find(shape);
    if (!remarks || made == meshes_.end() || made->second.areReported) return;
    made->second.areReported = true;
    append(*remarks, made->second.remarks);
}

const VertexBox& DeviceMeshes::bounds(scene::ShapeIndex shape, bool withTangents, Diagnostics* remarks) {
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

const VertexBox* DeviceMeshes::boundsOfMesh(const geometry::Mesh& mesh) const {
    for (const auto& [shape, made] : meshes_)
        if (made.mesh.get() == &mesh) return knownBounds(shape);
    return nullptr;
}

const VertexBox* DeviceMeshes::knownBounds(scene::ShapeIndex shape) const {
    const auto found = bounds_.find(shape);
    return found == bounds_.end() ? nullptr : &found->second;
}

std::shared_ptr<const DeviceMesh> DeviceMeshes::earlierDeviceMesh(const std::string& key,
                                                                  const plan::FramePlan& plan,
                                                                  plan::PlannedMeshIndex planned) {
    if (key.empty()) return nullptr;
    if (const auto kept = keptDeviceMeshes_.find(key); kept != keptDeviceMeshes_.end()) return kept->second;
    if (previous_)
        for (const auto& [earlier, meshes] : previous_->plans_)
            for (const Uploaded& each : meshes)
                if (each.mesh && each.key == key) return each.mesh;
    std::shared_ptr<const DeviceMesh> found =
        shared_ ? shared_->deviceMeshes.find(key).value_or(nullptr) : nullptr;
    if (!found) return nullptr;
    stats_.add("meshes kept", 1);
    if (const scene::Draw* draw = drawOf(plan, planned))
        stats_.skip("mesh", draw->word + ": already on the device", draw->place);
    return found;
}

Diagnostics DeviceMeshes::prepare(const plan::FramePlan& plan, const ProgramLibrary& programs) {
    Diagnostics diagnostics;
    scene::List<Uploaded, plan::PlannedMesh>& meshes = plans_[&plan];
    meshes.resize(plan.meshes.size());
    for (const plan::PlannedMeshIndex each : plan.meshes.indices())
        append(diagnostics, upload(plan, each, programs, meshes[each]));
    return diagnostics;
}

Diagnostics DeviceMeshes::upload(const plan::FramePlan& plan, plan::PlannedMeshIndex planned,
                                 const ProgramLibrary& programs, Uploaded& to) {
    const plan::PlannedMesh& wanted = plan.meshes[planned];
    const scene::Shape& shape = scene_.shapes[wanted.shape];
    if (shape.bare) {
        DeviceMesh bare;
        bare.indexCount = shape.numbers.empty() ? 0 : static_cast<int>(shape.numbers.front());
        to.mesh = std::make_shared<const DeviceMesh>(std::move(bare));
        return {};
    }
    const auto isInteger = [&](std::string_view attribute) {
        return wantsIntegers(plan, planned, attribute, programs);
    };
    std::string key = reuseKey(scene_, scene_.shapes[wanted.shape]);
    if (!key.empty())
        for (const std::string& each : wanted.attributes) key += (isInteger(each) ? " i" : " ") + each;
    if (!key.empty() && wanted.isExpanded) key += " expanded";
    if (!key.empty() && wanted.adjacency) key.append(" ").append(plan::wordOf(*wanted.adjacency));
    to = {earlierDeviceMesh(key, plan, planned), key};
    if (to.mesh) return {};
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
            diagnostics.push_back(diagnose("draw-E05", "cannot find neighbours: " + base::reasonOf(problem),
                                           draw ? draw->place : Place{scene_.path, 1, 1}));
            return diagnostics;
        }
    }
    const StageTimer timer(stats_, "upload");
    const std::vector<std::uint32_t>& indices = wanted.adjacency ? adjacency : source->indices;
    Result<DeviceMesh> made =
        wanted.isExpanded ? copyToDevice(expanded(*source, indices), indices, wanted.attributes, isInteger)
                          : copyToDevice(*source, indices, wanted.attributes, isInteger);
    append(diagnostics, std::move(made.diagnostics));
    if (!made) return diagnostics;
    const auto uploaded = std::make_shared<const DeviceMesh>(std::move(*made));
    stats_.add("meshes", 1);
    stats_.add("vertices stored", uploaded->vertexCount);
    if (shared_ && !key.empty() && meshes_.at(wanted.shape).remarks.empty())
        shared_->deviceMeshes.add(key, uploaded, bytesOf(*uploaded));
    to.mesh = uploaded;
    return diagnostics;
}

const DeviceMesh* DeviceMeshes::onDevice(const plan::FramePlan& plan, plan::PlannedMeshIndex planned) const {
    const auto found = plans_.find(&plan);
    return found == plans_.end() ? nullptr : found->second[planned].mesh.get();
}

}  // namespace glibra::render
