#include "plan/needs.h"

#include <algorithm>
#include <cstddef>
#include <map>
#include <optional>
#include <ranges>
#include <set>
#include <utility>

#include "plan/accesses.h"
#include "scene/primitives.h"
#include "scene/texture_parts.h"

namespace glibra::plan {
namespace {

using scene::StepIndex;

class NeedFinder {
  public:
    NeedFinder(const scene::Scene& scene, const scene::NodeList& nodes, const NeedQuestions& questions)
        : scene_(scene),
          nodes_(nodes),
          questions_(questions),
          visited_(nodes.passes.size()),
          read_(scene.textures.size()) {
        needs_.passes.resize(nodes.passes.size());
        needs_.textures.resize(scene.textures.size());
        for (const scene::Pass& pass : nodes.passes)
            needs_.steps.emplace_back(pass.steps.size(), StepNeed::needed);
    }

    Needs find(bool everything) && {
        if (everything) {
            needs_.passes.assign(needs_.passes.size(), true);
        } else {
            markEmptyShapes();
            startAtWindow();
        }
        spread();
        while (!everything && addImageWriter()) spread();
        for (std::size_t i = 0; i < needs_.passes.size(); ++i)
            if (!needs_.passes[i]) std::ranges::fill(needs_.steps[i], StepNeed::passNotNeeded);
        for (const scene::TextureIndex i : scene_.textures.indices())
            if (read_[i] || everything) needs_.textures[i] = true;
        return std::move(needs_);
    }

  private:
    bool isWindow(std::size_t pass) const { return nodes_.passes[pass].isWindow; }
    const scene::Draw* drawAt(StepIndex index) const {
        return std::get_if<scene::Draw>(&nodes_.passes[index.pass].steps[index.step]);
    }

    void markEmptyShapes() {
        for (std::size_t pass = 0; pass < nodes_.passes.size(); ++pass)
            for (std::size_t step = 0; step < nodes_.passes[pass].steps.size(); ++step) {
                const scene::Draw* draw = drawAt({pass, step});
                if (draw != nullptr && drawsNothing(scene_.shapes[draw->shape]))
                    needs_.steps[pass][step] = StepNeed::drawsNothing;
            }
    }

    bool mayWrite(const scene::Draw& draw) {
        if (usesBuiltin(scene_, draw)) return false;
        const auto [entry, isNew] = writes_.try_emplace(draw.program, false);
        if (isNew) entry->second = questions_.mayWriteImages && questions_.mayWriteImages(draw.program);
        return entry->second;
    }

    void startAtWindow() {
        std::vector<StepIndex> window;
        std::optional<std::size_t> lastClear;
        for (std::size_t pass = 0; pass < nodes_.passes.size(); ++pass) {
            if (!isWindow(pass)) continue;
            for (std::size_t step = 0; step < nodes_.passes[pass].steps.size(); ++step) {
                if (const auto* clear = std::get_if<scene::Clear>(&nodes_.passes[pass].steps[step])) {
                    lastClear = window.size();
                    needs_.clear = clear->place;
                }
                window.push_back({pass, step});
            }
        }
        std::size_t kept = 0;  // steps from the front that an image-writing draw needs
        for (std::size_t i = lastClear.value_or(0); i > 0 && kept == 0; --i) {
            const auto [pass, step] = window[i - 1];
            const scene::Draw* draw = drawAt(window[i - 1]);
            if (draw != nullptr && needs_.steps[pass][step] == StepNeed::needed && mayWrite(*draw)) kept = i;
        }
        for (std::size_t i = kept; lastClear && i < *lastClear; ++i) {
            StepNeed& need = needs_.steps[window[i].pass][window[i].step];
            if (need == StepNeed::needed) need = StepNeed::coveredByClear;
        }
        const std::size_t firstSeen = lastClear ? window[*lastClear].pass : 0;
        for (std::size_t pass = 0; pass < nodes_.passes.size(); ++pass) {
            if (!isWindow(pass)) continue;
            // Even a pass without draws counts, since it may carry the window's implicit clear.
            const std::vector<StepNeed>& steps = needs_.steps[pass];
            needs_.passes[pass] =
                pass >= firstSeen || std::ranges::find(steps, StepNeed::needed) != steps.end();
        }
    }

