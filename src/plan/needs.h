#pragma once
// Private to this room.
// Finds which steps of a frame contribute to the picture: it walks back from the window to the passes whose
// targets are sampled on the way.

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "plan/frame_plan.h"
#include "plan/planned_programs.h"

namespace glibra::plan {

enum class StepNeed : std::uint8_t { needed, coveredByClear, drawsNothing, outOfSight, passNotNeeded };

/// One element per pass, dispatch and clear of the list, per step of each pass, and per texture and buffer.
struct Needs {
    std::vector<bool> passes;
    std::vector<bool> dispatches, clears;
    std::vector<std::vector<StepNeed>> steps;
    scene::List<bool, scene::Texture> textures;          ///< used by a needed node: read or drawn into
    scene::List<bool, scene::Buffer> buffers;            ///< likewise
    std::map<scene::StepIndex, std::string> outOfSight;  ///< why, for each such step
    Place
        clear;  ///< of the last Clear of the window, or the pass that clears it, if steps are coveredByClear
};

/// The nodes that the window or one of PlanOptions::roots depends on. It walks back through the list and
/// knows what is still read: a node is needed if it writes such an object, and what it reads is needed before
/// it. A clear of a whole target ends the need for its earlier content. Targets are seen as wholes: a pass
/// into one level of a texture that is read is needed. Where a frame begins with what the one before has left
/// (scene::Scene::goesOn), what is read at the beginning is read after the end, too. Draws that are out of
/// sight are not needed, nor are those of which that is not known: they are among the questions then. With
/// PlanOptions::everything all nodes are needed.
Needs findNeeds(const scene::Scene& scene, const scene::NodeList& nodes, PlannedPrograms& programs,
                const Answers& answers, const PlanOptions& options, Questions& questions);

/// True if a draw of the pass tests the stencil, or a Clear sets it.
bool usesStencil(const scene::Pass& pass);

}  // namespace glibra::plan
