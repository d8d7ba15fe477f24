#include "plan/needs.h"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <ranges>
#include <set>
#include <utility>

#include "plan/planned_programs.h"
#include "scene/primitives.h"
#include "scene/textures.h"

namespace glibra::plan {
namespace {

/// True if a draw of the pass tests the stencil, or a Clear sets it.
bool usesStencil(const scene::Pass& pass) {
    return std::ranges::any_of(pass.steps, [](const auto& step) {
        const auto* draw = std::get_if<scene::Draw>(&step);
        return draw != nullptr ? draw->raster->stencilTest : std::get<scene::Clear>(step).stencil;
    });
}

class NeedFinder {
  public:
    NeedFinder(const scene::Scene& scene, const scene::NodeList& nodes, PlannedPrograms& programs,
               const Answers& answers, bool everything, Questions& questions)
        : scene_(scene),
          nodes_(nodes),
          programs_(programs),
          answers_(answers),
          everything_(everything),
          questions_(questions) {
        needs_.textures.resize(scene.textures.size());
        needs_.buffers.resize(scene.buffers.size());
    }

    Needs find(const std::vector<scene::ObjectView>& roots) && {
        for (const scene::ObjectView& each : roots) read(each);
        for (bool isChanged = true; isChanged;) {
            const std::set<Object> atEnd = live_;
            const std::set<int> depthsAtEnd = liveDepths_;
            walkBack();
            // What a frame begins with is what the one before has left.
            isChanged = scene_.goesOn && !everything_ && leavesOut();
            if (!isChanged) break;
            live_.insert(atEnd.begin(), atEnd.end());
            liveDepths_.insert(depthsAtEnd.begin(), depthsAtEnd.end());
            isChanged = live_ != atEnd || liveDepths_ != depthsAtEnd;
        }
        if (everything_) needs_.textures.assign(needs_.textures.size(), true);
        return std::move(needs_);
    }

  private:
    void walkBack() {
        isWindowLive_ = true;
        needs_.clear = {};
        needs_.passes.assign(nodes_.passes.size(), false);
        needs_.dispatches.assign(nodes_.dispatches.size(), false);
        needs_.clears.assign(nodes_.clears.size(), false);
        needs_.steps.clear();
        for (const scene::Pass& pass : nodes_.passes)
            needs_.steps.emplace_back(pass.steps.size(), StepNeed::passNotNeeded);
        std::size_t position = nodes_.order.size(), left = nodes_.untils.size();
        writtenByRounds_.clear();
        for (auto node : std::ranges::reverse_view(nodes_.order)) {
            readAtEndsOfRounds(position--, left);
            if (node.kind == scene::NodeIndex::Kind::pass) visitPass(node.index);
            if (node.kind == scene::NodeIndex::Kind::dispatch) visitDispatch(node.index);
            if (node.kind == scene::NodeIndex::Kind::clear) visitClear(node.index);
        }
    }
    /// Where a repetition may end, its condition is read, and what its rounds have written so far stays.
    /// `left`: the conditions before this node, of which those at the node are taken.
    void readAtEndsOfRounds(std::size_t node, std::size_t& left) {
        for (; left > 0 && nodes_.untils[left - 1].node == node; --left) {
            const scene::Until& each = nodes_.untils[left - 1];
            for (const scene::BufferIndex buffer : each.reads) keep(buffer);
            const auto [written, isNew] = writtenByRounds_.try_emplace({each.first, each.end});
            if (isNew)
                for (std::size_t i = each.first; i < each.end; ++i)
                    addWritten(nodes_.order[i], written->second);
            for (const Object& object : written->second) keep(object);
        }
    }
    void keep(const Object& object) {
        if (note(object)) live_.insert(object);
    }
    /// Adds what the node writes if any of it is needed.
    void addWritten(const scene::NodeIndex& node, std::set<Object>& to) {
        const auto addUses = [&](const std::vector<ObjectUse>& uses) {
            for (const ObjectUse& each : uses)
                if (each.writes) to.insert(objectOf(each.object));
        };
        if (node.kind == scene::NodeIndex::Kind::dispatch) {
            addUses(programs_.usesOf(nodes_.dispatches[node.index]));
        } else if (node.kind == scene::NodeIndex::Kind::pass) {
            const scene::Pass& pass = nodes_.passes[node.index];
            to.insert(pass.targets.begin(), pass.targets.end());
            if (pass.depth) to.insert(pass.depth->texture);
            for (const auto& step : pass.steps)
                if (const auto* draw = std::get_if<scene::Draw>(&step); draw && programs_.mayWrite(*draw))
                    addUses(programs_.usesOf(*draw, pass));
        } else {
            to.insert(nodes_.clears[node.index].object);
        }
    }
    /// True if a draw might be needed that is not yet.
    [[nodiscard]] bool leavesOut() const {
        return std::ranges::any_of(needs_.steps, [](const std::vector<StepNeed>& steps) {
            return std::ranges::any_of(steps, [](StepNeed each) {
                return each == StepNeed::passNotNeeded || each == StepNeed::coveredByClear;
            });
        });
    }
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

