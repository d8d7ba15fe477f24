#pragma once
// Inside the room: the state machine of the language, section 2.1, and the handlers of the commands.

#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <tuple>
#include <utility>
#include <vector>

#include "geometry/list_mesh.h"
#include "glib/script.h"
#include "scene/file_lookup.h"
#include "scene/interpret.h"
#include "scene/scene.h"

namespace glibra::scene {

inline constexpr glm::dvec4 kInitialBackground{18 / 255., 27 / 255., 33 / 255., 1};
inline constexpr int kNoise2Unit = 2;
inline constexpr int kNoise3Unit = 3;

struct SavedMatrix {
    glm::dmat4 modelView;
    Place place;
};

/// What RenderToTexture chose; no units: the window.
struct TargetList {
    std::vector<int> units;
    std::vector<TextureIndex> textures;
    int width = 0, height = 0;
    Place place;
};

/// What a statement may change for the statements after it.
struct State {
    Projection projection = Perspective{};
    glm::dmat4 modelView{1.0};
    std::vector<SavedMatrix> stack;
    glm::dvec4 color{1.0};
    glm::dvec4 background = kInitialBackground;
    RasterState raster;
    int patchVertices = 3;
    bool flatColors = false;
    Sampling sampling;
    SlotTable slots;
    std::map<glsl::Stage, FileIndex> stageFiles;
    std::string geometryInput, geometryOutput;
    int geometryVerticesOut = 0;
    ProgramIndex program{};
    TargetList target;
    double timerPeriod = 10;
};

/// A glBegin list that waits for its glEnd.
struct OpenList {
    geometry::ListTopology topology{};
    std::string word;
    Place place;
    std::vector<geometry::ListVertex> vertices;
    geometry::ListVertex current;  ///< attributes of the next vertex
    bool hasNormals = false;
    bool isFull = false;  ///< the limit has been reported
};

/// One run over a script.
struct Interpreter {
    const glib::Script& script;
    Scene scene;
    State state;
    SearchFolders folders;
    FolderListings listings;
    std::optional<OpenList> list;
    bool isOrphan = false;  ///< the statement before belonged to a list that is not open, and that is told

    // What has been made so far, to share it.
    std::map<std::string, FileIndex> files;  ///< by name as written
    std::map<std::tuple<glib::CommandId, std::vector<double>, std::string>, ShapeIndex> shapes;
    std::multimap<std::uint64_t, ShapeIndex> listShapes;  ///< by hash of the mesh
    SlotTableIndex slotTable{};  ///< the table that equals state.slots, if there is one
    std::set<TextureIndex> clearedTextures;
    bool isWindowCleared = false;
    std::map<std::tuple<std::vector<int>, int, int>, int> depthBuffers;  ///< by units and size
    std::set<int> clearedDepths;
    std::uint64_t vertices = 0;      ///< of all geometry commands
    std::uint64_t textureBytes = 0;  ///< of all empty textures
    int noiseSizes[2] = {64, 64};    ///< 2D, 3D
    bool areNoiseSizesGiven[2] = {false, false};
    std::optional<std::pair<int, int>> windowSize;

