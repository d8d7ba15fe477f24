#pragma once
// The textures of a scene on the device, each made at its first use, with what samplers read of them.

#include <array>
#include <cstdint>
#include <deque>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "gpu/context/context.h"
#include "gpu/object/framebuffer.h"
#include "gpu/object/texture.h"
#include "gpu/object/texture_copy.h"
#include "gpu/state/state_tracker.h"
#include "image/file.h"
#include "image/image.h"
#include "noise/noise.h"
#include "plan/frame_plan.h"
#include "render/load/gl_names.h"
#include "render/load/shared_parts.h"
#include "render/stats.h"
#include "scene/scene.h"

namespace glibra::render {

/// Numbers of texels, top row first, tightly packed.
struct TexelNumbers {
    int width = 0, height = 0;
    int components = 4;
    gpu::TexelType type = gpu::TexelType::f32;
    std::vector<std::byte> data;
};

/// The type of numbers that keeps the texels of a format as they are; floats for those of other steps.
gpu::TexelType numberTypeOf(const base::TexelFormatRow& row);

class DeviceTextures {
  public:
    /// `shared` and `sharesTextures`: as of DeviceScene.
    DeviceTextures(const gpu::Context& context, const scene::Scene& scene, Stats& stats, SharedParts* shared,
                   bool sharesTextures)
        : context_(context), scene_(scene), stats_(stats), shared_(shared), sharesTextures_(sharesTextures) {}

    /// prepare() takes over unchanged textures, until inherit(nullptr).
    void inherit(DeviceTextures* previous) { previous_ = previous; }
    /// DeviceScene::noteWrites.
    void noteWrites(const plan::FramePlan& plan);
    /// Makes the textures of the plan, each in memory of its own or in that of another one.
    Diagnostics prepare(const plan::FramePlan& plan);
    /// DeviceScene::followSizes.
    Diagnostics followSizes(Resized& resized);
    /// The textures that have been destroyed since the last call.
    std::set<const gpu::Texture*> takeGone() { return std::exchange(gone_, {}); }
    /// Reads the files of a texture or computes its noise, unless that is done; prepare() uses the result. No
    /// GL.
    void readAhead(scene::TextureIndex texture);
    /// Reports draw-E10 for parts of textures that this driver cannot read alone.
    [[nodiscard]] Diagnostics checkParts(const plan::FramePlan& plan) const;

    /// What has happened to a texture that nodes write.
    ObjectState& state(scene::TextureIndex texture) { return made_[texture].state; }
    /// The texture, or the current copy of one with history. Null if it has not been made.
    [[nodiscard]] const gpu::Texture* texture(scene::TextureIndex texture) const;
    /// The copy that the view names; the whole of it, whatever its level and layer.
    [[nodiscard]] const gpu::Texture* texture(const scene::TextureView& view) const;
    /// What samplers read of the texture: with its samples resolved and its mipmaps made; the whole of it,
    /// whatever the view's level and layer. Null if it has not been made. The scissor test must be off.
    const gpu::Texture* completed(const scene::TextureView& view);
    /// SceneRenderer::textureImage.
    Result<image::Image> imageOf(const scene::TextureView& view);
    /// The same texels in the components of the texture's format and in the type that loses nothing: bytes
    /// and 16 bits of normalised numbers, integers of their own size, and floats of all else.
    Result<TexelNumbers> numbersOf(const scene::TextureView& view);

