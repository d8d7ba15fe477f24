#include <fmt/format.h>
#include <glibra/scene.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <system_error>
#include <utility>

#include "base/device_lost.h"
#include "base/suggest.h"
#include "base/text.h"
#include "gpu/format/pixel_format.h"
#include "gpu/object/readback.h"
#include "gpu/state/foreign.h"
#include "image/image.h"
#include "library/renderer_state.h"
#include "plan/buffers.h"
#include "render/check/run_checks.h"
#include "render/consequences.h"
#include "render/load/device_buffers.h"
#include "render/load/device_scene.h"
#include "render/scene_renderer.h"
#include "scene/textures.h"
#include "suite/options/option_table.h"

namespace glibra {
namespace {

BufferContent::Column columnOf(const plan::BufferField& from) {
    BufferContent::Column to;
    to.name = from.name;
    to.type = plan::wordOf(from.numbers.front().kind);
    to.count = from.numbers.size();
    for (const plan::MemoryNumber& each : from.numbers)
        to.offsets.push_back(static_cast<std::size_t>(each.offset));
    to.offset = to.offsets.front();
    to.stride = to.count > 1 ? to.offsets[1] - to.offset : plan::sizeOf(from.numbers.front().kind);
    for (std::size_t i = 0; i < to.count; ++i)
        if (to.offsets[i] != to.offset + i * to.stride) to.stride = 0;
    return to;
}

BufferContent contentOf(render::BufferContent from) {
    BufferContent to = describedContent(from.layout, from.table);
    to.bytes = std::move(from.bytes);
    return to;
}

Result<Picture> pictureIn(Result<render::TexelNumbers> numbers) {
    using enum gpu::TexelType;
    if (!numbers) return std::move(numbers.diagnostics);
    Picture picture;
    picture.width = numbers->width;
    picture.height = numbers->height;
    picture.components = numbers->components;
    picture.isFloat = numbers->type == f32;
    picture.isSigned = numbers->type == i8 || numbers->type == i16 || numbers->type == i32;
    picture.bits = static_cast<int>(8 * gpu::bytesOf(numbers->type));
    picture.data = std::move(numbers->data);
    return picture;
}

/// The path as it was meant in that folder.
void moveInto(const std::filesystem::path& folder, std::filesystem::path& path) {
    if (!path.empty() && path.is_relative()) path = (folder / path).lexically_normal();
}

}  // namespace

Diagnostics problemsOf(const DrawOptions& options) {
    Diagnostics found = outOfRange({{"width", options.width, kLargestPictureSide},
                                    {"height", options.height, kLargestPictureSide},
                                    {"samples", options.samples, suite::kMostSamples}});
    if (!std::isfinite(options.time))
        found.push_back(wrongOption(fmt::format("time: {} is not a finite number of seconds", options.time)));
    append(found, problemsOf(options.view));
    return found;
}

Diagnostic nothingDrawn() {
    return diagnose("library-E04", "no picture has been drawn yet");
}

BufferContent describedContent(const plan::BufferLayout& layout, const plan::BufferTable& table) {
    BufferContent to;
    for (const plan::BufferField& each : plan::fieldsOf(table, layout.pattern))
        (each.isOfElement ? to.columns : to.head).push_back(columnOf(each));
    to.headBytes = static_cast<std::size_t>(layout.pattern.elementsAt);
    to.stride = static_cast<std::size_t>(layout.pattern.stride);
    to.elements = layout.elements;
    return to;
}

Scene::Scene(std::unique_ptr<State> state) : state_(std::move(state)) {}
Scene::Scene(Scene&&) noexcept = default;
Scene& Scene::operator=(Scene&&) noexcept = default;
Scene::~Scene() = default;

Scene::State::State(std::shared_ptr<Renderer::State> on, std::filesystem::path file, RenderOptions from)
    : renderer(std::move(on)), path(std::move(file)), options(std::move(from)) {
    std::error_code failed;
    folder = std::filesystem::current_path(failed);
}

/// Relative paths are those of the folder in which the scene was loaded. What is in memory stays.
void Scene::State::keepFolder() {
    std::error_code failed;
    if (options.reader || folder.empty() || std::filesystem::current_path(failed) == folder) return;
    moveInto(folder, path);
    moveInto(folder, options.within);
    for (std::filesystem::path& each : options.libraryRoots) moveInto(folder, each);
    for (auto& [file, content] : std::exchange(options.texts, {})) {
        std::filesystem::path known = file;
        moveInto(folder, known);
        options.texts.emplace(std::move(known), std::move(content));
    }
}

Result<void> Scene::State::load() {
    keepFolder();
    // Nothing moves from the scene as it is into one that may turn out to be faulty.
    render::LiveScene::Loading loading = render::LiveScene::load(*renderer->context, path, options, nullptr);
    std::set<std::string, std::less<>> before = std::exchange(written, {});
    applyStrict(loading.diagnostics);
    if (!loading.scene || hasError(loading.diagnostics)) {
        written = std::move(before);
        return std::move(loading.diagnostics);
    }
    device = OnDevice{std::move(loading.scene), {}};
    {
        const std::lock_guard<std::mutex> lock(renderer->mutex);
        renderer->scenes.insert(this);
    }
    diagnostics = std::move(loading.diagnostics);
    device.live->keepTextures(diagnostics);
    isDrawn = false;
    for (const render::Knob& each : std::exchange(changed, {})) {
        const std::vector<render::Knob> now = knobs();
        const auto same = std::find_if(now.begin(), now.end(), [&](const render::Knob& one) {
            return one.tag == each.tag && one.title == each.title &&
                   one.initial.size() == each.current.size();
        });
        if (same == now.end()) continue;
        render::Knob knob = *same;
        knob.current = each.current;
        device.live->setValue(knob);
        changed.push_back(std::move(knob));
    }
    // Variables have been read with the scene; these are uniforms. Only the first reading has any.
    for (const std::string& each : std::exchange(options.set, {})) {
        const std::size_t equals = each.find('=');
        if (equals == std::string::npos) return wrongOption(fmt::format("set: '{}' is not NAME=VALUE", each));
        if (Result<void> done =
                set(std::string_view(each).substr(0, equals), {}, std::string_view(each).substr(equals + 1));
            !done)
            return done;
    }
    return {};
}

Diagnostics Scene::State::begin() {
    if (Diagnostics problems = renderer->begin(); !problems.empty()) return problems;
    if (device.live) return {};
    Result<void> loaded = load();
    return loaded ? Diagnostics() : std::move(loaded.diagnostics);
}

Diagnostics Scene::problems() const {
    return State::guarded<void>(state_.get(), []() -> Result<void> { return {}; }).diagnostics;
}

Result<const gpu::Target*> Scene::State::targetFor(const DrawOptions& wanted) {
    const int width = wanted.width > 0 ? wanted.width : device.live->scene().width;
    const int height = wanted.height > 0 ? wanted.height : device.live->scene().height;
    const gpu::Capabilities& capabilities = renderer->context->capabilities();
    const int largest = std::min(
        {capabilities.maxRenderbufferSide, capabilities.maxViewportWidth, capabilities.maxViewportHeight});
    if (width > largest || height > largest)
        return wrongOption(fmt::format(
            "a picture of {} x {} pixels; this driver draws up to {} x {} at once; render() draws "
            "larger ones in tiles",
            width, height, largest, largest));
    const gpu::TexelFormat depth = render::depthFormat(device.live->scene().reversesWindow);
    if (device.window && device.window->width == width && device.window->height == height &&
        device.window->samples == wanted.samples && device.window->isFloat == wanted.floatPixels &&
        device.window->target.depth()->format() == depth)
        return &device.window->target;
    device.window.reset();
    isDrawn = false;
    Result<gpu::Target> made = gpu::Target::window(
        capabilities, width, height, wanted.floatPixels ? gpu::TexelFormat::rgba32f : gpu::TexelFormat::rgba8,
        std::max(1, wanted.samples), depth);
    if (!made) return std::move(made.diagnostics);
    device.window.emplace(SceneWindow{width, height, wanted.samples, wanted.floatPixels, std::move(*made)});
    return {&device.window->target, std::move(made.diagnostics)};
}

Result<Picture> Scene::State::draw(const DrawOptions& wanted) {
    return drawn<Picture>(
        wanted, [&](const gpu::Target&) { return readWindow(wanted.alpha ? 4 : 3, wanted.floatPixels); });
}

Result<Picture> Scene::State::readWindow(int components, bool isFloat) const {
    Picture picture;
    picture.width = device.window->width;
    picture.height = device.window->height;
    picture.components = components;
    picture.isFloat = isFloat;
    picture.bits = isFloat ? 32 : 8;
    Result<std::vector<std::byte>> pixels =
        gpu::readPixels(renderer->context->capabilities(), device.window->target.readable(), 0,
                        {0, 0, picture.width, picture.height},
                        {components, isFloat ? gpu::TexelType::f32 : gpu::TexelType::u8});
    if (!pixels) return std::move(pixels.diagnostics);
    picture.data = std::move(*pixels);
    return picture;
}

Result<Picture> Scene::draw(const DrawOptions& options) {
    if (Diagnostics problems = problemsOf(options); !problems.empty()) return problems;
    return State::guarded<Picture>(state_.get(), [&] { return state_->draw(options); });
}

Diagnostics Scene::check(double time) {
    if (!std::isfinite(time)) return {wrongOption("time: not a finite number of seconds")};
    Result<void> answered = State::guarded<void>(state_.get(), [&]() -> Result<void> {
        state_->keepFolder();
        RenderOptions options = state_->options;
        options.time = time;
        options.set = state_->settings();
        return render::runChecks(*state_->renderer->context, state_->path, options, {});
    });
    std::erase_if(answered.diagnostics,
                  [](const Diagnostic& each) { return each.severity != Severity::error; });
    return std::move(answered.diagnostics);
}

/// Draws the last picture once more with an object that it does not need, and gives that to `use`.
template <class T, class Use>
Result<T> Scene::State::drawnFor(std::string_view name, const Use& use) {
    keepFolder();
    RenderOptions wanted = options;
    wanted.set = settings();
    wanted.width = device.window->width;
    wanted.height = device.window->height;
    wanted.samples = device.window->samples;
    wanted.viewState = drawnView;
    wanted.wantedObjects = {std::string(name)};
    render::Stats stats;
    Result<render::SceneRenderer> loaded =
        render::SceneRenderer::load(*renderer->context, path, wanted, stats);
    if (!loaded) return std::move(loaded.diagnostics);
    render::DeviceScene& copy = loaded->state().conductor.device;
    Diagnostics failed = device.live->device().textures().giveWritten(copy.textures());
    append(failed, device.live->device().buffers().giveWritten(copy.buffers()));
    if (hasError(failed)) return failed;
    Result<image::Image> drawn = loaded->draw(drawnTime, stats);
    if (!drawn) return std::move(drawn.diagnostics);
    return use(*loaded);
}

/// A texture that the picture does not need is drawn for this.
Result<Picture> Scene::State::textureNamed(std::string_view name) {
    Result<scene::TextureView> view = scene::textureNamed(device.live->scene(), name);
    if (!view) return identified(std::move(view.diagnostics), "library-E02", path);
    const scene::Texture& texture = device.live->scene().textures[view->texture];
    const bool isCube = texture.target == scene::TextureTarget::cube;
    const std::optional<int> layers = scene::layersOf(texture, view->level.value_or(0));
    if (layers && view->layer.value_or(0) >= *layers)
        return diagnose("library-E02",
                        fmt::format("'{}': '{}' has {}", name, texture.name,
                                    base::counted(*layers, isCube ? "face" : "layer")),
                        {path.generic_string(), 1, 1});
    if (device.live->texture(view->texture) != nullptr) return pictureIn(device.live->numbersOf(*view));
    return drawnFor<Picture>(
        name, [&](render::SceneRenderer& drawn) { return pictureIn(drawn.textureNumbers(*view)); });
}

Result<Picture> Scene::target(std::string_view name) {
    return State::guarded<Picture>(state_.get(), [&]() -> Result<Picture> {
        if (!state_->isDrawn) return nothingDrawn();
        return name == "window" ? state_->readWindow(4, true) : state_->textureNamed(name);
    });
}

Result<BufferContent> Scene::State::bufferNamed(std::string_view name) {
    const scene::Scene& scene = device.live->scene();
    std::vector<std::string_view> names;
    for (const scene::BufferIndex index : scene.buffers.indices()) {
        names.push_back(scene.buffers[index].name);
        if (scene.buffers[index].name != name) continue;
        const gpu::Buffer* buffer = device.live->buffers().buffer({index});
        const plan::BufferLayout* layout = device.live->buffers().layout(index);
        const auto given = [](Result<render::BufferContent> content) -> Result<BufferContent> {
            if (!content) return std::move(content.diagnostics);
            return contentOf(std::move(*content));
        };
        if (buffer == nullptr || layout == nullptr)
            return drawnFor<BufferContent>(
                name, [&](render::SceneRenderer& drawn) { return given(drawn.bufferContent({index})); });
        return given(render::contentOf(*layout, *buffer));
    }
    return diagnose("library-E02",
                    fmt::format("the scene has no buffer '{}'{}", name, base::suggestion(name, names)),
                    {path.generic_string(), 1, 1});
}

Result<BufferContent> Scene::buffer(std::string_view name) {
    return State::guarded<BufferContent>(state_.get(), [&]() -> Result<BufferContent> {
        if (!state_->isDrawn) return nothingDrawn();
        return state_->bufferNamed(name);
    });
}

std::vector<double> BufferContent::numbers(const Column& column, std::uint64_t element, bool isOfHead) const {
    using enum plan::NumberKind;
    if (!isOfHead && element >= elements) return {};
    const std::size_t from = isOfHead ? 0 : headBytes + static_cast<std::size_t>(element) * stride;
    std::vector<double> all;
    for (const std::size_t each : column.offsets) {
        plan::MemoryNumber number{from + each, floating};
        for (const plan::NumberKind kind : {doublePrecision, integer, unsignedInteger, boolean})
            if (column.type == plan::wordOf(kind)) number.kind = kind;
        if (number.offset + plan::sizeOf(number.kind) > bytes.size()) return {};
        all.push_back(plan::readNumber(number, bytes));
    }
    return all;
}

const Diagnostics& Scene::diagnostics() const {
    static const Diagnostics kMovedFrom{movedFrom()};
    return state_ ? state_->diagnostics : kMovedFrom;
}

std::vector<std::filesystem::path> Scene::files() const {
    if (!state_) return {};
    return state_->device.live ? state_->device.live->files()
                               : std::vector<std::filesystem::path>{state_->path};
}

std::map<std::string, std::uint64_t> Scene::stats() const {
    if (!state_) return {};
    std::map<std::string, std::uint64_t> counts{{"frames", state_->frames}};
    if (state_->device.live)
        for (const render::Stats::Count& each : state_->device.live->drawStats().counts)
            counts[each.name] = each.value;
    return counts;
}

Result<void> Scene::reload() {
    return State::guarded<void>(state_.get(), [&] { return state_->load(); });
}

// Pictures and textures of a loaded scene that stay on the device, for a program that draws there itself.

namespace {

/// library-E08 in a context of the renderer's own, which the caller cannot draw in.
Diagnostics problemsOf(bool isAdopted) {
    if (isAdopted) return {};
    return {diagnose("library-E08",
                     "the renderer draws in a context of its own; open(Renderer::current()) adopts the "
                     "program's")};
}

/// A size of the surface and the one that an option asks for, 0 where nothing is said. False if they differ.
bool agree(int& surface, int option) {
    if (surface == 0) surface = option;
    return option == 0 || option == surface;
}

}  // namespace

Result<void> Scene::State::drawInto(const Surface& surface, DrawOptions wanted) {
    if (Diagnostics problems = problemsOf(renderer->isAdopted); !problems.empty()) return problems;
    int width = surface.width, height = surface.height;
    if (surface.texture != 0) {
        const Result<gpu::TextureSize> size = gpu::sizeOfForeign(surface.texture);
        if (!size) return size.diagnostics;
        if (width == 0) width = size->width;
        if (height == 0) height = size->height;
    }
    if (!agree(width, wanted.width) || !agree(height, wanted.height))
        return wrongOption(fmt::format("the options ask for {} x {} pixels, the surface for {} x {}",
                                       wanted.width, wanted.height, width, height));
    wanted.width = width;
    wanted.height = height;
    return drawn<void>(wanted, [&](const gpu::Target& target) -> Result<void> {
        const gpu::PixelRectangle part{surface.x, surface.y, target.width(), target.height()};
        return gpu::copyInto({surface.framebuffer, surface.texture, part}, target, !wanted.alpha);
    });
}

Result<void> Scene::drawInto(const Surface& surface, const DrawOptions& options) {
    Diagnostics problems = problemsOf(options);
    append(problems, outOfRange({{"surface.width", surface.width, kLargestPictureSide},
                                 {"surface.height", surface.height, kLargestPictureSide}}));
    if (!problems.empty()) return problems;
    return State::guarded<void>(state_.get(), [&] { return state_->drawInto(surface, options); });
}

Result<DeviceTexture> Scene::State::deviceTexture(std::string_view name) {
    if (Diagnostics problems = problemsOf(renderer->isAdopted); !problems.empty()) return problems;
    const Result<scene::TextureView> view = scene::textureNamed(device.live->scene(), name);
    if (!view) return identified(view.diagnostics, "library-E02", path);
    if (view->level || view->layer)
        return diagnose("library-E02", fmt::format("'{}' is a part of a texture, not one", name),
                        {path.generic_string(), 1, 1});
    const gpu::Texture* texture = device.live->completed(view->texture, view->isPrevious);
    if (texture == nullptr)
        return diagnose(
            "library-E07",
            fmt::format("texture '{}' is not on the device: nothing that the picture needs uses it", name),
            {path.generic_string(), 1, 1});
    const gpu::TextureSize& size = texture->size();
    return DeviceTexture{texture->id(),
                         gpu::glTarget(texture->shape()),
                         gpu::internalFormat(texture->format()),
                         size.width,
                         size.height,
                         size.depth,
                         texture->levels()};
}

Result<DeviceTexture> Scene::deviceTexture(std::string_view name) {
    return State::guarded<DeviceTexture>(state_.get(), [&]() -> Result<DeviceTexture> {
        if (!state_->isDrawn) return nothingDrawn();
        return state_->deviceTexture(name);
    });
}

}  // namespace glibra
