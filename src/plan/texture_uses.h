#pragma once
// Finds the texture that each sampler of a draw reads, and the texture image unit of GL that it is bound to
// (language, 2.4 and 7.9).

#include <glibra/result.h>

#include <span>
#include <string>
#include <vector>

#include "plan/frame_plan.h"

namespace glibra::plan {

/// A sampler or image element with the unit of the language that it reads and the unit of GL that it is set
/// to. Both are the same for all draws of a program; only the textures on the units differ.
struct UnitUse {
    SamplerBinding binding;
    int driverUnit = 0;
};

/// Assigns texture image units from 0 on, in the order of the samplers: one per pair of unit and sampler
/// type, since GL forbids samplers of different types on one unit; and one for each bound texture. Image
/// units are assigned likewise. Error draw-E13, without a place, if the driver has too few.
Result<std::vector<UnitUse>> assignUnits(const ProgramInterface& interface,
                                         std::span<const SamplerBinding> samplers, int maxTextureUnits,
                                         int maxImageUnits);

/// The textures that the units hold at a draw or dispatch, and those that are bound by name. A sampler of a
/// type that units cannot hold reads no texture.
std::vector<TextureUse> textureUses(const scene::Scene& scene, scene::SlotTableIndex slots,
                                    const scene::Sampling& sampling, const ProgramInterface& interface,
                                    std::span<const UnitUse> units);

/// The name of a slot in messages: "5 / 3D".
std::string slotText(int unit, scene::TextureTarget target);

}  // namespace glibra::plan
