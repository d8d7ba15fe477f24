#pragma once
// Private to this room: what all frames of a script share.

#include <compare>
#include <cstddef>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "expression/expression.h"
#include "glib/script.h"
#include "scene/camera.h"
#include "scene/run/environment.h"
#include "scene/scene.h"

namespace glibra::scene {

/// An expression of a script is known by the place where it is written, whatever copies there are of its
/// value.
struct WrittenAt {
    const glib::Script* script = nullptr;
    int line = 0, column = 0;
    glib::Value::Kind kind = glib::Value::Kind::expression;
    friend auto operator<=>(const WrittenAt&, const WrittenAt&) = default;
};

/// An expression that has been read.
struct ReadExpression {
    std::optional<expression::Expression> expression;  ///< nothing if it is wrong, which has been reported
    bool isProblemReported = false;                    ///< a problem of its evaluation
    bool readsShape = false;  ///< it reads a camera's projection, which depends on the target
};

/// The expressions of a script, each read once for each meaning of its names.
using ExpressionCache = std::map<WrittenAt, MadeOfNames<ReadExpression>>;

/// The values of `Buffer name type n (expression of i)`, which are computed again only if what the expression
/// reads has changed.
struct ComputedElements {
    bool isSteady = false;  ///< it changes with variables alone
    std::size_t count = 0;
    std::vector<Environment::Slot> slots;  ///< of these variables
    std::vector<double> reads;
    BufferValues values;
    expression::Depends depends = expression::Depends::nothing;
};

/// The buffers of a Mesh statement.
struct MeshContent {
    struct Part {
        std::string name;  ///< "position"
        std::string type;  ///< of an element
        BufferValues values;
    };
    std::size_t vertices = 0, primitives = 0;
    std::vector<Part> parts;
};

/// The files that frames have read, so that a file is read once and keeps its index.
struct KnownFiles {
    std::map<std::string, std::unique_ptr<const glib::Script>> included;  ///< by path
    std::vector<const glib::Script*> includedOrder;
    List<FileReference> all;
    std::map<std::string, FileIndex> indices;
};

/// What has been computed and is computed again only if what it reads has changed.
struct Computed {
    ExpressionCache expressions;
    std::map<WrittenAt, MadeOfNames<std::optional<expression::Type>>> arrayTypes;  ///< of `Let name[n] (...)`
    std::map<WrittenAt, ComputedElements> elements;
    std::map<std::string, std::optional<MeshContent>> meshes;  ///< nothing: the shape cannot be made
};

/// The cameras of the last frames, which expressions of this one may read.
struct SeenCameras {
    std::map<CameraName, CameraValues> cameras;   ///< of the last frame
    std::map<CameraName, CameraValues> previous;  ///< of the frame before the one that is interpreted
    bool readsPrevious = false;                   ///< an expression reads a camera of the frame before
    bool isTrial = false;      ///< the frame is run for its cameras alone, so its values have no problems
    bool readsShapes = false;  ///< an expression reads what depends on the aspect of a camera with a name
    /// The aspects of the passes that each camera sees: as they were when the last frame ended, and as they
    /// are taken to be while a frame is interpreted.
    std::map<CameraName, std::set<double>> foundAspects, aspects;
};

/// What all frames of a script share.
struct SharedState {
    Environment environment;
    KnownFiles files;
    Computed computed;
    SeenCameras seen;
    expression::Depends depends = expression::Depends::nothing;  ///< of all that the last frame evaluated
    double frameRate = 60;                                       ///< 1 / dt
};

}  // namespace glibra::scene
