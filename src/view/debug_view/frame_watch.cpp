#include "view/debug_view/frame_watch.h"

#include <glad/gl.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>

#include "base/raster_state.h"
#include "gpu/object/timer.h"
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

bool mayDiscard(const render::BuiltProgram& built) {
    const glsl::TranslatedStage* fragment = stageOf(built, glsl::Stage::fragment);
    return fragment != nullptr && fragment->facts.mayLeaveFragments;
}

class PixelWatch {
  public:
    PixelWatch(gpu::Context& context, render::LiveScene& scene, std::span<const FrameItem> items,
               std::size_t item, const TargetPixel& pixel, int output)
        : context_(context),
          scene_(scene),
          items_(items),
          pass_(scene.scene().frame.passes.at(items[item].step.pass)),
          pixel_{pixel.x, pixel.y, 1, 1},
          layer_(layerOf(scene, pass_, pixel.layer)) {
        const auto& passes = scene.scene().frame.passes;
        for (std::size_t i = 0; i < items.size(); ++i) {
            const FrameItem& each = items[i];
            if (!each.hasPass() || !haveSameTargets(pass_, passes.at(each.step.pass))) continue;
            if (each.kind == FrameItem::Kind::pass)
                ofNode_[each.node] = i;
            else
                ofStep_[each.step] = i;
        }
        for (const FrameTarget& each : items[item].targets)
            if (each.kind != FrameTarget::Kind::color || each.output == output) targets_.push_back(each);
    }

    PixelHistory run(int width, int height, double time) {
        size_ = sizeOf(scene_, pass_, width, height);
        if (pixel_.x < 0 || pixel_.y < 0 || pixel_.x >= size_.width || pixel_.y >= size_.height)
            return {{}, 0, "the pixel lies outside of the target"};
        const Result<gpu::Target> window =
            windowTarget(context_.capabilities(), scene_.scene(), width, height);
        if (!window) return {{}, 0, "there is no memory for another picture"};
        render::FrameDrawer& drawer = scene_.drawer();
        render::Frame frame{scene_.view(), width, height, {0, 0, width, height}, time};
        // What the window's passes read is there from the last frame.
        frame.texturePasses = !pass_.isWindow;
        // The first frame finds the few draws that have something at the pixel, the second one examines them:
        // only that one waits for the device at each of them.
        drawer.setDrawHook([&](const plan::PlannedDraw& draw, bool, bool begins) {
            const auto at = ofStep_.find(draw.step);
            if (at != ofStep_.end() && begins) ask(draw, at->second);
        });
        drawer.draw(*window, frame);
        for (const auto& [item, query] : asked_)
            if (query.result() > 0) touching_.insert(item);
        asked_.clear();
        drawer.setDrawHook([&](const plan::PlannedDraw& draw, bool, bool begins) {
            const auto at = ofStep_.find(draw.step);
            if (at == ofStep_.end() || !found_.problem.empty()) return;
            begins ? begin(draw, at->second) : end(at->second);
        });
        drawer.setNodeHook([&](std::size_t node, bool begins) {
            const auto at = ofNode_.find(node);
            if (at == ofNode_.end() || begins || !found_.problem.empty()) return;
            if (begun_ != node) beginNode(node, at->second);  // nothing is drawn
            takeClears(items_.size(), node);
        });
        drawer.draw(*window, frame);
        drawer.setDrawHook({});
        drawer.setNodeHook({});
        return std::move(found_);
    }

  private:
    PixelState state() {
        PixelState now;
        bool isRead = false;
        for (const FrameTarget& each : targets_) {
            const auto content =
                readBound(context_.capabilities(), partOf(scene_, each, size_, layer_), 0, pixel_);
            if (!content || content->values.empty()) continue;
            isRead = true;
            if (each.kind == FrameTarget::Kind::color) now.color = content->values;
            if (each.kind == FrameTarget::Kind::depth) now.depth = content->values.front();
            if (each.kind == FrameTarget::Kind::stencil)
                now.stencil = static_cast<int>(content->values.front());
        }
        if (!isRead) found_.problem = "the driver cannot read single pixels of this target";
        return now;
    }

    /// What the item has done to the pixel, whose fragments do not count.
    void note(std::size_t item, PixelEvent::Outcome outcome) {
        const PixelState now = state();
        found_.events.push_back({item, outcome, 0, 0, last_.value_or(now), now});
        last_ = now;
    }

    void beginNode(std::size_t node, std::size_t item) {
        begun_ = node;
        // A node with draws begins at the first one: what the pass has cleared is there then.
        note(item, PixelEvent::Outcome::begins);
    }

