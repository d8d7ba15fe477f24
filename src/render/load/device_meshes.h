#pragma once
// The meshes of a scene: as vertices, and on the device with the attributes that programs read.

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "geometry/mesh.h"
#include "gpu/object/buffer.h"
#include "plan/frame_plan.h"
#include "render/load/programs.h"
#include "render/load/shared_parts.h"
#include "render/stats.h"
#include "scene/scene.h"

namespace glibra::render {

/// A mesh on the device: one buffer for each attribute that a program reads.
struct DeviceMesh {
    struct Attribute {
        std::string name;
        int components = 0;
        gpu::Buffer floats;
        std::optional<gpu::Buffer>
            integers;  ///< the same values as ints, if a program declares an integer input
    };
    std::vector<Attribute> attributes;
    std::optional<gpu::Buffer> indices;  ///< nothing: vertices without data
    int indexCount = 0;                  ///< without `indices` the vertices of the shape, or 0
    int pointCount = 0;                  ///< of the last indices, which are points (geometry::Mesh)
    std::size_t vertexCount = 0;
};

class DeviceMeshes {
  public:
    DeviceMeshes(const scene::Scene& scene, Stats& stats, SharedParts* shared)
        : scene_(scene), stats_(stats), shared_(shared) {}

    /// prepare() takes over unchanged meshes, until inherit(nullptr).
    void inherit(DeviceMeshes* previous) { previous_ = previous; }
    /// Forgets the shapes of the scene, because it has been interpreted for another moment, when shapes may
    /// have other indices. Meshes that both moments have stay on the device.
    void forgetShapes();
    /// Makes all meshes of the plan on the device.
    Diagnostics prepare(const plan::FramePlan& plan, const ProgramLibrary& programs);
    /// Forgets those of a plan.
    void forget(const plan::FramePlan& plan) { plans_.erase(&plan); }

    /// The CPU mesh of a shape, kept until release(); null if it could not be made, with the reason in
    /// `remarks`. If `remarks` is null, the next call with `remarks` gets them. No GL.
    const geometry::Mesh* mesh(scene::ShapeIndex shape, bool withTangents, Diagnostics* remarks);
    /// The box of the vertices of that mesh; makes the mesh if necessary. No GL.
    const VertexBox& bounds(scene::ShapeIndex shape, bool withTangents, Diagnostics* remarks);
    /// The box that bounds() has found for the shape, or null.
    [[nodiscard]] const VertexBox* knownBounds(scene::ShapeIndex shape) const;
    /// Call it after the shape has changed.
    void forget(scene::ShapeIndex shape) {
        meshes_.erase(shape);
        bounds_.erase(shape);
    }
    /// Frees the CPU meshes.
    void release() { meshes_.clear(); }

    /// Null if the mesh has nothing to draw.
    [[nodiscard]] const DeviceMesh* onDevice(const plan::FramePlan& plan,
                                             plan::PlannedMeshIndex planned) const;

  private:
    struct Made {
        std::shared_ptr<const geometry::Mesh> mesh;
        bool withTangents = false;
        Diagnostics remarks;
        bool areReported = false;
        std::string key;
    };
    struct Uploaded {
        std::shared_ptr<const DeviceMesh> mesh;
        std::string key;
    };
    void make(scene::ShapeIndex shape, bool withTangents, Made& made);
    void reportOnce(scene::ShapeIndex shape, Diagnostics* remarks);
    std::shared_ptr<const geometry::Mesh> earlierMesh(const std::string& key);
    [[nodiscard]] const VertexBox* boundsOfMesh(const geometry::Mesh& mesh) const;
    std::shared_ptr<const DeviceMesh> earlierDeviceMesh(const std::string& key, const plan::FramePlan& plan,
                                                        plan::PlannedMeshIndex planned);
    Diagnostics upload(const plan::FramePlan& plan, plan::PlannedMeshIndex planned,
                       const ProgramLibrary& programs, Uploaded& to);

    const scene::Scene& scene_;
    Stats& stats_;
    SharedParts* shared_;
    DeviceMeshes* previous_ = nullptr;
    std::map<std::string, std::shared_ptr<const geometry::Mesh>> keptMeshes_;  ///< of the last moment, by key
    std::map<std::string, std::shared_ptr<const DeviceMesh>> keptDeviceMeshes_;
    std::map<scene::ShapeIndex, Made> meshes_;
    std::map<scene::ShapeIndex, VertexBox> bounds_;
    std::map<const plan::FramePlan*, scene::List<Uploaded, plan::PlannedMesh>> plans_;
};

}  // namespace glibra::render