    /// Follows textures and shared depth from the needed passes to others, until nothing new is found.
    void spread() {
        bool isChanged = true;
        while (isChanged) {
            isChanged = false;
            for (std::size_t pass = nodes_.passes.size(); pass-- > 0;) {
                if (!needs_.passes[pass] && !feedsNeeded(pass)) continue;
                needs_.passes[pass] = true;
                if (visited_[pass]) continue;
                visited_[pass] = true;
                isChanged = true;
                visit(pass);
            }
        }
    }

    void visit(std::size_t pass) {
        for (const scene::TextureIndex target : nodes_.passes[pass].targets) needs_.textures[target] = true;
        for (std::size_t step = 0; step < nodes_.passes[pass].steps.size(); ++step) {
            const scene::Draw* draw = drawAt({pass, step});
            if (draw == nullptr || needs_.steps[pass][step] != StepNeed::needed) continue;
            if (isOutOfSight({pass, step})) {
                needs_.steps[pass][step] = StepNeed::outOfSight;
                continue;
            }
            for (const ObjectUse& each : questions_.usesOf(*draw, nodes_.passes[pass]))
                if (const auto* view = std::get_if<scene::TextureView>(&each.object))
                    read_[view->texture] = true;
        }
        if (!isWindow(pass) && !startsWithClearDepth(nodes_.passes[pass])) keepDepthBefore(pass);
    }

    bool isOutOfSight(StepIndex index) {
        if (!questions_.outOfSight) return false;
        std::string why = questions_.outOfSight(nodes_.draw(index), nodes_.passes[index.pass]);
        if (why.empty()) return false;
        needs_.outOfSight.emplace(index, std::move(why));
        return true;
    }

    static bool startsWithClearDepth(const scene::Pass& pass) {
        return pass.clearDepth ||
               (!pass.steps.empty() && std::holds_alternative<scene::Clear>(pass.steps.front()));
    }

    /// The latest earlier pass with the same depth buffer: its depth is what this pass is tested against.
    void keepDepthBefore(std::size_t pass) {
        for (std::size_t earlier = pass; earlier-- > 0;) {
            const scene::Pass& other = nodes_.passes[earlier];
            if (other.isWindow || other.depthBuffer != nodes_.passes[pass].depthBuffer) continue;
            needs_.passes[earlier] = true;
            return;
        }
    }

    bool feedsNeeded(std::size_t pass) const {
        const std::vector<scene::TextureIndex>& targets = nodes_.passes[pass].targets;
        return std::ranges::any_of(targets, [&](scene::TextureIndex target) { return read_[target]; });
    }

    /// Adds the last pass that is not needed yet and may write to an image. False if there is none.
    bool addImageWriter() {
        for (std::size_t pass = nodes_.passes.size(); pass-- > 0;) {
            if (needs_.passes[pass] || isWindow(pass)) continue;
            for (std::size_t step = 0; step < nodes_.passes[pass].steps.size(); ++step) {
                const scene::Draw* draw = drawAt({pass, step});
                if (draw == nullptr || needs_.steps[pass][step] != StepNeed::needed || !mayWrite(*draw))
                    continue;
                needs_.passes[pass] = true;
                return true;
            }
        }
        return false;
    }

    const scene::Scene& scene_;
    const scene::NodeList& nodes_;
    const NeedQuestions& questions_;
    std::vector<bool> visited_;
    scene::List<bool, scene::Texture> read_;      ///< by a needed draw
    std::map<scene::ProgramIndex, bool> writes_;  ///< results of mayWriteImages
    Needs needs_;
};

}  // namespace

bool usesStencil(const scene::Pass& pass) {
    return std::ranges::any_of(pass.steps, [](const auto& step) {
        const auto* draw = std::get_if<scene::Draw>(&step);
        return draw != nullptr ? draw->raster.stencilTest : std::get<scene::Clear>(step).stencil;
    });
}

Needs findNeeds(const scene::Scene& scene, const scene::NodeList& nodes, const NeedQuestions& questions,
                bool everything) {
    return NeedFinder(scene, nodes, questions).find(everything);
}

// The needs of modern scenes.

namespace {

class LiveFinder {
  public:
    LiveFinder(const scene::Scene& scene, const scene::NodeList& nodes, const NeedQuestions& questions,
               bool everything)
        : scene_(scene), nodes_(nodes), questions_(questions), everything_(everything) {
        needs_.passes.resize(nodes.passes.size());
        needs_.dispatches.resize(nodes.dispatches.size());
        needs_.clears.resize(nodes.clears.size());
        needs_.textures.resize(scene.textures.size());
        needs_.buffers.resize(scene.buffers.size());
        for (const scene::Pass& pass : nodes.passes)
            needs_.steps.emplace_back(pass.steps.size(), StepNeed::passNotNeeded);
    }