    /// The copies of a texture with history change their places: what was current is the previous one.
    void exchange(scene::TextureIndex texture);
    /// Gives the current copy the content of the previous one.
    Diagnostics copyFromPrevious(scene::TextureIndex texture, gpu::BindingTracker& bindings);
    /// Sets a texture that nodes write to zero; with history only the current copy.
    void clear(scene::TextureIndex texture);
    /// Makes it as declared, in both copies of one with history.
    Diagnostics reset(scene::TextureIndex texture);
    /// DeviceScene::takeOver.
    void takeOver(DeviceTextures& previous, scene::TextureIndex texture);
    /// Replaces level 0 of a texture that has been made, which is then no other one's: in both copies of one
    /// with history, and what reset() gives back. Not for samples.
    Diagnostics write(scene::TextureIndex texture, const gpu::Texels& texels);
    /// Writes into the textures of a copy of the scene what was written into the same ones here.
    Diagnostics giveWritten(DeviceTextures& copy) const;
    /// Keeps the content of a texture from a file, or from write(), before a node writes it for the first
    /// time; reset() gives it back.
    Diagnostics keepDeclared(scene::TextureIndex texture, gpu::BindingTracker& bindings);
    /// Something has been drawn or stored into the current copy.
    void wasWritten(scene::TextureIndex texture);
    /// True if mipmaps or resolved samples that the sampler reads are older than the texture.
    [[nodiscard]] bool isIncomplete(const plan::TextureUse& use) const;
    /// Makes them. The scissor test must be off.
    void complete(const plan::TextureUse& use);
    /// Binds the texture and sampler, or the image, to the unit of the use.
    void bind(const plan::TextureUse& use, gpu::BindingTracker& bindings);

  private:
    /// Of a texture that nodes write to and that has a name.
    struct Copies {
        struct Copy {
            std::shared_ptr<gpu::Texture> texture;
            std::shared_ptr<gpu::Texture> resolved;  ///< of a multisampled texture
            bool isResolved = true;                  ///< `resolved` is up to date
            bool hasMipmaps = true;                  ///< mipmaps are up to date
        };
        std::array<Copy, 2> copies;  ///< the second one only with history
        std::size_t current = 0;
        std::shared_ptr<gpu::Texture> declared;  ///< what reset() gives back, once a node has written it
        bool isGiven = false;                    ///< by write()

        [[nodiscard]] const Copy& of(const scene::TextureView& view) const {
            return copies[view.isPrevious ? 1 - current : current];
        }
        Copy& now() { return copies[current]; }
        Copy& before() { return copies[1 - current]; }
    };
    /// All about one texture of the scene.
    struct Made {
        std::shared_ptr<const gpu::Texture> texture;  ///< the current copy; null: it has not been made
        std::optional<Copies> copies;
        scene::TextureIndex sharing{};  ///< the one whose memory it uses (FramePlan::sharing)
        std::string key;                ///< reuseKey() of what it was made from
        std::uint64_t charged = 0;      ///< from texelBytesLeft_
        bool mayBeWritten = false;      ///< by nodes; never shared with other scenes
        ObjectState state;
    };
    using PictureTexels = Result<image::TexelBlock>;
    using NoiseTexels = Result<noise::TexelShorts>;

    [[nodiscard]] const Copies* copiesOf(scene::TextureIndex texture) const {
        const auto found = made_.find(texture);
        return found == made_.end() || !found->second.copies ? nullptr : &*found->second.copies;
    }
    [[nodiscard]] Copies* copiesOf(scene::TextureIndex texture) {
        return const_cast<Copies*>(std::as_const(*this).copiesOf(texture));
    }
    /// One layer of one level; draw-E10 if there is no such part, or several.
    Result<TexelNumbers> read(const scene::TextureView& view, int components, gpu::TexelType type);
    /// `isFilled`: gpu::TextureLayout::isFilled, of empty textures.
    Diagnostics make(scene::TextureIndex index, bool isFilled = true);
    /// True if the texture of a unit has been made as the scene states it now. One that another moment had in
    /// another size or from other files is forgotten.
    bool isMade(scene::TextureIndex index, const std::string& key);
    /// Makes `declared` of the copies, without its content.
    Diagnostics makeDeclared(scene::TextureIndex index);
    /// Forgets a texture with its copies, and what was made of them.
    void drop(Made& made);
    std::shared_ptr<const gpu::Texture> earlierTexture(const std::string& key, const scene::Texture& texture);
    Result<gpu::Texture> create(const scene::Texture& texture, const std::string& key, bool isFilled);
    Result<gpu::Texture> createNamed(const scene::Texture& texture, image::TexelBlock block);
    /// Makes the second copy of a texture with history, and what its samples are resolved into.
    Diagnostics makeCopies(scene::TextureIndex index, std::shared_ptr<gpu::Texture> first);
    /// A texture that reads (0, 0, 0, 1) everywhere.
    const gpu::Texture& emptyTexture(scene::TextureTarget target);
    const gpu::Sampler& sampler(const base::SamplerState& state, bool compares);
    /// The texture or the part of it that the use reads.
    const gpu::Texture* readable(const plan::TextureUse& use);
    const gpu::Texture* layerCopy(const gpu::Texture& whole, const scene::TextureView& view);
    NoiseTexels noiseTexels(const scene::NoiseSource& source, const Place& place);
    PictureTexels pictureTexels(const scene::Texture& texture, const scene::PictureSource& picture);
    /// Takes the bytes of a texture from what is left for the scene; draw-E08 if it is not enough.
    std::optional<Diagnostic> charge(std::uint64_t bytes, const scene::Texture& texture);

