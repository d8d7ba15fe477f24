#pragma once
// Private to this room: what the interpreter of modern statements keeps, for one frame and from frame to
// frame.

#include <cstddef>
#include <filesystem>
#include <glm/mat4x4.hpp>
#include <glm/vec4.hpp>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "glib/script.h"
#include "scene/camera.h"
#include "scene/modern/environment.h"
#include "scene/modern/evaluate.h"
#include "scene/modern/undecided.h"
#include "scene/scene.h"

namespace glibra::scene {

struct Interpreter;

/// The values of `Buffer name type n (expression of i)`, which are computed again only if what the expression
/// reads has changed.
struct ComputedElements {
    bool isSteady = false;  ///< it changes with variables alone
    std::size_t count = 0;
    std::vector<Environment::Slot> slots;  ///< of these variables
    std::vector<double> reads, values;
    expression::Depends depends = expression::Depends::nothing;
};

/// The buffers of a Mesh statement.
struct MeshContent {
    struct Part {
        std::string name;  ///< "position"
        std::string type;  ///< of an element
        std::vector<double> values;
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
    std::map<const glib::Command*, LostRaster> rasterLost;
    std::set<const glib::Command*> rasterUsed;  ///< statements that decide how something is drawn
    bool drawsClassicView = false;              ///< something is drawn that no Camera `eye` before it sees
    bool usesEye = false;                       ///< something is seen by the Camera `eye`, or reads it
    std::set<const glib::Command*> hidingLets;  ///< of glib-W40
    ChecksOfRun checks;
    std::vector<UntakenRange> untaken{};  ///< each once per time that it does not run
};

// statements.cpp

/// Runs the statements [first, last) of the current script. Each block runs its own statements.
void run(Interpreter&, std::size_t first, std::size_t last);
/// Makes the names known that the statements of the current script declare, before they run.
void expectNames(Interpreter&);
/// Counts a statement that is about to run. False, with glib-E28, if there are too many.
bool countStatement(Interpreter&, const glib::Command& command);
/// The same for a round of Repeat, whether or not it has statements.
bool countRound(Interpreter&, const glib::Command& command);
/// The same for elements that an expression of `i` gives a list or array.
bool countElements(Interpreter&, const glib::Value& owner, double count);
/// The number of the file that the current statement stands in: 0 for the scene's own, then the included ones
/// in the order in which they were read first.
int fileNumber(const Interpreter&);

// constants.cpp

/// The value of a parameter or variable: an expression, or one to four numbers. Nothing with the reason
/// reported.
std::optional<expression::Value> constantOf(Interpreter&, std::span<const glib::Value> values);
/// Elements of a list or array variable.
inline constexpr int kMostVariableElements = 65'536;
/// The numbers of a list, where `[6 of (...)]` counts `i`. Nothing with the reason reported.
std::optional<std::vector<double>> listOf(Interpreter&, const glib::Value& list);
/// What expressions know of a name that counts.
expression::Symbol counterSymbol();
/// The values of `element` for i from 0 to count - 1, one after the other. `owner` is the value that they
/// stand in. Nothing with the reason reported, which is glib-E15 if they are more than `most` numbers.
std::optional<std::vector<double>> elementsOf(Interpreter&, const glib::Value& owner,
                                              std::span<const glib::Value> element, int count, double most);
/// The program of that name, if it draws or if it computes, as wanted. Nothing with glib-E27 reported.
std::optional<ProgramIndex> programNamed(Interpreter&, const glib::Value& name, bool isCompute);

// tags.cpp

/// The uniform variables and objects that tags with expressions, Set and Material give to a draw or dispatch
/// of the program that is made now. `own` are the tags of its own statement, which come before all others.
UniformSetIndex uniformsOf(Interpreter&, ProgramIndex program, std::span<const glib::KeyedValues> own = {});
// checks.cpp

/// The Expect statements that have not run, and why.
std::vector<IdleCheck> idleChecks(const Interpreter&);

// tags.cpp

/// The values of all variables, for uniform variables of the same name.
std::vector<glib::UniformSpec> namedValues(Interpreter&);
/// The same for those that the open Once or Step block sets.
std::vector<glib::UniformSpec> namedValuesOfBlock(Interpreter&);

// cameras.cpp

const SceneCamera* findCamera(const Interpreter&, const CameraName& name);
/// Reports glib-W38 for each camera whose name stands nowhere else in the scene, if no camera `eye` is
/// declared.
void reportUnusedCameras(Interpreter&);
/// Reports glib-W41 for a Camera `eye` that stands after all draws.
void reportLateEye(Interpreter&);
/// True if the value names a camera, not a part of one.
bool namesCamera(const Interpreter& in, const glib::Value& value);
/// True if the value names a choice, or the counter of a Repeat over words, whose word names a camera.
bool choosesCamera(Interpreter& in, const glib::Value& value);
/// The camera that a value names. Nothing with the reason reported.
std::optional<SceneCamera> cameraNamed(Interpreter&, const glib::Value& name);
/// Remembers that the scene, or the block that is open, depends on what the camera depends on.
void noteCameraDepends(Interpreter&, const CameraName& name);
/// The camera that sees what is drawn now: that of the pass, or `eye`, which may be the classic view.
SceneCamera currentCamera(const Interpreter&);
/// The name as a scene writes it: "slice[2]", or "eye".
std::string textOf(const Interpreter&, const CameraName& name);
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
/// Sets what the current camera decides for a draw: its matrices, and the winding if it is mirrored.
void lookAt(Interpreter&, Draw& draw);

// blocks.cpp

/// Remembers that a pass of a Once block is seen by the camera.
void noteCamera(Interpreter&, const SceneCamera& camera);
/// Remembers what the camera of a Fill depends on. Only if its program reads matrices, the block does so.
void noteFill(Interpreter&);

// buffers.cpp

/// `Clear NAME`.
void doClearObject(Interpreter&, const glib::Command&);

// names.cpp

/// Declares the name that the statement's first value states. False with glib-E27 if it has a meaning
/// already.
bool declareName(Interpreter&, const glib::Command&, const std::string& name, DeclaredName::Kind kind);
/// Sets the object of a declared name.
void setObject(Interpreter&, const std::string& name,
               const std::variant<std::monostate, TextureIndex, SamplerIndex, BufferIndex>& object);
/// True for a name that a faulty statement would have declared.
bool isLost(const Interpreter&, std::string_view name);
/// True if the value names a texture or buffer, or a part of one.
bool namesObject(const Interpreter&, const glib::Value& value);
/// True if the value names a choice, or the counter of a Repeat over words, whose word names a texture or
/// buffer. A part of the object may follow, but not `.index`.
bool choosesObject(Interpreter&, const glib::Value& value);
/// The texture or buffer that a value names, with its part. Nothing with the reason reported.
std::optional<ObjectView> objectNamed(Interpreter&, const glib::Value& value);
std::optional<TextureView> textureNamed(Interpreter&, const glib::Value& value);
std::optional<BufferView> bufferNamed(Interpreter&, const glib::Value& value);
/// What a statement says with `from BUFFER [at n]`. Nothing with the reason reported.
std::optional<CountFrom> countFrom(Interpreter&, const glib::Command& command);
/// A texture, buffer, camera or variable of the scene that the name means here; null if a scope gives the
/// name another meaning, or nothing has the name.
const DeclaredName* declaredName(const Interpreter&, std::string_view name);
/// The word that a name stands for, if it is the counter of a Repeat over words or a choice; otherwise the
/// name itself.
std::string wordBehind(Interpreter&, const std::string& name);
/// True for the word `window`.
bool isWindow(const glib::Value& value);

}  // namespace glibra::scene
