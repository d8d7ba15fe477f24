#pragma once
// What a Renderer and its scenes share: the context, and who is loaded on it.

#include <glibra/render.h>
#include <glibra/scene.h>

#include <memory>
#include <optional>
#include <set>
#include <thread>

#include "gpu/context/context.h"
#include "gpu/object/target.h"
#include "view/scene/live_scene.h"

namespace glibra {

inline constexpr int kMostSamples = 64;  ///< per pixel

struct Renderer::State {
    State(Driver asked, gpu::Context opened) : driver(asked), context(std::move(opened)) {}

    /// gpu-E08 on another thread than the one that opened the context. Opens a new context after a reset.
    Diagnostics begin();
    /// After a reset: all that is on the device goes, then the context.
    void lose();
    Result<Picture> render(const std::filesystem::path& scene, const RenderOptions& options);

    Driver driver;
    bool isAdopted = false;
    std::thread::id thread = std::this_thread::get_id();
    std::optional<gpu::Context> context;  ///< empty after a reset of the device
    std::set<Scene::State*> scenes;       ///< that are on the device
};

struct Scene::State {
    State(std::shared_ptr<Renderer::State> on, std::filesystem::path file, RenderOptions from)
        : renderer(std::move(on)), path(std::move(file)), options(std::move(from)) {}
    State(const State&) = delete;
    State& operator=(const State&) = delete;
    ~State() { renderer->scenes.erase(this); }

    /// Reads the scene, or reads it again: what has been set stays.
    Result<void> load();
    /// What every call begins with: the thread, and the scene on the device.
    Diagnostics begin();
    /// Runs `work`, which may find that the device was reset.
    template <class T, class Work>
    Result<T> guarded(const Work& work);
    Result<Picture> draw(const DrawOptions& options);
    Result<const gpu::Target*> targetFor(const DrawOptions& options);
    Result<void> set(std::string_view name, std::span<const double> values, std::string_view text);
    [[nodiscard]] std::vector<view::Knob> knobs() const;
    /// NAME=VALUE for all that has been set.
    [[nodiscard]] std::vector<std::string> settings() const;
    Result<Picture> textureNamed(std::string_view name);

    std::shared_ptr<Renderer::State> renderer;  ///< outlives what is on its device
    std::filesystem::path path;
    RenderOptions options;
    std::unique_ptr<view::LiveScene> live;  ///< null after a reset
    Diagnostics diagnostics;
    std::uint64_t frames = 0;
    double drawnTime = 0;
    std::vector<view::Knob> changed;  ///< what has been set

    struct Window {
        int width = 0, height = 0, samples = 0;
        bool isFloat = false;
        gpu::Target target;
    };
    std::optional<Window> window;  ///< that the last picture was drawn into
    bool isDrawn = false;
};

/// The picture of an image in memory, and the image of a picture.
Picture pictureOf(image::Image image);
image::Image imageOf(const Picture& picture);

}  // namespace glibra
