#include "page/runtime/runtime.h"

#include <glad/gl.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "base/text.h"
#include "gpu/context/context.h"
#include "gpu/object/framebuffer.h"
#include "render/draw/view_matrices.h"
#include "render/live/knobs.h"
#include "render/live/live_scene.h"
#include "render/load/device_textures.h"
#include "source/code_html.h"
#include "source/scene_head.h"
#include "system/web/page_files.h"

namespace glibra::page {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

/// What the page shows.
struct Shown {
    std::optional<gpu::Context> context;
    std::unique_ptr<render::LiveScene> live;
    std::vector<render::Knob> knobs;
    render::KeptValues kept;
    std::optional<gpu::Target> target;
    Diagnostics diagnostics;
    bool hasNews = false;  ///< diagnostics that no answer has had
    std::string scene, camera;
    double mouseX = .5, mouseY = .5;
    bool isMouseDown = false, isWireframe = false;
    bool isSet = true, mayLoop = true;  ///< since the last frame; since loops were watched
    std::chrono::steady_clock::time_point drawn{};
    std::string answer;
    Json around;  ///< surroundings() of the last frame
};

Shown& shown() {
    static auto* const all = new Shown;  // until the page ends
    return *all;
}

/// A text from glibra_memory(), which ends here.
std::string take(char* memory, std::size_t bytes) {
    std::string text(memory, bytes);
    std::free(memory);
    return text;
}

const char* answer(const Json& json) {
    shown().answer = json.dump(-1, ' ', false, Json::error_handler_t::replace);
    return shown().answer.c_str();
}

/// A file as the page names it.
std::string nameOf(const fs::path& file) {
    return file.empty() ? std::string() : system::nameInPage(file);
}

Json jsonOf(const Diagnostic& of) {
    Json json{{"severity", name(of.severity)}, {"id", of.id}, {"text", of.text}};
    if (!of.suggestion.empty()) json["suggestion"] = of.suggestion;
    if (of.place.file.empty()) return json;
    json["file"] = nameOf(of.place.file);
    json["line"] = of.place.line;
    json["column"] = of.place.column;
    return json;
}

/// All messages so far, if some of them are new.
void addMessages(Json& json, bool always = false) {
    if (!std::exchange(shown().hasNews, false) && !always) return;
    Json& all = json["messages"] = Json::array();
    for (const Diagnostic& each : shown().diagnostics) all.push_back(jsonOf(each));
}

/// Frames report the same again and again. A note about the same place replaces the earlier one, whose
/// numbers were for another size.
void note(Diagnostics diagnostics) {
    constexpr std::size_t kMost = 200;
    Diagnostics& known = shown().diagnostics;
    for (Diagnostic& each : diagnostics) {
        const auto same = std::ranges::find_if(known, [&](const Diagnostic& one) {
            return one.id == each.id && one.place == each.place &&
                   (one.text == each.text ||
                    (one.severity == Severity::note && each.severity == Severity::note));
        });
        if (same != known.end() ? same->text == each.text : known.size() == kMost) continue;
        if (same != known.end())
            same->text = std::move(each.text);
        else
            known.push_back(std::move(each));
        shown().hasNews = true;
    }
}

// ---- Opening

Json placed(const render::Knob& knob) {
    Json json = render::jsonOf(knob);
    json["file"] = nameOf(knob.place.file);
    json["line"] = knob.place.line;
    return json;
}

Json jsonOf(const scene::KeyBinding& key) {
    const std::string what = key.restarts            ? "begin the scene anew"
                             : key.isHeld            ? "hold to move " + key.variable
                             : key.values.size() > 1 ? "next value of " + key.variable
                                                     : "set " + key.variable;
    return {{"key", key.key}, {"what", what}, {"isHeld", key.isHeld}};
}

/// The scene, its shaders with what these include, then other files that it reads.
Json filesOf(const render::LiveScene& live) {
    Json files = Json::array();
    std::set<std::string> known;
    const auto add = [&](const fs::path& path, const std::string& role, bool isText) {
        const std::string name = nameOf(path);
        if (path.empty() || !known.insert(name).second) return;
        const bool isGlib = base::sameWord(path.extension().generic_string(), ".glib");
        files.push_back({{"name", name},
                         {"language", isGlib   ? "glib"
                                      : isText ? "glsl"
                                               : ""},
                         {"role", role}});
    };
    const scene::Scene& scene = live.scene();
    add(scene.path, "scene", true);
    for (const scene::Program& program : scene.programs)
        for (const scene::StageFile& each : program.stages)
            add(scene.files[each.file].path,
                std::string(glsl::stageName(each.stage)) + " shader of " + program.name, true);
    std::set<fs::path> data;
    for (const scene::FileReference& each : scene.files) data.insert(each.path);
    for (const fs::path& each : live.files())
        if (!data.contains(each)) add(each, "included", true);
    for (const fs::path& each : data) add(each, "", false);
    return files;
}

Json namesOf(const auto& all, const auto& nameOfEach) {
    Json names = Json::array();
    for (const auto& each : all) names.push_back(nameOfEach(each));
    return names;
}

void describe(Json& json) {
    const Shown& page = shown();
    const scene::Scene& scene = page.live->scene();
    const auto itself = [](const auto& each) { return Json(each); };
    const auto file = system::pageFiles().find(page.scene);
    json["summary"] = file == system::pageFiles().end() ? "" : source::headOf(file->second).summary;
    json["width"] = scene.width;
    json["height"] = scene.height;
    json["boxes"] = scene.messages;
    json["animated"] = page.live->isAnimated();
    json["readsMouse"] = page.live->readsMouse();
    json["hasSteps"] = !scene.steps.empty();
    double rate = 0;
    for (const auto& each : scene.steps) rate = std::max(rate, each.rate);
    json["stepRate"] = rate;
    json["files"] = filesOf(*page.live);
    json["missing"] = namesOf(page.live->missingFiles(), [](const fs::path& each) { return nameOf(each); });
    json["camera"] = page.camera;
    json["cameras"] = namesOf(page.live->cameras(), [](const scene::NamedCamera& each) { return each.name; });
    json["keys"] = namesOf(scene.keys, [](const scene::KeyBinding& each) { return jsonOf(each); });
    json["knobs"] = namesOf(page.knobs, [](const render::Knob& each) { return placed(each); });
    json["shared"] = namesOf(render::sharedKnobs(page.knobs), itself);
}

void lookThrough(const std::string& camera) {
    Shown& page = shown();
    const auto& cameras = page.live->cameras();
    const bool isKnown = std::ranges::find(cameras, camera, &scene::NamedCamera::name) != cameras.end();
    page.camera = isKnown ? camera : "";
    page.live->setCamera(page.camera);
}

RenderOptions options() {
    RenderOptions options;
    options.libraryRoots = {"/"};
    options.reader =
        std::make_shared<const FileReader>([](const fs::path& path) -> std::optional<std::string> {
            const auto file = system::pageFiles().find(system::nameInPage(path));
            if (file == system::pageFiles().end()) return std::nullopt;
            return file->second;
        });
    return options;
}

/// False if there is no scene, or it cannot be drawn at all: then the one before stays.
bool open(const std::string& name) {
    Shown& page = shown();
    page.diagnostics.clear();
    if (!page.context) {
        Result<gpu::Context> opened = gpu::openContext({.driver = gpu::Driver::gles});
        note(std::move(opened.diagnostics));
        if (!opened) return false;
        page.context.emplace(std::move(*opened));
    }
    if (page.live && page.scene != name) {
        page.live.reset();
        page.kept.forget();
        page.camera.clear();
    }
    render::LiveScene::Loading loading =
        render::LiveScene::load(*page.context, name, options(), page.live.get());
    note(std::move(loading.diagnostics));
    if (loading.isPreviousLost && !loading.scene) page.live.reset();
    if (!loading.scene) return false;
    if (page.live) page.kept.keep(page.live->scene(), page.knobs);
    page.live = std::move(loading.scene);
    page.scene = name;
    page.isSet = false;
    page.mayLoop = true;
    page.knobs = page.live->knobs();
    page.kept.restore(page.live->scene(), page.knobs);
    for (const render::Knob& each : page.knobs)
        if (each.isChanged()) page.live->setValue(each);
    page.live->setMouse(page.mouseX, page.mouseY, page.isMouseDown);
    if (page.isWireframe) page.live->drawer().setWireframe(true);
    lookThrough(std::string(page.camera));
    return true;
}

// ---- Changes

void setValue(std::size_t index, const std::vector<double>& values) {
    Shown& page = shown();
    if (index >= page.knobs.size()) return;
    render::Knob& knob = page.knobs[index];
    std::vector<double> wanted = knob.current;
    for (std::size_t i = 0; i < std::min(values.size(), wanted.size()); ++i) {
        if (!std::isfinite(static_cast<float>(values[i]))) return;
        wanted[i] = knob.isInteger() ? std::trunc(values[i]) : values[i];
    }
    if (wanted == knob.current) return;
    knob.current = std::move(wanted);
    page.live->setValue(knob);
    page.isSet = page.mayLoop = true;
    std::erase_if(page.diagnostics, [](const Diagnostic& each) { return each.id == "draw-W08"; });
    page.hasNews = true;
    note(page.live->longLoops());
}

/// The values of a variable after a press of the key, or after it was down for so long.
std::vector<double> valuesAfter(const scene::KeyBinding& key, const render::Knob& knob, double seconds) {
    if (!key.isHeld) {
        const auto now = std::ranges::find(key.values, knob.current);
        return now == key.values.end() || now + 1 == key.values.end() ? key.values.front() : *(now + 1);
    }
    std::vector<double> moved = knob.current;
    const std::vector<double>& aim = key.values.front();
    for (std::size_t i = 0; i < std::min(moved.size(), aim.size()); ++i) {
        moved[i] += (aim[i] - moved[i]) * seconds;
        // A value that the scene states outside of its range can come back into it.
        if (knob.widget == render::Widget::slider)
            moved[i] = std::clamp(moved[i], std::min(knob.minimum, knob.current[i]),
                                  std::max(knob.maximum, knob.current[i]));
    }
    return moved;
}

/// True if the key begins the scene anew.
bool press(std::string_view name, std::optional<double> secondsDown) {
    Shown& page = shown();
    bool restarts = false;
    const std::vector<scene::KeyBinding> keys = page.live->scene().keys;
    for (const scene::KeyBinding& key : keys) {
        if (!base::sameWord(key.key, name) || key.isHeld != secondsDown.has_value()) continue;
        restarts = restarts || key.restarts;
        for (std::size_t i = 0; i < page.knobs.size() && !key.values.empty(); ++i)
            if (!page.knobs[i].program && page.knobs[i].tag == key.variable)
                setValue(i, valuesAfter(key, page.knobs[i], secondsDown.value_or(0)));
    }
    return restarts;
}

void setKnob(std::size_t index, const std::vector<double>& values, bool movesShared) {
    setValue(index, values);
    if (!movesShared) return;
    for (const std::vector<std::size_t>& group : render::sharedKnobs(shown().knobs))
        if (std::ranges::find(group, index) != group.end())
            for (const std::size_t each : group) setValue(each, values);
}

void reset(int index) {
    Shown& page = shown();
    for (std::size_t i = 0; i < page.knobs.size(); ++i)
        if (index < 0 || i == static_cast<std::size_t>(index))
            setValue(i, std::vector<double>(page.knobs[i].initial));
    if (index < 0) page.kept.forget();
}

// ---- Drawing

ViewState viewOf(const Json& json) {
    ViewState view;
    view.scene = json.value("scene", kIdentity);
    view.eye = json.value("eye", kIdentity);
    view.texture = json.value("texture", kIdentity);
    const std::string projection = json.value("projection", "scene");
    view.projection = projection == "perspective"    ? ProjectionMode::perspective
                      : projection == "orthographic" ? ProjectionMode::orthographic
                                                     : ProjectionMode::scene;
    return view;
}

/// False if there is no memory for it.
bool makeTarget(int width, int height, int samples) {
    Shown& page = shown();
    samples = std::clamp(samples, 1, page.context->capabilities().maxSamples);
    const gpu::TexelFormat depth = render::depthFormat(page.live->scene().reversesWindow);
    if (page.target && page.target->width() == width && page.target->height() == height &&
        page.target->samples() == samples && page.target->depth()->format() == depth)
        return true;
    page.target.reset();
    Result<gpu::Target> made = gpu::Target::window(page.context->capabilities(), width, height,
                                                   gpu::TexelFormat::rgba8, samples, depth);
    note(std::move(made.diagnostics));
    page.target = std::move(made.value);
    return page.target.has_value();
}

void showTarget() {
    const gpu::Target& target = *shown().target;
    target.readable().bindForReading();
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, 0);
    glDisable(GL_SCISSOR_TEST);
    glBlitFramebuffer(0, 0, target.width(), target.height(), 0, 0, target.width(), target.height(),
                      GL_COLOR_BUFFER_BIT, GL_NEAREST);
}

