#pragma once
// Private to this room: the state machine (language, 2.1) and the handlers of the commands.

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <tuple>
#include <utility>
#include <vector>

#include "geometry/list_mesh.h"
#include "glib/command_table.h"
#include "glib/message_log.h"
#include "glib/script.h"
#include "scene/file_lookup.h"
#include "scene/interpret.h"
#include "scene/modern/modern.h"
#include "scene/scene.h"

namespace glibra::scene {

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
    std::array<const glib::Command*, 3> rasterStatements{};
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
    std::map<std::tuple<glib::CommandId, std::vector<double>, std::string>, ShapeIndex> shapes;
    std::map<std::vector<std::pair<std::string, std::vector<double>>>, UniformSetIndex> uniformSets;
    std::map<std::vector<std::pair<std::string, std::vector<double>>>, AttributeSetIndex> attributeSets;
    std::multimap<std::uint64_t, ShapeIndex> listShapes;  ///< by hash of the mesh
    SlotTableIndex slotTable{};  ///< the table that equals State::slots, if there is one
    /// By size, and the units or the numbers of the textures and their parts.
    std::map<std::tuple<std::vector<int>, int, int>, int> depthBuffers;
    std::map<std::pair<int, int>, int> drawsOfLines;  ///< by file and line
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

/// One run over a script.
struct Interpreter {
    const glib::Script* script;  ///< that is running; an Include replaces it
    SharedState* shared;
    const FrameInputs& inputs;
    glib::MessageLog log;
    SearchFolders folders;
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
    bool isOrphan = false;  ///< the previous statement needed an open list, which has been reported
    std::optional<std::pair<int, int>> windowSize{};
    std::set<std::tuple<std::string, std::string, int, int>> reported{};  ///< errors by id and place
    std::size_t problems = 0;  ///< errors of this frame, also those that an earlier frame has reported

