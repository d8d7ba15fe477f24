#pragma once
// The library's front door: a scene file in, a picture out. Everything else is behind it.

#include <glibra/diagnostic.h>
#include <glibra/driver.h>
#include <glibra/result.h>

#include <array>
#include <cstddef>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace glibra {

/// How the eye is placed: `automatic` moves it back from a scene that would be seen from inside.
enum class ViewPolicy { automatic, glman };

/// 4 x 4 numbers, column by column.
using Matrix = std::array<double, 16>;
inline constexpr Matrix kIdentity{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};

/// Whether the scene's own projections hold. `orthographic` shows what lies at the origin of the world as
/// large as the scene's perspective does; `perspective` (50 degrees) shows an orthographic scene so.
enum class ProjectionMode { scene, perspective, orthographic };

/// What a window adds to the matrices of a scene, and replaces of it. The default changes nothing.
struct ViewState {
    Matrix scene = kIdentity;    ///< Projection becomes Projection * scene
    Matrix eye = kIdentity;      ///< ModelView becomes eye * ModelView
    Matrix texture = kIdentity;  ///< gl_TextureMatrix[0]
    /// One object's own transform: ModelView * matrix for the draw of that line of the scene, counted from 1.
    struct Object {
        int line = 0;
        Matrix matrix = kIdentity;
        friend bool operator==(const Object&, const Object&) = default;
    };
    std::vector<Object> objects{};
    ProjectionMode projection = ProjectionMode::scene;
    std::optional<std::array<double, 4>> background{};  ///< instead of the window's clear colours
    friend bool operator==(const ViewState&, const ViewState&) = default;
};

/// What may be asked of a picture beyond what the scene says.
struct RenderOptions {
    int width = 0;  ///< pixels; 0: the scene's WindowSize
    int height = 0;
    double time = 0;                 ///< seconds since loading; Timer = fract(time / period)
    std::vector<std::string> set{};  ///< "NAME=VALUE" for uniforms
    ViewPolicy view = ViewPolicy::automatic;
    int samples = 0;  ///< multisampling, limited to what the driver has; 0: one, or as maxError needs
    /// Pixels. Above 0: counts, samples and noise sizes that the scene leaves open are chosen so that nothing
    /// is drawn further from its place, at the least cost. 0: the language's defaults.
    double maxError = 0;
    bool overrideCounts = false;  ///< with maxError: numbers that the scene states are chosen as well
    bool axes = false;            ///< draws axes two units long at the origin of eye space
    bool alpha = false;           ///< keeps the window's alpha; otherwise pictures are opaque
    bool floatPixels = false;     ///< 32-bit float pixels, not limited to 0..1
    bool strict = false;          ///< warnings are errors
    bool checkNan = false;        ///< searches the draws that put NaN or infinity into the picture
    bool shim = true;             ///< false: shaders are compiled as they are
    bool skip = true;  ///< false: what the picture does not need is read, made and drawn all the same
    std::vector<std::filesystem::path>
        libraryRoots{};  ///< searched for files besides the scene's own folders
    int tileSize = 0;    ///< pixels a side of the tiles of a large picture; 0: as large as the driver allows
    ViewState viewState{};

    friend bool operator==(const RenderOptions&, const RenderOptions&) = default;
};

/// Pixels, top row first, tightly packed: 3 (opaque) or 4 components, bytes or 32-bit floats.
struct Picture {
    int width = 0;
    int height = 0;
    int components = 3;
    bool isFloat = false;
    std::vector<std::byte> data;
};

/// A GL context and what pictures share. Use it from the thread that made it; one at a time in a process.
class Renderer {
  public:
    /// Opens a context; the error says what was tried.
    static Result<Renderer> open(Driver driver = Driver::automatic);

    /// Reads and draws one scene file. Errors of the scene are diagnostics with file, line and column.
    Result<Picture> render(const std::filesystem::path& scene, const RenderOptions& options = {});

    Renderer(Renderer&&) noexcept;
    Renderer& operator=(Renderer&&) noexcept;
    ~Renderer();

  private:
    struct State;
    explicit Renderer(std::unique_ptr<State> state);
    std::unique_ptr<State> state_;
};

}  // namespace glibra
