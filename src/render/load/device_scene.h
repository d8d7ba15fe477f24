#pragma once
// The meshes, textures and targets of a scene on the device, each made at its first use.

#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "gpu/context/context.h"
#include "gpu/object/buffer.h"
#include "gpu/object/target.h"
#include "gpu/object/texture.h"
#include "gpu/object/vertex_array.h"
#include "image/image.h"
#include "image/limits.h"
#include "noise/texel_bytes.h"
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
    std::optional<gpu::Buffer> indices;
    int indexCount = 0;
    std::size_t vertexCount = 0;
};

class DeviceScene {
  public:
    /// `shared`: parts of other scenes, or null. `sharesTextures`: statements that name the same files share
    /// one texture.
    DeviceScene(const gpu::Context& context, const scene::Scene& scene, Stats& stats,
                SharedParts* shared = nullptr, bool sharesTextures = true)
        : context_(context), scene_(scene), stats_(stats), shared_(shared), sharesTextures_(sharesTextures) {}

    /// Sets the device scene before the scene was read again; it must exist until prepare(), which takes over
    /// unchanged meshes and textures.
    void inherit(DeviceScene& previous) { previous_ = &previous; }
    /// Call it after the scene has been interpreted for another moment, before prepare(): shapes may have
    /// other indices, textures have not. Meshes that both moments have stay on the device.
    void beginMoment();
    /// Makes all meshes and textures of the plan. Errors name the scene line that needs them.
    Diagnostics prepare(const plan::FramePlan& plan, const ProgramLibrary& programs);

    /// The CPU mesh of a shape, kept until releaseMeshes(); null if it could not be made, with the reason in
    /// `remarks`. If `remarks` is null, the next call with `remarks` gets them. No GL.
    const geometry::Mesh* mesh(scene::ShapeIndex shape, bool withTangents, Diagnostics* remarks);
    /// The box of the vertices of that mesh; makes the mesh if necessary. No GL.
    const VertexBox& bounds(scene::ShapeIndex shape, bool withTangents, Diagnostics* remarks);
    /// Reads the files of a texture or computes its noise, unless that is done; prepare() uses the result. No
    /// GL.
    void readAhead(scene::TextureIndex texture);
    /// The box that bounds() has found for the shape, or null.
    [[nodiscard]] const VertexBox* knownBounds(scene::ShapeIndex shape) const;
    /// Call it after the shape has changed.
    void forgetMesh(scene::ShapeIndex shape) {
        meshes_.erase(shape);
        bounds_.erase(shape);
    }
    /// Frees the CPU meshes.
    void releaseMeshes() { meshes_.clear(); }

    /// Null if the mesh has nothing to draw.
    [[nodiscard]] const DeviceMesh* deviceMesh(plan::PlannedMeshIndex planned) const;
    /// Null if it has not been made.
    [[nodiscard]] const gpu::Texture* texture(scene::TextureIndex texture) const;
    /// A texture that reads (0, 0, 0, 1) everywhere.
    const gpu::Texture& emptyTexture(scene::TextureTarget target);
    const gpu::Sampler& sampler(bool clamp);
    /// The vertex array that connects the mesh's buffers to the program's inputs; cached.
    const gpu::VertexArray& vertexArray(plan::PlannedMeshIndex planned, plan::PlannedProgramIndex program,
                                        const BuiltProgram& built);
    /// The render target of a pass into textures; cached.
    Result<const gpu::Target*> target(const scene::Pass& pass);

  private:
    struct MadeMesh {
        std::shared_ptr<const geometry::Mesh> mesh;
        bool withTangents = false;
        Diagnostics remarks;
        bool areReported = false;
        std::string key;
    };
    using PictureTexels = Result<image::TexelBlock>;
    using NoiseTexels = Result<noise::TexelShorts>;
    void make(scene::ShapeIndex shape, bool withTangents, MadeMesh& made);
    void reportOnce(scene::ShapeIndex shape, Diagnostics* remarks);
    std::shared_ptr<const geometry::Mesh> earlierMesh(const std::string& key);
    [[nodiscard]] const VertexBox* boundsOfMesh(const geometry::Mesh& mesh) const;
    std::shared_ptr<const DeviceMesh> earlierDeviceMesh(const std::string& key, const plan::FramePlan& plan,
                                                        plan::PlannedMeshIndex planned);
    std::shared_ptr<const gpu::Texture> earlierTexture(const std::string& key, const scene::Texture& texture);
    Diagnostics upload(const plan::FramePlan& plan, plan::PlannedMeshIndex planned,
                       const ProgramLibrary& programs);
    Diagnostics makeTexture(scene::TextureIndex index);
    Result<gpu::Texture> createTexture(const scene::Texture& texture, const std::string& key);
    NoiseTexels noiseTexels(const scene::NoiseSource& source, const Place& place);
    PictureTexels pictureTexels(const scene::Texture& texture, const scene::PictureSource& picture);
    /// Takes the bytes of a texture from what is left for the scene; draw-E08 if it is not enough.
    std::optional<Diagnostic> charge(std::uint64_t bytes, const scene::Texture& texture);

    const gpu::Context& context_;
    const scene::Scene& scene_;
    Stats& stats_;
    SharedParts* shared_;
    bool sharesTextures_;
    DeviceScene* previous_ = nullptr;
    std::map<std::string, std::shared_ptr<const geometry::Mesh>> keptMeshes_;  ///< of the last moment, by key
    std::map<std::string, std::shared_ptr<const DeviceMesh>> keptDeviceMeshes_;
    std::map<scene::ShapeIndex, MadeMesh> meshes_;
    std::map<scene::ShapeIndex, VertexBox> bounds_;
    scene::List<std::string, plan::PlannedMesh> deviceMeshKeys_;
    std::map<scene::TextureIndex, std::string> textureKeys_;
    scene::List<std::shared_ptr<const DeviceMesh>, plan::PlannedMesh> deviceMeshes_;
    std::map<scene::TextureIndex, std::shared_ptr<const gpu::Texture>> textures_;
    std::set<scene::TextureIndex> written_;  ///< textures that programs may write to as images; never shared
    /// Files and target of a picture -> the texture that holds it.
    std::map<std::pair<std::vector<scene::FileIndex>, scene::TextureTarget>, scene::TextureIndex> pictures_;
    std::map<scene::TextureIndex, scene::TextureIndex> sameTexture_;
    std::map<std::string, PictureTexels> picturesAhead_;  ///< by reuseKey()
    std::map<std::string, NoiseTexels> noiseAhead_;
    std::uint64_t texelBytesLeft_ = image::kSceneTexelBytes;
    std::map<scene::TextureTarget, gpu::Texture> emptyTextures_;
    std::map<bool, gpu::Sampler> samplers_;
    std::map<std::pair<plan::PlannedMeshIndex, plan::PlannedProgramIndex>, gpu::VertexArray> vertexArrays_;
    std::map<int, gpu::SharedDepth> depthBuffers_;
    std::map<std::pair<std::vector<scene::TextureIndex>, int>, gpu::Target> targets_;
};

}  // namespace glibra::render
