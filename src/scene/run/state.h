#pragma once
// Private to this room: the state machine (language, 2.1), on which the functions of the statements act.

#include <array>
#include <compare>
#include <cstddef>
#include <cstdint>
#include <glm/mat4x4.hpp>
#include <glm/vec4.hpp>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <tuple>
#include <utility>
#include <variant>
#include <vector>

#include "expression/expression.h"
#include "expression/type.h"
#include "geometry/list_mesh.h"
#include "glib/messages.h"
#include "glib/script.h"
#include "glib/statement_table.h"
#include "scene/file_lookup.h"
#include "scene/run/environment.h"
#include "scene/scene.h"
#include "scene/view.h"

namespace glibra::scene {

// ---- What modern statements declare during one frame, and what stands around them.

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
    enum class Kind { variable, computed, function, camera, texture, sampler, buffer, mesh };
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
    bool isDrawn = false;        ///< it has been
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

// ---- What all frames of a script share.

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
    std::set<std::string> hidden;  ///< Scene::hiddenFiles
    List<FileReference> all;
    std::map<std::string, FileIndex> indices;
};

/// What has been computed and is computed again only if what it reads has changed.
struct Computed {
    ExpressionCache expressions;
    std::map<WrittenAt, MadeOfNames<std::optional<expression::Type>>> arrayTypes;  ///< of `Let name[n] (...)`
    /// Functions of expressions; null if the body is wrong.
    std::map<WrittenAt, MadeOfNames<std::shared_ptr<const expression::Function>>> functions;
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
    Diagnostics found;  ///< what the runs of one frame have reported by reportOnce()
    expression::Depends depends = expression::Depends::nothing;  ///< of all that the last frame evaluated
    double frameRate = 60;                                       ///< 1 / dt
};

using glib::Command;
using glib::CommandId;
using glib::KeyedValues;
using glib::Value;

inline constexpr glm::dvec4 kInitialBackground{glib::kDefaultBackground[0], glib::kDefaultBackground[1],
                                               glib::kDefaultBackground[2], 1};

struct SavedMatrix {
    glm::dmat4 modelView, model;
    Place place;
};

/// The targets that RenderToTexture selected. Without units it is the window.
struct TargetList {
    std::vector<int> units;
    std::vector<TextureIndex> textures;
    int width = 0, height = 0;
    Place place;
};

/// The parts of the raster state that statements decide: all of it, the viewport, the scissor.
enum class RasterPart { state, viewport, scissor };

/// State of modern statements that ends with its scope, as RasterState does.
struct LocalState {
    bool isBlendStated = false;  ///< otherwise the target decides how draws outside of Pass are blended
    int instances = 1;
    CountFrom instancesFrom{};
    AttributeSetIndex attributes{};
    std::optional<std::array<double, 6>> tessellationLevels{};
    /// The statements that decide the raster state, by RasterPart; null: none does.
    std::array<const Command*, 3> rasterStatements{};
};

/// What has been cleared since the beginning of a node list.
struct Cleared {
    bool isWindow = false;
    std::set<std::tuple<TextureIndex, int, int>> parts;  ///< level and layer; -1: all layers
    std::set<int> depthBuffers;
};

/// The state that a scope gives back at its end (language, 12.2).
struct ScopedState {
    glm::dmat4 modelView{1.0};
    glm::dmat4 model{1.0};           ///< the product of the transforms below the view
    std::vector<SavedMatrix> stack;  ///< of the scope alone
    ProgramIndex program{};
    std::vector<ScopedTag> set;  ///< of Set and Material; each tag once
    RasterState raster;          ///< without what PointsAndLines has
    LocalState local;
};

/// The part of RasterState that classic commands set, which no scope ends.
struct PointsAndLines {
    double lineWidth = 1, pointSize = 1;
    bool pointSizeFromShader = false;
};

/// The state that a statement may change for the statements after it.
struct State : ScopedState {
    Projection projection = Perspective{};
    glm::dvec4 color{1.0};
    glm::dvec4 background = kInitialBackground;
    PointsAndLines pointsAndLines;
    int patchVertices = 3;
    bool flatColors = false;
    Sampling sampling;
    SlotTable slots;
    std::map<glsl::Stage, FileIndex> stageFiles;
    std::set<glsl::Stage> stagesOfProgram;  ///< those of stageFiles that the last Program has
    FileIndex computeFile{};                ///< of the next Program alone
    std::string geometryInput, geometryOutput;
    int geometryVerticesOut = 0;
    bool hasGeometryWordsOfProgram = false;  ///< no such statement has followed the last Program
    TargetList target;
    double timerPeriod = 10;
};

/// A glBegin list that is still open.
struct OpenList {
    geometry::ListTopology topology{};
    std::string word;
    Place place;
    std::vector<geometry::ListVertex> vertices;
    geometry::ListVertex current;  ///< attributes of the next vertex
    bool hasNormals = false;
    bool isFull = false;  ///< the limit has been reported
    /// The values of Attribute at each vertex so far, by name, and how many components are used.
    struct Extra {
        int components = 1;
        std::array<double, 4> before{0, 0, 0, 1};  ///< of the vertices before the first Attribute
        std::array<double, 4> current{0, 0, 0, 1};
        std::vector<std::array<double, 4>> values;
    };
    std::map<std::string, Extra> extras;
};

