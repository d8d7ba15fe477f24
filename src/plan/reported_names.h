#pragma once
// What only all plans of a scene show together: names of --set and Set that no program has (language, 12.1),
// and textures that nothing writes (12.4).

#include <glibra/diagnostic.h>

#include <span>

#include "plan/frame_plan.h"
#include "plan/overrides.h"

namespace glibra::plan {

/// glib-W23 for `--set` names that no program of the plans has, and glib-W24 for those that are declared but
/// not active. `plans` are those of the scene's frame and of its Once and Step blocks, made with the same
/// overrides. For a program that none of them asked for, or that did not link, only the pairs are known, so a
/// name among them is accepted. Also draw-W11 for textures that are read and never written, and glib-W23 for
/// names of Set that look misspelt: no program has them, one has a name that is near, and all programs of the
/// scene are known.
Diagnostics reportNames(const scene::Scene& scene, std::span<const FramePlan* const> plans,
                        std::span<const Override> overrides);

}  // namespace glibra::plan
