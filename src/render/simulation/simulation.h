#pragma once
// Runs the Once and Step blocks of a scene, so that what lasts has the state of a time (language, 12).

#include <glibra/result.h>

#include <cstdint>
#include <functional>
#include <memory>
#include <set>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "gpu/context/context.h"
#include "gpu/object/timer.h"
#include "plan/accesses.h"
#include "plan/frame_plan.h"
#include "render/draw/frame.h"
#include "render/load/device_scene.h"
#include "render/load/programs.h"
#include "render/stats.h"
#include "scene/interpret.h"

namespace glibra::render {

/// The steps that a picture at `time` has seen: floor(time * rate + 2^-20), at least 0. Limited to 2^62.
std::int64_t stepsAt(double time, double rate);

/// One step of one block.
struct StepNumber {
    std::size_t block = 0;
    std::int64_t tick = 0;  ///< from 0
    friend bool operator==(const StepNumber&, const StepNumber&) = default;
};
/// Runs the steps of several blocks in the order of time, which is (tick + 1) / rate; at equal times in the
/// order of the blocks. `run` returns false to stop.
void inOrderOfTime(std::span<const double> rates, std::span<const std::int64_t> from,
                   std::span<const std::int64_t> to, const std::function<bool(StepNumber)>& run);
/// True if all steps below `done` come before all others in that order, so that going on after them gives the
/// same as beginning anew.
bool canGoOn(std::span<const double> rates, std::span<const std::int64_t> done,
             std::span<const std::int64_t> to);

/// The parts of a loaded scene that a simulation works with. They must outlive it.
struct SimulationParts {
    gpu::Context& context;
    scene::Scene& scene;                      ///< replaced while steps are interpreted, and put back
    scene::Interpretation* source = nullptr;  ///< null: the scene is the same for all ticks
    ProgramLibrary& programs;
    DeviceScene& device;
    Stats& stats;
    /// Plans a node list of the scene. The nodes that `roots` depend on are needed.
    std::function<plan::FramePlan(const scene::NodeList& nodes, std::vector<scene::ObjectView> roots)>
        planList;
    /// Makes what a plan needs on the device. The programs of all plans say what lies in its buffers.
    std::function<Diagnostics(const plan::FramePlan& plan)> prepare;
    /// Conductor::recordLoops.
    std::function<void(const plan::FramePlan& plan)> recordLoops;
};

class Simulation {
  public:
    Simulation(SimulationParts parts, std::int64_t mostSteps);
    Simulation(const Simulation&) = delete;
    Simulation& operator=(const Simulation&) = delete;
    ~Simulation();

    /// Plans all blocks. `frame` is the plan of a frame: what it reads decides which nodes are needed, unless
    /// frames differ (`framesDiffer`), when all are. Errors: memory-E07 if the frame writes what lasts,
    /// memory-E09 if a block draws into the window, memory-E11 if Once reads a variable that changes with
    /// time, and those of plans. Warning memory-W01 if a block reads what only the frame writes.
    /// `roots`: what else is read of what lasts.
    Diagnostics plan(const plan::FramePlan& frame, bool framesDiffer, std::vector<scene::ObjectView> roots);
    /// Makes what the plans need. Call it after the frame's own objects are made.
    Diagnostics make();
    /// Errors of a frame that was planned for another time: memory-E07.
    [[nodiscard]] Diagnostics check(const plan::FramePlan& frame) const;
    /// Brings what lasts to its state at inputs.time: goes on from the steps that have run, or begins anew.
    /// Error memory-E08 if more steps are to run than allowed.
    Diagnostics advance(const scene::FrameInputs& inputs);

