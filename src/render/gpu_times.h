#pragma once
// The GPU time of a loaded scene, for each pass, dispatch and clear.

#include <cstddef>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "gpu/object/timer.h"
#include "plan/frame_plan.h"
#include "render/draw/frame.h"
#include "render/simulation/simulation.h"
#include "render/stats.h"
#include "scene/scene.h"

namespace glibra::render {

/// What a node of a plan is, with the line of its statement: "pass into window", "pass into depth layer 2",
/// "dispatch of Move", "clear of hits". The line is 0 if no statement begins the pass.
struct NodeName {
    std::string what;
    int line = 0;
};
/// `node` is an index into FramePlan::order, and `scene` the scene of the plan.
NodeName nameOf(const scene::Scene& scene, const plan::FramePlan& plan, std::size_t node);

/// Adds up the GPU time (gpu/object/timer.h) of what is executed while it watches. The context must be that
/// of what it watches. Nodes of one statement that are called the same are one entry.
class GpuTimes {
  public:
    explicit GpuTimes(const gpu::Capabilities& capabilities);
    GpuTimes(const GpuTimes&) = delete;
    GpuTimes& operator=(const GpuTimes&) = delete;
    ~GpuTimes() = default;

    /// False if the driver has no timer.
    [[nodiscard]] bool measures() const { return timer_.measures(); }

    /// Watches every node that the drawer executes from now on. `scene` and `plan` are the drawer's and must
    /// stay where they are.
    void watch(FrameDrawer& drawer, const scene::Scene& scene, const plan::FramePlan& plan);
    /// The same for every run of a block.
    void watch(Simulation& simulation, const scene::Scene& scene);
    /// Watches other work until endWork().
    void beginWork(const NodeName& name);
    void endWork() { timer_.end(); }

    /// What has been measured, in the order of first use. Waits for the device.
    std::vector<Stats::GpuTime> finish();

  private:
    std::size_t entryOf(NodeName name);

    gpu::Timer timer_;
    std::vector<Stats::GpuTime> entries_;
    std::map<std::pair<int, std::string>, std::size_t> known_;  ///< entries by their line and name
};

}  // namespace glibra::render
