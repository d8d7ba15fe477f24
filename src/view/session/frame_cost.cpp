#include "view/session/frame_cost.h"

#include <glad/gl.h>

#include <array>
#include <chrono>

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

/// Index of the pass that the draw belongs to.
int passOf(const plan::FramePlan& plan, const plan::PlannedDraw& draw) {
    for (std::size_t pass = 0; pass < plan.passes.size(); ++pass)
        for (const auto& step : plan.passes[pass].steps)
            if (std::get_if<plan::PlannedDraw>(&step) == &draw) return static_cast<int>(pass);
    return 0;
}

std::vector<PassCost> passesOf(const LiveScene& live) {
    std::vector<PassCost> passes;
    for (const plan::PlannedPass& each : live.plan().passes) {
        PassCost pass{"window", live.plan().passOf(each).place.line, 0};
        std::string units;
        for (const scene::TextureIndex target : live.plan().passOf(each).targets)
            units += (units.empty() ? "" : ", ") + std::to_string(live.scene().textures[target].unit);
        if (!units.empty())
            pass.target = (live.plan().passOf(each).targets.size() > 1 ? "units " : "unit ") + units;
        passes.push_back(std::move(pass));
    }
    return passes;
}

/// Draws one frame with a timer around every draw, and adds the times to `draws`.
void timeDraws(Session& session, std::vector<DrawCost>& draws) {
    std::vector<gpu::Query> timers;
    std::vector<DrawCost> found;
    session.live().drawer().setDrawHook([&](const plan::PlannedDraw& draw, bool, bool begins) {
        if (!begins) return timers.back().end();
        const plan::FramePlan& plan = session.live().plan();
        const scene::Draw& drawn = plan.drawOf(draw);
        found.push_back({drawn.word, drawn.place.line, passOf(plan, draw), 0});
        timers.emplace_back(GL_TIME_ELAPSED).begin();
    });
    drawOnce(session);
    session.live().drawer().setDrawHook({});
    if (draws.empty()) draws = found;
    constexpr double kNanosecondsInMillisecond = 1e6;
    for (std::size_t i = 0; i < timers.size() && i < draws.size(); ++i)
        draws[i].milliseconds += static_cast<double>(timers[i].result()) / kNanosecondsInMillisecond;
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
    constexpr int kTimedFrames = 5;
    for (int i = 0; i < kTimedFrames; ++i) timeDraws(session, cost.draws);
    cost.passes = passesOf(session.live());
    for (DrawCost& each : cost.draws) {
        each.milliseconds /= kTimedFrames;
        cost.passes[static_cast<std::size_t>(each.pass)].milliseconds += each.milliseconds;
    }
    cost.counts = countOnce(session, capabilities);
    session.setNeedsFrame();
    return cost;
}

}  // namespace glibra::view
