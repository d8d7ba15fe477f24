#pragma once
// The library's entry point: reads a scene file and renders its picture.

#include <glibra/diagnostic.h>
#include <glibra/draw_id.h>
#include <glibra/driver.h>
#include <glibra/export.h>
#include <glibra/result.h>

#include <array>
#include <concepts>
#include <cstddef>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace glibra {

/// How the eye is placed. `automatic` moves it back if the scene would be seen from inside.
enum class ViewPolicy { automatic, glman };

/// A 4 x 4 matrix, column by column.
using Matrix = std::array<double, 16>;
inline constexpr Matrix kIdentity{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};

/// Which projection is used instead of the scene's. `orthographic` keeps the size that the scene's
/// perspective gives to what lies at the world's origin; `perspective` (50 degrees) likewise for an
/// orthographic scene.
enum class ProjectionMode { scene, perspective, orthographic };

/// The transforms that a window adds to a scene, and the settings that it replaces. The default changes
/// nothing.
struct ViewState {
    Matrix scene = kIdentity;    ///< Projection becomes Projection * scene
    Matrix eye = kIdentity;      ///< ModelView becomes eye * ModelView
    Matrix texture = kIdentity;  ///< gl_TextureMatrix[0]
    /// The transform of one object: ModelView * matrix for that draw.
    struct Object {
        int line = 0;  ///< of the scene, counted from 1
        Matrix matrix = kIdentity;
        int file = 0, counter = 0;  ///< as in DrawId

        Object() = default;
        Object(int ofLine, const Matrix& by) : line(ofLine), matrix(by) {}
        Object(const DrawId& draw, const Matrix& by)
            : line(draw.line), matrix(by), file(draw.file), counter(draw.counter) {}
        [[nodiscard]] DrawId draw() const { return {line, file, counter}; }
        friend bool operator==(const Object&, const Object&) = default;
    };
    std::vector<Object> objects{};
    ProjectionMode projection = ProjectionMode::scene;
    std::optional<std::array<double, 4>> background{};  ///< instead of the window's clear colours
    friend bool operator==(const ViewState&, const ViewState&) = default;
};

/// The corner of the picture that shows the values of uniform variables; `none` shows none.
enum class LabelCorner { none, bottomLeft, bottomRight, topLeft, topRight };

/// The limits of RenderOptions::width, height and maxError, in pixels.
inline constexpr int kLargestPictureSide = 65'536;
inline constexpr double kLeastMaxError = 1e-9, kLargestMaxError = 1e6;

/// Gives the content of a file in place of the disk, or nothing: then the disk has it, if there is one. The
/// path is one at which the scene looks for the file: a folder that is searched, the scene's own first, and
/// the name. It is called while a scene is read, on any thread, one call at a time, and must not use the
/// renderer.
using FileReader = std::function<std::optional<std::string>(const std::filesystem::path& path)>;

/// The options of a picture, in addition to what the scene states.
struct RenderOptions {
    int width = 0;  ///< pixels; 0: the scene's WindowSize
    int height = 0;
    double time = 0;                 ///< seconds since loading; Timer = fract(time / period)
    int steps = 100'000;             ///< of Step blocks that one picture may need
    std::vector<std::string> set{};  ///< "NAME=VALUE" for uniforms
    ViewPolicy view = ViewPolicy::automatic;
    int samples = 0;  ///< per pixel, limited to the driver's maximum; 0: one, or as maxError needs
    /// The largest error in pixels. Above 0, glibra chooses the counts, samples and noise sizes that the
    /// scene leaves open, so that nothing is drawn further from its place, at the least cost. 0: the
    /// language's defaults.
    double maxError = 0;
    /// The time of the last picture of an animation that begins at `time`; up to `time` there is none. Values
    /// of Bound variables are measured at its beginning, middle and end.
    double lastTime = 0;
    bool overrideCounts = false;             ///< with maxError: also chooses numbers that the scene states
    bool axes = false;                       ///< draws axes 1.5 units long at the origin of world space
    LabelCorner labels = LabelCorner::none;  ///< writes the values of uniform variables over the picture
    bool alpha = false;                      ///< keeps the window's alpha; otherwise pictures are opaque
    bool floatPixels = false;                ///< 32-bit float pixels, not limited to 0..1
    bool strict = false;                     ///< warnings are errors
    /// Draws what does not need the files that are missing or wrong, with a striped border around the
    /// picture. The result has the errors and the picture.
    bool incomplete = false;
    bool checkNan = false;  ///< finds the draws that put NaN or infinity into the picture
    /// Finds what shaders do that GLSL leaves undefined: subscripts outside of arrays, fetches outside of
    /// textures, vertices beyond max_vertices, divisions by uniforms that are 0. Needs OpenGL 4.3.
    bool checkUndefined = false;
    bool shim = true;  ///< false: shaders are compiled without translation
    bool skip = true;  ///< false: reads, makes and draws even what the picture does not need
    std::vector<std::filesystem::path>
        libraryRoots{};  ///< searched for files besides the scene's own folders
    /// If it is not empty, the scene may read only files below this folder and below the library folders.
    /// Others are an error (file-E12), even if a link leads to them.
    std::filesystem::path within{};
    bool checks = false;  ///< what Expect statements read is made, even if the picture does not show it
    /// The text of the scene; nothing: what its file has. With a text the file need not exist.
    std::optional<std::string> sceneText{};
    /// Contents in place of what files have: of the scene, shaders, what these include, pictures, models,
    /// buffers. The paths are those under which the scene finds the files.
    std::map<std::filesystem::path, std::string> texts{};
    /// The same by a function, which is asked first. May be null; options are equal only if they share it.
    std::shared_ptr<const FileReader> reader{};
    int tileSize = 0;  ///< pixels per side of the tiles of a large picture; 0: as large as the driver allows
    ViewState viewState{};
    /// Textures of a modern scene, or parts of them, and buffers that are made even if the picture does not
    /// show them: "shadow", "glow.level(2)", "sky.face(0)", "slices.layer(3)", "Particles".
    std::vector<std::string> wantedObjects{};