    [[nodiscard]] Place place(const glib::Command& command) const { return script.place(command.position); }
    void report(Diagnostic diagnostic) { scene.diagnostics.push_back(std::move(diagnostic)); }
    void reportError(const glib::Command& command, std::string id, std::string text) {
        report(error(std::move(id), std::move(text), place(command)));
    }
    void reportWarning(const glib::Command& command, std::string id, std::string text) {
        report(warning(std::move(id), std::move(text), place(command)));
    }
};

/// Does what a statement says. Its numbers are as the command's row in glib's table promises.
using Handler = void (*)(Interpreter&, const glib::Command&);

/// Index of the file that a statement names, looked up where it is named first.
FileIndex fileOf(Interpreter&, const std::string& name, const Place& place);

// window, projection, colours, transforms (interpret_view.cpp)
void doWindowSize(Interpreter&, const glib::Command&);
void doPerspective(Interpreter&, const glib::Command&);
void doOrtho(Interpreter&, const glib::Command&);
void doLookAt(Interpreter&, const glib::Command&);
void doColor(Interpreter&, const glib::Command&);
void doBackground(Interpreter&, const glib::Command&);
void doTranslate(Interpreter&, const glib::Command&);
void doRotate(Interpreter&, const glib::Command&);
void doScale(Interpreter&, const glib::Command&);
void doPushMatrix(Interpreter&, const glib::Command&);
void doPopMatrix(Interpreter&, const glib::Command&);
/// glib-W31
void checkStack(Interpreter&);

// draws and what decides how they are rasterised (interpret_geometry.cpp)
void doPrimitive(Interpreter&, const glib::Command&);
void doModel(Interpreter&, const glib::Command&);
void doPointGroups(Interpreter&, const glib::Command&);
void doLineWidth(Interpreter&, const glib::Command&);
void doPointSize(Interpreter&, const glib::Command&);
void doPointSizeMode(Interpreter&, const glib::Command&);
void doNumPatchVertices(Interpreter&, const glib::Command&);
void doFlat(Interpreter&, const glib::Command&);
void doSmooth(Interpreter&, const glib::Command&);

// glBegin lists (lists.cpp)
void doGlBegin(Interpreter&, const glib::Command&);
void doGlVertex(Interpreter&, const glib::Command&);
void doGlNormal(Interpreter&, const glib::Command&);
void doGlColor(Interpreter&, const glib::Command&);
void doGlTexCoord(Interpreter&, const glib::Command&);
void doGlEnd(Interpreter&, const glib::Command&);
/// glib-E07 for a list without glEnd
void checkList(Interpreter&);

// targets (interpret_passes.cpp)
void doRenderToTexture(Interpreter&, const glib::Command&);
void doClear(Interpreter&, const glib::Command&);
/// The pass into the current target, begun with its implicit clears if need be.
Pass& currentPass(Interpreter&);
/// The window is shown even if nothing is drawn into it.
void finishPasses(Interpreter&);

// textures (interpret_textures.cpp)
void addNoiseTextures(Interpreter&);
void doTexture(Interpreter&, const glib::Command&);
void doCubeMap(Interpreter&, const glib::Command&);
void doClamp(Interpreter&, const glib::Command&);
void doNoise2D(Interpreter&, const glib::Command&);
void doNoise3D(Interpreter&, const glib::Command&);
/// The sizes are known at the end of the file only.
void finishNoise(Interpreter&);

// shaders, programs, and the rest (interpret_programs.cpp)
void doStage(Interpreter&, const glib::Command&);
void doProgram(Interpreter&, const glib::Command&);
void doGeometryInput(Interpreter&, const glib::Command&);
void doGeometryOutput(Interpreter&, const glib::Command&);
void doGeometryVerticesOut(Interpreter&, const glib::Command&);
void doTimer(Interpreter&, const glib::Command&);
void doMessageBox(Interpreter&, const glib::Command&);
void doNothing(Interpreter&, const glib::Command&);

/// What a geometry command draws with the state of this place. `vertices` counts against the limits, `size`
/// is what Verbose says of it, `color` replaces the current colour.
struct Drawing {
    ShapeIndex shape{};
    std::string word;
    std::string size;
    std::optional<glm::dvec4> color;
};
void draw(Interpreter&, const glib::Command&, const Drawing&);
/// False, with glib-E15, if that many more vertices are beyond a limit.
bool countVertices(Interpreter&, const glib::Command&, std::uint64_t vertices);
/// The shape with that mesh, shared with an equal one.
ShapeIndex shapeOfMesh(Interpreter&, glib::CommandId command, geometry::Mesh mesh);

/// The statement as notes and messages repeat it: "Sphere 1 60 60".
std::string textOf(const glib::Command& command);

}  // namespace glibra::scene
