#include <glibra/render.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <mutex>
#include <string_view>
#include <utility>
#include <vector>

#include "base/device_lost.h"
#include "gpu/context/fork.h"
#include "gpu/state/foreign.h"
#include "library/renderer_state.h"
#include "render/check/nan_search.h"
#include "render/scene_renderer.h"
#include "suite/options/option_table.h"

namespace glibra {
namespace {

Diagnostic forked() {
    return diagnose("gpu-E08", gpu::forkedText());
}

Result<gpu::Context> openFor(Driver driver) {
    if (gpu::isForked()) return forked();
    gpu::ContextOptions options;
    options.driver = driver;
    return gpu::openContext(options);
}

/// library-E01 for each option that no picture can have.
Diagnostics problemsOf(const RenderOptions& options) {
    Diagnostics found = outOfRange({{"width", options.width, kLargestPictureSide},
                                    {"height", options.height, kLargestPictureSide},
                                    {"samples", options.samples, suite::kMostSamples},
                                    {"tileSize", options.tileSize, kLargestPictureSide}});
    const auto wrong = [&](std::string text) { found.push_back(wrongOption(std::move(text))); };
    if (options.steps < 0) wrong(fmt::format("steps: {} is below 0", options.steps));
    if (!std::isfinite(options.time))
        wrong(fmt::format("time: {} is not a finite number of seconds", options.time));
    if (options.maxError != 0 &&
        !(options.maxError >= kLeastMaxError && options.maxError <= kLargestMaxError))
        wrong(fmt::format("maxError: {} is not between {:g} and {:g} pixels", options.maxError,
                          kLeastMaxError, kLargestMaxError));
    if (!std::isfinite(options.lastTime))
        wrong(fmt::format("lastTime: {} is not a finite number of seconds", options.lastTime));
    append(found, glibra::problemsOf(options.viewState));
    return found;
}

/// library-E01 for each option that load() would not keep.
Diagnostics problemsOfLoading(const RenderOptions& options) {
    Diagnostics found = problemsOf(options);
    const RenderOptions none;
    suite::Shot rest;  // options that have no message yet
    rest.options = options;
    const auto refuse = [&](std::string_view name, auto member, const char* words) {
        if (options.*member != none.*member) found.push_back(wrongOption(fmt::format("{}: {}", name, words)));
        rest.options.*member = none.*member;
    };
    constexpr const char* kOfRender = "only render() has this; load() has not";
    refuse("maxError", &RenderOptions::maxError, kOfRender);
    refuse("overrideCounts", &RenderOptions::overrideCounts, kOfRender);
    refuse("lastTime", &RenderOptions::lastTime, kOfRender);
    refuse("checkNan", &RenderOptions::checkNan, kOfRender);
    refuse("checkUndefined", &RenderOptions::checkUndefined, kOfRender);
    refuse("checks", &RenderOptions::checks, kOfRender);
    refuse("tileSize", &RenderOptions::tileSize, kOfRender);
    refuse("wantedObjects", &RenderOptions::wantedObjects, kOfRender);
    constexpr const char* kOfDraw = "an option of draw(), not of load()";
    refuse("width", &RenderOptions::width, kOfDraw);
    refuse("height", &RenderOptions::height, kOfDraw);
    refuse("time", &RenderOptions::time, kOfDraw);
    refuse("samples", &RenderOptions::samples, kOfDraw);
    refuse("alpha", &RenderOptions::alpha, kOfDraw);
    refuse("floatPixels", &RenderOptions::floatPixels, kOfDraw);
    refuse("viewState", &RenderOptions::viewState, kOfDraw);
    refuse("axes", &RenderOptions::axes, kOfDraw);
    // Every other one is of render(), too, unless a loaded scene keeps it.
    for (const suite::OptionRow& row : suite::optionTable())
        if (!row.isKept && !suite::isDefault(row, rest))
            found.push_back(wrongOption(fmt::format("{}: {}", row.name, kOfRender)));
    return found;
}

/// A driver that draws with the processor takes megabytes for each draw and frees them. glibc would give them
/// back to the system, and every page of the next draw would be a new one: a third of the time of a teapot.
/// Once a block of this size has been freed, glibc keeps up to twice as much (mallopt(3),
/// M_MMAP_THRESHOLD), unless the program has decided otherwise. The block itself is never written to.
void keepFreedMemory() {
#ifdef __GLIBC__
    constexpr std::size_t kBytes = std::size_t{16} << 20;
    void* volatile block = std::malloc(kBytes);  // volatile, because compilers remove such pairs
    std::free(block);
#endif
}

/// The options with a reader that is called once at a time.
RenderOptions withOrder(RenderOptions options) {
    if (options.reader)
        options.reader = std::make_shared<const FileReader>(
            [reader = options.reader, mutex = std::make_shared<std::mutex>()](
                const std::filesystem::path& path) -> std::optional<std::string> {
                const std::lock_guard<std::mutex> lock(*mutex);
                return (*reader)(path);
            });
    return options;
}

/// What a scene does not take of `set` as it is, which the command line warns of, is an error of the caller.
void refuseSettings(Result<Picture>& drawn) {
    static constexpr std::array kOfValues{"glib-W15", "glib-W20", "glib-W23", "glib-W27"};
    for (Diagnostic& each : drawn.diagnostics)
        if (each.place.file.empty() && std::ranges::find(kOfValues, each.id) != kOfValues.end()) {
            each.severity = Severity::error;
            each.id.clear();  // identified() gives it the library's
            drawn.value.reset();
        }
}

/// The renderer whose context the calls of this thread used last.
thread_local const void* lastOfThread = nullptr;

}  // namespace

Diagnostic wrongOption(std::string text) {
    return diagnose("library-E01", std::move(text));
}

Diagnostic movedFrom() {
    return diagnose("library-E05", "the scene or renderer was moved into another object, which has it now");
}

Diagnostics problemsOf(const ViewState& view) {
    const auto areFinite = [](const auto& numbers) {
        return std::ranges::all_of(numbers, [](double each) { return std::isfinite(each); });
    };
    bool isFinite = areFinite(view.scene) && areFinite(view.eye) && areFinite(view.texture) &&
                    (!view.background || areFinite(*view.background));
    for (const ViewState::Object& each : view.objects) isFinite = isFinite && areFinite(each.matrix);
    if (isFinite) return {};
    return {wrongOption("the view has a number that is not finite")};
}

Diagnostics outOfRange(std::initializer_list<OptionRange> options) {
    Diagnostics found;
    for (const auto& [name, value, most] : options)
        if (value < 0 || value > most)
            found.push_back(wrongOption(fmt::format("{}: {} is not between 0 and {}", name, value, most)));
    return found;
}

Diagnostics identified(Diagnostics messages, const std::string& id, const std::filesystem::path& scene) {
    for (Diagnostic& each : messages) {
        if (each.severity != Severity::error || !each.id.empty()) continue;
        each.id = id;
        if (each.place.file.empty()) each.place = {scene.generic_string(), 1, 1};
    }
    return messages;
}

Renderer::Renderer(std::shared_ptr<State> state) : state_(std::move(state)) {}
Renderer::Renderer(Renderer&&) noexcept = default;
Renderer& Renderer::operator=(Renderer&&) noexcept = default;
Renderer::~Renderer() = default;

Result<Renderer> Renderer::open(Driver driver) {
    Result<gpu::Context> context = openFor(driver);
    if (!context) return std::move(context.diagnostics);
    keepFreedMemory();
    return {Renderer(std::make_shared<State>(driver, std::move(*context))), std::move(context.diagnostics)};
}

Result<Renderer> Renderer::open(const CurrentContext& current) {
    if (gpu::isForked()) return forked();
    if (!current.loader)
        return diagnose("gpu-E01", "no usable OpenGL driver: no context is current on this thread");
    Result<gpu::Context> context = gpu::adopt(current.loader);
    if (!context) return std::move(context.diagnostics);
    keepFreedMemory();
    auto state = std::make_shared<State>(Driver::automatic, std::move(*context));
    state->isAdopted = true;
    return {Renderer(std::move(state)), std::move(context.diagnostics)};
}

CurrentContext Renderer::current() {
    if (gpu::isForked()) return {};
    if (const auto found = gpu::currentContext()) return {found->address};
    return {};
}

Diagnostics Renderer::State::begin() {
    if (gpu::isForked()) return {forked()};
    if (std::this_thread::get_id() != thread)
        return {
            diagnose("gpu-E08", "the renderer was opened on another thread; use it and its scenes there")};
    if (context) {
        if (!makeCurrent())
            return {diagnose("gpu-E01", isAdopted ? "no usable OpenGL driver: the context that the renderer "
                                                    "adopted is not current on this thread; make it current "
                                                    "before each call"
                                                  : "no usable OpenGL driver: the renderer's context cannot "
                                                    "be made current on this thread again")};
        gpu::takeBackState(*context);
        std::vector<OnDevice> ended;
        const std::lock_guard<std::mutex> lock(mutex);
        ended.swap(left);
        return {};
    }
    if (isAdopted)
        return {diagnose("gpu-E06",
                         "the graphics driver has reset the device of the context that was adopted; open a "
                         "renderer with another one")};
    Result<gpu::Context> opened = openFor(driver);
    if (!opened) return std::move(opened.diagnostics);
    context = std::move(opened.value);
    lastOfThread = this;
    return {};
}

Renderer::State::State(Driver asked, gpu::Context opened) : driver(asked), context(std::move(opened)) {
    lastOfThread = this;
}

Renderer::State::~State() {
    if (lastOfThread == this) lastOfThread = nullptr;
    if (!context || (!gpu::isForked() && makeCurrent())) return;
    // The context is current on the thread that opened it, where nothing ends it any more, or that thread's
    // driver is gone, or it is the parent's, or an adopted context is not current: what is on the device
    // cannot be released from here.
    gpu::keepForever(std::pair(std::move(left), std::move(*context)));
}

bool Renderer::State::makeCurrent() {
    if (lastOfThread == this && context->isCurrent()) return true;
    if (!context->makeCurrent()) return false;
    lastOfThread = this;
    return true;
}

void Renderer::State::lose() {
    std::vector<OnDevice> gone;
    {
        const std::lock_guard<std::mutex> lock(mutex);
        gone = std::move(left);
        left.clear();
        for (Scene::State* each : scenes) {
            gone.push_back(std::move(each->device));
            each->device = {};
            each->isDrawn = false;
        }
        scenes.clear();
    }
    gone.clear();
    context.reset();
}

void Renderer::State::leave(Scene::State& scene) {
    if (gpu::isForked())
        return gpu::keepForever(std::move(scene.device));  // the mutex may be locked for ever
    OnDevice last;
    {
        const std::lock_guard<std::mutex> lock(mutex);
        scenes.erase(&scene);
        last = std::move(scene.device);
        if (std::this_thread::get_id() != thread) {
            left.push_back(std::move(last));
            return;
        }
    }
    if (context && !makeCurrent()) left.push_back(std::move(last));
}

Result<Picture> Renderer::render(const std::filesystem::path& scene, const RenderOptions& options) {
    if (!state_) return movedFrom();
    if (Diagnostics problems = problemsOf(options); !problems.empty()) return problems;
    try {
        if (Diagnostics problems = state_->begin(); !problems.empty()) return problems;
        Result<Picture> drawn = state_->render(scene, withOrder(options));
        refuseSettings(drawn);
        drawn.diagnostics = identified(std::move(drawn.diagnostics), "library-E01", scene);
        return drawn;
    } catch (const base::DeviceLost& lost) {
        state_->lose();
        return base::diagnosticOf(lost, scene.generic_string());
    }
}

Result<Picture> Renderer::State::render(const std::filesystem::path& scene, const RenderOptions& from) {
    render::Stats stats;
    Result<render::SceneRenderer> loaded = render::SceneRenderer::load(*context, scene, from, stats);
    Diagnostics found = std::move(loaded.diagnostics);
    if (!loaded) return found;
    Result<image::Image> image = loaded->draw(from.time, stats);
    append(found, std::move(image.diagnostics));
    if (from.checkNan)
        if (Result<render::NanSearch> search = render::NanSearch::load(*context, scene, from))
            append(found, search->at(from.time));
    if (!image || (hasError(found) && !from.incomplete)) return found;
    return {pictureOf(std::move(*image)), std::move(found)};
}

Result<Scene> Renderer::load(const std::filesystem::path& scene, const RenderOptions& options) {
    if (!state_) return movedFrom();
    if (Diagnostics problems = problemsOfLoading(options); !problems.empty()) return problems;
    try {
        if (Diagnostics problems = state_->begin(); !problems.empty()) return problems;
        auto state = std::make_unique<Scene::State>(state_, scene, withOrder(options));
        Result<void> loaded = state->load();
        if (!loaded) return std::move(loaded.diagnostics);
        Diagnostics remarks = state->diagnostics;
        return {Scene(std::move(state)), std::move(remarks)};
    } catch (const base::DeviceLost& lost) {
        state_->lose();
        return base::diagnosticOf(lost, scene.generic_string());
    }
}

Result<Scene> Renderer::loadText(std::string_view text, const std::string& name,
                                 const std::map<std::string, std::string>& files, const RenderOptions& from) {
    RenderOptions options = from;
    options.sceneText = std::string(text);
    if (files.empty()) return load(name, options);
    const auto pathOf = [&](const std::string& file) {
        return (std::filesystem::path(name).parent_path() / file).lexically_normal();
    };
    std::map<std::filesystem::path, std::string> contents;
    for (const auto& [file, content] : files) contents[pathOf(file)] = content;
    options.reader = std::make_shared<const FileReader>(
        [contents = std::move(contents),
         before = from.reader](const std::filesystem::path& path) -> std::optional<std::string> {
            if (const auto found = contents.find(path.lexically_normal()); found != contents.end())
                return found->second;
            return before ? (*before)(path) : std::nullopt;
        });
    return load(name, options);
}

}  // namespace glibra