    friend bool operator==(const RenderOptions&, const RenderOptions&) = default;
};

/// Pixels, top row first, tightly packed: 3 (opaque) or 4 components, bytes or 32-bit floats. Textures may
/// also have 1 or 2 components, and whole numbers of 16 and 32 bits. Whole numbers of 8 and 16 bits without a
/// sign stand for 0..1 where pictures are saved and compared; others stand for themselves.
struct Picture {
    int width = 0;
    int height = 0;
    int components = 3;
    bool isFloat = false;
    bool isSigned = false;  ///< whole numbers with a sign, as of textures r8i and rgba32i
    int bits = 8;           ///< of a component: 8, 16 or 32; of floats 32
    std::vector<std::byte> data{};

    /// Writes a file of the format that its name says: .png, .exr, .jpg, .tif and others. A file of that name
    /// is replaced when the new one is complete. Whole numbers with a sign or of 32 bits are written as
    /// floats, by .exr and .pfm; library-E06 for other formats, and for a number that no float has.
    GLIBRA_API Result<void> save(const std::filesystem::path& file) const;
};

class Scene;

/// A GL context that is current on this thread and belongs to the calling program.
struct CurrentContext {
    /// Returns the address of a GL function, or null.
    std::function<void*(const char* name)> loader;
};

/// A GL context and the parts that pictures share. Use it, and the scenes that it loads, on the thread that
/// opened it: calls from another one return gpu-E08. So does every call, open() too, in a process that was
/// forked after a renderer was opened; what it inherits may be destroyed there. Calls of a renderer that has
/// been moved from return library-E05. open() and each call make the renderer's own context current and leave
/// it so; a calling program that draws itself makes its own current again. Several renderers may exist, on
/// one thread or on several; those of different threads must use the same driver, else open() returns
/// gpu-E01.
class GLIBRA_API Renderer {
  public:
    /// Opens a context. The error names each way that was tried.
    static Result<Renderer> open(Driver driver = Driver::automatic);
    /// Adopts a context, at least OpenGL 4.1 core, which must outlive the renderer. It must be current in
    /// each call; while it is not, calls return gpu-E01 and change nothing. What state it has does not
    /// matter, and calls leave it changed.
    static Result<Renderer> open(const CurrentContext& context);
    /// The context that is current on this thread, by EGL, GLX or OSMesa; without one, its loader finds
    /// nothing and open() says so.
    static CurrentContext current();

    /// Reads and draws one scene file; library-E01 for options that no picture can have, such as `set` and
    /// `wantedObjects` with values or names that the scene does not take as they are. Errors in the scene
    /// are diagnostics with file, line and column. To draw a scene more than once, load() it.
    Result<Picture> render(const std::filesystem::path& scene, const RenderOptions& options = {});

    /// Reads a scene that is to be drawn many times. Faulty statements are errors. The options are `steps`,
    /// `set`, `view`, `strict`, `shim`, `skip`, and those that say where files and texts come from;
    /// library-E01 for the others, which are those of render() or draw().
    Result<Scene> load(const std::filesystem::path& scene, const RenderOptions& options = {});
    /// The same for a scene in memory. `name` is its name in messages, and files are looked for beside it.
    /// `files` are the contents of files in place of those of the disk, by the names that the scene and its
    /// shaders use: texts of shaders and of what they include, pictures, models and buffers as files have
    /// them.
    Result<Scene> loadText(std::string_view text, const std::string& name = "scene.glib",
                           const std::map<std::string, std::string>& files = {},
                           const RenderOptions& options = {});
    /// The same with a function that gives the contents, as a FileReader does.
    template <std::invocable<const std::filesystem::path&> Reader>
    Result<Scene> loadText(std::string_view text, const std::string& name, Reader files,
                           RenderOptions options = {});

    Renderer(Renderer&&) noexcept;
    Renderer& operator=(Renderer&&) noexcept;
    ~Renderer();

  private:
    friend class Scene;
    struct State;
    explicit Renderer(std::shared_ptr<State> state);
    std::shared_ptr<State> state_;  ///< shared with its scenes
};

}  // namespace glibra
