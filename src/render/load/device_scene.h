#pragma once
// The meshes, textures and targets of a scene on the device, each made at its first use.

#include <array>
#include <deque>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <tuple>
#include <vector>

#include "gpu/context/context.h"
#include "gpu/object/buffer.h"
#include "gpu/object/buffer_texture.h"
#include "gpu/object/sampler.h"
#include "gpu/object/target.h"
#include "gpu/object/texture.h"
#include "gpu/object/texture_copy.h"
#include "gpu/object/vertex_array.h"
#include "gpu/state/binding_tracker.h"
#include "image/image.h"
#include "image/limits.h"
#include "noise/texel_bytes.h"
#include "plan/accesses.h"
#include "plan/frame_plan.h"
#include "render/load/device_buffers.h"
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

/// The format of depth buffers that the scene does not name. Only modern scenes have a stencil.
inline gpu::TexelFormat depthFormat(const scene::Scene& scene) {
    return scene.isModern ? gpu::TexelFormat::depth24_stencil8 : gpu::TexelFormat::depth24;
}

class DeviceScene {
  public:
    /// `shared`: parts of other scenes, or null. `sharesTextures`: statements that name the same files share
    /// one texture.
    DeviceScene(const gpu::Context& context, const scene::Scene& scene, Stats& stats,
                SharedParts* shared = nullptr, bool sharesTextures = true)
        : context_(context),
          scene_(scene),
          stats_(stats),
          shared_(shared),
          sharesTextures_(sharesTextures),
          buffers_(context, scene, stats) {}

    /// How long a draw with that program took at most, divided by its pixels; 0: it has not been measured.
    double& secondsPerPixel(const BuiltProgram* program) { return secondsPerPixel_[program]; }
    /// Sets the device scene before the scene was read again; it must exist until prepare(), which takes over
    /// unchanged meshes and textures.
    void inherit(DeviceScene& previous) { previous_ = &previous; }
    /// Call it after the scene has been interpreted for another moment, before prepare() of that plan: shapes
    /// may have other indices, textures have not. Meshes that both moments have stay on the device.
    void beginMoment(const plan::FramePlan& plan);
    /// Call it after beginMoment(): forgets empty textures that the scene now declares in another size than
    /// they were made in; prepare() makes them again. Those that last are made at once, empty, and
    /// `hasLost` is set to true.
    Diagnostics followSizes(bool& hasLost);
    /// Forgets the shapes of the scene, because it has been interpreted for another moment. Meshes on the
    /// device stay.
    void forgetShapes();
    /// Textures that shaders of the plan write to are not shared. Call it before the first prepare().
    void noteWrites(const plan::FramePlan& plan);
    /// Makes all meshes, textures and buffers of the plan, which must not move. Errors name the scene line
    /// that needs them.
    Diagnostics prepare(const plan::FramePlan& plan, const ProgramLibrary& programs);
    /// Forgets the meshes of a plan that is prepared no longer.
    void forget(const plan::FramePlan& plan) { plans_.erase(&plan); }

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