    const gpu::Context& context_;
    const scene::Scene& scene_;
    Stats& stats_;
    SharedParts* shared_;
    bool sharesTextures_;
    DeviceTextures* previous_ = nullptr;
    std::map<scene::TextureIndex, Made> made_;
    std::set<const gpu::Texture*> gone_;
    gpu::TextureCopier copier_;
    /// Parts of textures as samplers read them: texture, level, layer.
    std::map<std::tuple<const gpu::Texture*, int, int>, gpu::Texture> views_;
    std::map<std::string, scene::TextureIndex> pictures_;  ///< reuseKey() -> the texture made of it last
    std::map<std::string, PictureTexels> picturesAhead_;   ///< by reuseKey()
    std::map<std::string, NoiseTexels> noiseAhead_;
    std::uint64_t texelBytesLeft_ = image::kSceneTexelBytes;
    std::map<scene::TextureTarget, gpu::Texture> emptyTextures_;
    struct MadeSampler {
        base::SamplerState state;
        bool compares = false;
        gpu::Sampler sampler;
    };
    std::deque<MadeSampler> samplers_;  ///< few, so that a search is fast
};

// The render targets of passes into textures, and the depth buffers that passes share.

/// The format of a depth buffer that the scene does not name: of a pass that is reversed or not, or of the
/// window of a scene with Scene::reversesWindow or without it.
constexpr gpu::TexelFormat depthFormat(bool isReversed) {
    return isReversed ? gpu::TexelFormat::depth32f_stencil8 : gpu::TexelFormat::depth24_stencil8;
}

class DeviceTargets {
  public:
    DeviceTargets(const gpu::Context& context, const scene::Scene& scene, const DeviceTextures& textures)
        : context_(context), scene_(scene), textures_(textures) {}

    /// The target of a pass into textures; cached. Error draw-E10 if a part does not exist.
    Result<const gpu::Target*> of(const scene::Pass& pass);
    /// Forgets the targets of textures that have been destroyed, with their depth buffers.
    void forget(const std::set<const gpu::Texture*>& gone);

  private:
    struct Made {
        std::vector<scene::TextureIndex> targets;
        std::vector<scene::TargetPart> parts;
        std::optional<scene::TextureView> depth;
        int depthBuffer = 0;
        bool hasDepth = true, isReversed = false;
        std::vector<const gpu::Texture*> textures;  ///< of the targets and the depth
        gpu::Target target;
    };
    Result<gpu::Target> make(const scene::Pass& pass);

    const gpu::Context& context_;
    const scene::Scene& scene_;
    const DeviceTextures& textures_;
    /// By number, width, height and whether it is reversed: the numbers are those of one moment.
    std::map<std::tuple<int, int, int, bool>, gpu::SharedDepth> depthBuffers_;
    std::deque<Made> made_;
};

}  // namespace glibra::render
