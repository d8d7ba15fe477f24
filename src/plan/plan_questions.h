#pragma once
// The inputs of planFrame() (planner.h): options, limits of the driver, and the questions that it asks while
// it plans.

#include <functional>
#include <string>
#include <vector>

#include "plan/overrides.h"
#include "plan/program_variant.h"
#include "scene/scene.h"

namespace glibra::plan {

/// All that a plan asks while it is made. The answers cannot come as values: a program is compiled and a mesh
/// made only if something visible needs it, and what is visible depends on the answers before.
struct PlanQuestions {
    /// The interface of a program. Asked at most once per variant. The reference must stay valid while the
    /// plan is used.
    std::function<const ProgramInterface&(const ProgramVariant&)> interfaceOf;
    /// True if a stage of the program may write to an image. Asked before anything is compiled.
    std::function<bool(scene::ProgramIndex)> mayWriteImages;
    /// The number of rounds after which the driver ends a shader's loops, 0 if it never does. Asked at most
    /// once, and only if a needed program has long loops. May be empty, which means never.
    std::function<int()> loopLimit{};
    /// Says in words why nothing of the draw is visible; empty if it may be visible or has effects besides
    /// those on its target. Asked at most once per draw, before its program is asked for, and never with
    /// PlanOptions::everything. May be empty.
    std::function<std::string(const scene::Draw& draw, const scene::Pass& pass)> outOfSight{};
};

struct PlanOptions {
    std::vector<Override> overrides;
    int maxTextureUnits = 80;  ///< of the driver, all stages together
    int maxImageUnits = 8;     ///< of the driver
    /// What the driver lacks for compute programs and storage buffers, as "OpenGL 4.3; it has 4.1"; empty if
    /// it has them.
    std::string lacksCompute{};
    bool cutsDispatches = false;  ///< compute programs can run in pieces, also without `tiles`
    /// Objects of a modern scene whose content is wanted besides the window.
    std::vector<scene::ObjectView> roots{};
    bool everything = false;    ///< for `glibra check` and --no-skip: skips nothing
    bool idleNoise = true;      ///< with `everything`: also built-in noise that no sampler reads
    bool reportsNames = true;   ///< false: one of several lists; reportNames() is called with all plans
    bool shareMeshes = true;    ///< false: one mesh per draw
    bool shareTargets = false;  ///< textures may share memory; only `roots` keep their content
};

}  // namespace glibra::plan
