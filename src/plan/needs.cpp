#include "plan/needs.h"

#include <algorithm>
#include <cstddef>
#include <map>
#include <optional>
#include <utility>

#include "scene/primitives.h"

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

}  // namespace glibra::plan
