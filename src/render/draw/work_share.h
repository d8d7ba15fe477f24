#pragma once
// What a device does at once: work for one that others use too is cut into parts, so that none of them takes
// long: a driver resets the device when a draw keeps it for seconds (gpu/context/driver_reports.h).

#include <glibra/result.h>

#include <array>
#include <cstdint>
#include <functional>
#include <string>

#include "glsl/types/translated_program.h"
#include "gpu/context/capabilities.h"
#include "gpu/context/context.h"
#include "scene/nodes.h"

namespace glibra::render {

/// The seconds that one part of a draw may take on a device that is not the processor.
inline constexpr double kTimeShare = .1;
/// Work that takes less than this part of the share is not waited for.
inline constexpr double kQuickShare = .25;

/// How work was done in parts.
struct Shares {
    int parts = 1;
    double seconds = 0;  ///< at most, that all took
};

/// Does the rows 0 to `rows` - 1 of a draw, each once, in parts that take about `share` seconds. `work` hands
/// the rows from `first` to `end` - 1 to the device; with equal numbers, what every part costs besides its
/// rows. `wait` waits for the device and returns the seconds since it returned last. The device idles
/// meanwhile, so the last rows of work that is quick are not waited for.
Shares doInShares(int rows, double share, const std::function<void(int first, int end)>& work,
                  const std::function<double()>& wait);

// ---- The limits of dispatches

/// PlanOptions::lacksCompute for this driver.
std::string lackOfCompute(const gpu::Capabilities& driver);

using GroupCounts = std::array<std::uint64_t, 3>;

/// The counts as GL takes them. Error memory-E06 names the driver's limit for counts beyond it. GL has no
/// limit for their product, but software drivers count the groups with 32 bits and leave the others undone
/// without an error: warning draw-W18.
Result<std::array<unsigned, 3>> checkedGroups(const GroupCounts& groups, const gpu::Capabilities& driver,
                                              const Place& place);

// ---- Patches
// Splits a large draw of patches into several, for drivers that draw it wrongly. Mesa's software drivers
// (22.3.6) number the tessellated vertices of one draw in 16 bits, so that beyond 65,536 of them triangles
// use the wrong vertices. They also pass patches to the tessellator 1024 vertices at a time and restart
// gl_PrimitiveID at 0 each time.

/// Draws `indexCount` indices by calls of `drawPart`, with the program in use, which was built from
/// `program`. Between calls it sets the uniforms that the translator adds to stages that read gl_PrimitiveID,
/// so that each patch or primitive has its number within the whole draw.
void drawPatches(const gpu::Capabilities& driver, const glsl::TranslatedProgram& program, int patchVertices,
                 int indexCount, const std::function<void(int first, int count)>& drawPart);

/// For a caller that draws one part itself: sets the number that the part's first patch has within the whole
/// draw.
void setFirstPatch(const glsl::TranslatedProgram& program, int patch);

}  // namespace glibra::render
