#pragma once
// Which objects of a scene a node reads and writes: from the active resources of its programs and the memory
// qualifiers in their text.

#include <vector>

#include "plan/frame_plan.h"
#include "plan/needs.h"

namespace glibra::plan {

/// What the shaders of a program do with textures and buffers. A storage block, atomic counter or image that
/// is not declared readonly counts as written, and one that is not writeonly as read.
std::vector<ObjectUse> shaderUses(const PlannedProgram& program, const std::vector<TextureUse>& textures);

/// What plan.order[node] does, the same object several times if it is used in several ways. Targets of a pass
/// are written, and read too unless the pass clears them.
std::vector<ObjectUse> usesOf(const FramePlan& plan, std::size_t node);

/// FramePlan::exchanges and FramePlan::resets.
std::vector<std::vector<PlannedExchange>> exchangesOf(const scene::Scene& scene, const FramePlan& plan);
std::vector<scene::ObjectView> resetsOf(const scene::Scene& scene, const FramePlan& plan);

/// True if the shaders of the program may write to an image, a storage block or an atomic counter.
bool writesMemory(const PlannedProgram& program, const std::vector<TextureUse>& textures);

/// True if a stage of a translated program may write to an image, a storage block or an atomic counter.
bool writesMemory(const glsl::TranslatedProgram& program);

}  // namespace glibra::plan