    Needs find(const std::vector<scene::ObjectView>& roots) && {
        for (const scene::ObjectView& each : roots) read(each);
        for (auto node : std::ranges::reverse_view(nodes_.order)) {
            if (node.kind == scene::NodeIndex::Kind::pass) visitPass(node.index);
            if (node.kind == scene::NodeIndex::Kind::dispatch) visitDispatch(node.index);
            if (node.kind == scene::NodeIndex::Kind::clear) visitClear(node.index);
        }
        if (everything_) needs_.textures.assign(needs_.textures.size(), true);
        return std::move(needs_);
    }

  private:
    void read(const scene::ObjectView& view) {
        const Object object = objectOf(view);
        if (!note(object)) return;
        live_.insert(object);
        // The other copy is what an earlier writer left, in this frame or before it.
        if (isPreviousCopy(view)) pinned_.insert(object);
    }
    /// The object must exist, but its content need not. False for none.
    bool note(const Object& object) {
        if (!std::visit([](auto index) { return bool(index); }, object)) return false;
        if (const auto* texture = std::get_if<scene::TextureIndex>(&object))
            needs_.textures[*texture] = true;
        else
            needs_.buffers[std::get<scene::BufferIndex>(object)] = true;
        return true;
    }
    /// The whole texture gets a new content here.
    void overwritten(scene::TextureIndex texture, const scene::TargetPart& part) {
        const scene::Texture& declared = scene_.textures[texture];
        const bool isWhole = !part.layer && scene::levelsOf(declared) == 1;
        const bool restIsMade = !part.layer && part.level.value_or(0) == 0 && declared.hasMipmaps;
        if (isWhole || restIsMade) endNeed(texture);
    }

    /// What the object holds before this node is not needed.
    void endNeed(const Object& object) {
        if (!pinned_.contains(object)) live_.erase(object);
    }

    static scene::TargetPart partOf(const scene::Pass& pass, std::size_t target) {
        return target < pass.parts.size() ? pass.parts[target] : scene::TargetPart{};
    }
    [[nodiscard]] bool isDepthLive(const scene::Pass& pass) const {
        if (pass.depth) return live_.contains(pass.depth->texture);
        return liveDepths_.contains(pass.depthBuffer);
    }
    [[nodiscard]] bool isColorLive(const scene::Pass& pass) const {
        if (pass.isWindow) return isWindowLive_;
        return std::ranges::any_of(pass.targets,
                                   [this](scene::TextureIndex each) { return live_.contains(each); });
    }

    bool mayWrite(const scene::Draw& draw) const {
        return !usesBuiltin(scene_, draw) && questions_.mayWriteImages &&
               questions_.mayWriteImages(draw.program);
    }
    /// True if the draw stores into something that is read later.
    bool hasEffect(const scene::Draw& draw, const scene::Pass& pass) const {
        return mayWrite(draw) && writesLive(questions_.usesOf(draw, pass));
    }
    [[nodiscard]] bool writesLive(const std::vector<ObjectUse>& uses) const {
        return std::ranges::any_of(uses, [this](const ObjectUse& each) {
            return each.writes && live_.contains(objectOf(each.object));
        });
    }
    void use(const std::vector<ObjectUse>& uses) {
        for (const ObjectUse& each : uses) {
            if (each.reads || each.writes)
                read(each.object);
            else
                note(objectOf(each.object));
        }
    }

