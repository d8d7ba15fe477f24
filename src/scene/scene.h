#pragma once
// A Script, interpreted: everything a frame needs, as values. No GL, no pixels, no mesh data yet; names of
// files are resolved, but nothing is read before something visible needs it. Indices refer to the vectors of
// Scene.

#include <glibra/diagnostic.h>

#include <array>
#include <cstdint>
#include <filesystem>
#include <glm/mat4x4.hpp>
#include <glm/vec4.hpp>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "base/program_resources.h"
#include "geometry/mesh.h"
#include "glib/script.h"
#include "glsl/types/stage.h"

namespace glibra::scene {

/// No such thing: "no program", "no texture", "no file".
inline constexpr int kNone = -1;

/// A file that a scene names, looked up but not read. `path` is empty if nothing was found; `remarks`
/// (file-E01, file-W01 ...) belong to whoever needs the file. Statements that name the same file share one
/// reference, with the place of the first.
struct FileReference {
    std::string name;  ///< as written
    std::filesystem::path path;
    Diagnostics remarks;
    Place place;
};

/// What a geometry command draws: the command with its numbers, or a list made by glBegin, Triangles or
/// LinesAdjacency. Equal shapes share one entry of Scene::shapes, and so one mesh.
struct Shape {
    glib::CommandId command{};
    /// Arguments, defaults filled in. A count that the language fixes and no scene
    /// states may follow: cells a side of a Teapot's patches, cuts of a Soccerball's triangles, sides of an
    /// Xarrow.
    std::vector<double> numbers;
    int file = kNone;  ///< index into Scene::files
    std::shared_ptr<const geometry::Mesh>
        list;  ///< the mesh itself where the scene's text gives the vertices
};

using base::TextureTarget;
enum class TexelFormat { rgba8, rgba16f, rgba32f, r32f };

/// Where a texture's texels come from.
struct PictureSource {
    std::vector<int> files;  ///< one, or six for a cube map
    bool anyDimension =
        false;  ///< `Texture`: the file decides between 1D, 2D and 3D; `target` is then the best guess
};
struct EmptySource {
    int width = 1, height = 1, depth = 1;
    TexelFormat format = TexelFormat::rgba8;
};
/// What a texel of noise holds of the function: what glman's does, or 16 bits of it.
enum class NoiseTexels { bytes, shorts };

/// Noise of that size: the texels of the file if there is one (raw bytes of exactly that size), else built
/// in. The remarks (file-N01, file-W09, file-W10) belong to whoever needs the texture.
struct NoiseSource {
    int dimensions = 3;
    int size = 64;
    bool isSizeGiven = false;                 ///< the scene states it
    NoiseTexels texels = NoiseTexels::bytes;  ///< of built-in noise
    int file = kNone;                         ///< index into Scene::files
    Diagnostics remarks;
};

struct Texture {
    TextureTarget target = TextureTarget::texture2D;
    std::variant<PictureSource, EmptySource, NoiseSource> source;
    Place place;
    int unit = 0;
};

/// How a texture is read; apart from the texture itself.
struct Sampling {
    bool clamp = false;  ///< clamp to edge, else repeat (noise always repeats, cube maps always clamp)
};

/// Units that hold the noise textures until a scene fills them; Noise2 and Noise3 without a tag read them.
inline constexpr int kNoise2Unit = 2;
inline constexpr int kNoise3Unit = 3;

/// One filled slot of the (unit, target) table. The noise textures are Scene::textures[0] (2D, unit 2) and
/// [1] (3D, unit 3).
struct Slot {
    int unit = 0;
    TextureTarget target = TextureTarget::texture2D;
    int texture = kNone;
};
/// What all slots hold at one place of the scene, by rising unit and target; draws share these.
using SlotTable = std::vector<Slot>;

/// Shader files of one stage as they were current at a Program statement.
struct StageFile {
    glsl::Stage stage = glsl::Stage::vertex;
    int file = kNone;
};

struct Program {
    std::string name;
    Place place;
    std::vector<StageFile> stages;
    std::string geometryInput;  ///< plain lower-case GLSL word or empty
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
using Projection = std::variant<Perspective, Orthographic>;

enum class BlendMode { none, overOpaque };

/// Everything fixed-function about a draw. A classic scene sets few of these; each draw carries them all.
struct RasterState {
    BlendMode blend = BlendMode::overOpaque;
    double lineWidth = 1, pointSize = 1;  ///< pixels
    bool pointSizeFromShader = false;
};

/// One geometry command with its complete state.
struct Draw {
    Place place;
    std::string word;  ///< the command as written, for messages; of a glBegin list its topology
    int shape = kNone;
    int program = kNone;
    glm::dmat4 modelView{1.0};
    Projection projection;
    glm::dvec4 color{1.0};
    RasterState raster;
    int patchVertices = 3;
    bool flatColors = false;
    Sampling sampling;
    int slots = 0;  ///< index into Scene::slotTables
    double timerPeriod = 10;
    std::size_t givenNumbers =
        0;  ///< how many of the shape's numbers the scene states; the rest are defaults
};

/// Clears colour (all targets) and depth of the pass. A Clear that only repeats the pass's implicit clear is
/// left out.
struct Clear {
    Place place;
    glm::dvec4 color{0.0};
};

/// Drawing into one target list. The implicit clear of the language (2.3) is in `clearColors` and
/// `clearDepth`.
struct Pass {
    std::vector<int> targets;  ///< indices into Scene::textures; empty: the window
    int depthBuffer = 0;       ///< passes with the same number share depth; 0 is the window's
    std::vector<std::optional<glm::dvec4>>
        clearColors;  ///< a target each (window: one); nothing: keep content
    bool clearDepth = false;
    Place place;  ///< of RenderToTexture, for messages
    std::vector<std::variant<Draw, Clear>> steps;
};

struct Scene {
    std::string path;
    int width = 600, height = 600;
    std::vector<FileReference> files;
    std::vector<Shape> shapes;
    std::vector<Texture> textures;
    std::vector<SlotTable> slotTables;
    std::vector<Program> programs;
    std::vector<Pass> passes;  ///< in order; the last content of the window is the picture
    bool usesLookAt = false;
    glm::dmat4 view{1.0};  ///< viewing matrix of the last LookAt
    bool verbose = false;  ///< Verbose: every executed operation is in the diagnostics, as glib-N02
    Diagnostics diagnostics;
};

}  // namespace glibra::scene
