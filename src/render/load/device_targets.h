#pragma once
// The render targets of passes into textures, and the depth buffers that passes share.

#include <deque>
#include <map>
#include <optional>
#include <set>
#include <tuple>
#include <vector>

#include "gpu/context/context.h"
#include "gpu/object/framebuffer.h"
#include "render/load/device_textures.h"
#include "scene/scene.h"

namespace glibra::render {

/// The format of depth buffers that the scene does not name. Only modern scenes have a stencil.
inline gpu::TexelFormat depthFormat(const scene::Scene& scene) {
    return scene.isModern ? gpu::TexelFormat::depth24_stencil8 : gpu::TexelFormat::depth24;
}

class DeviceTargets {
  public:
    DeviceTargets(const gpu::Context& context, const scene::Scene& scene, const DeviceTextures& textures)
        : context_(context), scene_(scene), textures_(textures) {}

    /// The target of a pass into textures; cached. In modern scenes draw-E10 if a part does not exist.
    Result<const gpu::Target*> of(const scene::Pass& pass);
    /// Forgets the targets of textures that have been destroyed, with their depth buffers.
    void forget(const std::set<const gpu::Texture*>& gone);

  private:
    struct Made {
        std::vector<scene::TextureIndex> targets;
        std::vector<scene::TargetPart> parts;
        std::optional<scene::TextureView> depth;
        int depthBuffer = 0;
        bool hasDepth = true;
        std::vector<const gpu::Texture*> textures;  ///< of the targets and the depth
        gpu::Target target;
    };
    Result<gpu::Target> make(const scene::Pass& pass);

    const gpu::Context& context_;
    const scene::Scene& scene_;
    const DeviceTextures& textures_;
    /// By number, width and height: the numbers are those of one moment.
    std::map<std::tuple<int, int, int>, gpu::SharedDepth> depthBuffers_;
    std::deque<Made> made_;
};

}  // namespace glibra::render