    void visitPass(std::size_t index) {
        const scene::Pass& pass = nodes_.passes[index];
        bool isColorSeen = isColorLive(pass);
        bool isDepthSeen = isDepthLive(pass);
        bool isNeeded = everything_ || isColorSeen || isDepthSeen;
        for (std::size_t step = 0; step < pass.steps.size() && !isNeeded; ++step)
            if (const auto* draw = std::get_if<scene::Draw>(&pass.steps[step]))
                isNeeded = hasEffect(*draw, pass);
        if (!isNeeded) return;
        needs_.passes[index] = true;
        for (std::size_t step = pass.steps.size(); step-- > 0;) {
            StepNeed& need = needs_.steps[index][step];
            if (const auto* draw = std::get_if<scene::Draw>(&pass.steps[step])) {
                need = needOf(*draw, pass, {index, step}, isColorSeen || isDepthSeen);
                isDepthSeen = isDepthSeen || need == StepNeed::needed;
                continue;
            }
            const bool isSeen = everything_ || isColorSeen || isDepthSeen;
            need = isSeen ? StepNeed::needed : StepNeed::coveredByClear;
            const auto& clear = std::get<scene::Clear>(pass.steps[step]);
            if (isSeen && pass.isWindow && clear.color && needs_.clear.file.empty())
                needs_.clear = clear.place;
            if (clear.color) isColorSeen = false;
            if (clear.depth && (clear.stencil || !usesStencil(pass))) isDepthSeen = false;
        }
        beginsWith(pass, isColorSeen, isDepthSeen);
    }

    StepNeed needOf(const scene::Draw& draw, const scene::Pass& pass, scene::StepIndex at, bool isSeen) {
        if (!everything_) {
            if (drawsNothing(scene_.shapes[draw.shape])) return StepNeed::drawsNothing;
            if (!isSeen && !hasEffect(draw, pass)) return StepNeed::coveredByClear;
            if (questions_.outOfSight) {
                std::string why = questions_.outOfSight(draw, pass);
                if (!why.empty()) {
                    needs_.outOfSight.emplace(at, std::move(why));
                    return StepNeed::outOfSight;
                }
            }
        }
        use(questions_.usesOf(draw, pass));
        return StepNeed::needed;
    }

    /// What is read before the pass: its targets, as far as it keeps them. `isColorSeen`: something of the
    /// colours that the pass begins with may be seen.
    void beginsWith(const scene::Pass& pass, bool isColorSeen, bool isDepthSeen) {
        const auto isCleared = [&](std::size_t color) {
            return !isColorSeen || (color < pass.clearColors.size() && pass.clearColors[color]);
        };
        if (pass.isWindow && isCleared(0)) {
            if (isWindowLive_ && !everything_ && needs_.clear.file.empty()) needs_.clear = pass.place;
            isWindowLive_ = false;
        }
        for (std::size_t i = 0; i < pass.targets.size(); ++i) {
            needs_.textures[pass.targets[i]] = true;
            if (isCleared(i)) overwritten(pass.targets[i], partOf(pass, i));
        }
        const bool keepsStencil = !pass.clearStencil && usesStencil(pass);
        const bool isDepthCleared = !isDepthSeen || (pass.clearDepth && !keepsStencil);
        if (pass.depth) {
            needs_.textures[pass.depth->texture] = true;
            if (isDepthCleared)
                overwritten(pass.depth->texture, {pass.depth->level, pass.depth->layer});
            else
                live_.insert(pass.depth->texture);
        } else if (isDepthCleared) {
            liveDepths_.erase(pass.depthBuffer);
        } else {
            liveDepths_.insert(pass.depthBuffer);
        }
    }

    void visitDispatch(std::size_t index) {
        const std::vector<ObjectUse> uses = questions_.usesOfDispatch(nodes_.dispatches[index]);
        needs_.dispatches[index] = everything_ || writesLive(uses);
        if (needs_.dispatches[index]) use(uses);
    }

    void visitClear(std::size_t index) {
        const scene::ClearObject& clear = nodes_.clears[index];
        needs_.clears[index] = everything_ || live_.contains(clear.object);
        endNeed(clear.object);
        if (needs_.clears[index]) note(clear.object);
    }

    const scene::Scene& scene_;
    const scene::NodeList& nodes_;
    const NeedQuestions& questions_;
    bool everything_;
    std::set<Object> live_;    ///< their content is read by a later node
    std::set<Object> pinned_;  ///< a clear does not end the need for them
    std::set<int> liveDepths_;
    bool isWindowLive_ = true;
    Needs needs_;
};

}  // namespace

Needs findLiveNeeds(const scene::Scene& scene, const scene::NodeList& nodes, const NeedQuestions& questions,
                    const std::vector<scene::ObjectView>& roots, bool everything) {
    return LiveFinder(scene, nodes, questions, everything).find(roots);
}

}  // namespace glibra::plan