    [[nodiscard]] Place place(const glib::Command& command) const { return script->place(command.position); }
    [[nodiscard]] Place place(const glib::Value& value) const { return script->place(value.position); }
    /// Messages are limited in number, except notes, which the scene asks for.
    void report(Diagnostic diagnostic) {
        if (diagnostic.severity == Severity::error) ++problems;
        // A statement of a repetition or group has each mistake once.
        if (scene.isModern && diagnostic.severity == Severity::error &&
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
    void reportAt(const glib::Command& command, std::string id, std::string text) {
        report(diagnose(std::move(id), std::move(text), place(command)));
    }
};

/// Reports that something at that position of a statement is wrong: "Buffer: the size 0 is not ...".
inline std::nullopt_t refuse(Interpreter& in, const char* id, const glib::Command& command,
                             glib::Position position, const std::string& text) {
    in.report(diagnose(id, command.word + ": " + text, in.script->place(position)));
    return std::nullopt;
}

/// Executes a statement. Its numbers satisfy the command's row in glib's table.
using Handler = void (*)(Interpreter&, const glib::Command&);
/// The handler of a command that only ends a block or has no effect.
inline void doNothing(Interpreter&, const glib::Command&) {}

/// What happens to a command inside an open glBegin list.
enum class InList {
    isPart,     ///< it belongs to the list
    goesFirst,  ///< it is executed before the list is drawn: glib-W32
    isWrong,    ///< glib-E07
};

/// A command and the function that executes it. Each file lists the actions that it implements at its end.
struct CommandAction {
    glib::CommandId id{};
    Handler handler = nullptr;
    InList inList = InList::goesFirst;
    bool draws = false;     ///< it reports itself when the scene is verbose
    bool isModern = false;  ///< a statement of the language's section 12
};
std::span<const CommandAction> viewActions();       // interpret_view.cpp
std::span<const CommandAction> drawActions();       // interpret_geometry.cpp
std::span<const CommandAction> listActions();       // lists.cpp
std::span<const CommandAction> passActions();       // interpret_passes.cpp
std::span<const CommandAction> textureActions();    // interpret_textures.cpp
std::span<const CommandAction> programActions();    // interpret_programs.cpp
std::span<const CommandAction> structureActions();  // modern/structure.cpp
std::span<const CommandAction> variableActions();   // modern/variables.cpp
std::span<const CommandAction> tagActions();        // modern/tags.cpp
std::span<const CommandAction> lightActions();      // modern/lights.cpp
std::span<const CommandAction> cameraActions();     // modern/cameras.cpp
std::span<const CommandAction> objectActions();     // modern/textures.cpp
std::span<const CommandAction> targetActions();     // modern/passes.cpp
std::span<const CommandAction> stateActions();      // modern/state.cpp
std::span<const CommandAction> vertexActions();     // modern/draws.cpp
std::span<const CommandAction> bufferActions();     // modern/buffers.cpp
std::span<const CommandAction> blockActions();      // modern/blocks.cpp
std::span<const CommandAction> keyActions();        // modern/keys.cpp
std::span<const CommandAction> meshActions();       // modern/meshes.cpp
std::span<const CommandAction> checkActions();      // modern/checks.cpp

/// The action of a command; null if there is none.
const CommandAction* actionOf(glib::CommandId command);

/// Runs one statement. A command that opens a block runs the block.
void execute(Interpreter&, const glib::Command& command);

/// Width / height of the window.
double windowAspect(const Interpreter&);
/// Sets the names of time that a frame has: time, dt, frame and tick.
void setTime(Interpreter&);

/// Returns the index of the file that a statement names. The file is looked up the first time.
FileIndex fileOf(Interpreter&, const std::string& name, const Place& place);
/// The file of that key; `make` is called once for all frames of the script.
FileIndex fileNamed(Interpreter&, const std::string& key, const std::function<FileReference()>& make);

// interpret_view.cpp

/// Reports glib-W31 for a PushMatrix without PopMatrix.
void checkStack(Interpreter&);

// lists.cpp

/// Reports glib-E07 for a list without glEnd.
void checkList(Interpreter&);

// interpret_passes.cpp

/// Returns the pass into the current target. If there is none, begins it with its implicit clears. Inside
/// Pass it is that pass. Inside Once and Step there is no current target: null, with glib-E25 reported.
Pass* currentPass(Interpreter&, const glib::Command&);
/// The number of the depth buffer that belongs to a list of targets of that size. 0 is the window's.
int depthBufferOf(Interpreter&, const std::vector<int>& key, int width, int height);
/// True if nothing has cleared the part since the beginning of the frame or block. From now on it counts as
/// cleared. The `layers` are those of the level.
bool isFirstUse(Interpreter&, TextureIndex texture, const TargetPart& part, int layers);
/// Makes sure that the window is shown, even if nothing is drawn into it.
void finishPasses(Interpreter&);

// interpret_textures.cpp

/// Adds to the bytes of all textures and buffers. False, with glib-E15, if they are too many.
bool chargeTexels(Interpreter&, const glib::Command&, std::uint64_t bytes);
/// A texture from a file; the built-in noise replaces a missing noise file. `dimensions` 0: as the file has.
Texture pictureTexture(Interpreter&, const std::string& name, const Place& place, std::size_t dimensions);
void addNoiseTextures(Interpreter&);
/// Sets the sizes of the noise textures, which are known only at the end of the file.
void finishNoise(Interpreter&);

// interpret_geometry.cpp

/// The action of every primitive.
void doPrimitive(Interpreter&, const glib::Command&);
/// The thing that a geometry command draws with the current state. `size` describes it for Verbose; `color`
/// replaces the current colour.
struct Drawing {
    ShapeIndex shape{};
    std::string word;
    std::string size;
    std::optional<glm::dvec4> color;
    CountFrom verticesFrom{};
    BufferView indices{};
    bool drawsAllIndices = false;
};
void draw(Interpreter&, const glib::Command&, const Drawing&);
/// The shape's index; equal shapes share one.
ShapeIndex shareShape(Interpreter&, Shape shape);
/// The index of the set; equal sets share one.
AttributeSetIndex shareAttributes(Interpreter&, AttributeSet set);
/// The number of a draw or dispatch among those of the same line.
DrawId nextDrawId(Interpreter&, const Place& place);
/// The index of the current slot table.
SlotTableIndex currentSlots(Interpreter&);
/// Adds the vertices to those of the scene. Returns false and reports glib-E15 if a limit is exceeded.
bool countVertices(Interpreter&, const glib::Command&, std::uint64_t vertices);
/// Returns the shape with that mesh; equal meshes share one shape.
ShapeIndex shapeOfMesh(Interpreter&, glib::CommandId command, geometry::Mesh mesh);

// interpret_programs.cpp

/// The shader that stands in the script after this statement.
FileIndex inlineShader(Interpreter&, const glib::Command&);

/// Returns the statement as it appears in messages: "Sphere 1 60 60".
std::string textOf(const glib::Command& command);

}  // namespace glibra::scene
