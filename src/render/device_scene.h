#pragma once
// A scene's meshes, textures and targets on the device, made when first asked for.

#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "gpu/buffer.h"
#include "gpu/context.h"
#include "gpu/target.h"
#include "gpu/texture.h"
#include "gpu/vertex_array.h"
#include "image/image.h"
#include "noise/texel_bytes.h"
#include "plan/frame_plan.h"
#include "render/programs.h"
#include "render/shared_parts.h"
#include "render/stats.h"
#include "scene/scene.h"

namespace glibra::render {

/// A mesh on the device: one buffer for each attribute that some program reads.
struct DeviceMesh {
    struct Attribute {
        std::string name;
        int components = 0;
        gpu::Buffer floats;
        std::optional<gpu::Buffer>
            integers;  ///< the same values as ints, where a program declares the input so
    };
    std::vector<Attribute> attributes;
    std::optional<gpu::Buffer> indices;
    int indexCount = 0;
    std::size_t vertexCount = 0;
};

class DeviceScene {
  public:
    /// `shared`: what other scenes have made already, or null.
    DeviceScene(const gpu::Context& context, const scene::Scene& scene, Stats& stats,
                SharedParts* shared = nullptr)
        : context_(context), scene_(scene), stats_(stats), shared_(shared) {}
    /// Statements that name the same files no longer share one texture.
    void separateTextures() { sharesPictures_ = false; }

    /// What the scene had before it was read again: prepare() takes over meshes and textures that are still
    /// the same. It must live until then.
    void inherit(DeviceScene& previous) { previous_ = &previous; }
    /// Makes all meshes and textures of the plan. Errors name the scene line that wants them.
    Diagnostics prepare(const plan::FramePlan& plan, const ProgramLibrary& programs);

    /// The CPU mesh of a shape, kept until releaseMeshes; null if it could not be made, with the reason in
    /// `remarks`. Without `remarks` they wait for the next who asks. No GL.
    const geometry::Mesh* mesh(scene::ShapeIndex shape, bool withTangents, Diagnostics* remarks);
    /// Of the vertices of that mesh, which is made for it if need be. No GL.
    const Bounds& bounds(scene::ShapeIndex shape, bool withTangents, Diagnostics* remarks);
    /// Reads the files of a texture, or computes its noise, if nobody has yet; prepare() uses it. No GL.
    void readAhead(scene::TextureIndex texture);
    /// What bounds() has found out for the shape, or null.
    [[nodiscard]] const Bounds* knownBounds(scene::ShapeIndex shape) const;
    /// The shape is another now.
    void forgetMesh(scene::ShapeIndex shape) {
        meshes_.erase(shape);
        bounds_.erase(shape);
    }
    /// Frees the CPU's copies.
    void releaseMeshes() { meshes_.clear(); }

    /// Null if the mesh has nothing to draw.
    [[nodiscard]] const DeviceMesh* deviceMesh(plan::PlannedMeshIndex planned) const;
    /// Null if it has not been made.
    [[nodiscard]] const gpu::Texture* texture(scene::TextureIndex texture) const;
    /// Reads (0, 0, 0, 1) everywhere.
    const gpu::Texture& emptyTexture(scene::TextureTarget target);
    const gpu::Sampler& sampler(bool clamp);
    /// Joins the mesh's buffers and the program's inputs; kept.
    const gpu::VertexArray& vertexArray(plan::PlannedMeshIndex planned, plan::PlannedProgramIndex program,
                                        const BuiltProgram& built);
    /// The render target of a pass into textures; kept.
    Result<const gpu::Target*> target(const scene::Pass& pass);

  private:
    struct MadeMesh {
        std::shared_ptr<const geometry::Mesh> mesh;
        bool withTangents = false;
        Diagnostics remarks;
        bool areTold = false;
        std::string key;
    };
    using PictureTexels = Result<image::TexelBlock>;
    using NoiseTexels = Result<noise::TexelShorts>;
    void make(scene::ShapeIndex shape, bool withTangents, MadeMesh& made);
    void tell(scene::ShapeIndex shape, Diagnostics* remarks);
    std::shared_ptr<const geometry::Mesh> earlierMesh(const std::string& key);
    [[nodiscard]] const Bounds* boundsOfMesh(const geometry::Mesh& mesh) const;
    std::shared_ptr<const DeviceMesh> earlierDeviceMesh(const std::string& key, const plan::FramePlan& plan,
                                                        plan::PlannedMeshIndex planned);
    std::shared_ptr<const gpu::Texture> earlierTexture(const std::string& key, const scene::Texture& texture);
    Diagnostics upload(const plan::FramePlan& plan, plan::PlannedMeshIndex planned,
                       const ProgramLibrary& programs);
    Diagnostics makeTexture(scene::TextureIndex index);
    Result<gpu::Texture> createTexture(const scene::Texture& texture, const std::string& key);
    NoiseTexels noiseTexels(const scene::NoiseSource& source, const Place& place);
    PictureTexels pictureTexels(const scene::Texture& texture, const scene::PictureSource& picture);

    const gpu::Context& context_;
    const scene::Scene& scene_;
    Stats& stats_;
    SharedParts* shared_;
    DeviceScene* previous_ = nullptr;
    bool sharesPictures_ = true;
    std::map<scene::ShapeIndex, MadeMesh> meshes_;
    std::map<scene::ShapeIndex, Bounds> bounds_;
    scene::List<std::string, plan::PlannedMesh> deviceMeshKeys_;
    std::map<scene::TextureIndex, std::string> textureKeys_;
    scene::List<std::shared_ptr<const DeviceMesh>, plan::PlannedMesh> deviceMeshes_;
    std::map<scene::TextureIndex, std::shared_ptr<const gpu::Texture>> textures_;
    std::set<scene::TextureIndex> written_;  ///< textures that programs may write to as images: nobody else's
    /// Files and target of a picture -> the texture that holds it.
    std::map<std::pair<std::vector<scene::FileIndex>, scene::TextureTarget>, scene::TextureIndex> pictures_;
    std::map<scene::TextureIndex, scene::TextureIndex> sameTexture_;
    std::map<std::string, PictureTexels> picturesAhead_;  ///< by reuseKey()
    std::map<std::string, NoiseTexels> noiseAhead_;
    std::map<scene::TextureTarget, gpu::Texture> emptyTextures_;
    std::map<bool, gpu::Sampler> samplers_;
    std::map<std::pair<plan::PlannedMeshIndex, plan::PlannedProgramIndex>, gpu::VertexArray> vertexArrays_;
    std::map<int, gpu::SharedDepth> depthBuffers_;
    std::map<std::pair<std::vector<scene::TextureIndex>, int>, gpu::Target> targets_;
};

}  // namespace glibra::render
