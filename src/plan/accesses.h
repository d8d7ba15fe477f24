#pragma once
// Which objects of a scene a node reads, writes and keeps: from the active resources of its programs and the
// memory qualifiers in their text.

#include <map>
#include <string>
#include <vector>

#include "plan/frame_plan.h"

namespace glibra::plan {

/// What the shaders of a program do with textures and buffers. A storage block, atomic counter or image that
/// is not declared readonly counts as written, and one that is not writeonly as read.
std::vector<ObjectUse> shaderUses(const PlannedProgram& program, const std::vector<TextureUse>& textures);
/// The same with what the statement itself reads; the targets of a draw's pass are left out. `inputs` may be
/// null.
std::vector<ObjectUse> usesOf(const PlannedProgram& program, const std::vector<TextureUse>& textures,
                              const scene::Draw& draw, const PlannedInputs* inputs);
std::vector<ObjectUse> usesOf(const PlannedProgram& program, const std::vector<TextureUse>& textures,
                              const scene::Dispatch& dispatch);

/// Returns draw-W12 for each texture with a name that a sampler reads and an image may write in the
/// same draw or dispatch, whose invocations run in any order (GL 4.6, 7.13.1). `word` names the statement.
Diagnostics readsOfWritten(const scene::Scene& scene, const PlannedProgram& program,
                           const std::vector<TextureUse>& textures, const std::string& word,
                           const Place& place);

Object objectOf(const scene::ObjectView& view);
/// True for the copy that an object with history had before.
bool isPreviousCopy(const scene::ObjectView& view);
/// True if there are two copies of it, which are exchanged.
bool hasHistory(const scene::Scene& scene, const Object& object);

/// FramePlan::accesses. `everything`: what shaders write whole is kept nevertheless.
std::vector<NodeAccess> accessesOf(const scene::Scene& scene, const FramePlan& plan, bool everything);
/// NodeAccess::exchanges of a node of FramePlan::order, from the other members.
std::vector<PlannedExchange> exchangesOf(const scene::Scene& scene, const FramePlan& plan,
                                         const scene::NodeIndex& node, const NodeAccess& access,
                                         bool everything);
/// Fills FramePlan::resets, showsEarlierFrames, reads and cleared.
void findBeginnings(const scene::Scene& scene, FramePlan& plan);
/// FramePlan::sharing.
std::map<scene::TextureIndex, scene::TextureIndex> sharedTargets(const scene::Scene& scene,
                                                                 const FramePlan& plan,
                                                                 const std::vector<scene::ObjectView>& roots);

/// True if a draw that covers its target reads matrices or the place of the camera, by glibra's vertex stage
/// (ProgramVariant::isFullScreen).
bool readsCamera(const PlannedProgram& program);

/// True if the shaders of the program may write to an image, a storage block or an atomic counter.
bool writesMemory(const PlannedProgram& program, const std::vector<TextureUse>& textures);

/// How the samples of a pixel see the edges that a fragment stage paints or cuts.
enum class PaintedEdges {
    none,      ///< it only passes on what lies between the vertices
    shown,     ///< they are where they are if the stage runs for each sample
    perPixel,  ///< the stage has to run once per pixel, because it writes memory
};
PaintedEdges paintedEdges(const PlannedProgram& program, const std::vector<TextureUse>& textures);

/// True if a stage of a translated program may write to an image, a storage block or an atomic counter.
bool writesMemory(const glsl::TranslatedProgram& program);

}  // namespace glibra::plan