    /// True if the draw stores into something that is read later.
    bool hasEffect(const scene::Draw& draw, const scene::Pass& pass) {
        return programs_.mayWrite(draw) && writesLive(programs_.usesOf(draw, pass));
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
            if (isOutOfSight(at)) return StepNeed::outOfSight;
        }
        use(programs_.usesOf(draw, pass));
        return StepNeed::needed;
    }

    /// True, too, if it is not known yet.
    bool isOutOfSight(scene::StepIndex at) {
        if (answers_.seesAll) return false;
        const std::string* why = answers_.sight.find(at);
        if (why == nullptr) {
            if (asked_.find(at) == nullptr) questions_.unseen.push_back(at);
            asked_.add(at, {});
            return !answers_.asksAhead;
        }
        if (!why->empty()) needs_.outOfSight.emplace(at, *why);
        return !why->empty();
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
        const std::vector<ObjectUse> uses = programs_.usesOf(nodes_.dispatches[index]);
        needs_.dispatches[index] = everything_ || writesLive(uses);
        if (needs_.dispatches[index]) use(uses);
    }

    void visitClear(std::size_t index) {
        const scene::ClearObject& clear = nodes_.clears[index];
        needs_.clears[index] = everything_ || live_.contains(clear.object);
        endNeed(clear.object);
        if (needs_.clears[index]) note(clear.object);
    }

    /// By the first node of the rounds and that after the last one.
    std::map<std::pair<std::size_t, std::size_t>, std::set<Object>> writtenByRounds_;
    const scene::Scene& scene_;
    const scene::NodeList& nodes_;
    PlannedPrograms& programs_;
    const Answers& answers_;
    bool everything_;
    Questions& questions_;
    std::set<Object> live_;    ///< their content is read by a later node
    std::set<Object> pinned_;  ///< a clear does not end the need for them
    std::set<int> liveDepths_;
    bool isWindowLive_ = true;
    Sight asked_;  ///< those in `questions_`
    Needs needs_;
};

}  // namespace

Needs findNeeds(const scene::Scene& scene, const scene::NodeList& nodes, PlannedPrograms& programs,
                const Answers& answers, const PlanOptions& options, Questions& questions) {
    return NeedFinder(scene, nodes, programs, answers, options.everything, questions).find(options.roots);
}

// ---- What stands still

