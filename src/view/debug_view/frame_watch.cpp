#include "view/debug_view/frame_watch.h"

#include <algorithm>
#include <map>
#include <utility>

#include "plan/accesses.h"
#include "view/debug_view/bound_target.h"
#include "view/debug_view/debug_program.h"
#include "view/debug_view/texels.h"
#include "view/scene/window_target.h"

namespace glibra::view {
namespace {

FrameThumbnail thumbnailOf(const render::Content& content, bool fits) {
    TexelDisplay display;
    if (fits) std::tie(display.low, display.high) = rangeOf(content, display.channels);
    return {content.width, content.height, screenBytes(content, display)};
}

class FrameLook {
  public:
    FrameLook(gpu::Context& context, render::LiveScene& scene, std::span<const FrameItem> items,
              const FrameQuestion& question)
        : context_(context), scene_(scene), items_(items), question_(question) {
        for (std::size_t i = 0; i < items.size(); ++i) {
            if (items[i].isInPass())
                ofStep_[items[i].step] = i;
            else
                ofNode_[items[i].node] = i;
        }
        answer_.isExecuted.resize(items.size());
        if (!question.thumbnails.empty()) answer_.thumbnails.resize(items.size());
    }

    FrameAnswer run() {
        const Result<gpu::Target> window =
            windowTarget(context_.capabilities(), scene_.scene(), question_.width, question_.height);
        if (!window) {
            answer_.problem = "there is no memory for another picture";
            return std::move(answer_);
        }
        render::FrameDrawer& drawer = scene_.drawer();
        drawer.setDrawHook([&](const plan::PlannedDraw& draw, bool, bool begins) {
            const auto found = ofStep_.find(draw.step);
            if (found == ofStep_.end()) return;
            begins ? beginDraw(draw, found->second) : left(found->second);
        });
        drawer.setNodeHook([&](std::size_t node, bool begins) {
            const auto found = ofNode_.find(node);
            if (found == ofNode_.end() || begins) return;
            takeClears(items_.size(), node);
            left(found->second);
        });
        const int width = question_.width, height = question_.height;
        render::Frame frame{scene_.view(), width, height, {0, 0, width, height}, question_.time};
        // What the window's passes read is there from the last frame.
        frame.texturePasses =
            !question_.thumbnails.empty() || !question_.item || !isOfWindow(items_[*question_.item]);
        drawer.draw(*window, frame);
        drawer.setDrawHook({});
        drawer.setNodeHook({});
        if (question_.item && !answer_.content && answer_.problem.empty())
            answer_.problem = answer_.isExecuted[*question_.item]
                                  ? "the driver cannot read this target"
                                  : "nothing of it is drawn: it is out of sight, or its program failed";
        return std::move(answer_);
    }

  private:
    const scene::Pass& passOf(const FrameItem& item) const {
        return scene_.scene().frame.passes.at(item.step.pass);
    }

    bool isOfWindow(const FrameItem& item) const { return item.hasPass() && passOf(item).isWindow; }
    bool wantsThumbnail(std::size_t item) {
        if (item >= question_.thumbnails.size() || !question_.thumbnails[item]) return false;
        return ++thumbnails_ <= kMostThumbnails;
    }

    /// The clears of the node before that item have been carried out.
    void takeClears(std::size_t before, std::size_t node) {
        for (; next_ < before && next_ < items_.size() && items_[next_].node <= node; ++next_)
            if (items_[next_].kind == FrameItem::Kind::clear && items_[next_].node == node) left(next_);
    }

    void beginDraw(const plan::PlannedDraw& draw, std::size_t item) {
        takeClears(item, items_[item].node);
        if (question_.item == item) drawMask(draw, items_[item]);
    }

    /// The layers of the target that the item draws into, or whose shaders write it, all at once; 1: one.
    int layersOf(const FrameItem& item, const FrameTarget& target) const {
        if (item.hasPass()) return view::layersOf(scene_, passOf(item));
        const gpu::Texture* texture = target.view.texture ? scene_.texture(target.view.texture) : nullptr;
        if (texture == nullptr || target.view.layer) return 1;
        return texture->layers(target.view.level.value_or(0));
    }

    std::optional<render::Content> read(const FrameItem& item, const FrameTarget& target, int mostSide,
                                        int layer = 0) {
        if (target.kind == FrameTarget::Kind::buffer) return std::nullopt;
        if (!item.hasPass()) {
            const gpu::Texture* texture = scene_.texture(target.view.texture);
            scene::TextureView view = target.view;
            const int layers = layersOf(item, target);
            if (layers > 1) view.layer = std::min(layer, layers - 1);
            return texture != nullptr ? readTexture(context_.capabilities(), *texture, view, mostSide)
                                      : std::nullopt;
        }
        const scene::Pass& pass = passOf(item);
        const gpu::TextureSize size = sizeOf(scene_, pass, question_.width, question_.height);
        return readBound(context_.capabilities(), partOf(scene_, target, size, layerOf(scene_, pass, layer)),
                         mostSide);
    }

