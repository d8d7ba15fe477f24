// Cameras (language, 12.3).

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <string_view>

#include "base/matrices.h"
#include "base/number.h"
#include "base/suggest.h"
#include "base/text.h"
#include "expression/known_names.h"
#include "scene/modern/modern.h"
#include "scene/run/camera_use.h"
#include "scene/run/evaluate.h"
#include "scene/run/names.h"
#include "scene/run/scope.h"
#include "scene/view.h"

namespace glibra::scene {
namespace {

using Numbers = std::optional<std::vector<double>>;

/// The camera that a parameter of this name stands for; null if it is none.
const CameraName* cameraOfScope(const Interpreter& in, std::string_view name) {
    const Environment& names = in.names();
    const auto slot = names.findLocal(name);
    return slot && names.cameraOf(*slot) ? &*names.cameraOf(*slot) : nullptr;
}

/// True if the name means a camera here.
bool isCameraHere(const Interpreter& in, std::string_view name) {
    if (cameraOfScope(in, name) != nullptr) return true;
    if (in.names().findLocal(name)) return false;
    const DeclaredName* declared = declaredName(in, name);
    return name == "eye" || (declared != nullptr && declared->kind == DeclaredName::Kind::camera);
}

}  // namespace

void noteCameraDepends(Interpreter& in, const CameraName& name) {
    if (name.first == "eye") in.modern.usesEye = true;
    if (const auto* symbol = in.names().lookUpInScene(name.first + ".view"))
        addDepends(in, in.names().dependsOf(symbol->slot));
}

bool namesCamera(const Interpreter& in, const Value& value) {
    return value.kind == Value::Kind::word && value.path.size() < 2 && isCameraHere(in, headOf(value));
}

bool choosesCamera(Interpreter& in, const Value& value) {
    if (value.kind != Value::Kind::word || value.path.size() > 1 || namesCamera(in, value)) return false;
    const std::string& name = headOf(value);
    const std::string word = wordBehind(in, name);
    return word != name && isCameraHere(in, word);
}

std::optional<SceneCamera> cameraNamed(Interpreter& in, const Value& value) {
    const auto refuse = [&](const std::string& text, const char* id = "glib-E34") {
        return in.reportAt(value, id, text);
    };
    const glib::NamePart whole{value.text, {}};
    const glib::NamePart& first = value.path.empty() ? whole : value.path.front();
    const auto isCamera = [&](const std::string& name) {
        const auto known = in.modern.names.find(name);
        return known != in.modern.names.end() && known->second.kind == DeclaredName::Kind::camera;
    };
    CameraName name{wordBehind(in, first.name), 0};
    const bool isWord = name.first != first.name;  // of a counter, which hides a camera of its name
    if (!isWord || !isCamera(name.first)) name.first = isCamera(first.name) ? first.name : name.first;
    const bool isEye = name.first == "eye" && !isCamera("eye");
    if (value.path.size() > 1)
        return refuse(fmt::format("expected a camera, found '{}', which is a part of one", value.text));
    const CameraName* given = cameraOfScope(in, first.name);
    if (given == nullptr && isWord) given = cameraOfScope(in, name.first);
    if (given != nullptr) {
        if (!first.index.empty()) return refuse(fmt::format("'{}' is one camera, not an array", first.name));
        noteCameraDepends(in, *given);
        const SceneCamera* const found = findCamera(in, *given);
        return found != nullptr ? *found : classicCamera(in);
    }
    if (isEye && first.index.empty()) return classicCamera(in);
    if (in.modern.lostNames.contains(name.first)) return std::nullopt;
    if (!isCamera(name.first)) {
        std::vector<std::string_view> names{"eye"};
        for (const auto& [each, camera] : in.modern.cameras) names.push_back(each.first);
        return refuse(fmt::format("no camera '{}' is declared before this line{}", name.first,
                                  base::suggestion(name.first, names)),
                      "glib-E27");
    }
    const expression::Symbol* const symbol = in.names().lookUpInScene(name.first);
    const std::size_t count = symbol != nullptr ? symbol->count : 0;
    if (count == 0 && !first.index.empty())
        return refuse(fmt::format("'{}' is one camera, not an array", name.first));
    if (count > 0) {
        if (first.index.empty())
            return refuse(
                fmt::format("'{0}' is an array of cameras; write {0}[0] to {0}[{1}]", name.first, count - 1));
        const auto index = integerIn(in, first.index.front(), fmt::format("{}: the index", name.first), 0,
                                     static_cast<int>(count) - 1);
        if (!index) return std::nullopt;
        name.second = static_cast<std::size_t>(*index);
    }
    noteCameraDepends(in, name);
    const SceneCamera* found = findCamera(in, name);
    return found != nullptr ? std::optional(*found) : std::nullopt;  // a faulty one has been reported
}

namespace {

glm::dvec3 vectorAt(const std::vector<double>& numbers, std::size_t first) {
    return {numbers[first], numbers[first + 1], numbers[first + 2]};
}

void refuseCamera(Interpreter& in, const Command& command, std::string text) {
    in.reportAt(command, "glib-E29", "Camera: " + std::move(text));
}

std::span<const Value> afterName(const KeyedValues& key) {
    return std::span(key.values).subspan(1);
}

/// Reads Perspective, Ortho or Frustum. The box of Ortho is taken exactly.
bool readLens(Interpreter& in, const Command& command, SceneCamera& camera) {
    if (const KeyedValues* key = command.key("Perspective")) {
        const Numbers n = floatsOf(in, key->values, 3, "Camera: Perspective");
        if (!n) return false;
        const Perspective lens{(*n)[0], (*n)[1], (*n)[2]};
        if (!(lens.fieldOfView > 0 && lens.fieldOfView < 180 && lens.near > 0 && lens.far > lens.near)) {
            refuseCamera(in, command, "Perspective needs an angle between 0 and 180, and 0 < near < far");
            return false;
        }
        camera.projection = lens;
        if (const KeyedValues* aspect = command.key("aspect")) {
            const auto ratio = numberOf(in, aspect->values.front());
            if (!ratio) return false;
            if (!(*ratio > 0)) {
                in.reportAt(command, "glib-E05", "Camera: the aspect must be above 0");
                return false;
            }
            camera.aspect = *ratio;
        }
        return true;
    }
    const KeyedValues* ortho = command.key("Ortho");
    const KeyedValues* key = ortho != nullptr ? ortho : command.key("Frustum");
    if (key == nullptr) return false;
    const Numbers n = floatsOf(in, key->values, 6, ortho != nullptr ? "Camera: Ortho" : "Camera: Frustum");
    if (!n) return false;
    const bool isFlat = (*n)[0] == (*n)[1] || (*n)[2] == (*n)[3] || (*n)[4] == (*n)[5];
    if (isFlat || (ortho == nullptr && !((*n)[4] > 0 && (*n)[5] > 0))) {
        refuseCamera(
            in, command,
            "the volume of Ortho or Frustum is empty, or the near plane of Frustum is not in front of the "
            "eye");
        return false;
    }
    const auto make = ortho != nullptr ? base::boxProjection : base::frustumProjection;
    camera.projection = make((*n)[0], (*n)[1], (*n)[2], (*n)[3], (*n)[4], (*n)[5]);
    camera.near = (*n)[4];
    camera.far = (*n)[5];
    return true;
}

std::optional<SceneCamera> lookAtCamera(Interpreter& in, const Command& command, const KeyedValues& key) {
    const Numbers n = floatsOf(in, key.values, 9, "Camera: LookAt");
    if (!n) return std::nullopt;
    const auto view = viewingMatrix(vectorAt(*n, 0), vectorAt(*n, 3), vectorAt(*n, 6));
    if (!view) {
        refuseCamera(in, command, "the eye looks at itself, or up is parallel to the direction of view");
        return std::nullopt;
    }
    SceneCamera camera;
    camera.view = *view;
    return readLens(in, command, camera) ? std::optional(camera) : std::nullopt;
}

std::optional<SceneCamera> atAxes(Interpreter& in, const Command& command, const KeyedValues& key) {
    const KeyedValues* axes = command.key("Axes");
    const Numbers place = floatsOf(in, key.values, 3, "Camera: At");
    if (!place || axes == nullptr) return std::nullopt;
    const Numbers n = floatsOf(in, axes->values, 9, "Camera: Axes");
    if (!n) return std::nullopt;
    const glm::dmat4 frame(glm::dvec4(vectorAt(*n, 0), 0), glm::dvec4(vectorAt(*n, 3), 0),
                           glm::dvec4(vectorAt(*n, 6), 0), glm::dvec4(vectorAt(*place, 0), 1));
    if (isSingular(frame)) {
        refuseCamera(in, command, "the three axes lie in one plane");
        return std::nullopt;
    }
    SceneCamera camera;
    camera.view = inverseOrZero(frame);
    return readLens(in, command, camera) ? std::optional(camera) : std::nullopt;
}

std::optional<SceneCamera> reflected(Interpreter& in, const Command& command, const KeyedValues& key) {
    auto camera = cameraNamed(in, key.values.front());
    const Numbers n = floatsOf(in, afterName(key), 4, "Camera: Reflect");
    if (!camera || !n) return std::nullopt;
    const glm::dvec3 normal = vectorAt(*n, 0);
    if (glm::dot(normal, normal) == 0) {
        refuseCamera(in, command, "the plane of Reflect has no normal");
        return std::nullopt;
    }
    camera->view = camera->view * reflection(normal, (*n)[3]);
    camera->isMirrored = !camera->isMirrored;
    if (command.key("clip") == nullptr) return camera;
    // The plane in eye space, turned so that the eye is behind it.
    glm::dvec4 plane = glm::transpose(inverseOrZero(camera->view)) * glm::dvec4(normal, (*n)[3]);
    plane /= glm::length(glm::dvec3(plane));
    if (plane.w > 0) plane = -plane;
    camera->clip = plane;
    return camera;
}

std::optional<SceneCamera> shifted(Interpreter& in, const KeyedValues& key) {
    auto camera = cameraNamed(in, key.values.front());
    const Numbers n = floatsOf(in, afterName(key), 3, "Camera: Shift");
    if (!camera || !n) return std::nullopt;
    const glm::dmat4 shift = translation(-vectorAt(*n, 0));
    camera->view = shift * camera->view;
    camera->shift = shift * camera->shift;
    return camera;
}

std::optional<SceneCamera> ofFace(Interpreter& in, const Command& command, const KeyedValues& key) {
    const Numbers n = floatsOf(in, key.values, 6, "Camera: Face");
    if (!n) return std::nullopt;
    const double face = base::wholeNumber((*n)[0]).value, near = (*n)[4], far = (*n)[5];
    if (face < 0 || face > 5 || !(near > 0 && far > near)) {
        refuseCamera(in, command, "Face needs a face from 0 to 5, and 0 < near < far");
        return std::nullopt;
    }
    SceneCamera camera;
    camera.view = faceView(static_cast<int>(face), vectorAt(*n, 1));
    camera.projection = Perspective{90, near, far};
    camera.aspect = 1;
    return camera;
}

std::optional<SceneCamera> ofMatrices(Interpreter& in, const Command& command) {
    if (command.values.size() < 3) return std::nullopt;
    static constexpr expression::Type kMatrix[] = {expression::Type::matrix(4)};
    const auto view = evaluate(in, command.values[1], {.types = kMatrix});
    const auto projection = evaluate(in, command.values[2], {.types = kMatrix});
    if (!view || !projection || !fitFloats(in, command.values[1], view->all()) ||
        !fitFloats(in, command.values[2], projection->all()))
        return std::nullopt;
    SceneCamera camera;
    camera.view = view->mat4();
    camera.projection = projection->mat4();
    const Lens lens = lensOf(projection->mat4());
    camera.near = lens.near;
    camera.far = lens.far;
    return camera;
}

std::optional<SceneCamera> read(Interpreter& in, const Command& command) {
    if (const KeyedValues* key = command.key("LookAt")) return lookAtCamera(in, command, *key);
    if (const KeyedValues* key = command.key("At")) return atAxes(in, command, *key);
    if (const KeyedValues* key = command.key("Reflect")) return reflected(in, command, *key);
    if (const KeyedValues* key = command.key("Shift")) return shifted(in, *key);
    if (const KeyedValues* key = command.key("Face")) return ofFace(in, command, *key);
    return ofMatrices(in, command);
}

/// Gives expressions the values of the camera. Its aspect is that of the passes that it sees; if they differ,
/// it has no projection outside of them.
void publish(Interpreter& in, const SceneCamera& camera) {
    Environment& names = in.names();
    const auto& [name, element] = camera.name;
    const auto known = in.shared->seen.aspects.find(camera.name);
    const std::size_t aspects = known != in.shared->seen.aspects.end() ? known->second.size() : 0;
    const CameraValues values = valuesOf(camera, aspects > 0 ? *known->second.begin() : windowAspect(in));
    names.setCamera(name, values, element);
    const auto previous = in.shared->seen.previous.find(camera.name);
    names.setCamera(name + ".prev", previous != in.shared->seen.previous.end() ? previous->second : values,
                    element);
    if (aspects < 2 || !camera.followsTarget()) return;
    for (const char* field : {".projection", ".viewProjection", ".shadow", ".aspect"})
        names.forget(name + field, "the camera sees targets of different shapes, so write its aspect");
}

/// What the camera depends on passes to the expressions that read it, and to the passes that it sees.
void addCameraDepends(Interpreter& in, const std::string& name, expression::Depends depends) {
    for (const expression::NameRow& each : expression::cameraFields())
        for (const char* moment : {".", ".prev."})
            if (const auto* symbol = in.names().lookUpInScene(name + moment + std::string(each.path)))
                in.names().addDepends(symbol->slot, depends);
}

void declareCamera(Interpreter& in, const Command& command) {
    const Value& target = command.values.front();
    const std::string name = headOf(target);
    Environment& names = in.names();
    const bool isArray = !target.path.empty() && !target.path.front().index.empty();
    double count = 1;
    if (isArray) {
        const auto given = wholeOf(in, target.path.front().index.front());
        if (!given) return;
        count = *given;
        constexpr double kMostCameras = 256;
        if (!(count >= 1 && count <= kMostCameras))
            return refuseCamera(
                in, command,
                "the number in brackets is how many cameras the array has, 1 to 256; one "
                "statement declares them all, with i for the index: Camera side[6] Face (i) ...");
    }
    if (!declareName(in, command, name, DeclaredName::Kind::camera)) return;
    constexpr double kElementsPerCamera = 64;  // a camera takes as long as so many elements of an array
    if (isArray && !countElements(in, target, kElementsPerCamera * count)) return;
    names.declareCamera(name, isArray ? static_cast<std::size_t>(count) : 0);
    const InnerNames inner(in);
    const Environment::Slot counter = isArray ? names.bind("i", counterSymbol()) : Environment::Slot();
    for (double i = 0; i < count; ++i) {
        if (isArray) names.setNumber(counter, i);
        auto camera = read(in, command);
        if (!camera) return;
        camera->name = {name, static_cast<std::size_t>(i)};
        if (camera->root.first.empty()) camera->root = camera->name;
        publish(in, *camera);
        in.scene.usesLookAt = true;
        if (name == "eye" && !isArray) in.scene.view = camera->view;
        in.modern.cameras[camera->name] = std::move(*camera);
    }
}

void doCamera(Interpreter& in, const Command& command) {
    const DependsOnly own(in);
    declareCamera(in, command);
    const Value& target = command.values.front();
    addCameraDepends(in, headOf(target), own.depends());
}

/// All words of the statements but the names that Camera declares.
std::set<std::string, std::less<>> wordsIn(std::span<const Command> commands) {
    std::set<std::string, std::less<>> words;
    for (const Command& each : commands) {
        // This runs for every frame, and most statements of a long script are vertices of lists.
        if (each.values.empty() && each.keys.empty() && each.tags.empty()) continue;
        Command rest;
        rest.keys = each.keys;
        rest.tags = each.tags;
        rest.values = each.values;
        if (each.id == CommandId::camera && !rest.values.empty()) rest.values.erase(rest.values.begin());
        const std::string text = glib::written(rest);
        for (auto end = text.begin(); end != text.end();) {
            const auto begin = std::find_if(end, text.end(), base::isOfName);
            end = std::find_if_not(begin, text.end(), base::isOfName);
            if (begin != end) words.emplace(begin, end);
        }
    }
    return words;
}

}  // namespace

std::span<const CommandAction> cameraActions() {
    static constexpr CommandAction kActions[] = {{CommandId::camera, doCamera}};
    return kActions;
}

void reportUnusedCameras(Interpreter& in) {
    const auto& commands = in.script->commands;
    if (in.modern.cameras.empty() || findCamera(in, {"eye", 0}) != nullptr ||
        std::ranges::any_of(commands, [](const Command& each) { return each.id == CommandId::include; }))
        return;
    const std::set<std::string, std::less<>> words = wordsIn(commands);
    for (const auto& [name, camera] : in.modern.cameras) {
        if (name.second > 0 || words.contains(name.first)) continue;
        in.report(diagnose(
            "glib-W38", fmt::format("camera '{}' is not used; the camera 'eye' sees the window", name.first),
            in.modern.names.at(name.first).place));
    }
}

void reportLateEye(Interpreter& in) {
    const auto known = in.modern.names.find("eye");
    if (known == in.modern.names.end() || in.modern.usesEye || !in.modern.drawsClassicView) return;
    in.report(
        diagnose("glib-W41",
                 "Camera 'eye' stands after everything that is drawn, so nothing is seen by it; move it "
                 "up",
                 known->second.place));
}

}  // namespace glibra::scene
