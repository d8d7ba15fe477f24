#pragma once
// The limits of dispatches.

#include <glibra/result.h>

#include <array>
#include <cstdint>
#include <string>

#include "gpu/context/capabilities.h"
#include "scene/nodes.h"

namespace glibra::render {

/// PlanOptions::lacksCompute for this driver.
std::string lackOfCompute(const gpu::Capabilities& driver);

using GroupCounts = std::array<std::uint64_t, 3>;

/// The counts as GL takes them. Error memory-E06 names the driver's limit for counts beyond it. GL has no
/// limit for their product, but software drivers count the groups with 32 bits and leave the others undone
/// without an error: warning draw-W18.
Result<std::array<unsigned, 3>> checkedGroups(const GroupCounts& groups, const gpu::Capabilities& driver,
                                              const Place& place);

}  // namespace glibra::render
