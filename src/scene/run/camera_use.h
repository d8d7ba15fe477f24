#pragma once
// Private to this room: which camera sees what is drawn, and what it decides.

#include <glm/mat4x4.hpp>
#include <string>
#include <string_view>

#include "scene/run/state.h"
#include "scene/view.h"

namespace glibra::scene {

/// The camera of a Camera statement that has run; null if there is none.
const SceneCamera* findCamera(const Interpreter&, const CameraName& name);
/// The camera that sees what is drawn now: that of the pass, or `eye`, which may be the classic view.
SceneCamera currentCamera(const Interpreter&);
/// The name as a scene writes it: "slice[2]", or "eye".
std::string textOf(const Interpreter&, const CameraName& name);
/// Width / height of the window.
double windowAspect(const Interpreter&);
/// Width / height of the current target.
double currentAspect(const Interpreter&);
/// The view and projection of classic commands as a camera.
SceneCamera classicCamera(const Interpreter&);
/// What expressions may ask of the camera.
CameraValues valuesOf(const SceneCamera& camera, double aspect);
/// Gives expressions the values that a camera had in the frame before; those of now if it had none.
void setPrevious(Interpreter&, std::string_view name, const CameraName& camera, const CameraValues& now);
glm::dmat4 projectionOf(const SceneCamera& camera, double aspect);
/// Remembers the shape of a target that the camera sees.
void noteAspect(Interpreter&, const SceneCamera& camera, double aspect);
/// The space of a draw that covers a target of this shape (width / height), seen by the current camera.
ClipSpace coveringSpace(Interpreter&, double aspect);
/// Gives a draw the projection, which it shares with the last draw if that has an equal one.
void shareProjection(Interpreter&, Draw& draw, const Projection& projection);
/// Sets what the current camera decides for a draw: its matrices, and the winding if it is mirrored.
void lookAt(Interpreter&, Draw& draw, RasterState& raster);

}  // namespace glibra::scene