/// What a drag of the mouse is computed with: the view of the camera without the transforms of the page, and
/// its projection. Null if the page's view moves nothing.
Json surroundings(const ViewState& view, double aspect) {
    const render::LiveScene& live = *shown().live;
    const scene::NodeList& frame = live.scene().frame;
    const scene::Draw* last = nullptr;
    for (const scene::Pass& pass : frame.passes) {
        if (!render::isMoved(frame, pass)) continue;
        for (const auto& step : pass.steps)
            if (const auto* each = std::get_if<scene::Draw>(&step))
                if (!std::holds_alternative<scene::ClipSpace>(*each->projection)) last = each;
    }
    if (last == nullptr) return nullptr;
    ViewState without;
    without.projection = view.projection;
    const render::ViewMatrices matrices(without, live.scene().view, live.eyeDistance());
    return {{"before", render::asNumbers(matrices.worldView())},
            {"projection", render::asNumbers(matrices.projection(*last->projection, aspect))}};
}

bool draw(const Json& frame, Json& answer) {
    Shown& page = shown();
    if (!makeTarget(frame.value("width", page.live->scene().width),
                    frame.value("height", page.live->scene().height), frame.value("samples", 1)))
        return false;
    if (const auto mouse = frame.find("mouse"); mouse != frame.end()) {
        page.mouseX = mouse->at(0);
        page.mouseY = mouse->at(1);
        page.isMouseDown = mouse->at(2).get<double>() != 0;
        page.live->setMouse(page.mouseX, page.mouseY, page.isMouseDown);
    }
    if (const bool wanted = frame.value("wireframe", false);
        std::exchange(page.isWireframe, wanted) != wanted)
        page.live->drawer().setWireframe(wanted);
    // Values that go on moving are not reported one by one. Loops may become long as time passes.
    const auto now = std::chrono::steady_clock::now();
    const bool isSlow = now - std::exchange(page.drawn, now) > std::chrono::seconds(1);
    const bool isSet = std::exchange(page.isSet, false);
    if ((isSlow || (!isSet && std::exchange(page.mayLoop, false))) && page.live->hasLoopsToWatch())
        page.live->watchLoops();
    const ViewState view = viewOf(frame.value("view", Json::object()));
    note(page.live->draw(*page.target, view, frame.value("time", 0.0), frame.value("axes", false)));
    showTarget();
    Json around = surroundings(view, static_cast<double>(page.target->width()) / page.target->height());
    if (around != page.around) answer["around"] = page.around = std::move(around);
    return true;
}

}  // namespace
}  // namespace glibra::page

