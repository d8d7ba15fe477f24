#pragma once
// Do the outputs of a fragment stage fit the targets of the pass?

#include <bitset>
#include <cstddef>
#include <optional>
#include <string>

#include "base/raster_state.h"
#include "plan/program_interface.h"
#include "scene/scene.h"

namespace glibra::plan {

/// Returns draw-E11 for each output whose kind (floating, signed or unsigned integer) differs from that of
/// the texels which it writes: OpenGL leaves the result undefined (GL 4.6, 17.4.4). A target without colour
/// writes does not count. Empty for classic scenes, whose targets hold no integers.
Diagnostics outputProblems(const scene::Scene& scene, const scene::Draw& draw, const scene::Pass& pass,
                           const ProgramInterface& interface);

/// The colour targets of the pass that the draw may write but its program has no output for: OpenGL leaves
/// undefined what it would write there (GL 4.6, 15.2.3). None for classic scenes.
std::bitset<base::kRasterTargets> targetsWithoutOutput(const scene::Scene& scene, const scene::Draw& draw,
                                                       const scene::Pass& pass,
                                                       const ProgramInterface& interface);

/// A target that has several layers or faces.
struct LayeredTarget {
    std::string name;
    int count = 0;
    bool isCube = false;
};
/// The first target of which the pass names no single layer or face, if that target has several. Nothing for
/// the window.
std::optional<LayeredTarget> layeredTarget(const scene::Scene& scene, const scene::Pass& pass);

/// A colour target in messages: "the window", "target 'ids' (line 4)".
std::string describeTarget(const scene::Scene& scene, const scene::Pass& pass, std::size_t target);

}  // namespace glibra::plan
