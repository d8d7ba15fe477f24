#include "expression/known_names.h"

namespace glibra::expression {
namespace {

using D = Depends;

constexpr NameRow kSceneNames[] = {
    {"time", Type::number(), D::time, "seconds since the start; in `Step r` the number of the step / r"},
    {"dt", Type::number(), D::nothing, "seconds from one frame, or step, to the next; the same for all"},
    {"frame", Type::number(), D::frame, "number of the frame, from 0"},
    {"tick", Type::number(), D::tick, "number of the simulation step, from 0"},
    {"window", Type::vector(2), D::window, "width and height of the window in pixels"},
    {"aspect", Type::number(), D::window, "width / height of the window"},
    {"mouse", Type::vector(2), D::mouse,
     "place of the mouse, 0 to 1 from the lower left corner; .5 .5 without a window"},
    {"mouse.down", Type::boolean(), D::mouse, "whether the left button is down"},
    {"model", Type::matrix(4), D::model, "the product of the transforms below the camera"},
};

constexpr NameRow kCameraFields[] = {
    {"view", Type::matrix(4), D::camera, "from the world to the eye"},
    {"projection", Type::matrix(4), D::camera, "from the eye to the clip space"},
    {"viewProjection", Type::matrix(4), D::camera, "projection * view"},
    {"inverseView", Type::matrix(4), D::camera, "from the eye to the world"},
    {"shadow", Type::matrix(4), D::camera, "viewProjection, mapped from -1..1 to 0..1"},
    {"position", Type::vector(3), D::camera, "the eye in the world"},
    {"direction", Type::vector(3), D::camera, "the direction of view in the world, of length 1"},
    {"near", Type::number(), D::camera, "distance of the near plane"},
    {"far", Type::number(), D::camera, "distance of the far plane"},
    {"fov", Type::number(), D::camera, "vertical full angle of view in degrees; 0 of an `Ortho`"},
    {"aspect", Type::number(), D::camera, "width / height of the picture"},
};

constexpr PartRow kParts[] = {
    {"level", "TEXTURE.level(n)", "a mipmap level of a texture, from 0"},
    {"layer", "TEXTURE.layer(n)", "a layer of an array, or a slice of a 3D texture, from 0"},
    {"face", "CUBE.face(n)", "a face of a cube map: 0 to 5, or +x -x +y -y +z -z"},
    {"size", "TEXTURE.size", "width, height, and depth or layers of a texture"},
    {"count", "BUFFER.count", "the number of elements of a buffer"},
    {"prev", "NAME.prev", "an object with history, or a camera, as it was in the frame or step before"},
    {"index", "NAME.index", "the number of the round of a Repeat over words or values, from 0"},
    {"vertices", "MESH.vertices", "the number of vertices of a Mesh"},
    {"primitives", "MESH.primitives", "the number of primitives of a Mesh"},
};

}  // namespace

std::span<const PartRow> partTable() {
    return kParts;
}

std::span<const NameRow> sceneNames() {
    return kSceneNames;
}
std::span<const NameRow> cameraFields() {
    return kCameraFields;
}

}  // namespace glibra::expression