    /// What samplers read of the texture: with its samples resolved and its mipmaps made; the whole of it,
    /// whatever the view's level and layer. Null if it has not been made. The scissor test must be off.
    const gpu::Texture* completed(const scene::TextureView& view);
    /// Null if the mesh has nothing to draw.
    [[nodiscard]] const DeviceMesh* deviceMesh(const plan::FramePlan& plan,
                                               plan::PlannedMeshIndex planned) const;
    /// The texture, or the current copy of one with history. Null if it has not been made.
    [[nodiscard]] const gpu::Texture* texture(scene::TextureIndex texture) const;
    /// The copy that the view names; the whole of it, whatever its level and layer.
    [[nodiscard]] const gpu::Texture* texture(const scene::TextureView& view) const;
    /// The copies of a texture with history change their places: what was current is the previous one.
    void exchange(scene::TextureIndex texture);
    /// Gives the current copy the content of the previous one.
    Diagnostics copyFromPrevious(scene::TextureIndex texture, gpu::BindingTracker& bindings);
    /// Sets a texture that nodes write to zero; with history only the current copy.
    void clear(scene::TextureIndex texture);
    /// Makes a buffer or texture as declared, in both copies of one with history.
    Diagnostics reset(const scene::ObjectView& object);
    /// Takes an object that nodes write to, with its content, from the device scene before the scene was
    /// read again. Both scenes declare it equally.
    void takeOver(DeviceScene& previous, const scene::ObjectView& object);
    /// Notes that a node is about to write the object. Errors: no memory for what reset() gives back.
    Diagnostics noteWritten(const plan::Object& object, gpu::BindingTracker& bindings);
    /// True if the object is not as declared because a frame has written it.
    [[nodiscard]] bool isChanged(const plan::Object& object) const { return changed_.contains(object); }
    /// False: the object is as it was made, or as reset() has made it.
    [[nodiscard]] bool hasBeenWritten(const plan::Object& object) const { return stored_.contains(object); }
    /// What Once and Step write is not reset by frames.
    void setLasting(const plan::Object& object);
    /// Something has been drawn or stored into the current copy.
    void wasWritten(scene::TextureIndex texture);
    /// True if mipmaps or resolved samples that the sampler reads are older than the texture.
    [[nodiscard]] bool isIncomplete(const plan::TextureUse& use) const;
    /// Makes them. The scissor test must be off.
    void complete(const plan::TextureUse& use);
    /// Binds the texture and sampler, or the image, to the unit of the use.
    void bind(const plan::TextureUse& use, gpu::BindingTracker& bindings);

    /// SceneRenderer::textureImage.
    Result<image::Image> imageOf(const scene::TextureView& view);

    [[nodiscard]] bool isModern() const { return scene_.isModern; }
    /// The vertex array that connects the program's inputs to what feeds them, with the indices of the draw
    /// or of its mesh; cached. Without inputs of the draw they read what glibra supplies.
    const gpu::VertexArray& vertexArray(const plan::FramePlan& plan, const plan::PlannedDraw& planned,
                                        const BuiltProgram& built);
    /// 32-bit indices in a buffer of the scene.
    struct Indices {
        const gpu::Buffer* buffer = nullptr;
        std::uint64_t offset = 0;  ///< bytes before the first one
        int count = 0;
    };
    /// The indices of `Draw::indices`; nothing if it has none, or without a buffer that can hold them.
    [[nodiscard]] std::optional<Indices> indicesOf(const scene::Draw& draw) const;
    /// The name of the buffer that Draw::indices is.
    [[nodiscard]] const std::string& nameOfIndices(const scene::Draw& draw) const {
        return scene_.buffers[draw.indices.buffer].name;
    }
    /// What a vertex input reads of a buffer.
    struct Elements {
        const gpu::Buffer* buffer = nullptr;
        std::uint64_t at = 0;      ///< byte at which the first element begins
        std::uint64_t stride = 0;  ///< bytes
        std::uint64_t count = 0;
        std::vector<plan::MemoryNumber> numbers;  ///< counted from where an element begins
    };
    /// Nothing for other sources, and for a member that the buffer does not have.
    [[nodiscard]] std::optional<Elements> elementsOf(const plan::FramePlan& plan,
                                                     const plan::InputSource& source) const;
    /// Adds what feeds an input from them, one source per column.
    static void addBufferSources(const Elements& elements, bool isPerInstance, const base::ActiveInput& input,
                                 std::vector<gpu::AttributeSource>& sources);
    /// What feeds the inputs of the program; without `inputs` what glibra supplies.
    const std::vector<plan::InputSource>& inputSources(const plan::FramePlan& plan,
                                                       plan::PlannedInputsIndex inputs,
                                                       const BuiltProgram& built);
    [[nodiscard]] DeviceBuffers& buffers() { return buffers_; }
    [[nodiscard]] const DeviceBuffers& buffers() const { return buffers_; }
    /// The render target of a pass into textures; cached. In modern scenes draw-E10 if a part does not
    /// exist.
    Result<const gpu::Target*> target(const scene::Pass& pass);

