#include "view/session/frame_cost.h"

#include <fmt/format.h>
#include <glad/gl.h>

#include <array>
#include <chrono>
#include <utility>

#include "gpu/object/name.h"
#include "gpu/object/query.h"

namespace glibra::view {
namespace {

double seconds(std::chrono::steady_clock::time_point since) {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - since).count();
}

void drawOnce(Session& session) {
    const gpu::Target& picture = *session.picture();
    const int width = picture.width(), height = picture.height();
    session.live().drawer().draw(
        picture, {session.live().view(), width, height, {0, 0, width, height}, session.clock().time()});
}

constexpr int kTimedFrames = 5;
constexpr double kNanosecondsInMillisecond = 1e6;

double milliseconds(const gpu::Query& timer) {
    return static_cast<double>(timer.result()) / kNanosecondsInMillisecond;
}

std::string textureName(const scene::Scene& scene, scene::TextureIndex index) {
    const scene::Texture& texture = scene.textures[index];
    return texture.name.empty() ? fmt::format("unit {}", texture.unit) : texture.name;
}

std::string targetsOf(const scene::Scene& scene, const scene::Pass& pass) {
    if (pass.isWindow) return "window";
    std::string targets;
    for (std::size_t i = 0; i < pass.targets.size(); ++i) {
        targets += (targets.empty() ? "" : ", ") + textureName(scene, pass.targets[i]);
        if (i >= pass.parts.size()) continue;
        if (pass.parts[i].level) targets += fmt::format(" level {}", *pass.parts[i].level);
        if (pass.parts[i].layer) targets += fmt::format(" layer {}", *pass.parts[i].layer);
    }
    if (!pass.depth) return targets;
    targets += (targets.empty() ? "" : ", ") + textureName(scene, pass.depth->texture);
    if (pass.depth->layer) targets += fmt::format(" layer {}", *pass.depth->layer);
    return targets;
}

NodeCost nodeOf(const scene::Scene& scene, const plan::FramePlan& plan, std::size_t node) {
    const scene::NodeIndex& at = plan.order[node];
    if (at.kind == scene::NodeIndex::Kind::pass) {
        const scene::Pass& pass = plan.passOf(plan.passes[at.index]);
        return {"pass into " + targetsOf(scene, pass), pass.place.line, 0};
    }
    if (at.kind == scene::NodeIndex::Kind::dispatch) {
        const scene::Dispatch& dispatch = plan.dispatchOf(plan.dispatches[at.index]);
        return {"dispatch of " + scene.programs[dispatch.program].name, dispatch.place.line, 0};
    }
    const scene::ClearObject& clear = plan.clearOf(plan.clears[at.index]);
    const auto* buffer = std::get_if<scene::BufferIndex>(&clear.object);
    return {
        "clear of " + (buffer != nullptr ? scene.buffers[*buffer].name
                                         : textureName(scene, std::get<scene::TextureIndex>(clear.object))),
        clear.place.line, 0};
}

/// Draws frames with a timer around every draw, and others with a timer around every node: only one timer
/// runs at a time.
void timeFrame(Session& session, FrameCost& cost) {
    render::FrameDrawer& drawer = session.live().drawer();
    const plan::FramePlan& plan = session.live().plan();
    for (std::size_t i = 0; i < plan.order.size(); ++i)
        cost.nodes.push_back(nodeOf(session.live().scene(), plan, i));
    for (int frame = 0; frame < kTimedFrames; ++frame) {
        std::vector<gpu::Query> timers;
        std::vector<DrawCost> found;
        std::size_t node = 0;
        drawer.setNodeHook([&](std::size_t index, bool) { node = index; });
        drawer.setDrawHook([&](const plan::PlannedDraw& draw, bool, bool begins) {
            if (!begins) return timers.back().end();
            const scene::Draw& drawn = plan.drawOf(draw);
            found.push_back({drawn.word, drawn.place.line, node, 0});
            timers.emplace_back(GL_TIME_ELAPSED).begin();
        });
        drawOnce(session);
        drawer.setDrawHook({});
        if (cost.draws.empty()) cost.draws = std::move(found);
        for (std::size_t i = 0; i < timers.size() && i < cost.draws.size(); ++i)
            cost.draws[i].milliseconds += milliseconds(timers[i]) / kTimedFrames;

        std::vector<std::pair<std::size_t, gpu::Query>> nodeTimers;
        drawer.setNodeHook([&](std::size_t index, bool begins) {
            if (!begins) return nodeTimers.back().second.end();
            nodeTimers.emplace_back(index, gpu::Query(GL_TIME_ELAPSED)).second.begin();
        });
        drawOnce(session);
        drawer.setNodeHook({});
        for (const auto& [index, timer] : nodeTimers)
            cost.nodes[index].milliseconds += milliseconds(timer) / kTimedFrames;
    }
}

/// Runs all steps again and times the last ones of each block.
void timeBlocks(Session& session, FrameCost& cost) {
    const std::vector<render::Simulation::Progress> progress = session.live().steps();
    for (const render::Simulation::Progress& each : progress)
        cost.blocks.push_back({fmt::format("Step {:g}", each.rate), each.place.line, 0, 0, {}});
    struct Timed {
        std::size_t block = 0, node = 0;
        gpu::Query timer;
    };
    std::vector<Timed> timers;
    std::vector<std::int64_t> ran(cost.blocks.size(), 0);
    session.live().setRunHook([&](const render::Simulation::Run& run, bool begins) {
        if (!begins) return run.drawer.setNodeHook({});
        std::size_t block = 0;
        while (block < cost.blocks.size() && cost.blocks[block].line != run.place.line) ++block;
        if (block == cost.blocks.size()) {
            cost.blocks.push_back({"Once", run.place.line, 0, 0, {}});
            ran.push_back(0);
        }
        if (block < progress.size() && ran[block]++ < progress[block].steps - kTimedFrames) return;
        ++cost.blocks[block].runs;
        std::vector<NodeCost>& nodes = cost.blocks[block].nodes;
        for (std::size_t i = nodes.size(); i < run.plan.order.size(); ++i)
            nodes.push_back(nodeOf(session.live().scene(), run.plan, i));
        run.drawer.setNodeHook([&timers, block](std::size_t node, bool nodeBegins) {
            if (!nodeBegins) return timers.back().timer.end();
            timers.push_back({block, node, gpu::Query(GL_TIME_ELAPSED)});
            timers.back().timer.begin();
        });
    });
    session.live().restart();
    session.setNeedsFrame();
    session.drawIfNeeded();
    session.live().setRunHook({});
    for (const Timed& each : timers) {
        BlockCost& block = cost.blocks[each.block];
        const double time = milliseconds(each.timer) / block.runs;
        block.nodes[each.node].milliseconds += time;
        block.milliseconds += time;
    }
}

std::optional<PipelineCounts> countOnce(Session& session, const gpu::Capabilities& capabilities) {
    if (!capabilities.hasExtension("GL_ARB_pipeline_statistics_query")) return std::nullopt;
    constexpr std::array<GLenum, 3> kKinds{GL_VERTEX_SHADER_INVOCATIONS, GL_CLIPPING_INPUT_PRIMITIVES,
                                           GL_FRAGMENT_SHADER_INVOCATIONS};
    std::array<GLuint, 3> names{};
    glGenQueries(static_cast<GLsizei>(names.size()), names.data());
    for (std::size_t i = 0; i < kKinds.size(); ++i) glBeginQuery(kKinds[i], names[i]);
    drawOnce(session);
    std::array<GLuint64, 3> values{};
    for (const GLenum kind : kKinds) glEndQuery(kind);
    for (std::size_t i = 0; i < kKinds.size(); ++i)
        glGetQueryObjectui64v(names[i], GL_QUERY_RESULT, &values[i]);
    glDeleteQueries(static_cast<GLsizei>(names.size()), names.data());
    return PipelineCounts{values[0], values[1], values[2]};
}

}  // namespace

FrameCost measureFrames(Session& session, const gpu::Capabilities& capabilities, int leastFrames,
                        double leastSeconds) {
    FrameCost cost;
    session.drawIfNeeded();
    if (!session.hasScene() || !session.picture()) return cost;
    glFinish();
    const auto start = std::chrono::steady_clock::now();
    while (cost.frames < leastFrames || seconds(start) < leastSeconds) {
        drawOnce(session);
        ++cost.frames;
        // Otherwise the driver queues an unlimited number of frames.
        constexpr int kFramesInFlight = 8;
        if (cost.frames % kFramesInFlight == 0) glFinish();
    }
    glFinish();
    constexpr double kMillisecondsInSecond = 1000;
    cost.millisecondsPerFrame = seconds(start) * kMillisecondsInSecond / cost.frames;
    timeFrame(session, cost);
    timeBlocks(session, cost);
    cost.counts = countOnce(session, capabilities);
    session.setNeedsFrame();
    return cost;
}

}  // namespace glibra::view