/// Where the next node goes: into the frame, or into a Once or Step block.
struct Output {
    NodeList* nodes = nullptr;
    Cleared cleared{};
    std::optional<std::size_t> implicitPass{};  ///< the last pass, if it was begun without a Pass statement
};

/// Everything made so far, so that equal things are shared.
struct MadeParts {
    std::map<std::tuple<CommandId, std::vector<double>, std::string>, ShapeIndex> shapes;
    std::unordered_multimap<std::size_t, UniformSetIndex> uniformSets;  ///< by hash
    std::map<std::vector<std::pair<std::string, std::vector<double>>>, AttributeSetIndex> attributeSets;
    std::multimap<std::uint64_t, ShapeIndex> listShapes;  ///< by hash of the mesh
    SlotTableIndex slotTable{};  ///< the table that equals State::slots, if there is one
    /// By size, and the units or the numbers of the textures and their parts.
    std::map<std::tuple<std::vector<int>, int, int>, int> depthBuffers;
    /// The first pass into each depth, by its texture, or by the number of its buffer: is it reversed?
    std::map<std::pair<TextureIndex, int>, std::pair<bool, Place>> depthOrders;
    std::map<std::pair<int, int>, int> drawsOfLines;  ///< by file and line
    base::Shared<RasterState> raster;                 ///< of the last draw
    base::Shared<Projection> projection;
};

/// What a frame has used so far of what is limited.
struct UsedLimits {
    std::uint64_t vertices = 0;      ///< of all geometry commands
    std::uint64_t textureBytes = 0;  ///< of all empty textures and buffers
    std::size_t statements = 0;
    std::size_t rounds = 0;    ///< of all Repeat statements
    std::size_t elements = 0;  ///< that expressions of i have given
    bool isFull = false;       ///< the limit of statements has been reported
};

/// The sizes of the noise textures, 2D and 3D.
struct NoiseSizes {
    int sizes[2] = {64, 64};
    bool areGiven[2] = {false, false};
};

struct Interpreter;

/// Executes a statement. Its numbers satisfy the command's row in glib's table.
using Handler = void (*)(Interpreter&, const Command&);
/// The handler of a command that only ends a block or has no effect.
inline void doNothing(Interpreter&, const Command&) {}

/// What happens to a command inside an open glBegin list.
enum class InList {
    isPart,     ///< it belongs to the list
    goesFirst,  ///< it is executed before the list is drawn: glib-W32
    isWrong,    ///< glib-E07
};

/// A command and the function that executes it. Each file lists the actions that it implements at its end.
struct CommandAction {
    CommandId id{};
    Handler handler = nullptr;
    InList inList = InList::goesFirst;
    bool draws = false;     ///< it reports itself when the scene is verbose
    bool isModern = false;  ///< a statement of the language's section 12
};

/// One run over a script.
struct Interpreter {
    const glib::Script* script;  ///< that is running; an Include replaces it
    SharedState* shared;
    std::span<const CommandAction> actions;  ///< of all commands, by CommandId
    const FrameInputs& inputs;
    glib::MessageLog log;
    SearchFolders folders;
    bool runsAll = false;  ///< both branches of When, a Repeat without rounds, and groups that nothing draws
    Scene scene{};
    State state{};
    Around around{};
    ModernState modern{};
    Output out{};
    MadeParts made{};
    UsedLimits counts{};
    NoiseSizes noise{};
    FolderListings listings{};
    std::optional<OpenList> list{};
    bool isModern = false;  ///< the script with which the run begins has a modern statement or an expression
    bool isOrphan = false;  ///< the previous statement needed an open list, which has been reported
    std::optional<std::pair<int, int>> windowSize{};
    std::set<std::tuple<std::string, std::string, int, int>> reported{};  ///< errors by id and place
    std::pair<const glib::Script*, glib::Position> running{};             ///< the place of the last statement
    std::size_t problems = 0;  ///< errors of this frame, also those that an earlier frame has reported

    [[nodiscard]] Environment& names() const { return shared->environment; }
    /// The place of a command, a value, a key or a tag of the current script.
    [[nodiscard]] Place place(const auto& written) const { return script->place(written.position); }
    /// Messages are limited in number, except notes, which the scene asks for.
    void report(Diagnostic diagnostic) {
        if (diagnostic.severity == Severity::error) ++problems;
        // A statement of a repetition or group has each mistake once.
        if (isModern && diagnostic.severity == Severity::error &&
            !reported
                 .insert(
                     {diagnostic.id, diagnostic.place.file, diagnostic.place.line, diagnostic.place.column})
                 .second)
            return;
        if (diagnostic.severity == Severity::note)
            log.keep(std::move(diagnostic));
        else
            log.report(std::move(diagnostic));
    }
    /// Reports what only the first run finds that meets it, also if the result of that run is not used.
    void reportOnce(const Diagnostic& diagnostic) {
        shared->found.push_back(diagnostic);
        report(diagnostic);
    }
    std::nullopt_t reportAt(const auto& written, std::string id, std::string text) {
        report(diagnose(std::move(id), std::move(text), place(written)));
        return std::nullopt;
    }
};

/// Reports that something at that position of a statement is wrong: "Buffer: the size 0 is not ...".
inline std::nullopt_t refuse(Interpreter& in, const char* id, const Command& command, glib::Position position,
                             const std::string& text) {
    in.report(diagnose(id, command.word + ": " + text, in.script->place(position)));
    return std::nullopt;
}

}  // namespace glibra::scene
