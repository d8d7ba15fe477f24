#pragma once
// Private to this room: the state machine (language, 2.1), on which the functions of the statements act.

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <tuple>
#include <unordered_map>
#include <utility>
#include <vector>

#include "geometry/list_mesh.h"
#include "glib/command_table.h"
#include "glib/message_log.h"
#include "glib/script.h"
#include "scene/file_lookup.h"
#include "scene/frame_inputs.h"
#include "scene/run/modern_state.h"
#include "scene/run/shared_state.h"
#include "scene/scene.h"

namespace glibra::scene {

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

    [[nodiscard]] Environment& names() const { return shared->environment; }
    /// The place of a command, a value, a key or a tag of the current script.
    [[nodiscard]] Place place(const auto& written) const { return script->place(written.position); }
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