    /// The next advance() begins anew.
    void forget();
    /// Call it after the scene has been interpreted for other values of variables: plans the Step blocks
    /// again. They go on where they are, unless a rate is another one.
    Diagnostics variablesChanged();
    /// Changes literals in the plans of all blocks. `change` returns the programs whose literals it has
    /// changed. Other values in a Once block mean that the next advance() begins anew.
    void changeValues(const std::function<std::vector<plan::PlannedProgramIndex>(plan::FramePlan&)>& change);
    /// Takes over what lasts, with its content, from the simulation of the same blocks before the scene was
    /// read again. `previous` is to be destroyed.
    void takeOver(Simulation& previous);

    /// A block that runs.
    struct Run {
        bool isOnce = false;
        double rate = 0;  ///< of a Step
        Place place;
        const plan::FramePlan& plan;
        FrameDrawer& drawer;
    };
    /// Called before (`begins`) and after each run of a block.
    using RunHook = std::function<void(const Run& run, bool begins)>;
    void setRunHook(RunHook hook) { hook_ = std::move(hook); }

    /// How far a Step block has run.
    struct Progress {
        Place place;
        double rate = 1;
        std::int64_t steps = 0;  ///< that have run
    };
    /// Of all Step blocks, in the order of the text.
    [[nodiscard]] std::vector<Progress> progress() const;

    /// The steps of each block at that time; 0 for blocks of which nothing is needed.
    [[nodiscard]] std::vector<std::int64_t> stepsAt(double time) const;
    /// False if the next advance() begins anew, whatever its time.
    [[nodiscard]] bool hasRun() const { return hasRun_; }
    /// How often what lasts has been brought to another state; equal numbers mean the same state.
    [[nodiscard]] std::int64_t changes() const { return changes_; }
    /// True if a block writes the object.
    [[nodiscard]] bool lasts(const plan::Object& object) const;

    /// The plans of the blocks, Once before Step.
    [[nodiscard]] std::vector<const plan::FramePlan*> plans() const;

  private:
    struct Block;
    struct Lasting {
        scene::ObjectView object;
        Place place;         ///< of the block that writes it
        const char* word{};  ///< "Once" or "Step"
    };
    Diagnostics planAll();
    /// Whether the condition at the end of a round holds, by the buffers as they are. What is wrong with it
    /// is added to `diagnostics`, and then it holds.
    bool holds(const scene::Until& until, Diagnostics& diagnostics);
    /// memory-W01.
    [[nodiscard]] Diagnostics checkReads() const;
    /// Finds out whether each tick needs a scene of its own.
    void noteDepends(Block& block, const scene::StepBlock& now) const;
    Diagnostics restart(bool plansAgain);
    /// Plans a block of the scene as it is now.
    Diagnostics planAgain(Block& block, const scene::NodeList& nodes);
    Diagnostics run(Block& block, double time);
    /// Closes the drawer that the last run has left open.
    void closeDrawer();
    Diagnostics runStep(const StepNumber& step, scene::FrameInputs inputs);
    void noteWrites(Block& block);
    /// Remembers the values after `reset` at a step. True if they differ from those at the step before.
    static bool hasOtherResets(Block& block, const std::vector<double>& now);
    Diagnostics beginAnew(Block& step, std::int64_t tick);
    /// What the content of the Once blocks depends on.
    [[nodiscard]] std::vector<std::vector<double>> onceReads() const;

    std::set<std::pair<std::string, int>> notReached_;  ///< conditions of rounds that were reported
    SimulationParts parts_;
    std::int64_t mostSteps_;
    std::vector<std::unique_ptr<Block>> once_, steps_;
    std::vector<std::vector<double>> onceReads_;  ///< of the Once blocks that have run
    std::vector<std::int64_t> done_;              ///< steps that have run, per Step block
    std::vector<Lasting> lasting_;
    std::vector<scene::ObjectView> roots_;  ///< what is read of what lasts
    bool hasRun_ = false;
    RunHook hook_;
    FrameDrawer* open_ = nullptr;  ///< of the block that has run last, while advance() runs
    gpu::WorkQueue queue_;         ///< of steps
    std::int64_t changes_ = 0;
};

}  // namespace glibra::render
