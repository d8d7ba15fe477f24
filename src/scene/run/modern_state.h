#pragma once
// Private to this room: what modern statements declare during one frame, and what stands around them.

#include <cstddef>
#include <cstdint>
#include <glm/mat4x4.hpp>
#include <glm/vec4.hpp>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "expression/type.h"
#include "glib/script.h"
#include "scene/camera.h"
#include "scene/run/environment.h"
#include "scene/scene.h"

namespace glibra::scene {

/// A camera of a Camera statement.
struct SceneCamera {
    glm::dmat4 view{1.0};
    Projection projection = Perspective{};
    std::optional<double> aspect;    ///< nothing: that of the target
    std::optional<glm::dvec4> clip;  ///< a plane of eye space that replaces the near plane
    double near = 0, far = 0;        ///< of a projection matrix
    bool isMirrored = false;         ///< it turns the winding of triangles
    CameraName name;
    CameraName root;        ///< that it is derived from by Reflect and Shift; its own name if it is not
    glm::dmat4 shift{1.0};  ///< view = shift * view of the root * reflections

    /// True if the shape of the target decides the projection.
    [[nodiscard]] bool followsTarget() const {
        return !aspect && !std::holds_alternative<glm::dmat4>(projection);
    }
};

/// A name of the namespace that variables, cameras, textures, samplers and buffers share.
struct DeclaredName {
    enum class Kind { variable, computed, camera, texture, sampler, buffer, mesh };
    Kind kind = Kind::variable;
    Place place;
    const glib::Command* command = nullptr;
    /// The texture, sampler or buffer; empty if its declaration has an error.
    std::variant<std::monostate, TextureIndex, SamplerIndex, BufferIndex> object;
};

/// The values that Include gives to variables of the file.
using GivenVariables = std::map<std::string, expression::Value, std::less<>>;

/// A file whose statements run, with what the Include that read it gives its variables.
struct RunningFile {
    const glib::Script* script = nullptr;
    std::shared_ptr<const GivenVariables> given;  ///< null: nothing
};

/// The Pass that the current statement stands in.
struct OpenPass {
    std::size_t index = 0;  ///< in NodeList::passes
    Place place;
    double aspect = 1;
    CameraName camera;
    bool hasStencil = false;
    bool isStencilReported = false;  ///< that it has none
};

/// The Once or Step block that the current statement stands in.
struct OpenBlock {
    const char* word = "Once";
    Place place;
    bool isStep = false;
    std::vector<double> reads;  ///< the values of the variables and cameras that were read
    std::set<std::uint32_t> readSlots;
    expression::Depends depends = expression::Depends::nothing;
    expression::Depends fillDepends = expression::Depends::nothing;  ///< of the camera, if there is a Fill
};

/// What a parameter of a group is given: a value, a texture or buffer, or a camera.
struct Argument {
    std::variant<expression::Value, ObjectView, CameraName> value;
    expression::Depends depends = expression::Depends::nothing;
};

/// A group of statements with a name.
struct GroupDefinition {
    RunningFile file;            ///< that declares it
    std::size_t command = 0;     ///< index of the Group statement
    Environment::Point names{};  ///< around the Group statement
    bool isRunning = false;      ///< a group cannot draw itself
    /// The default of a parameter, as it is where the Group stands.
    struct Default {
        std::optional<Argument> argument{};  ///< nothing: it has an error, or is of later
        bool isOfLater = false;  ///< it reads a name that is declared below: evaluated at the Draw
    };
    std::vector<Default> defaults{};
};

/// How the numbers of a tag reach the eye space of the camera that a draw has.
enum class EyeSpace : std::uint8_t {
    asGiven,
    place,       ///< four numbers of a place in the world (w = 0: of a direction)
    direction,   ///< three numbers of a direction in the world
    halfVector,  ///< four numbers of a place; the result lies between the direction to it and that to the eye
};

/// A tag of Set, Material or Light with the script that it stands in.
struct ScopedTag {
    const glib::KeyedValues* tag = nullptr;
    std::string key;  ///< the tag with the subscripts that its expressions had where the Set stands
    const glib::Script* script = nullptr;
    Environment::Point names{};          ///< where the Set stands
    std::optional<ObjectView> object{};  ///< what its value names there
    std::vector<double> numbers{};       ///< of Material and Light: the value, in place of that of `tag`
    EyeSpace space = EyeSpace::asGiven;  ///< of `numbers`
};

/// A Program statement with tags that are evaluated at its draws.
struct ProgramTags {
    const glib::Command* command = nullptr;
    const glib::Script* script = nullptr;
    Environment::Point names{};  ///< where the statement stands
};

/// A Pass or Fill after a statement whose raster state it does not take over.
struct LostRaster {
    Place place;       ///< of the statement
    Place pass;        ///< of the Pass or Fill
    std::string word;  ///< of the Pass or Fill
};

/// What has run around the Expect statements of a frame.
struct ChecksOfRun {
    bool areThere = false;  ///< a script that runs has Expect statements
    /// Where the current statement stands among rounds and calls: the numbers of the rounds, and the places
    /// of the Draw and Include statements.
    std::vector<std::size_t> path;
    std::set<const glib::Command*> run;     ///< Expect statements that have been read
    std::set<const glib::Command*> bodies;  ///< statements that open a body, or divide one, which has run
};

/// What stands around the current statement.
struct Around {
    std::size_t calls = 0;                                          ///< nested groups and included files
    std::size_t blocks = 0;                                         ///< blocks
    expression::Depends conditions = expression::Depends::nothing;  ///< of When
    std::optional<OpenPass> pass{};
    OpenBlock* block = nullptr;
    std::shared_ptr<const GivenVariables> given{};        ///< RunningFile::given of the current script
    std::vector<Environment::Slot>* readSlots = nullptr;  ///< collects the variables that expressions read
};

/// Statements that did not run, although other values of variables or another time would run them.
struct UntakenRange {
    const glib::Script* script = nullptr;
    std::size_t first = 0, last = 0;  ///< commands [first, last)
};

/// What modern statements declare during one frame, and what is known of their use.
struct ModernState {
    std::map<CameraName, SceneCamera> cameras;
    std::map<std::string, ProgramIndex, std::less<>> programs;
    std::map<std::string, GroupDefinition, std::less<>> groups;
    std::map<ProgramIndex, ProgramTags> programTags;
    std::set<const glib::Script*> including;
    std::set<const glib::Script*> included;  ///< that have run
    std::map<std::string, DeclaredName, std::less<>> names;
    /// What faulty statements would have declared. Whoever misses one of these reports nothing.
    std::set<std::string, std::less<>> lostNames;
    std::vector<std::pair<std::string, glib::Position>> variables;  ///< of all Let statements, in order
    std::set<std::string, std::less<>> variableNames;               ///< of `variables`
    std::map<std::string, glib::UniformForm, std::less<>> forms;    ///< of Scene::variables, by name
    std::map<const glib::Command*, LostRaster> rasterLost;
    std::set<const glib::Command*> rasterUsed;  ///< statements that decide how something is drawn
    bool drawsClassicView = false;              ///< something is drawn that no Camera `eye` before it sees
    bool usesEye = false;                       ///< something is seen by the Camera `eye`, or reads it
    std::set<const glib::Command*> hidingLets;  ///< of glib-W40
    ChecksOfRun checks;
    std::vector<UntakenRange> untaken{};  ///< each once per time that it does not run
};

}  // namespace glibra::scene
