#pragma once
// The buffers of a scene on the device: made once, with the content that the scene declares.

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <tuple>
#include <vector>

#include "gpu/context/context.h"
#include "gpu/object/buffer.h"
#include "gpu/object/framebuffer.h"
#include "gpu/state/state_tracker.h"
#include "plan/buffers.h"
#include "plan/frame_plan.h"
#include "render/load/gl_names.h"
#include "render/stats.h"
#include "scene/scene.h"

namespace glibra::render {

/// A buffer as the last picture left it.
struct BufferContent {
    plan::BufferLayout layout;
    plan::BufferTable table;
    std::vector<std::byte> bytes;
};

/// Reads it from the device, and waits for that.
BufferContent contentOf(const plan::BufferLayout& layout, const gpu::Buffer& buffer);

class DeviceBuffers {
  public:
    DeviceBuffers(const gpu::Context& context, const scene::Scene& scene, Stats& stats)
        : context_(context), scene_(scene), stats_(stats) {}

    /// Lays out and makes the buffers of the plan. A buffer whose declared values are others than before gets
    /// them, unless it lasts. Errors: memory-E03 to E05, E17, draw-E05, and those of files.
    /// `others`: as of plan::BufferLayouts::add.
    Diagnostics prepare(const plan::FramePlan& plan, std::span<const plan::FramePlan* const> others = {});
    /// DeviceScene::followSizes. True if a buffer has been forgotten.
    bool followSizes();
    /// What has happened to a buffer that nodes write.
    ObjectState& state(scene::BufferIndex buffer) { return states_[buffer]; }

    /// Null if it has not been made.
    [[nodiscard]] const gpu::Buffer* buffer(const scene::BufferView& view) const;
    /// Null if the buffer has not been made.
    [[nodiscard]] const plan::BufferLayout* layout(scene::BufferIndex buffer) const;
    /// The numbers of a buffer from number `first` on, in order of declaration; fewer than `count` at its
    /// end. Waits for the device.
    [[nodiscard]] std::vector<double> read(const scene::BufferView& view, std::uint64_t first,
                                           std::uint64_t count) const;

    /// Makes the content as declared, in both copies of a buffer with history.
    Diagnostics reset(scene::BufferIndex buffer);
    /// Replaces bytes of a buffer that has been made: in both copies of one with history, and in what reset()
    /// gives back. Other values that the scene declares later do not replace them.
    Diagnostics write(scene::BufferIndex buffer, std::size_t offset, std::span<const std::byte> bytes);
    /// DeviceTextures::giveWritten.
    Diagnostics giveWritten(DeviceBuffers& copy) const;
    /// Keeps what write() has given before a node writes the buffer for the first time.
    Diagnostics keepGiven(scene::BufferIndex buffer);
    /// DeviceScene::takeOver.
    void takeOver(DeviceBuffers& previous, scene::BufferIndex buffer);
    /// Sets all bytes to zero. The other copy of a buffer with history stays as it is.
    void clear(scene::BufferIndex buffer);
    /// Exchanges the two copies of a buffer with history, before something writes to it. `keepsContent`: the
    /// new one begins with the content of the other.
    void exchange(scene::BufferIndex buffer, bool keepsContent);

    /// Binds the buffer that the use reads as a texture to its unit.
    void bind(const plan::TextureUse& use, gpu::BindingTracker& bindings);
    /// Reports memory-E17 for buffers with more texels than the driver reads as a texture.
    [[nodiscard]] Diagnostics checkTexels(const plan::FramePlan& plan) const;

  private:
    struct Made {
        gpu::Buffer current;
        std::optional<gpu::Buffer> previous;
        std::optional<gpu::Buffer> declared;  ///< what reset() gives back; made when it is needed
        bool isGiven = false;                 ///< by write()
        scene::BufferValues values;           ///< that it was declared with
        std::uint64_t declaredSize = 0;       ///< elements or numbers that the scene has declared
        std::uint64_t charged = 0;            ///< bytes of bytesLeft_
    };
    Diagnostics make(scene::BufferIndex index);
    /// Gives a buffer that has become longer by padding that many bytes, with its content.
    Diagnostics grow(Made& made, std::uint64_t bytes);
    /// The declared bytes, with what computing them has reported; empty if all are zero.
    Result<std::vector<std::byte>> declaredBytes(scene::BufferIndex index);
    Result<gpu::Buffer> filled(std::size_t bytes, std::span<const std::byte> content);

    void setZero(gpu::Buffer& buffer) { clearer_.clear(context_.capabilities(), buffer); }

    const gpu::Context& context_;
    const scene::Scene& scene_;
    Stats& stats_;
    plan::BufferLayouts layouts_;
    gpu::BufferClearer clearer_;
    std::map<scene::BufferIndex, Made> made_;
    std::vector<gpu::Buffer> outgrown_;  ///< kept, since caches find buffers by their GL names
    std::map<scene::BufferIndex, ObjectState> states_;
    /// By buffer, copy and format.
    std::map<std::tuple<scene::BufferIndex, bool, gpu::TexelFormat>, gpu::BufferTexture> textures_;
    std::uint64_t bytesLeft_ = kMostBytes;
    /// What the buffers of a scene may have together.
    static constexpr std::uint64_t kMostBytes = std::uint64_t{2} << 30;
};

}  // namespace glibra::render
