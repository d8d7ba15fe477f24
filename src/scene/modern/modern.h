#pragma once
// Private to this room: what the files of modern statements give to each other and to the interpretation.

#include <optional>
#include <set>
#include <span>
#include <vector>

#include "expression/expression.h"
#include "scene/run/state.h"

namespace glibra::scene {

std::span<const CommandAction> structureActions();  // structure.cpp
std::span<const CommandAction> variableActions();   // variables.cpp
std::span<const CommandAction> tagActions();        // tags.cpp
std::span<const CommandAction> cameraActions();     // cameras.cpp
std::span<const CommandAction> objectActions();     // textures.cpp
std::span<const CommandAction> targetActions();     // passes.cpp
std::span<const CommandAction> stateActions();      // draws.cpp
std::span<const CommandAction> vertexActions();     // draws.cpp
std::span<const CommandAction> bufferActions();     // buffers.cpp
std::span<const CommandAction> blockActions();      // blocks.cpp
std::span<const CommandAction> checkActions();      // checks.cpp

// checks.cpp

/// The Expect statements that have not run, and why.
std::vector<IdleCheck> idleChecks(const Interpreter&);

// cameras.cpp

/// Reports glib-W38 for each camera whose name stands nowhere else in the scene, if no camera `eye` is
/// declared.
void reportUnusedCameras(Interpreter&);
/// Reports glib-W41 for a Camera `eye` that stands after all draws.
void reportLateEye(Interpreter&);
/// True if the value names a camera, not a part of one.
bool namesCamera(const Interpreter& in, const Value& value);
/// True if the value names a choice, or the counter of a Repeat over words, whose word names a camera.
bool choosesCamera(Interpreter& in, const Value& value);
/// The camera that a value names. Nothing with the reason reported.
std::optional<SceneCamera> cameraNamed(Interpreter&, const Value& name);
/// Remembers that the scene, or the block that is open, depends on what the camera depends on.
void noteCameraDepends(Interpreter&, const CameraName& name);

// blocks.cpp

/// Remembers that a pass of a Once block is seen by the camera.
void noteCamera(Interpreter&, const SceneCamera& camera);
/// Remembers what the camera of a Fill depends on. Only if its program reads matrices, the block does so.
void noteFill(Interpreter&);

// buffers.cpp

/// `Clear NAME`.
void doClearObject(Interpreter&, const Command&);
/// What a statement says with `from BUFFER [at n]`. Nothing with the reason reported.
std::optional<CountFrom> countFrom(Interpreter&, const Command& command);

// passes.cpp

/// False, with glib-E23 reported, inside a pass, whose draws would be torn apart: a group that is drawn there
/// may contain any statement.
bool isOutsidePass(Interpreter&, const Command& command);

// structure.cpp

/// Draws each group that nothing has drawn, with the defaults of its parameters.
void drawOtherGroups(Interpreter&);
/// The variables that the commands [first, last) set change with the conditions around them, whether they run
/// or not.
void addConditions(Interpreter&, std::size_t first, std::size_t last);
/// The textures that statements of ModernState::untaken may write, also through the groups that they draw,
/// and those that the other words of a choice would make the target of a statement. Uniforms of dispatches
/// count as images.
std::set<TextureIndex> undecidedWrites(const Interpreter&);

}  // namespace glibra::scene
