#include "scene/run/camera_use.h"

#include <fmt/format.h>

namespace glibra::scene {

const SceneCamera* findCamera(const Interpreter& in, const CameraName& name) {
    const auto known = in.modern.cameras.find(name);
    return known != in.modern.cameras.end() ? &known->second : nullptr;
}

SceneCamera classicCamera(const Interpreter& in) {
    SceneCamera camera;
    camera.view = in.scene.view;
    camera.projection = in.state.projection;
    camera.name = camera.root = {"eye", 0};
    return camera;
}

SceneCamera currentCamera(const Interpreter& in) {
    const SceneCamera* found = findCamera(in, in.around.pass ? in.around.pass->camera : CameraName{"eye", 0});
    return found != nullptr ? *found : classicCamera(in);
}

std::string textOf(const Interpreter& in, const CameraName& name) {
    const expression::Symbol* const symbol = in.names().lookUpInScene(name.first);
    const bool isArray = symbol != nullptr && symbol->count > 0;
    return isArray ? fmt::format("{}[{}]", name.first, name.second) : name.first;
}

double windowAspect(const Interpreter& in) {
    const int width = in.inputs.width > 0 ? in.inputs.width : in.scene.width;
    const int height = in.inputs.height > 0 ? in.inputs.height : in.scene.height;
    return static_cast<double>(width) / height;
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
    in.names().setCamera(std::string(name) + ".prev",
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
    space.hasStage = true;
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

void shareProjection(Interpreter& in, Draw& draw, const Projection& projection) {
    draw.projection = in.made.projection = projection;
}

void lookAt(Interpreter& in, Draw& draw, RasterState& raster) {
    const SceneCamera* camera =
        findCamera(in, in.around.pass ? in.around.pass->camera : CameraName{"eye", 0});
    draw.model = in.state.model;
    if (camera == nullptr || camera->name.first == "eye")
        (camera == nullptr ? in.modern.drawsClassicView : in.modern.usesEye) = true;
    if (camera == nullptr) {
        draw.modelView = in.state.modelView;
        shareProjection(in, draw, in.state.projection);
        return;
    }
    const double aspect = currentAspect(in);
    if (!in.around.pass) noteAspect(in, *camera, aspect);
    draw.modelView = camera->view * in.state.model;
    if (camera->clip || camera->aspect)
        shareProjection(in, draw, projectionOf(*camera, aspect));
    else
        shareProjection(in, draw, camera->projection);
    if (camera->isMirrored) raster.front = base::opposite(raster.front);
}

}  // namespace glibra::scene