    void takeClears(std::size_t before, std::size_t node) {
        for (; next_ < before && next_ < items_.size() && items_[next_].node <= node; ++next_)
            if (items_[next_].node == node && items_[next_].kind == FrameItem::Kind::clear)
                note(next_, PixelEvent::Outcome::clears);
    }

    [[nodiscard]] bool stores(const plan::PlannedDraw& draw) const {
        return plan::writesMemory(scene_.plan().programs[draw.program], draw.textures);
    }

    /// Asks without waiting whether any primitive of the draw covers the pixel, whatever becomes of its
    /// fragments, in any layer.
    void ask(const plan::PlannedDraw& draw, std::size_t item) {
        const render::BuiltProgram* built = scene_.drawer().programOf(draw);
        if (built == nullptr) return;
        if (stores(draw)) {
            touching_.insert(item);
            return;
        }
        const KeptState kept;
        if (!limitToPixel()) return;
        writeNothing();
        glDisable(GL_DEPTH_TEST);
        glDisable(GL_STENCIL_TEST);
        glDisable(GL_CULL_FACE);
        if (const DebugProgram* whole = mayDiscard(*built) ? withoutDiscard(*built) : nullptr)
            whole->use(*built);
        gpu::Query query(GL_SAMPLES_PASSED);
        query.begin();
        scene_.drawer().submit(draw, true);
        query.end();
        asked_.emplace_back(item, std::move(query));
    }

