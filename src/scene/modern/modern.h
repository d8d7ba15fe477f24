#pragma once
// Private to this room: what the interpreter of modern statements keeps, for one frame and from frame to
// frame.

#include <cstddef>
#include <glm/mat4x4.hpp>
#include <glm/vec4.hpp>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "glib/script.h"
#include "scene/camera.h"
#include "scene/modern/environment.h"
#include "scene/modern/evaluate.h"
#include "scene/scene.h"

namespace glibra::scene {

struct Interpreter;

/// What all frames of a script share.
struct SharedState {
    Environment environment;
    ExpressionCache expressions;
    std::map<const glib::Value*, std::optional<expression::Type>> arrayTypes;  ///< of `Let name[n] (...)`
    std::vector<const glib::Script*> includedOrder;
    std::map<std::string, std::unique_ptr<const glib::Script>> included;  ///< by path
    List<FileReference> files;  ///< of all frames so far, so that a file keeps its index
    std::map<std::string, FileIndex> fileIndices;
    expression::Depends depends = expression::Depends::nothing;  ///< of all that the last frame evaluated
    double interval = 1.0 / 60;                                  ///< dt
    std::map<std::string, CameraValues> cameras;                 ///< of the last frame
    std::map<std::string, CameraValues> previousCameras;  ///< of the frame before the one that is interpreted
    bool readsPrevious = false;  ///< an expression reads a camera of the frame before
};

/// A camera of a Camera statement.
struct SceneCamera {
    glm::dmat4 view{1.0};
    Projection projection = Perspective{};
    std::optional<double> aspect;    ///< nothing: that of the target
    std::optional<glm::dvec4> clip;  ///< a plane of eye space that replaces the near plane
    double near = 0, far = 0;        ///< of a projection matrix
    bool isMirrored = false;         ///< it turns the winding of triangles
};

/// A group of statements with a name.
struct GroupDefinition {
    const glib::Script* script = nullptr;
    std::size_t command = 0;  ///< index of the Group statement
    bool isRunning = false;   ///< a group cannot draw itself
};

/// A tag of Set or Material with the script that it stands in.
struct ScopedTag {
    const glib::KeyedValues* tag = nullptr;
    const glib::Script* script = nullptr;
};

/// A Program statement with tags that are evaluated at its draws.
struct ProgramTags {
    const glib::Command* command = nullptr;
    const glib::Script* script = nullptr;
};

/// What modern statements change during one frame.
struct ModernState {
    std::map<std::string, SceneCamera, std::less<>> cameras;
    std::map<std::string, ProgramIndex, std::less<>> programs;
    std::map<std::string, GroupDefinition, std::less<>> groups;
    std::map<ProgramIndex, ProgramTags> programTags;
    std::vector<ScopedTag> set;  ///< of the scope; each tag once
    std::size_t statements = 0;
    std::size_t calls = 0;   ///< nested groups and included files
    std::size_t blocks = 0;  ///< blocks that the current statement stands in
    bool isFull = false;     ///< the limit of statements has been reported
    std::set<const glib::Script*> including;
};

// structure.cpp

/// Runs the statements [first, last) of the current script. Each block runs its own statements.
void run(Interpreter&, std::size_t first, std::size_t last);
/// Counts a statement that is about to run. False, with glib-E33, if there are too many.
bool countStatement(Interpreter&, const glib::Command& command);
/// The number of the file that the current statement stands in: 0 for the scene's own, then the included ones
/// in the order in which they were read first.
int fileNumber(const Interpreter&);

// variables.cpp

/// The value of a parameter or variable: an expression, or one to four numbers. Nothing with the reason
/// reported.
std::optional<expression::Value> constantOf(Interpreter&, std::span<const glib::Value> values);
/// The uniform variables that tags with expressions, Set and Material give to a draw that is made now.
UniformSetIndex currentUniforms(Interpreter&);

// cameras.cpp

const SceneCamera* findCamera(const Interpreter&, std::string_view name);
/// What expressions may ask of the camera; the aspect ratio is the window's unless the camera has its own.
CameraValues valuesOf(const Interpreter&, const SceneCamera& camera);
glm::dmat4 projectionOf(const SceneCamera& camera, double aspect);

}  // namespace glibra::scene
