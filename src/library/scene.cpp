#include <glibra/scene.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "base/device_lost.h"
#include "base/suggest.h"
#include "base/text.h"
#include "gpu/object/readback.h"
#include "image/image.h"
#include "library/renderer_state.h"
#include "plan/buffer_table.h"
#include "render/check/run_checks.h"
#include "render/consequences.h"
#include "render/load/device_scene.h"
#include "render/scene_renderer.h"
#include "scene/texture_name.h"
#include "scene/texture_parts.h"
#include "suite/options/option_table.h"

namespace glibra {
namespace {

Diagnostics problemsOf(const DrawOptions& options) {
    Diagnostics found = outOfRange({{"width", options.width, kLargestPictureSide},
                                    {"height", options.height, kLargestPictureSide},
                                    {"samples", options.samples, suite::kMostSamples}});
    if (!std::isfinite(options.time))
        found.push_back(wrongOption(fmt::format("time: {} is not a finite number of seconds", options.time)));
    return found;
}

std::string typeOf(const view::Knob& knob) {
    if (!knob.words.empty()) return "choice";
    if (!knob.type.word.empty()) return knob.type.word;
    const std::size_t count = knob.initial.size();
    if (knob.type.base == plan::BaseType::boolean) return "bool";
    return count == 1 ? "float" : fmt::format("vec{}", count);
}

/// What is wrong with these numbers for the value; empty if nothing is.
std::string whyNot(const view::Knob& knob, std::span<const double> values) {
    if (values.size() != knob.initial.size())
        return fmt::format("'{}' takes {}, found {}", knob.tag, base::counted(knob.initial.size(), "number"),
                           values.size());
    for (const double each : values) {
        if (!std::isfinite(each)) return fmt::format("'{}': {} is not a finite number", knob.tag, each);
        if (!knob.words.empty() &&
            (each < 0 || each >= static_cast<double>(knob.words.size()) || each != std::floor(each)))
            return fmt::format("'{}': {} is not the number of a word, 0 to {}", knob.tag, each,
                               knob.words.size() - 1);
        if (knob.isInteger() && each != std::floor(each))
            return fmt::format("'{}' takes whole numbers, found {}", knob.tag, each);
        if (knob.type.base == plan::BaseType::boolean && each != 0 && each != 1)
            return fmt::format("'{}' is true (1) or false (0), found {}", knob.tag, each);
    }
    return {};
}

/// A column of the library's table; the kinds of its numbers are those of the memory.
BufferContent::Column columnOf(const plan::BufferColumn& from, const std::vector<plan::MemoryNumber>& kinds) {
    BufferContent::Column to;
    to.name = from.name;
    to.count = from.count;
    if (from.first >= kinds.size()) return to;
    const plan::MemoryNumber& first = kinds[from.first];
    to.offset = static_cast<std::size_t>(first.offset);
    to.type = plan::wordOf(first.kind);
    return to;
}

Result<Picture> pictureIn(Result<image::Image> image) {
    if (!image) return std::move(image.diagnostics);
    return pictureOf(std::move(*image));
}

}  // namespace

Scene::Scene(std::unique_ptr<State> state) : state_(std::move(state)) {}
Scene::Scene(Scene&&) noexcept = default;
Scene& Scene::operator=(Scene&&) noexcept = default;
Scene::~Scene() = default;

Result<void> Scene::State::load() {
    // Nothing moves from the scene as it is into one that may turn out to be faulty.
    view::LiveScene::Loading loading = view::LiveScene::load(*renderer->context, path, options, nullptr);
    render::applyStrict(loading.diagnostics, options.strict);
    if (!loading.scene || hasError(loading.diagnostics)) return std::move(loading.diagnostics);
    device = OnDevice{std::move(loading.scene), {}};
    {
        const std::lock_guard<std::mutex> lock(renderer->mutex);
        renderer->scenes.insert(this);
    }
    diagnostics = std::move(loading.diagnostics);
    device.live->keepTextures(diagnostics);
    isDrawn = false;
    for (const view::Knob& each : std::exchange(changed, {})) {
        const std::vector<view::Knob> now = device.live->knobs();
        const auto same = std::find_if(now.begin(), now.end(), [&](const view::Knob& one) {
            return one.tag == each.tag && one.title == each.title &&
                   one.initial.size() == each.current.size();
        });
        if (same == now.end()) continue;
        view::Knob knob = *same;
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

template <class T, class Work>
Result<T> Scene::State::guarded(const Work& work) {
    try {
        if (Diagnostics problems = begin(); !problems.empty()) return problems;
        return work();
    } catch (const base::DeviceLost& lost) {
        renderer->lose();
        return base::diagnosticOf(lost, path.string());
    }
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
    if (device.window && device.window->width == width && device.window->height == height &&
        device.window->samples == wanted.samples && device.window->isFloat == wanted.floatPixels)
        return &device.window->target;
    device.window.reset();
    isDrawn = false;
    Result<gpu::Target> made = gpu::Target::window(
        capabilities, width, height, wanted.floatPixels ? gpu::TexelFormat::rgba32f : gpu::TexelFormat::rgba8,
        std::max(1, wanted.samples), render::depthFormat(device.live->scene()));
    if (!made) return std::move(made.diagnostics);
    device.window.emplace(SceneWindow{width, height, wanted.samples, wanted.floatPixels, std::move(*made)});
    return {&device.window->target, std::move(made.diagnostics)};
}

Result<Picture> Scene::State::draw(const DrawOptions& wanted) {
    Result<const gpu::Target*> target = targetFor(wanted);
    if (!target) return std::move(target.diagnostics);
    Diagnostics found = device.live->draw(**target, wanted.view, wanted.time, false);
    Result<Picture> picture = readWindow(wanted.alpha ? 4 : 3, wanted.floatPixels);
    append(found, std::move(picture.diagnostics));
    render::applyStrict(found, options.strict);
    isDrawn = picture && !hasError(found);
    drawnTime = wanted.time;
    drawnView = wanted.view;
    if (!isDrawn) return found;
    ++frames;
    return {std::move(*picture), std::move(found)};
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
    return state_->guarded<Picture>([&] { return state_->draw(options); });
}

/// With the values that have been set.
std::vector<view::Knob> Scene::State::knobs() const {
    std::vector<view::Knob> all = device.live->knobs();
    for (view::Knob& each : all)
        for (const view::Knob& set : changed)
            if (each.tag == set.tag && each.program == set.program) {
                each.current = set.current;
                each.initial = set.initial;  // a plan knows only the present value
            }
    return all;
}

std::vector<std::string> Scene::State::settings() const {
    std::vector<std::string> all;
    for (const view::Knob& each : changed)
        all.push_back(view::setArgument(device.live->scene(), each, device.live->knobs()));
    return all;
}

std::vector<Value> Scene::values() const {
    Result<std::vector<view::Knob>> knobs = state_->guarded<std::vector<view::Knob>>(
        [&]() -> Result<std::vector<view::Knob>> { return state_->knobs(); });
    if (!knobs) return {};
    std::vector<Value> values;
    for (const view::Knob& knob : *knobs) {
        Value& to = values.emplace_back();
        to.name = knob.tag;
        if (knob.program) to.program = state_->device.live->scene().programs[knob.program].name;
        to.type = typeOf(knob);
        to.value = knob.current;
        to.initial = knob.initial;
        to.hasRange = knob.form == glib::UniformForm::range;
        to.minimum = knob.minimum;
        to.maximum = knob.maximum;
        to.words = knob.words;
        to.place = knob.place;
    }
    return values;
}

Result<void> Scene::State::set(std::string_view name, std::span<const double> values, std::string_view text) {
    // A text is read as the command line reads it, which knows lines, programs, words and numbers.
    std::string_view tag = name;
    std::string program;
    if (const std::size_t colon = name.find(':'); colon != std::string_view::npos) {
        program = name.substr(0, colon);
        tag = name.substr(colon + 1);
    }
    const scene::Scene& scene = device.live->scene();
    std::vector<view::Knob> all = knobs();
    const auto isMeant = [&](const view::Knob& knob) {
        if (knob.tag == tag && program.empty()) return true;
        if (!knob.program) return false;
        const scene::Program& of = scene.programs[knob.program];
        if (knob.tag == tag && (of.name == program || std::to_string(of.place.line) == program)) return true;
        return program.empty() && tag == of.name + "." + knob.tag;
    };
    std::vector<view::Knob> meant;
    std::ranges::copy_if(all, std::back_inserter(meant), isMeant);
    if (meant.empty()) {
        std::vector<std::string_view> names;
        for (const view::Knob& each : all) names.push_back(each.tag);
        return diagnose("library-E02",
                        fmt::format("the scene has no value '{}'{}", name, base::suggestion(name, names)),
                        {path.string(), 1, 1});
    }
    std::vector<double> read(values.begin(), values.end());
    if (values.empty()) {
        const auto& words = meant.front().words;
        if (const auto word = std::ranges::find(words, text); word != words.end()) {
            read = {static_cast<double>(word - words.begin())};
        } else {
            Result<plan::Override> parsed =
                plan::parseOverride(fmt::format("{}={}", meant.front().tag, text));
            if (!parsed || !parsed->word.empty())
                return diagnose("library-E03",
                                words.empty() ? fmt::format("'{}': expected numbers, found '{}'", tag, text)
                                              : fmt::format("'{}': expected one of {}, found '{}'", tag,
                                                            fmt::join(words, ", "), text),
                                {path.string(), 1, 1});
            read = parsed->values;
        }
    }
    for (const view::Knob& each : meant)
        if (const std::string why = whyNot(each, read); !why.empty())
            return diagnose("library-E03", why, each.place);
    for (view::Knob& each : meant) {
        each.current = read;
        device.live->setValue(each);
        std::erase_if(changed, [&](const view::Knob& one) {
            return one.tag == each.tag && one.program == each.program;
        });
        changed.push_back(std::move(each));
    }
    return {};
}

Result<void> Scene::set(std::string_view name, double value) {
    return set(name, std::span<const double>(&value, 1));
}
Result<void> Scene::set(std::string_view name, int value) {
    return set(name, static_cast<double>(value));
}
Result<void> Scene::set(std::string_view name, bool value) {
    return set(name, value ? 1. : 0.);
}
Result<void> Scene::set(std::string_view name, std::initializer_list<double> values) {
    return set(name, std::span<const double>(values.begin(), values.size()));
}

Result<void> Scene::set(std::string_view name, std::span<const double> values) {
    if (values.empty()) return diagnose("library-E03", fmt::format("'{}': no numbers", name));
    return state_->guarded<void>([&] { return state_->set(name, values, {}); });
}

Result<void> Scene::set(std::string_view name, std::string_view text) {
    return state_->guarded<void>([&] { return state_->set(name, {}, text); });
}

Diagnostics Scene::check(double time) {
    if (!std::isfinite(time)) return {wrongOption("time: not a finite number of seconds")};
    Result<void> answered = state_->guarded<void>([&]() -> Result<void> {
        RenderOptions options = state_->options;
        options.time = time;
        options.set = state_->settings();
        return render::runChecks(*state_->renderer->context, state_->path, options, {});
    });
    std::erase_if(answered.diagnostics,
                  [](const Diagnostic& each) { return each.severity != Severity::error; });
    return std::move(answered.diagnostics);
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
                        {path.string(), 1, 1});
    if (device.live->texture(view->texture) != nullptr) return pictureIn(device.live->imageOf(*view));
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
    Result<image::Image> drawn = loaded->draw(drawnTime, stats);
    if (!drawn) return std::move(drawn.diagnostics);
    return pictureIn(loaded->textureImage(*view));
}

Result<Picture> Scene::target(std::string_view name) {
    return state_->guarded<Picture>([&]() -> Result<Picture> {
        if (!state_->isDrawn) return diagnose("library-E04", "no picture has been drawn yet");
        return name == "window" ? state_->readWindow(4, true) : state_->textureNamed(name);
    });
}

Result<BufferContent> Scene::buffer(std::string_view name) {
    return state_->guarded<BufferContent>([&]() -> Result<BufferContent> {
        const scene::Scene& scene = state_->device.live->scene();
        std::vector<std::string_view> names;
        for (const scene::BufferIndex index : scene.buffers.indices()) {
            names.push_back(scene.buffers[index].name);
            if (scene.buffers[index].name != name) continue;
            const gpu::Buffer* buffer = state_->device.live->buffers().buffer({index});
            const plan::BufferLayout* layout = state_->device.live->buffers().layout(index);
            if (buffer == nullptr || layout == nullptr)
                return diagnose("library-E04", fmt::format("buffer '{}' is not used by the picture", name),
                                scene.buffers[index].place);
            BufferContent content;
            content.bytes.resize(static_cast<std::size_t>(layout->bytes));
            buffer->read(0, content.bytes);
            const plan::BufferTable table = plan::tableOf(*layout, state_->device.live->blockOf(index),
                                                          std::numeric_limits<std::size_t>::max());
            for (const plan::BufferColumn& each : table.head)
                content.head.push_back(columnOf(each, layout->pattern.head));
            for (const plan::BufferColumn& each : table.columns)
                content.columns.push_back(columnOf(each, layout->pattern.element));
            content.headBytes = static_cast<std::size_t>(layout->pattern.elementsAt);
            content.stride = static_cast<std::size_t>(layout->pattern.stride);
            content.elements = layout->elements;
            return content;
        }
        return diagnose("library-E02",
                        fmt::format("the scene has no buffer '{}'{}", name, base::suggestion(name, names)),
                        {state_->path.string(), 1, 1});
    });
}

const Diagnostics& Scene::diagnostics() const {
    return state_->diagnostics;
}

std::vector<std::filesystem::path> Scene::files() const {
    return state_->device.live ? state_->device.live->files()
                               : std::vector<std::filesystem::path>{state_->path};
}

std::map<std::string, std::uint64_t> Scene::stats() const {
    std::map<std::string, std::uint64_t> counts{{"frames", state_->frames}};
    if (state_->device.live)
        for (const render::Stats::Count& each : state_->device.live->drawStats().counts)
            counts[each.name] = each.value;
    return counts;
}

Result<void> Scene::reload() {
    return state_->guarded<void>([&] { return state_->load(); });
}

}  // namespace glibra