namespace {

/// The numbers of a plan's nodes that write each object.
std::map<Object, std::vector<std::size_t>> writersOf(const FramePlan& plan) {
    std::map<Object, std::vector<std::size_t>> writers;
    for (std::size_t node = 0; node < plan.accesses.size(); ++node)
        for (const Object& each : plan.accesses[node].written) writers[each].push_back(node);
    return writers;
}

bool isShared(const FramePlan& plan, const Object& object) {
    const auto* texture = std::get_if<scene::TextureIndex>(&object);
    return texture != nullptr && std::ranges::any_of(plan.sharing, [&](const auto& each) {
               return each.first == *texture || each.second == *texture;
           });
}

bool followsTimer(const PlannedProgram& program) {
    return std::ranges::any_of(program.values, [](const UniformBinding& each) {
        const auto* supplied = std::get_if<Supplied>(&each.value);
        return supplied != nullptr && supplied->value == glsl::Builtin::timer;
    });
}

bool isSameProgram(const PlannedProgram& a, const PlannedProgram& b) {
    const auto haveOneBuffer = [](const BlockUse& one, const BlockUse& other) {
        return one.kind == other.kind && one.index == other.index && one.buffer == other.buffer;
    };
    return a.variant == b.variant && a.interface == b.interface && a.values == b.values && !followsTimer(a) &&
           std::equal(a.blocks.begin(), a.blocks.end(), b.blocks.begin(), b.blocks.end(), haveOneBuffer);
}

bool isSameDraw(const PlannedScene& before, const PlannedDraw& a, const PlannedScene& now,
                const PlannedDraw& b) {
    const auto meshOf = [](const PlannedScene& in, const PlannedDraw& draw) -> const PlannedMesh& {
        return in.plan.meshes[draw.mesh];
    };
    const PlannedMesh &mesh = meshOf(before, a), &other = meshOf(now, b);
    if (a.submission != b.submission || a.textures != b.textures || bool(a.inputs) != bool(b.inputs) ||
        mesh.attributes != other.attributes || mesh.adjacency != other.adjacency ||
        mesh.isExpanded != other.isExpanded ||
        before.scene.shapes[mesh.shape] != now.scene.shapes[other.shape] ||
        !isSameProgram(before.plan.programs[a.program], now.plan.programs[b.program]))
        return false;
    if (a.inputs && before.plan.inputs[a.inputs].sources != now.plan.inputs[b.inputs].sources) return false;
    // The plans have resolved what these indices refer to.
    scene::Draw draw = before.plan.drawOf(a);
    const scene::Draw& same = now.plan.drawOf(b);
    draw.shape = same.shape;
    draw.slots = same.slots;
    draw.uniforms = same.uniforms;
    draw.attributes = same.attributes;
    return draw == same;
}

bool isSamePass(const PlannedScene& before, const PlannedPass& a, const PlannedScene& now,
                const PlannedPass& b) {
    const auto isSameStep = [&](const auto& step, const auto& same) {
        if (step.index() != same.index()) return false;
        if (const auto* draw = std::get_if<PlannedDraw>(&step))
            return isSameDraw(before, *draw, now, std::get<PlannedDraw>(same));
        return before.plan.clearOf(std::get<PlannedClear>(step)) ==
               now.plan.clearOf(std::get<PlannedClear>(same));
    };
    const scene::PassSetup &one = before.plan.passOf(a), &other = now.plan.passOf(b);
    return one == other &&
           std::equal(a.steps.begin(), a.steps.end(), b.steps.begin(), b.steps.end(), isSameStep);
}

bool isSameNode(const PlannedScene& before, const scene::NodeIndex& a, const PlannedScene& now,
                const scene::NodeIndex& b) {
    if (a.kind != b.kind) return false;
    if (a.kind == scene::NodeIndex::Kind::pass)
        return isSamePass(before, before.plan.passes.at(a.index), now, now.plan.passes.at(b.index));
    if (a.kind == scene::NodeIndex::Kind::clear)
        return before.plan.clearOf(before.plan.clears.at(a.index)).object ==
               now.plan.clearOf(now.plan.clears.at(b.index)).object;
    const PlannedDispatch &one = before.plan.dispatches.at(a.index), &other = now.plan.dispatches.at(b.index);
    const scene::Dispatch &first = before.plan.dispatchOf(one), &second = now.plan.dispatchOf(other);
    return one.textures == other.textures && first.groups == second.groups && first.tiles == second.tiles &&
           first.discards == second.discards &&
           isSameProgram(before.plan.programs[one.program], now.plan.programs[other.program]);
}

/// True if the pass reads or writes its depth or stencil.
bool usesDepth(const scene::Pass& pass) {
    return pass.depth || pass.clearDepth || pass.clearStencil || usesStencil(pass) ||
           std::ranges::any_of(pass.steps, [](const auto& step) {
               const auto* draw = std::get_if<scene::Draw>(&step);
               return draw != nullptr ? draw->raster->depthTest : std::get<scene::Clear>(step).depth;
           });
}

/// True if nothing outside the pass decides its depth and stencil, and no other pass goes on with them.
bool hasOwnDepth(const FramePlan& plan, const scene::Pass& pass) {
    if (!usesDepth(pass)) return true;
    if (!pass.clearDepth || (!pass.clearStencil && usesStencil(pass))) return false;
    return pass.depth || std::ranges::none_of(plan.passes, [&](const PlannedPass& each) {
               const scene::Pass& other = plan.passOf(each);
               return &other != &pass && !other.isWindow && !other.depth &&
                      other.depthBuffer == pass.depthBuffer;
           });
}

}  // namespace

