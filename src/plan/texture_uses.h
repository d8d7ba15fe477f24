#pragma once
// Which texture each sampler of a draw reads, and through which texture image unit of GL (language, 2.4
// and 7.9).

#include <glibra/result.h>

#include <span>
#include <string>
#include <vector>

#include "plan/frame_plan.h"

namespace glibra::plan {

/// A sampler or image element with the unit of the language that it reads and GL's unit that it is set to.
/// The same for every draw of a program: what the unit holds differs, not the unit.
struct UnitUse {
    SamplerBinding binding;
    int driverUnit = 0;
};

/// Gives texture image units from 0 on, in the order of the samplers, one for each pair of unit and sampler
/// type, since GL forbids samplers of different types on one unit; likewise image units from 0 on, one for
/// each unit. Error draw-E05 where the driver has too few; its place is empty.
Result<std::vector<UnitUse>> assignUnits(const ProgramInterface& interface,
                                         std::span<const SamplerBinding> samplers, int maxTextureUnits,
                                         int maxImageUnits);

/// What the units hold at a draw. Samplers of types that scenes cannot fill read no texture.
std::vector<TextureUse> textureUses(const scene::Scene& scene, const scene::Draw& draw,
                                    const ProgramInterface& interface, std::span<const UnitUse> units);

/// "5 / 3D": a slot as messages name it.
std::string slotText(int unit, scene::TextureTarget target);

}  // namespace glibra::plan