    static void writeNothing() {
        for (GLuint i = 0; i < base::kRasterTargets; ++i)
            glColorMaski(i, GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
        glDepthMask(GL_FALSE);
        glStencilMask(0);
    }

    /// Fragments that pass, of the draw in the state that is set; with `whole` also those that its fragment
    /// stage discards.
    std::uint64_t count(const plan::PlannedDraw& draw, const render::BuiltProgram& built,
                        const DebugProgram* whole = nullptr) {
        if (layer_) {
            const DebugProgram* counting = whole != nullptr ? whole : ones(built);
            return counting != nullptr ? countInLayer(draw, built, *counting) : 0;
        }
        const KeptState kept;
        if (whole != nullptr) whole->use(built);
        const gpu::Query query(GL_SAMPLES_PASSED);
        query.begin();
        scene_.drawer().submit(draw, true);
        query.end();
        return query.result();
    }

    /// A query would count in all layers, so every fragment adds 1 to a colour beside them.
    std::uint64_t countInLayer(const plan::PlannedDraw& draw, const render::BuiltProgram& built,
                               const DebugProgram& program) {
        const KeptState kept;
        const auto beside = BesideTarget::make(context_.capabilities(), scene_, pass_, size_, layer_->layer);
        if (!beside) return 0;
        program.use(built);
        beside->clear();
        beside->bind(kDebugOutput);
        glColorMaski(kDebugOutput, GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
        glEnablei(GL_BLEND, kDebugOutput);
        glBlendFunci(kDebugOutput, GL_ONE, GL_ONE);
        glBlendEquationi(kDebugOutput, GL_FUNC_ADD);
        scene_.drawer().submit(draw, true);
        const render::Content counted = beside->read(context_.capabilities(), pixel_);
        // Of a pixel with several samples the mean is read.
        return counted.values.empty() ? 0 : static_cast<std::uint64_t>(std::ceil(counted.values.front()));
    }

    /// Only the pixel is drawn. False if the draw's own scissor leaves it out.
    bool limitToPixel() const {
        if (glIsEnabled(GL_SCISSOR_TEST) != GL_FALSE) {
            std::array<GLint, 4> box{};
            glGetIntegerv(GL_SCISSOR_BOX, box.data());
            if (pixel_.x < box[0] || pixel_.y < box[1] || pixel_.x >= box[0] + box[2] ||
                pixel_.y >= box[1] + box[3])
                return false;
        }
        glEnable(GL_SCISSOR_TEST);
        glScissor(pixel_.x, pixel_.y, 1, 1);
        return true;
    }

    void begin(const plan::PlannedDraw& draw, std::size_t item) {
        const FrameItem& drawn = items_[item];
        if (begun_ != drawn.node)
            for (const auto& [node, pass] : ofNode_)
                if (node == drawn.node) beginNode(node, pass);
        takeClears(item, drawn.node);
        PixelEvent event{item, PixelEvent::Outcome::passed, 0, 0, last_.value_or(PixelState{}), {}};
        const render::BuiltProgram* built = scene_.drawer().programOf(draw);
        if (stores(draw))
            event.outcome = PixelEvent::Outcome::unknown;
        else if (built != nullptr && touching_.contains(item))
            examine(draw, *built, event);
        current_ = std::move(event);
    }

    void examine(const plan::PlannedDraw& draw, const render::BuiltProgram& built, PixelEvent& event) {
        const KeptState kept;
        if (!limitToPixel()) return;
        writeNothing();
        const GLboolean testsDepth = glIsEnabled(GL_DEPTH_TEST), testsStencil = glIsEnabled(GL_STENCIL_TEST);
        glDisable(GL_DEPTH_TEST);
        glDisable(GL_STENCIL_TEST);
        event.fragments = count(draw, built);
        if (event.fragments > 0) {  // of most draws there are none
            if (testsStencil != GL_FALSE) glEnable(GL_STENCIL_TEST);
            const std::uint64_t afterStencil =
                testsStencil != GL_FALSE ? count(draw, built) : event.fragments;
            if (testsDepth != GL_FALSE) glEnable(GL_DEPTH_TEST);
            event.passed = testsDepth != GL_FALSE ? count(draw, built) : afterStencil;
            if (event.passed == 0)
                event.outcome =
                    afterStencil > 0 ? PixelEvent::Outcome::depthFails : PixelEvent::Outcome::stencilFails;
            return;
        }
        if (glIsEnabled(GL_CULL_FACE) != GL_FALSE) {
            glDisable(GL_CULL_FACE);
            if (count(draw, built) > 0) event.outcome = PixelEvent::Outcome::culled;
            glEnable(GL_CULL_FACE);
        }
        if (event.outcome == PixelEvent::Outcome::culled || !mayDiscard(built)) return;
        const DebugProgram* whole = withoutDiscard(built);
        if (whole != nullptr && count(draw, built, whole) > 0) event.outcome = PixelEvent::Outcome::discarded;
    }

    /// The stages before the fragment stage, with one that discards nothing.
    const DebugProgram* withoutDiscard(const render::BuiltProgram& built) {
        const auto [known, isNew] = whole_.try_emplace(&built);
        if (isNew) known->second = makeCoverageProgram(context_, built);
        return known->second ? &*known->second : nullptr;
    }

    /// Its stages, with 1 in the output for numbers.
    const DebugProgram* ones(const render::BuiltProgram& built) {
        const auto [known, isNew] = ones_.try_emplace(&built);
        if (isNew) known->second = makeDebugProgram(context_, built, DebugView::layers, DebugStages::numbers);
        return known->second ? &*known->second : nullptr;
    }

    void end(std::size_t item) {
        if (!current_ || current_->item != item) return;
        PixelEvent event = std::move(*current_);
        current_.reset();
        if (event.fragments == 0 && event.outcome == PixelEvent::Outcome::passed) {
            ++found_.untouched;
            return;
        }
        event.after = state();
        last_ = event.after;
        if (event.outcome == PixelEvent::Outcome::unknown && event.after == event.before) return;
        found_.events.push_back(std::move(event));
    }

    gpu::Context& context_;
    render::LiveScene& scene_;
    std::span<const FrameItem> items_;
    const scene::Pass& pass_;  ///< of the item that was asked for
    gpu::PixelRectangle pixel_;
    std::optional<LayerOfPass> layer_;
    gpu::TextureSize size_;
    std::vector<FrameTarget> targets_;
    std::map<scene::StepIndex, std::size_t> ofStep_;
    std::map<std::size_t, std::size_t> ofNode_;
    std::map<const render::BuiltProgram*, std::optional<DebugProgram>> whole_, ones_;
    std::vector<std::pair<std::size_t, gpu::Query>> asked_;
    std::set<std::size_t> touching_;    ///< items
    std::optional<std::size_t> begun_;  ///< the node
    std::size_t next_ = 0;
    std::optional<PixelEvent> current_;
    std::optional<PixelState> last_;
    PixelHistory found_;
};

}  // namespace

FrameAnswer watchFrame(gpu::Context& context, render::LiveScene& scene, std::span<const FrameItem> items,
                       const FrameQuestion& question) {
    return FrameLook(context, scene, items, question).run();
}

std::string_view wordsOf(PixelEvent::Outcome outcome) {
    constexpr std::array<std::string_view, 8> kWords{
        // in the order of the outcomes
        "the pass begins",
        "cleared",
        "drawn",
        "hidden: the depth test fails",
        "left out: the stencil test fails",
        "left out: the fragment stage discards it",
        "left out: this side of the face is culled",
        "changed; its shaders store to memory, so the tests are not counted"};
    return kWords.at(static_cast<std::size_t>(outcome));
}

PixelHistory pixelHistory(gpu::Context& context, render::LiveScene& scene, std::span<const FrameItem> items,
                          std::size_t item, int width, int height, double time, const TargetPixel& pixel,
                          int output) {
    if (item >= items.size() || !items[item].hasPass()) return {{}, 0, "only passes draw pixels"};
    return PixelWatch(context, scene, items, item, pixel, output).run(width, height, time);
}

}  // namespace glibra::view