bool mayStandStill(const FramePlan& plan) {
    const auto isTimed = [&](const PlannedProgramIndex each) { return followsTimer(plan.programs[each]); };
    return !plan.clears.empty() || std::ranges::any_of(plan.dispatches, [&](const PlannedDispatch& each) {
        return !isTimed(each.program);
    }) || std::ranges::any_of(plan.passes, [&](const PlannedPass& pass) {
        return !plan.passOf(pass).isWindow && std::ranges::none_of(pass.steps, [&](const auto& step) {
            const auto* draw = std::get_if<PlannedDraw>(&step);
            return draw != nullptr && isTimed(draw->program);
        });
    });
}

StillNodes stillNodes(const PlannedScene& before, const PlannedScene& now,
                      const std::function<bool(const Object&)>& changed) {
    StillNodes still;
    const auto writersBefore = writersOf(before.plan), writers = writersOf(now.plan);
    const auto onlyWriter = [](const auto& list, const Object& object) -> std::optional<std::size_t> {
        const auto found = list.find(object);
        if (found == list.end() || found->second.size() != 1) return std::nullopt;
        return found->second.front();
    };
    const auto isUnchanged = [&](const Object& object) {
        if (hasHistory(now.scene, object) || changed(object)) return false;
        if (writers.contains(object)) return still.contents.contains(object);
        if (writersBefore.contains(object)) return false;
        const auto* buffer = std::get_if<scene::BufferIndex>(&object);
        return buffer == nullptr || before.scene.buffers[*buffer].values == now.scene.buffers[*buffer].values;
    };
    still.nodes.assign(now.plan.order.size(), false);
    for (std::size_t node = 0; node < now.plan.order.size(); ++node) {
        const scene::NodeIndex& at = now.plan.order[node];
        if (at.kind == scene::NodeIndex::Kind::pass) {
            const scene::Pass& pass = now.plan.passOf(now.plan.passes.at(at.index));
            if (pass.isWindow || !hasOwnDepth(now.plan, pass)) continue;
        }
        const std::vector<ObjectUse>& uses = now.plan.accesses[node].uses;
        const std::set<Object>& written = now.plan.accesses[node].written;
        std::optional<std::size_t> earlier;
        const bool isAlone = std::ranges::all_of(written, [&](const Object& each) {
            const auto writer = onlyWriter(writersBefore, each);
            if (!writer || (earlier && *earlier != *writer)) return false;
            earlier = writer;
            const auto* buffer = std::get_if<scene::BufferIndex>(&each);
            if (buffer != nullptr &&
                before.scene.buffers[*buffer].values != now.scene.buffers[*buffer].values)
                return false;
            return onlyWriter(writers, each) == node && !hasHistory(now.scene, each) &&
                   !isShared(now.plan, each) && !isShared(before.plan, each);
        });
        if (!isAlone || !earlier) continue;
        const std::set<Object>& cleared = now.plan.accesses[node].overwritten;
        if (now.scene.goesOn && !std::ranges::includes(cleared, written)) continue;
        // What it writes begins as declared or is cleared by the node, in both frames.
        const bool readsOnlyStill = std::ranges::all_of(uses, [&](const ObjectUse& each) {
            const Object object = objectOf(each.object);
            return written.contains(object) || isUnchanged(object);
        });
        if (!readsOnlyStill || !isSameNode(before, before.plan.order[*earlier], now, at)) continue;
        still.nodes[node] = true;
        still.contents.insert(written.begin(), written.end());
    }
    if (still.contents.empty()) still.nodes.clear();
    return still;
}

}  // namespace glibra::plan