using namespace glibra;
using namespace glibra::page;

char* glibra_memory(std::size_t bytes) {
    return static_cast<char*>(std::malloc(bytes > 0 ? bytes : 1));
}

void glibra_file(char* name, std::size_t nameBytes, char* content, std::size_t bytes) {
    std::string text = take(content, bytes);
    system::pageFiles()[system::nameInPage(take(name, nameBytes))] = std::move(text);
}

const char* glibra_open(char* scene, std::size_t bytes) {
    Json json{{"drawn", open(system::nameInPage(take(scene, bytes)))}};
    addMessages(json, true);
    if (json["drawn"]) describe(json);
    return answer(json);
}

const char* glibra_set(char* change, std::size_t bytes) {
    const Json asked = Json::parse(take(change, bytes), nullptr, false);
    Shown& page = shown();
    if (!page.live || !asked.is_object()) return answer(Json::object());
    const std::vector<render::Knob> before = page.knobs;
    bool restarts = asked.value("restart", false);
    if (asked.contains("knob"))
        setKnob(asked["knob"], asked.value("values", std::vector<double>()), asked.value("shared", false));
    if (asked.contains("reset")) reset(asked["reset"]);
    if (asked.contains("key"))
        restarts =
            press(asked["key"].get<std::string>(),
                  asked.contains("seconds") ? std::optional<double>(asked["seconds"]) : std::nullopt) ||
            restarts;
    if (asked.contains("camera")) lookThrough(asked["camera"]);
    if (restarts) page.live->restart();
    Json json = Json::object();
    addMessages(json);
    for (std::size_t i = 0; i < page.knobs.size(); ++i)
        if (page.knobs[i].current != before[i].current)
            json["knobs"].push_back({{"knob", i}, {"current", page.knobs[i].current}});
    json["animated"] = page.live->isAnimated();
    json["camera"] = page.camera;
    if (page.isSet && page.live->hasLoopsToWatch()) json["unsure"] = true;
    if (restarts) json["restart"] = true;
    return answer(json);
}

const char* glibra_draw(char* frame, std::size_t bytes) {
    const Json asked = Json::parse(take(frame, bytes), nullptr, false);
    Json json{{"drawn", false}};
    json["drawn"] = shown().live && asked.is_object() && draw(asked, json);
    addMessages(json);
    json["animated"] = shown().live && shown().live->isAnimated();
    return answer(json);
}

const char* glibra_colour(bool isScene, char* text, std::size_t bytes) {
    shown().answer = source::codeHtml(take(text, bytes),
                                      isScene ? source::CodeLanguage::glib : source::CodeLanguage::glsl);
    return shown().answer.c_str();
}