    /// Looks at what is there after the item.
    void left(std::size_t index) {
        const FrameItem& item = items_[index];
        answer_.isExecuted[index] = true;
        if (wantsThumbnail(index) && !item.targets.empty()) {
            const FrameTarget& first = item.targets.front();
            const bool isOther = first.kind != FrameTarget::Kind::color;
            if (const auto content = read(item, first, kThumbnailSide))
                answer_.thumbnails[index] = thumbnailOf(*content, isOther || !isByte(first));
        }
        if (question_.item != index || item.targets.empty()) return;
        const FrameTarget& wanted = item.targets[std::min(question_.target, item.targets.size() - 1)];
        if (wanted.kind == FrameTarget::Kind::buffer) {
            answer_.problem = "'" + wanted.name + "' is a buffer";
            return;
        }
        answer_.layers = layersOf(item, wanted);
        if (item.hasPass() && answer_.layers > 1)
            answer_.layerName =
                layerName(scene_, passOf(item), std::min(question_.layer, answer_.layers - 1));
        answer_.content = read(item, wanted, 0, question_.layer);
    }

    /// True if the values of the target lie in 0..1.
    bool isByte(const FrameTarget& target) const {
        const gpu::Texture* texture = target.view.texture ? scene_.texture(target.view.texture) : nullptr;
        return texture == nullptr || base::rowOf(texture->format()).kind == base::TexelClass::normalized;
    }

    void drawMask(const plan::PlannedDraw& draw, const FrameItem& item) {
        const render::BuiltProgram* built = scene_.drawer().programOf(draw);
        // Shaders that store would store twice.
        if (built == nullptr || plan::writesMemory(scene_.plan().programs[draw.program], draw.textures))
            return;
        const scene::Pass& pass = passOf(item);
        const gpu::TextureSize size = sizeOf(scene_, pass, question_.width, question_.height);
        const KeptState kept;
        const auto beside = BesideTarget::make(context_.capabilities(), scene_, pass, size, question_.layer);
        const auto program = makeDebugProgram(context_, *built, DebugView::layers, DebugStages::numbers);
        if (!beside || !program) return;
        program->use(*built);
        beside->clear();
        beside->bind(kDebugOutput);
        glDepthMask(GL_FALSE);
        glStencilMask(0);
        // Red: passes the tests. Green: covers the pixel.
        maskOutput(GL_TRUE, GL_FALSE);
        scene_.drawer().submit(draw, true);
        glDisable(GL_DEPTH_TEST);
        glDisable(GL_STENCIL_TEST);
        maskOutput(GL_FALSE, GL_TRUE);
        scene_.drawer().submit(draw, true);
        const render::Content content = beside->read(context_.capabilities());
        DrawMask mask{content.width, content.height, {}};
        for (std::size_t i = 0; i < content.size(); ++i) {
            const auto texel = content.at(i);
            const DrawMask::Kind kind = texel[0] > 0   ? DrawMask::passed
                                        : texel[1] > 0 ? DrawMask::hidden
                                                       : DrawMask::none;
            mask.pixels.push_back(kind);
            if (kind == DrawMask::passed) ++mask.passedPixels;
            if (kind == DrawMask::hidden) ++mask.hiddenPixels;
        }
        answer_.mask = std::move(mask);
    }

    /// The colour masks of the output that the debug program writes: they go by draw buffer.
    static void maskOutput(GLboolean red, GLboolean green) {
        glColorMaski(kDebugOutput, red, green, GL_FALSE, GL_FALSE);
        glDisablei(GL_BLEND, kDebugOutput);
    }

    gpu::Context& context_;
    render::LiveScene& scene_;
    std::span<const FrameItem> items_;
    const FrameQuestion& question_;
    std::map<scene::StepIndex, std::size_t> ofStep_;
    std::map<std::size_t, std::size_t> ofNode_;  ///< items that are not in a pass
    std::size_t next_ = 0;                       ///< the first item whose clear has not been seen
    std::size_t thumbnails_ = 0;
    FrameAnswer answer_;
};

}  // namespace

FrameAnswer watchFrame(gpu::Context& context, render::LiveScene& scene, std::span<const FrameItem> items,
                       const FrameQuestion& question) {
    return FrameLook(context, scene, items, question).run();
}

}  // namespace glibra::view