  private:
    struct MadeMesh {
        std::shared_ptr<const geometry::Mesh> mesh;
        bool withTangents = false;
        Diagnostics remarks;
        bool areReported = false;
        std::string key;
    };
    /// What belongs to one plan.
    struct PlanParts {
        scene::List<std::shared_ptr<const DeviceMesh>, plan::PlannedMesh> meshes;
        scene::List<std::string, plan::PlannedMesh> keys;
        /// By mesh, inputs, and the names of the scene's buffers that feed them and hold the indices.
        std::map<std::tuple<plan::PlannedMeshIndex, plan::PlannedInputsIndex, std::vector<GLuint>>,
                 gpu::VertexArray>
            vertexArrays;
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
    /// Reports memory-E04 for buffers with more texels than the driver reads as a texture.
    Diagnostics checkBufferTextures(const plan::FramePlan& plan) const;
    void bindBuffer(const plan::TextureUse& use, gpu::BindingTracker& bindings);
    /// memory-E13 for draws with more vertices or instances than a buffer that feeds an input has elements,
    /// where the script gives the counts.
    [[nodiscard]] Diagnostics checkElements(const plan::FramePlan& plan) const;
    /// draw-E12 for attributes that name members which their buffers do not have.
    [[nodiscard]] Diagnostics membersProblems(const plan::FramePlan& plan,
                                              const plan::PlannedDraw& planned) const;
    [[nodiscard]] std::optional<std::string> elementsProblem(const plan::FramePlan& plan,
                                                             const plan::PlannedDraw& planned) const;
    /// memory-E13 for draws whose indices are no indices, are too few, or lie outside of their attributes.
    Diagnostics checkIndices(const plan::FramePlan& plan);
    /// What is wrong with the indices of a draw. `isAsDeclared`: no shader writes them.
    std::optional<std::string> indexProblem(const plan::FramePlan& plan, const plan::PlannedDraw& planned,
                                            bool isAsDeclared);
    struct IndexAt {
        std::size_t element = 0;
        double vertex = 0;
    };
    /// The first of `count` declared indices that is not below `limit`; those of a file are read once.
    std::optional<IndexAt> firstIndexFrom(scene::BufferIndex buffer, std::uint64_t count, std::uint64_t limit,
                                          bool restarts);
    /// `isFilled`: gpu::TextureLayout::isFilled, of empty textures.
    Diagnostics makeTexture(scene::TextureIndex index, bool isFilled = true);
    /// True if the texture of a unit has been made as the scene states it now. One that another moment had in
    /// another size or from other files is forgotten.
    bool isMade(scene::TextureIndex index, const std::string& key);
    /// Forgets a texture with its copies, and what was made of them.
    void dropTexture(scene::TextureIndex index);
    /// Makes the textures of the plan, each in memory of its own or in that of another one.
    Diagnostics makeTextures(const plan::FramePlan& plan);
    Result<gpu::Texture> createTexture(const scene::Texture& texture, const std::string& key, bool isFilled);
    Result<gpu::Texture> createNamed(const scene::Texture& texture, image::TexelBlock block);
    /// Makes the second copy of a texture with history, and what its samples are resolved into.
    Diagnostics makeCopies(scene::TextureIndex index, std::shared_ptr<gpu::Texture> first);
    /// Keeps the content of a texture from a file before a node writes it for the first time.
    Diagnostics keepDeclared(scene::TextureIndex index, gpu::BindingTracker& bindings);
    /// Gives it back.
    Diagnostics resetToFile(scene::TextureIndex index);
    /// Reports draw-E10 for parts of textures that this driver cannot read alone.
    [[nodiscard]] Diagnostics checkParts(const plan::FramePlan& plan) const;
    /// A texture that reads (0, 0, 0, 1) everywhere.
    const gpu::Texture& emptyTexture(scene::TextureTarget target);
    const gpu::Sampler& sampler(const base::SamplerState& state, bool compares);
    /// The texture or the part of it that the use reads.
    const gpu::Texture* readable(const plan::TextureUse& use);
    const gpu::Texture* layerCopy(const gpu::Texture& whole, const scene::TextureView& view);
    Result<gpu::Target> makeTarget(const scene::Pass& pass);
    NoiseTexels noiseTexels(const scene::NoiseSource& source, const Place& place);
    PictureTexels pictureTexels(const scene::Texture& texture, const scene::PictureSource& picture);
    /// Takes the bytes of a texture from what is left for the scene; draw-E08 if it is not enough.
    std::optional<Diagnostic> charge(std::uint64_t bytes, const scene::Texture& texture);

