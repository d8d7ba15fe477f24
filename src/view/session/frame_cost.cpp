#include "view/session/frame_cost.h"

#include <fmt/format.h>
#include <glad/gl.h>
#include <array>
#include <chrono>
#include <cmath>
#include <utility>

#include "gpu/object/timer.h"
#include "render/gpu_times.h"

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

/// Measures pieces by the driver's timer, or without one by waiting for the device around each of them.
class PieceClock {
  public:
    PieceClock(const gpu::Capabilities& capabilities, gpu::Timer::Take take)
        : timer_(capabilities, take), take_(std::move(take)) {}

    [[nodiscard]] bool isTimer() const { return timer_.measures(); }
    void begin(std::size_t piece) {
        if (isTimer()) return timer_.begin(piece);
        glFinish();
        open_.emplace_back(piece, std::chrono::steady_clock::now());
    }
    void end() {
        if (isTimer()) return timer_.end();
        if (open_.empty()) return;
        glFinish();
        take_(open_.back().first, seconds(open_.back().second) * 1000);
        open_.pop_back();
    }
    void finish() { timer_.finish(); }

  private:
    gpu::Timer timer_;
    gpu::Timer::Take take_;
    std::vector<std::pair<std::size_t, std::chrono::steady_clock::time_point>> open_;
};

NodeCost costOf(const scene::Scene& scene, const plan::FramePlan& plan, std::size_t node) {
    render::NodeName name = render::nameOf(scene, plan, node);
    return {std::move(name.what), name.line, 0};
}

/// Draws frames with a timer around every node and, within it, around every draw.
void timeFrame(Session& session, const gpu::Capabilities& capabilities, FrameCost& cost) {
    render::FrameDrawer& drawer = session.live().drawer();
    const plan::FramePlan& plan = session.live().plan();
    const std::size_t nodes = plan.order.size();
    for (std::size_t i = 0; i < nodes; ++i) cost.nodes.push_back(costOf(session.live().scene(), plan, i));
    // Pieces are nodes, after these the frame, and after that draws.
    PieceClock timer(capabilities, [&](std::size_t piece, double milliseconds) {
        double& sum = piece < nodes    ? cost.nodes[piece].milliseconds
                      : piece == nodes ? cost.millisecondsOfParts
                                       : cost.draws[piece - nodes - 1].milliseconds;
        sum += milliseconds / kTimedFrames;
    });
    cost.isTimed = timer.isTimer();
    cost.isEstimate = !cost.isTimed || capabilities.isSoftware;
    for (int frame = 0; frame < kTimedFrames; ++frame) {
        std::size_t node = 0, draws = 0;
        drawer.setNodeHook([&](std::size_t index, bool begins) {
            node = index;
            begins ? timer.begin(index) : timer.end();
        });
        drawer.setDrawHook([&](const plan::PlannedDraw& draw, bool, bool begins) {
            if (!begins) return timer.end();
            const scene::Draw& drawn = plan.drawOf(draw);
            if (draws == cost.draws.size())
                cost.draws.push_back({drawn.word, drawn.place.line, node, 0, draw.step});
            timer.begin(nodes + 1 + draws++);
        });
        timer.begin(nodes);
        drawOnce(session);
        timer.end();
    }
    drawer.setDrawHook({});
    drawer.setNodeHook({});
    timer.finish();
}

/// Runs all steps again and times the last ones of each block.
void timeBlocks(Session& session, const gpu::Capabilities& capabilities, FrameCost& cost) {
    const std::vector<render::Simulation::Progress> progress = session.live().steps();
    for (const render::Simulation::Progress& each : progress)
        cost.blocks.push_back({fmt::format("Step {:g}", each.rate), each.place.line, 0, 0, {}});
    struct Timed {
        std::size_t block = 0, node = 0;
        double milliseconds = 0;
    };
    std::vector<Timed> timed;
    PieceClock timer(capabilities, [&](std::size_t piece, double milliseconds) {
        timed[piece].milliseconds = milliseconds;
    });
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
            nodes.push_back(costOf(session.live().scene(), run.plan, i));
        run.drawer.setNodeHook([&timed, &timer, block](std::size_t node, bool nodeBegins) {
            if (!nodeBegins) return timer.end();
            timed.push_back({block, node});
            timer.begin(timed.size() - 1);
        });
    });
    session.live().restart();
    session.setNeedsFrame();
    session.drawIfNeeded();
    session.live().setRunHook({});
    timer.finish();
    for (const Timed& each : timed) {
        BlockCost& block = cost.blocks[each.block];
        const double time = each.milliseconds / block.runs;
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

int decimalsOf(const FrameCost& cost) {
    constexpr int kExact = 3;
    if (!cost.isEstimate) return kExact;
    int decimals = 0;
    for (double whole = cost.millisecondsOfParts; whole < 10 && decimals < kExact; whole *= 10) ++decimals;
    return decimals;
}

std::string millisecondsText(double milliseconds, int decimals) {
    const double unit = std::pow(10., -decimals);
    if (milliseconds > 0 && milliseconds < unit) return fmt::format("< {:.{}f}", unit, decimals);
    return fmt::format("{:.{}f}", std::floor(milliseconds / unit * (1 + 1e-12)) * unit, decimals);
}

FrameCost measureParts(Session& session, const gpu::Capabilities& capabilities) {
    FrameCost cost;
    session.drawIfNeeded();
    if (!session.hasScene() || !session.picture()) return cost;
    timeFrame(session, capabilities, cost);
    session.setNeedsFrame();
    return cost;
}

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
    timeFrame(session, capabilities, cost);
    timeBlocks(session, capabilities, cost);
    cost.counts = countOnce(session, capabilities);
    session.setNeedsFrame();
    return cost;
}

}  // namespace glibra::view
