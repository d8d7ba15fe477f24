// Which camera sees what is drawn, and what it decides.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <string_view>

#include "base/matrices.h"
#include "base/suggest.h"
#include "scene/camera.h"
#include "scene/matrices.h"
#include "scene/modern/evaluate.h"
#include "scene/modern/modern.h"
#include "scene/state.h"
#include "scene/view.h"

namespace glibra::scene {

void noteCameraDepends(Interpreter& in, const CameraName& name) {
    if (name.first == "eye") in.modern.usesEye = true;
    if (const auto* symbol = in.shared->environment.lookUpInScene(name.first + ".view"))
        addDepends(in, in.shared->environment.dependsOf(symbol->slot));
}

SceneCamera classicCamera(const Interpreter& in) {
    SceneCamera camera;
    camera.view = in.scene.view;
    camera.projection = in.state.projection;
    camera.name = camera.root = {"eye", 0};
    return camera;
}

namespace {

/// The camera that a parameter of this name stands for; null if it is none.
const CameraName* cameraOfScope(const Interpreter& in, std::string_view name) {
    const Environment& names = in.shared->environment;
    const auto slot = names.findLocal(name);
    return slot && names.cameraOf(*slot) ? &*names.cameraOf(*slot) : nullptr;
}

/// True if the name means a camera here.
bool isCameraHere(const Interpreter& in, std::string_view name) {
    if (cameraOfScope(in, name) != nullptr) return true;
    if (in.shared->environment.findLocal(name)) return false;
    const DeclaredName* declared = declaredName(in, name);
    return name == "eye" || (declared != nullptr && declared->kind == DeclaredName::Kind::camera);
}

}  // namespace

bool namesCamera(const Interpreter& in, const glib::Value& value) {
    return value.kind == glib::Value::Kind::word && value.path.size() < 2 &&
           isCameraHere(in, value.path.empty() ? value.text : value.path.front().name);
}

bool choosesCamera(Interpreter& in, const glib::Value& value) {
    if (value.kind != glib::Value::Kind::word || value.path.size() > 1 || namesCamera(in, value))
        return false;
    const std::string& name = value.path.empty() ? value.text : value.path.front().name;
    const std::string word = wordBehind(in, name);
    return word != name && isCameraHere(in, word);
}

std::optional<SceneCamera> cameraNamed(Interpreter& in, const glib::Value& value) {
    const auto refuse = [&](std::string text) {
        in.report(diagnose("glib-E27", std::move(text), in.script->place(value.position)));
        return std::nullopt;
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
    if (isLost(in, name.first)) return std::nullopt;
    if (!isCamera(name.first)) {
        std::vector<std::string_view> names{"eye"};
        for (const auto& [each, camera] : in.modern.cameras) names.push_back(each.first);
        return refuse(fmt::format("no camera '{}' is declared before this line{}", name.first,
                                  base::suggestion(name.first, names)));
    }
    const expression::Symbol* const symbol = in.shared->environment.lookUpInScene(name.first);
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

SceneCamera currentCamera(const Interpreter& in) {
    const SceneCamera* found = findCamera(in, in.around.pass ? in.around.pass->camera : CameraName{"eye", 0});
    return found != nullptr ? *found : classicCamera(in);
}

std::string textOf(const Interpreter& in, const CameraName& name) {
    const expression::Symbol* const symbol = in.shared->environment.lookUpInScene(name.first);
    const bool isArray = symbol != nullptr && symbol->count > 0;
    return isArray ? fmt::format("{}[{}]", name.first, name.second) : name.first;
}

double currentAspect(const Interpreter& in) {
    if (in.around.pass) return in.around.pass->aspect;
    const TargetList& target = in.state.target;
    return target.units.empty() ? windowAspect(in) : static_cast<double>(target.width) / target.height;
}

CameraValues valuesOf(const SceneCamera& camera, double aspect) {
    CameraValues values;
    values.view = camera.view;
    values.aspect = camera.aspect.value_or(aspect);
    values.projection = projectionOf(camera, values.aspect);
    if (const auto* lens = std::get_if<Perspective>(&camera.projection)) {
        values.near = lens->near;
        values.far = lens->far;
        values.fieldOfView = lens->fieldOfView;
    } else {
        values.near = camera.near;
        values.far = camera.far;
        values.fieldOfView = lensOf(projectionMatrix(camera.projection, values.aspect)).fieldOfView;
    }
    return values;
}

void setPrevious(Interpreter& in, std::string_view name, const CameraName& camera, const CameraValues& now) {
    const auto known = in.shared->seen.previous.find(camera);
    in.shared->environment.setCamera(std::string(name) + ".prev",
                                     known != in.shared->seen.previous.end() ? known->second : now);
}

glm::dmat4 projectionOf(const SceneCamera& camera, double aspect) {
    const glm::dmat4 projection = projectionMatrix(camera.projection, camera.aspect.value_or(aspect));
    return camera.clip ? withNearPlane(projection, *camera.clip) : projection;
}

void noteAspect(Interpreter& in, const SceneCamera& camera, double aspect) {
    if (camera.followsTarget()) in.shared->seen.foundAspects[camera.name].insert(aspect);
}

ClipSpace coveringSpace(Interpreter& in, double aspect) {
    const SceneCamera camera = currentCamera(in);
    if (camera.name.first == "eye" && findCamera(in, camera.name) != nullptr) in.modern.usesEye = true;
    ClipSpace space;
    space.view = camera.view;
    if (camera.clip || camera.aspect)
        space.projection = projectionOf(camera, aspect);
    else if (const auto* perspective = std::get_if<Perspective>(&camera.projection))
        space.projection = *perspective;
    else if (const auto* box = std::get_if<Orthographic>(&camera.projection))
        space.projection = *box;
    else if (const auto* matrix = std::get_if<glm::dmat4>(&camera.projection))
        space.projection = *matrix;
    return space;
}

void lookAt(Interpreter& in, Draw& draw) {
    const SceneCamera* camera =
        findCamera(in, in.around.pass ? in.around.pass->camera : CameraName{"eye", 0});
    draw.model = in.state.model;
    if (camera == nullptr || camera->name.first == "eye")
        (camera == nullptr ? in.modern.drawsClassicView : in.modern.usesEye) = true;
    if (camera == nullptr) {
        draw.modelView = in.state.modelView;
        draw.projection = in.state.projection;
        return;
    }
    const double aspect = currentAspect(in);
    if (!in.around.pass) noteAspect(in, *camera, aspect);
    draw.modelView = camera->view * in.state.model;
    if (camera->clip || camera->aspect)
        draw.projection = projectionOf(*camera, aspect);
    else
        draw.projection = camera->projection;
    if (camera->isMirrored)
        draw.raster.front = draw.raster.front == base::Winding::ccw ? base::Winding::cw : base::Winding::ccw;
}

}  // namespace glibra::scene