    const gpu::Context& context_;
    const scene::Scene& scene_;
    Stats& stats_;
    SharedParts* shared_;
    std::map<const BuiltProgram*, double> secondsPerPixel_;
    gpu::TextureCopier copier_;
    bool sharesTextures_;
    DeviceScene* previous_ = nullptr;
    std::map<std::string, std::shared_ptr<const geometry::Mesh>> keptMeshes_;  ///< of the last moment, by key
    std::map<std::string, std::shared_ptr<const DeviceMesh>> keptDeviceMeshes_;
    std::map<scene::ShapeIndex, MadeMesh> meshes_;
    std::map<scene::ShapeIndex, VertexBox> bounds_;
    std::map<scene::TextureIndex, std::string> textureKeys_;
    std::map<const plan::FramePlan*, PlanParts> plans_;
    std::map<scene::TextureIndex, std::shared_ptr<const gpu::Texture>> textures_;
    std::set<scene::TextureIndex> written_;  ///< textures that nodes may write to; never shared
    /// A texture that nodes write to and that has a name.
    struct Copies {
        struct Copy {
            std::shared_ptr<gpu::Texture> texture;
            std::shared_ptr<gpu::Texture> resolved;  ///< of a multisampled texture
            bool isResolved = true;                  ///< `resolved` is up to date
            bool hasMipmaps = true;                  ///< mipmaps are up to date
        };
        std::array<Copy, 2> copies;  ///< the second one only with history
        std::size_t current = 0;
        std::shared_ptr<const gpu::Texture> declared;  ///< of a file: its content, once a node has written it
    };
    std::map<scene::TextureIndex, Copies> copies_;
    std::map<scene::TextureIndex, scene::TextureIndex> sharing_;  ///< FramePlan::sharing, as made
    std::set<plan::Object> changed_, lasting_;
    std::set<plan::Object> stored_;  ///< of hasBeenWritten
    /// Parts of textures as samplers read them: texture, level, layer.
    std::map<std::tuple<const gpu::Texture*, int, int>, gpu::Texture> views_;
    /// What decides the texels of a picture -> the texture that holds it.
    struct PictureKey {
        std::vector<scene::FileIndex> files;
        scene::TextureTarget target{};
        bool isFlipped = false, isSrgb = false, hasMipmaps = false;
        friend auto operator<=>(const PictureKey&, const PictureKey&) = default;
    };
    std::map<PictureKey, scene::TextureIndex> pictures_;
    std::map<scene::TextureIndex, scene::TextureIndex> sameTexture_;
    std::map<std::string, PictureTexels> picturesAhead_;  ///< by reuseKey()
    std::map<std::string, NoiseTexels> noiseAhead_;
    std::uint64_t texelBytesLeft_ = image::kSceneTexelBytes;
    std::map<scene::TextureIndex, std::uint64_t> charged_;  ///< of textures on units, from texelBytesLeft_
    std::map<scene::TextureTarget, gpu::Texture> emptyTextures_;
    struct MadeSampler {
        base::SamplerState state;
        bool compares = false;
        gpu::Sampler sampler;
    };
    std::deque<MadeSampler> samplers_;  ///< few, so that a search is fast
    /// By number, width and height: the numbers are those of one moment.
    std::map<std::tuple<int, int, int>, gpu::SharedDepth> depthBuffers_;
    struct MadeTarget {
        std::vector<scene::TextureIndex> targets;
        std::vector<scene::TargetPart> parts;
        std::optional<scene::TextureView> depth;
        int depthBuffer = 0;
        std::vector<const gpu::Texture*> textures;  ///< of the targets and the depth
        gpu::Target target;
    };
    std::deque<MadeTarget> targets_;
    DeviceBuffers buffers_;
    std::set<std::tuple<scene::BufferIndex, std::uint64_t, std::uint64_t>> checkedIndices_;
    /// By buffer, copy and format.
    std::map<std::tuple<scene::BufferIndex, bool, gpu::TexelFormat>, gpu::BufferTexture> bufferTextures_;
    std::map<const BuiltProgram*, std::vector<plan::InputSource>> suppliedSources_;
};

}  // namespace glibra::render
