#include "plan/early_reads.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <tuple>
#include <utility>
#include <vector>

#include "plan/accesses.h"

namespace glibra::plan {
namespace {

/// What a node of the frame does with textures, whether or not it is planned.
struct NodeTextures {
    struct Read {
        scene::TextureIndex texture;
        bool isPrevious = false;
        Place place;
    };
    std::vector<Read> reads;                ///< by samplers
    std::set<scene::TextureIndex> written;  ///< or parts of them
    std::set<Object> uses, changes;         ///< everything that shaders read and write
    Place place;
};

std::vector<NodeTextures> declaredNodes(const scene::NodeList& frame) {
    std::vector<NodeTextures> nodes;
    for (const scene::NodeIndex& each : frame.order) {
        NodeTextures node;
        node.place = frame.placeOf(each);
        if (each.kind == scene::NodeIndex::Kind::pass) {
            const scene::Pass& pass = frame.passes.at(each.index);
            node.written.insert(pass.targets.begin(), pass.targets.end());
            if (pass.depth) node.written.insert(pass.depth->texture);
        } else if (each.kind == scene::NodeIndex::Kind::clear) {
            if (const auto* texture = std::get_if<scene::TextureIndex>(&frame.clears.at(each.index).object))
                node.written.insert(*texture);
        }
        nodes.push_back(std::move(node));
    }
    return nodes;
}

void addReads(const std::vector<TextureUse>& uses, const Place& place, NodeTextures& node) {
    for (const TextureUse& each : uses)
        if (!each.isImage && each.view.texture)
            node.reads.push_back({each.view.texture, each.view.isPrevious, place});
}

std::vector<NodeTextures> nodesOf(const FramePlan& plan) {
    std::vector<NodeTextures> nodes = declaredNodes(*plan.nodes);
    std::map<scene::NodeIndex, std::size_t> positions;
    for (std::size_t i = 0; i < nodes.size(); ++i) positions.emplace(plan.nodes->order[i], i);
    for (std::size_t i = 0; i < plan.order.size(); ++i) {
        NodeTextures& node = nodes.at(positions.at(plan.declared(plan.order[i])));
        node.changes = plan.accesses[i].written;
        for (const Object& each : node.changes)
            if (const auto* texture = std::get_if<scene::TextureIndex>(&each)) node.written.insert(*texture);
        for (const ObjectUse& each : plan.accesses[i].uses)
            if (each.reads) node.uses.insert(objectOf(each.object));
        if (plan.order[i].kind == scene::NodeIndex::Kind::dispatch) {
            const PlannedDispatch& dispatch = plan.dispatches.at(plan.order[i].index);
            addReads(dispatch.textures, plan.dispatchOf(dispatch).place, node);
        } else if (plan.order[i].kind == scene::NodeIndex::Kind::pass) {
            for (const auto& step : plan.passes.at(plan.order[i].index).steps)
                if (const auto* draw = std::get_if<PlannedDraw>(&step))
                    addReads(draw->textures, plan.drawOf(*draw).place, node);
        }
    }
    return nodes;
}

/// The node after `reader` that writes the texture first. Nothing if there is none, or if it needs what the
/// reader writes, since then the two cannot change their places.
std::optional<std::size_t> writerAfter(const std::vector<NodeTextures>& nodes, std::size_t reader,
                                       scene::TextureIndex texture) {
    std::set<Object> results = nodes[reader].changes;
    for (std::size_t i = reader + 1; i < nodes.size(); ++i) {
        const bool needsResults = std::ranges::any_of(
            nodes[i].uses, [&](const Object& object) { return results.contains(object); });
        if (nodes[i].written.contains(texture))
            return needsResults ? std::nullopt : std::optional<std::size_t>(i);
        if (needsResults) results.insert(nodes[i].changes.begin(), nodes[i].changes.end());
    }
    return std::nullopt;
}

/// The reads of zeros by one statement; of previous copies by all statements.
struct ZeroReads {
    bool isAlways = true;
    std::size_t node = 0;  ///< the first one
    Place place;
};

}  // namespace

Diagnostics reportEarlyReads(const scene::Scene& scene, const FramePlan& frame,
                             const std::set<scene::TextureIndex>& lasting) {
    const std::vector<NodeTextures> nodes = nodesOf(frame);
    std::map<scene::TextureIndex, int> writers;  // so far
    std::map<std::tuple<scene::TextureIndex, bool, std::string, int, int>, ZeroReads> found;
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        for (const NodeTextures::Read& each : nodes[i].reads) {
            const scene::Texture& texture = scene.textures[each.texture];
            if (texture.name.empty() || lasting.contains(each.texture) ||
                !std::holds_alternative<scene::EmptySource>(texture.source))
                continue;
            // The first writer exchanges the copies, after which both have been zero.
            const int zeros = each.isPrevious && !nodes[i].written.contains(each.texture) ? 1 : 0;
            const bool isZero = writers[each.texture] <= zeros &&
                                (each.isPrevious || !nodes[i].written.contains(each.texture));
            const auto key = each.isPrevious ? std::tuple(each.texture, true, std::string(), 0, 0)
                                             : std::tuple(each.texture, false, each.place.file,
                                                          each.place.line, each.place.column);
            const auto known = found.try_emplace(key, ZeroReads{true, i, each.place}).first;
            known->second.isAlways = known->second.isAlways && isZero;
        }
        for (const scene::TextureIndex each : nodes[i].written) ++writers[each];
    }
    Diagnostics diagnostics;
    std::set<scene::TextureIndex> reported;
    for (const auto& [key, reads] : found) {
        const auto& [texture, isPrevious, file, line, column] = key;
        if (!reads.isAlways || writers[texture] == 0 || reported.contains(texture)) continue;
        const std::string& name = scene.textures[texture].name;
        const auto writer = isPrevious ? std::nullopt : writerAfter(nodes, reads.node, texture);
        if (!isPrevious && !writer) continue;
        reported.insert(texture);
        diagnostics.push_back(diagnose(
            "draw-W11",
            isPrevious ? fmt::format("'{}.prev' is read here, but only the frame writes '{}', so it is zero; "
                                     "write '{}' in Step",
                                     name, name, name)
                       : fmt::format("texture '{}' is read here, but written only below (line {}), so it is "
                                     "zero; write it before this line",
                                     name, nodes[*writer].place.line),
            reads.place));
    }
    return diagnostics;
}

}  // namespace glibra::plan
