// Cameras (language, 12.3).

#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <string>

#include "base/matrices.h"
#include "base/suggest.h"
#include "scene/camera.h"
#include "scene/matrices.h"
#include "scene/modern/evaluate.h"
#include "scene/modern/modern.h"
#include "scene/state.h"
#include "scene/view.h"

namespace glibra::scene {
namespace {

using glib::Command;
using glib::CommandId;
using glib::KeyedValues;
using Numbers = std::optional<std::vector<double>>;

glm::dvec3 vectorAt(const std::vector<double>& numbers, std::size_t first) {
    return {numbers[first], numbers[first + 1], numbers[first + 2]};
}

void refuse(Interpreter& in, const Command& command, std::string text) {
    in.reportAt(command, "glib-E29", "Camera: " + std::move(text));
}

/// The camera that another one is made from.
std::optional<SceneCamera> otherCamera(Interpreter& in, const KeyedValues& key) {
    const std::string& name = key.values.front().text;
    if (const SceneCamera* known = findCamera(in, name)) return *known;
    std::vector<std::string_view> names{"eye"};
    for (const auto& [each, camera] : in.modern.cameras) names.push_back(each);
    in.report(diagnose(
        "glib-E27",
        fmt::format("no camera '{}' is declared before this line{}", name, base::suggestion(name, names)),
        in.script->place(key.values.front().position)));
    return std::nullopt;
}

std::span<const glib::Value> afterName(const KeyedValues& key) {
    return std::span(key.values).subspan(1);
}

/// Reads Perspective, Ortho or Frustum. The box of Ortho is taken exactly.
bool readLens(Interpreter& in, const Command& command, SceneCamera& camera) {
    if (const KeyedValues* key = command.key("Perspective")) {
        const Numbers n = numbersOf(in, key->values, 3, "Camera: Perspective");
        if (!n) return false;
        const Perspective lens{(*n)[0], (*n)[1], (*n)[2]};
        if (!(lens.fieldOfView > 0 && lens.fieldOfView < 180 && lens.near > 0 && lens.far > lens.near)) {
            refuse(in, command, "Perspective needs an angle between 0 and 180, and 0 < near < far");
            return false;
        }
        camera.projection = lens;
        if (const KeyedValues* aspect = command.key("aspect")) {
            const auto ratio = numberOf(in, aspect->values.front());
            if (!ratio) return false;
            if (!(*ratio > 0)) {
                refuse(in, command, "the aspect must be above 0");
                return false;
            }
            camera.aspect = *ratio;
        }
        return true;
    }
    const KeyedValues* ortho = command.key("Ortho");
    const KeyedValues* key = ortho != nullptr ? ortho : command.key("Frustum");
    if (key == nullptr) return false;
    const Numbers n = numbersOf(in, key->values, 6, ortho != nullptr ? "Camera: Ortho" : "Camera: Frustum");
    if (!n) return false;
    const bool isFlat = (*n)[0] == (*n)[1] || (*n)[2] == (*n)[3] || (*n)[4] == (*n)[5];
    if (isFlat || (ortho == nullptr && !((*n)[4] > 0 && (*n)[5] > 0))) {
        refuse(in, command, "the volume of Ortho or Frustum is empty, or Frustum begins behind the eye");
        return false;
    }
    const auto make = ortho != nullptr ? base::boxProjection : base::frustumProjection;
    camera.projection = make((*n)[0], (*n)[1], (*n)[2], (*n)[3], (*n)[4], (*n)[5]);
    camera.near = (*n)[4];
    camera.far = (*n)[5];
    return true;
}

std::optional<SceneCamera> lookAt(Interpreter& in, const Command& command, const KeyedValues& key) {
    const Numbers n = numbersOf(in, key.values, 9, "Camera: LookAt");
    if (!n) return std::nullopt;
    const auto view = viewingMatrix(vectorAt(*n, 0), vectorAt(*n, 3), vectorAt(*n, 6));
    if (!view) {
        refuse(in, command, "the eye looks at itself, or up is parallel to the direction of view");
        return std::nullopt;
    }
    SceneCamera camera;
    camera.view = *view;
    return readLens(in, command, camera) ? std::optional(camera) : std::nullopt;
}

std::optional<SceneCamera> atAxes(Interpreter& in, const Command& command, const KeyedValues& key) {
    const KeyedValues* axes = command.key("Axes");
    const Numbers place = numbersOf(in, key.values, 3, "Camera: At");
    if (!place || axes == nullptr) return std::nullopt;
    const Numbers n = numbersOf(in, axes->values, 9, "Camera: Axes");
    if (!n) return std::nullopt;
    const glm::dmat4 frame(glm::dvec4(vectorAt(*n, 0), 0), glm::dvec4(vectorAt(*n, 3), 0),
                           glm::dvec4(vectorAt(*n, 6), 0), glm::dvec4(vectorAt(*place, 0), 1));
    if (isSingular(frame)) {
        refuse(in, command, "the three axes lie in one plane");
        return std::nullopt;
    }
    SceneCamera camera;
    camera.view = inverseOrZero(frame);
    return readLens(in, command, camera) ? std::optional(camera) : std::nullopt;
}

std::optional<SceneCamera> reflected(Interpreter& in, const Command& command, const KeyedValues& key) {
    auto camera = otherCamera(in, key);
    const Numbers n = numbersOf(in, afterName(key), 4, "Camera: Reflect");
    if (!camera || !n) return std::nullopt;
    const glm::dvec3 normal = vectorAt(*n, 0);
    if (glm::dot(normal, normal) == 0) {
        refuse(in, command, "the plane of Reflect has no normal");
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
    auto camera = otherCamera(in, key);
    const Numbers n = numbersOf(in, afterName(key), 3, "Camera: Shift");
    if (!camera || !n) return std::nullopt;
    camera->view = translation(-vectorAt(*n, 0)) * camera->view;
    return camera;
}

std::optional<SceneCamera> ofFace(Interpreter& in, const Command& command, const KeyedValues& key) {
    const Numbers n = numbersOf(in, key.values, 6, "Camera: Face");
    if (!n) return std::nullopt;
    const double face = std::trunc((*n)[0]), near = (*n)[4], far = (*n)[5];
    if (face < 0 || face > 5 || !(near > 0 && far > near)) {
        refuse(in, command, "Face needs a face from 0 to 5, and 0 < near < far");
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
    if (!view || !projection) return std::nullopt;
    SceneCamera camera;
    camera.view = view->mat4();
    camera.projection = projection->mat4();
    return camera;
}

std::optional<SceneCamera> read(Interpreter& in, const Command& command) {
    if (const KeyedValues* key = command.key("LookAt")) return lookAt(in, command, *key);
    if (const KeyedValues* key = command.key("At")) return atAxes(in, command, *key);
    if (const KeyedValues* key = command.key("Reflect")) return reflected(in, command, *key);
    if (const KeyedValues* key = command.key("Shift")) return shifted(in, *key);
    if (const KeyedValues* key = command.key("Face")) return ofFace(in, command, *key);
    return ofMatrices(in, command);
}

void doCamera(Interpreter& in, const Command& command) {
    const glib::Value& target = command.values.front();
    const std::string name = target.path.empty() ? target.text : target.path.front().name;
    Environment& names = in.shared->environment;
    const bool isArray = !target.path.empty() && !target.path.front().index.empty();
    double count = 1;
    if (isArray) {
        const auto given = numberOf(in, target.path.front().index.front());
        if (!given) return;
        count = std::trunc(*given);
        constexpr double kMostCameras = 256;
        if (!(count >= 1 && count <= kMostCameras))
            return refuse(in, command, "an array has 1 to 256 cameras");
    }
    names.declareCamera(name, isArray ? static_cast<std::size_t>(count) : 0);
    for (double i = 0; i < count; ++i) {
        names.beginScope();
        if (isArray) {
            expression::Symbol symbol;
            symbol.depends = expression::Depends::counter;
            names.set(names.declareScoped(&command, "i", symbol), {&i, 1});
        }
        const auto camera = read(in, command);
        names.endScope();
        if (!camera) return;
        in.modern.cameras[isArray ? fmt::format("{}[{}]", name, i) : name] = *camera;
        names.setCamera(name, valuesOf(in, *camera), static_cast<std::size_t>(i));
        if (name == "eye" && !isArray) {
            in.scene.usesLookAt = true;
            in.scene.view = camera->view;
        }
    }
}

constexpr CommandAction kActions[] = {{CommandId::camera, doCamera}};

}  // namespace

std::span<const CommandAction> cameraActions() {
    return kActions;
}

const SceneCamera* findCamera(const Interpreter& in, std::string_view name) {
    const auto known = in.modern.cameras.find(name);
    return known != in.modern.cameras.end() ? &known->second : nullptr;
}

CameraValues valuesOf(const Interpreter& in, const SceneCamera& camera) {
    CameraValues values;
    values.view = camera.view;
    values.aspect = camera.aspect.value_or(windowAspect(in));
    values.projection = projectionOf(camera, values.aspect);
    if (const auto* lens = std::get_if<Perspective>(&camera.projection)) {
        values.near = lens->near;
        values.far = lens->far;
        values.fieldOfView = lens->fieldOfView;
    } else {
        values.near = camera.near;
        values.far = camera.far;
    }
    return values;
}

glm::dmat4 projectionOf(const SceneCamera& camera, double aspect) {
    const glm::dmat4 projection = projectionMatrix(camera.projection, camera.aspect.value_or(aspect));
    return camera.clip ? withNearPlane(projection, *camera.clip) : projection;
}

}  // namespace glibra::scene
