#pragma once
// A scene on the device: its meshes, textures, buffers and targets, each made at its first use, and what
// feeds the inputs of its programs.

#include <map>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <tuple>
#include <vector>

#include "gpu/context/context.h"
#include "gpu/object/buffer.h"
#include "gpu/state/state_tracker.h"
#include "plan/accesses.h"
#include "plan/frame_plan.h"
#include "render/load/device_buffers.h"
#include "render/load/device_meshes.h"
#include "render/load/device_textures.h"
#include "render/load/programs.h"
#include "render/load/shared_parts.h"
#include "render/stats.h"
#include "scene/scene.h"

namespace glibra::render {

class DeviceScene {
  public:
    /// `shared`: parts of other scenes, or null. `sharesTextures`: statements that name the same files share
    /// one texture.
    DeviceScene(const gpu::Context& context, const scene::Scene& scene, Stats& stats,
                SharedParts* shared = nullptr, bool sharesTextures = true)
        : scene_(scene),
          meshes_(scene, stats, shared),
          textures_(context, scene, stats, shared, sharesTextures),
          targets_(context, scene, textures_),
          buffers_(context, scene, stats) {}
    DeviceScene(const DeviceScene&) = delete;
    DeviceScene& operator=(const DeviceScene&) = delete;

    [[nodiscard]] DeviceMeshes& meshes() { return meshes_; }
    [[nodiscard]] const DeviceMeshes& meshes() const { return meshes_; }
    [[nodiscard]] DeviceTextures& textures() { return textures_; }
    [[nodiscard]] const DeviceTextures& textures() const { return textures_; }
    [[nodiscard]] DeviceBuffers& buffers() { return buffers_; }
    [[nodiscard]] const DeviceBuffers& buffers() const { return buffers_; }
    /// How long a draw with that program took at most, divided by its pixels; 0: it has not been measured.
    double& secondsPerPixel(const BuiltProgram* program) { return secondsPerPixel_[program]; }

    /// Sets the device scene before the scene was read again; it must exist until prepare(), which takes over
    /// unchanged meshes and textures.
    void inherit(DeviceScene& previous);
    /// Call it after the scene has been interpreted for another moment, before prepare() of that plan: shapes
    /// may have other indices, textures have not. Meshes that both moments have stay on the device.
    void beginMoment(const plan::FramePlan& plan);
    /// Call it after beginMoment(): forgets empty textures and buffers that the scene now declares in another
    /// size than they were made in; prepare() makes them again. Textures that last are made at once, empty.
    /// Content is lost if a texture lasts, and with every buffer, since blocks may have bound it.
    Diagnostics followSizes(Resized& resized);
    /// Textures that nodes of the plan write to are not shared. Call it before the first prepare().
    void noteWrites(const plan::FramePlan& plan) { textures_.noteWrites(plan); }
    /// Makes all meshes, textures and buffers of the plan, which must not move. Errors name the scene line
    /// that needs them.
    Diagnostics prepare(const plan::FramePlan& plan, const ProgramLibrary& programs,
                        std::span<const plan::FramePlan* const> others = {});
    /// Forgets the meshes of a plan that is prepared no longer.
    void forget(const plan::FramePlan& plan);

    /// What has happened to an object that nodes write.
    ObjectState& state(const plan::Object& object);
    /// Notes that a node is about to write the object. Errors: no memory for what reset() gives back.
    Diagnostics noteWritten(const plan::Object& object, gpu::BindingTracker& bindings);
    /// Makes a buffer or texture as declared, in both copies of one with history.
    Diagnostics reset(const plan::Object& object);
    /// Takes an object that nodes write to, with its content, from the device scene before the scene was
    /// read again. Both scenes declare it equally.
    void takeOver(DeviceScene& previous, const plan::Object& object);
    /// Binds the texture and sampler, the image, or the buffer to the unit of the use.
    void bind(const plan::TextureUse& use, gpu::BindingTracker& bindings);
    /// The render target of a pass into textures; cached. Error draw-E10 if a part does not
    /// exist.
    Result<const gpu::Target*> target(const scene::Pass& pass) { return targets_.of(pass); }

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
    [[nodiscard]] std::optional<Elements> elementsOf(const plan::InputSource& source) const;
    /// Adds what feeds an input from them, one source per column.
    static void addBufferSources(const Elements& elements, bool isPerInstance, const base::ActiveInput& input,
                                 std::vector<gpu::AttributeSource>& sources);
    /// What feeds the inputs of the program; without `inputs` what glibra supplies.
    const std::vector<plan::InputSource>& inputSources(const plan::FramePlan& plan,
                                                       plan::PlannedInputsIndex inputs,
                                                       const BuiltProgram& built);

  private:
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

    const scene::Scene& scene_;
    DeviceMeshes meshes_;
    DeviceTextures textures_;
    DeviceTargets targets_;
    DeviceBuffers buffers_;
    std::map<const BuiltProgram*, double> secondsPerPixel_;
    /// By mesh, inputs, and the names of the scene's buffers that feed them and hold the indices.
    using ArrayKey = std::tuple<plan::PlannedMeshIndex, plan::PlannedInputsIndex, std::vector<GLuint>>;
    std::map<const plan::FramePlan*, std::map<ArrayKey, gpu::VertexArray>> vertexArrays_;
    std::set<std::tuple<scene::BufferIndex, std::uint64_t, std::uint64_t>> checkedIndices_;
    std::map<const BuiltProgram*, std::vector<plan::InputSource>> suppliedSources_;
};

}  // namespace glibra::render
