#pragma once
// An interpreted Script: everything that a frame needs, as values. There is no GL, no pixel and no mesh data
// here. File names are resolved, but a file is read only when something visible needs it.

#include <glibra/diagnostic.h>
#include <glibra/draw_id.h>

#include <array>
#include <cstdint>
#include <filesystem>
#include <glm/mat4x4.hpp>
#include <glm/vec4.hpp>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <variant>
#include <vector>

#include "base/program_resources.h"
#include "base/raster_state.h"
#include "base/texel_format.h"
#include "geometry/mesh.h"
#include "glib/script.h"
#include "glsl/types/stage.h"
#include "scene/index.h"

namespace glibra::scene {

struct FileReference;
struct Shape;
struct Texture;
struct Slot;
struct Program;

/// Values of uniform variables that draws set besides those of their program's Program statement. Draws share
/// these.
using UniformSet = std::vector<glib::UniformSpec>;

/// The content of all slots at one place of the scene, sorted by unit and target. Draws share these.
using SlotTable = std::vector<Slot>;

// Indices into the lists of Scene.
using FileIndex = Index<FileReference>;
using ShapeIndex = Index<Shape>;
using TextureIndex = Index<Texture>;
using SlotTableIndex = Index<SlotTable>;
using ProgramIndex = Index<Program>;
using UniformSetIndex = Index<UniformSet>;

/// A file that a scene names, looked up but not read. `path` is empty if no file was found. `remarks`
/// (file-E01, file-W01 ...) are reported when the file is needed. Statements that name the same file share
/// one reference, with the place of the first statement.
struct FileReference {
    std::string name;  ///< as written
    std::filesystem::path path;
    Diagnostics remarks;
    Place place;
    /// The text of a shader that stands in the script, with as many empty lines before it as put it on its
    /// lines of the script, which is `path`.
    std::optional<std::string> text{};
};

/// What a geometry command draws: the command with its numbers, or a list made by glBegin, Triangles or
/// LinesAdjacency. Equal shapes share one entry of Scene::shapes, and so one mesh.
struct Shape {
    glib::CommandId command{};
    /// The arguments with defaults filled in. One count that scenes cannot set may follow: cells per side of
    /// a Teapot's patches, subdivisions of a Soccerball's triangles, or sides of an Xarrow.
    std::vector<double> numbers;
    FileIndex file{};
    std::shared_ptr<const geometry::Mesh>
        list;  ///< the mesh itself, if the text of the scene contains the vertices
};

using base::TexelFormat;
using base::TextureTarget;

/// Where a texture's texels come from.
struct PictureSource {
    std::vector<FileIndex> files;  ///< one, or six for a cube map
};
struct EmptySource {
    int width = 1, height = 1, depth = 1;
    TexelFormat format = TexelFormat::rgba8;
};
/// Precision of noise texels: 8 bits, as in glman, or 16 bits.
enum class NoiseTexels { bytes, shorts };

/// Noise of a given size. If there is a file with raw bytes of exactly that size, the texels come from it;
/// otherwise the noise is built in. The remarks (file-N01, file-W09, file-W10) are reported when the texture
/// is needed.
struct NoiseSource {
    int dimensions = 3;
    int size = 64;
    bool isSizeGiven = false;                 ///< the scene sets it
    NoiseTexels texels = NoiseTexels::bytes;  ///< of built-in noise
    FileIndex file{};
    Diagnostics remarks;
};

struct Texture {
    TextureTarget target = TextureTarget::texture2D;
    std::variant<PictureSource, EmptySource, NoiseSource> source;
    Place place;
    int unit = 0;
};

/// How a draw samples its textures.
struct Sampling {
    bool clamp = false;  ///< clamp to edge, otherwise repeat (noise always repeats, cube maps always clamp)
};

/// Units that hold the noise textures until a scene fills them; Noise2 and Noise3 without a tag read them.
inline constexpr int kNoise2Unit = 2;
inline constexpr int kNoise3Unit = 3;

/// One filled slot of the (unit, target) table. The first two elements of Scene::textures are the noise
/// textures: 2D on unit 2, 3D on unit 3.
struct Slot {
    int unit = 0;
    TextureTarget target = TextureTarget::texture2D;
    TextureIndex texture{};
};

/// The shader file of one stage that was current at a Program statement.
struct StageFile {
    glsl::Stage stage = glsl::Stage::vertex;
    FileIndex file{};
};

struct Program {
    std::string name;
    Place place;
    std::vector<StageFile> stages;
    std::string geometryInput;  ///< a lower-case GLSL word, or empty
    std::string geometryOutput;
    int geometryVerticesOut = 0;
    std::vector<glib::UniformSpec> uniforms;
    [[nodiscard]] bool hasStage(glsl::Stage stage) const {
        for (const StageFile& each : stages)
            if (each.stage == stage) return true;
        return false;
    }
};

struct Perspective {
    double fieldOfView = 50;  ///< vertical, full angle, degrees
    double near = .1, far = 1000;
};
struct Orthographic {
    double left = -3, right = 3, bottom = -3, top = 3, near = -1000, far = 1000;
};
/// A matrix is taken as it is, whatever the shape of the target.
using Projection = std::variant<Perspective, Orthographic, glm::dmat4>;

/// A classic scene sets little of it, but each draw carries all of it.
using base::RasterState;

/// One geometry command with its complete state.
struct Draw {
    DrawId id;
    Place place;
    std::string word;  ///< the command as written, or the topology of a glBegin list; for messages
    ShapeIndex shape{};
    ProgramIndex program{};
    glm::dmat4 modelView{1.0};
    Projection projection;
    glm::dvec4 color{1.0};
    RasterState raster;
    int patchVertices = 3;
    bool flatColors = false;
    Sampling sampling;
    SlotTableIndex slots{};
    UniformSetIndex uniforms{};  ///< none: only those of the program
    double timerPeriod = 10;
    std::size_t givenNumbers = 0;  ///< how many of the shape's numbers the scene gives; the rest are defaults
};

/// Clears the colour of all targets and the depth of the pass. A Clear that only repeats the implicit clear
/// of the pass is left out.
struct Clear {
    Place place;
    glm::dvec4 color{0.0};
};

/// Drawing into one target list. The implicit clear of the language (2.3) is in `clearColors` and
/// `clearDepth`.
struct Pass {
    std::vector<TextureIndex> targets;  ///< empty: the window
    int depthBuffer = 0;                ///< passes with the same number share depth; 0 is the window's
    std::vector<std::optional<glm::dvec4>>
        clearColors;  ///< one per target (the window has one); nothing: the content is kept
    bool clearDepth = false;
    Place place;  ///< place of RenderToTexture, for messages
    std::vector<std::variant<Draw, Clear>> steps;
};

/// A variable of a Let statement that the window and --set can change.
struct Variable {
    std::string name;
    glib::UniformForm form = glib::UniformForm::number;
    std::vector<double> written;     ///< least, current and largest of a range; otherwise the components
    std::vector<double> current;     ///< the components that the frame has
    std::vector<std::string> words;  ///< of a choice, which is a range that counts them from 0
    Place place;                     ///< of the value
};

/// What a scene declares. Indices into these lists stay valid until the scene is read again.
struct Declarations {
    List<FileReference> files;
    List<Shape> shapes;
    List<Texture> textures;
    List<SlotTable> slotTables;
    List<UniformSet> uniformSets;
    List<Program> programs;
};

/// A step of a node list.
struct StepIndex {
    std::size_t pass = 0, step = 0;  ///< indices into NodeList::passes and Pass::steps
    friend auto operator<=>(const StepIndex&, const StepIndex&) = default;
};

/// What is executed, in order.
struct NodeList {
    std::vector<Pass> passes;

    /// Throws std::out_of_range or std::bad_variant_access if that step is no draw.
    [[nodiscard]] const Draw& draw(StepIndex at) const {
        return std::get<Draw>(passes.at(at.pass).steps.at(at.step));
    }
    [[nodiscard]] Draw& draw(StepIndex at) { return std::get<Draw>(passes.at(at.pass).steps.at(at.step)); }
    /// The same for a Clear.
    [[nodiscard]] const Clear& clear(StepIndex at) const {
        return std::get<Clear>(passes.at(at.pass).steps.at(at.step));
    }
};

struct Scene : Declarations {
    std::string path;
    int width = 600, height = 600;
    NodeList frame;  ///< the last content of the window is the picture
    bool usesLookAt = false;
    glm::dmat4 view{1.0};  ///< viewing matrix of the last LookAt
    std::vector<Variable> variables;
    std::set<std::string, std::less<>> usedVariables;  ///< names of FrameInputs::variables that exist
    bool isModern = false;                             ///< it has a modern statement or an expression
    bool verbose = false;  ///< Verbose: the diagnostics contain a glib-N02 for each executed operation
    Diagnostics diagnostics;
};

}  // namespace glibra::scene
