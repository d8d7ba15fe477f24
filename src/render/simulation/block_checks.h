#pragma once
// What Once and Step blocks read, what they must not read (language, 12.8), and names of things for messages.

#include <glibra/result.h>

#include <functional>
#include <string>
#include <vector>

#include "plan/accesses.h"
#include "plan/frame_plan.h"
#include "scene/scene.h"

namespace glibra::render {

/// The name of a texture or buffer; "unit 5" for a texture without one.
std::string nameOf(const scene::Scene& scene, const scene::ObjectView& object);

/// Adds what the nodes of the plan read, each part once.
void addReads(const plan::FramePlan& plan, std::vector<scene::ObjectView>& to);
/// All textures and buffers.
std::vector<scene::ObjectView> allObjects(const scene::Scene& scene);

/// True if a uniform reads a variable by its name that changes with time.
bool readsTimedVariable(const plan::FramePlan& plan);
/// True if a draw that covers its target reads the camera.
bool readsCamera(const plan::FramePlan& plan);
/// Adds the matrices that such draws of a block read, as the scene has them `now`.
void addCameras(const plan::FramePlan& plan, const scene::NodeList& now, std::vector<double>& to);

/// memory-E11 for each draw and dispatch of a Once block whose uniforms read, by their names, variables that
/// change with time.
Diagnostics timedReadsOfOnce(const scene::Scene& scene, const plan::FramePlan& once);

/// A block with its word, "Once" or "Step".
struct CheckedBlock {
    const char* word{};
    const plan::FramePlan& plan;
};
/// memory-W01 for each object that the block reads and that only the frame writes. `lasts` says what a block
/// writes.
Diagnostics readsOfFrame(const scene::Scene& scene, const CheckedBlock& block, const plan::FramePlan& frame,
                         const std::function<bool(const plan::Object&)>& lasts);

}  // namespace glibra::render
