#pragma once
// What a Renderer and its scenes share: the context, and who is loaded on it.

#include <glibra/render.h>
#include <glibra/scene.h>

#include <functional>
#include <initializer_list>
#include <memory>
#include <mutex>
#include <optional>
#include <set>
#include <string>
#include <thread>
#include <vector>

#include "base/device_lost.h"
#include "gpu/context/context.h"
#include "gpu/object/framebuffer.h"
#include "render/live/live_scene.h"

namespace glibra {

/// What the picture of a scene is drawn into.
struct SceneWindow {
    int width = 0, height = 0, samples = 0;
    bool isFloat = false;
    gpu::Target target;
};

/// What of a scene is on the device. It ends on the renderer's thread, while the context is current.
struct OnDevice {
    std::unique_ptr<render::LiveScene> live;  ///< null after a reset
    std::optional<SceneWindow> window;        ///< that the last picture was drawn into
};

// Only the classes of the interface are exported; what they are made of is not.
#if defined(__GNUC__)
#define GLIBRA_INSIDE __attribute__((visibility("hidden")))
#else
#define GLIBRA_INSIDE
#endif

struct GLIBRA_INSIDE Renderer::State {
    State(Driver asked, gpu::Context opened);
    State(const State&) = delete;
    State& operator=(const State&) = delete;
    ~State();

    /// gpu-E08 on another thread than the one that opened the context, and in a forked process. Opens a new
    /// context after a reset, and makes the context current if another one is, such as that of another
    /// renderer. gpu-E01 while an adopted context is not current; else it has the state that drawing begins
    /// with, whatever the calling program has set.
    Diagnostics begin();
    /// After a reset: all that is on the device goes, then the context.
    void lose();
    /// A scene ends, on whatever thread.
    void leave(Scene::State& scene);
    Result<Picture> render(const std::filesystem::path& scene, const RenderOptions& options);

    Driver driver;
    bool isAdopted = false;
    std::thread::id thread = std::this_thread::get_id();
    std::optional<gpu::Context> context;  ///< empty after a reset of the device
    std::mutex mutex;                     ///< of what follows: scenes may end on any thread
    std::set<Scene::State*> scenes;       ///< that are on the device
    std::vector<OnDevice> left;           ///< by scenes that ended on other threads

  private:
    /// True if the context is current on this thread now.
    bool makeCurrent();
};

/// library-E05.
Diagnostic movedFrom();

struct GLIBRA_INSIDE Scene::State {
    State(std::shared_ptr<Renderer::State> on, std::filesystem::path file, RenderOptions from);
    State(const State&) = delete;
    State& operator=(const State&) = delete;
    ~State() { renderer->leave(*this); }

    /// Reads the scene, or reads it again: what has been set stays. After an error nothing has changed.
    Result<void> load();
    /// What every call begins with: the thread, and the scene on the device.
    Diagnostics begin();
    /// Runs `work`, which may find that the device was reset. Null: library-E05.
    template <class T, class Work>
    static Result<T> guarded(State* scene, const Work& work);
    Result<Picture> draw(const DrawOptions& options);
    /// Draws, and gives `use` the target with the picture, whose result is that of the drawing.
    template <class T, class Use>
    Result<T> drawn(const DrawOptions& options, const Use& use);
    Result<void> drawInto(const Surface& surface, DrawOptions options);
    Result<DeviceTexture> deviceTexture(std::string_view name);
    /// What was drawn last.
    [[nodiscard]] Result<Picture> readWindow(int components, bool isFloat) const;
    Result<const gpu::Target*> targetFor(const DrawOptions& options);
    Result<void> set(std::string_view name, std::span<const double> values, std::string_view text);
    [[nodiscard]] std::vector<render::Knob> knobs() const;
    /// NAME=VALUE for all that has been set.
    [[nodiscard]] std::vector<std::string> settings() const;
    Result<Picture> textureNamed(std::string_view name);
    Result<BufferContent> bufferNamed(std::string_view name);
    Result<void> write(std::string_view name, const DataView& data);
    Result<void> writeTexture(const scene::TextureView& view, std::string_view name, const DataView& data);
    Result<void> writeBuffer(const scene::BufferView& view, std::string_view name, const DataView& data);
    /// Warnings become errors if the options say so: but for textures without content, which the program may
    /// write. What it has written has some.
    void applyStrict(Diagnostics& found) const;
    template <class T, class Use>
    Result<T> drawnFor(std::string_view name, const Use& use);
    void keepFolder();

    std::shared_ptr<Renderer::State> renderer;  ///< outlives what is on its device
    std::filesystem::path path;
    std::filesystem::path folder;  ///< the current one when the scene was loaded
    RenderOptions options;
    OnDevice device;
    Diagnostics diagnostics;
    std::uint64_t frames = 0;
    double drawnTime = 0;
    std::vector<render::Knob> changed;           ///< what has been set
    std::set<std::string, std::less<>> written;  ///< textures and buffers, by name
    ViewState drawnView;
    bool isDrawn = false;
};

template <class T, class Work>
Result<T> Scene::State::guarded(State* scene, const Work& work) {
    if (scene == nullptr) return movedFrom();
    try {
        if (Diagnostics problems = scene->begin(); !problems.empty()) return problems;
        return work();
    } catch (const base::DeviceLost& lost) {
        scene->renderer->lose();
        return base::diagnosticOf(lost, scene->path.generic_string());
    }
}

template <class T, class Use>
Result<T> Scene::State::drawn(const DrawOptions& wanted, const Use& use) {
    Result<const gpu::Target*> target = targetFor(wanted);
    if (!target) return std::move(target.diagnostics);
    Diagnostics found = device.live->draw(**target, wanted.view, wanted.time, wanted.axes);
    Result<T> used = use(**target);
    append(found, std::move(used.diagnostics));
    applyStrict(found);
    isDrawn = used && !hasError(found);
    drawnTime = wanted.time;
    drawnView = wanted.view;
    if (!isDrawn) return found;
    ++frames;
    used.diagnostics = std::move(found);
    return used;
}

/// The members of a buffer, without its bytes.
BufferContent describedContent(const plan::BufferLayout& layout, const plan::BufferTable& table);

/// library-E01.
Diagnostic wrongOption(std::string text);
/// library-E01 for numbers that are not finite.
Diagnostics problemsOf(const ViewState& view);
/// library-E01 for each option that no picture of a loaded scene has.
Diagnostics problemsOf(const DrawOptions& options);
/// library-E04.
Diagnostic nothingDrawn();

struct OptionRange {
    const char* name;
    int value, most;
};
/// library-E01 for each option that is not between 0 and its most.
Diagnostics outOfRange(std::initializer_list<OptionRange> options);

/// Gives errors without an id this one, and the scene as their place if they have none.
Diagnostics identified(Diagnostics messages, const std::string& id, const std::filesystem::path& scene);

/// The picture of an image in memory, and the image of a picture whose numbers images have: floats, or of 8
/// and 16 bits without a sign.
Picture pictureOf(image::Image image);
image::Image imageOf(Picture picture);

}  // namespace glibra
