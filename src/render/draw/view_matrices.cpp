#include "render/draw/view_matrices.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <glm/gtc/type_ptr.hpp>
#include <numbers>

#include "image/image.h"
#include "scene/view.h"

namespace glibra::render {
namespace {

double tangentOfHalf(double degrees) {
    return std::tan(degrees * std::numbers::pi / 360);
}

/// An orthographic box as high as what the perspective shows at that distance.
scene::Projection orthographicOf(const scene::Perspective& perspective, double distance, double aspect) {
    const double half = distance > perspective.near ? distance * tangentOfHalf(perspective.fieldOfView) : 3.0;
    return scene::Orthographic{-half * aspect, half * aspect, -half, half, -perspective.far, perspective.far};
}

/// A perspective whose eye sees the plane z = 0 as large as in the box.
glm::dmat4 perspectiveOf(const scene::Orthographic& box, double aspect) {
    constexpr double kFieldOfView = 50;
    const glm::dmat4 flat = scene::projectionMatrix(box, aspect);
    const double half = std::abs(1 / flat[1][1]);
    const double distance = half / tangentOfHalf(kFieldOfView);
    const double centreX = -flat[3][0] / flat[0][0];
    const double centreY = -flat[3][1] / flat[1][1];
    const scene::Perspective perspective{kFieldOfView, distance / 100, distance * 100};
    return scene::projectionMatrix(perspective, aspect) *
           scene::scaling({std::copysign(1.0, flat[0][0]), std::copysign(1.0, flat[1][1]), 1.0}) *
           scene::translation({-centreX, -centreY, -distance});
}

}  // namespace

glm::dmat4 asMatrix(const Matrix& numbers) {
    return glm::make_mat4(numbers.data());
}

Matrix asNumbers(const glm::dmat4& matrix) {
    Matrix numbers{};
    std::copy_n(glm::value_ptr(matrix), numbers.size(), numbers.begin());
    return numbers;
}

ViewMatrices::ViewMatrices(const ViewState& state, const glm::dmat4& sceneView, double eyeDistance,
                           bool clipsFromZero)
    : state_(state), sceneView_(sceneView), eyeDistance_(eyeDistance), clipsFromZero_(clipsFromZero) {}

glm::dmat4 ViewMatrices::projection(const scene::Projection& projection, double aspect) const {
    if (std::holds_alternative<scene::ClipSpace>(projection)) return glm::dmat4(1);
    const auto* perspective = std::get_if<scene::Perspective>(&projection);
    const auto* box = std::get_if<scene::Orthographic>(&projection);
    glm::dmat4 matrix;
    if (perspective != nullptr && state_.projection == ProjectionMode::orthographic)
        matrix = scene::projectionMatrix(
            orthographicOf(*perspective, eyeDistance_ - sceneView_[3][2], aspect), aspect);
    else if (box != nullptr && state_.projection == ProjectionMode::perspective)
        matrix = perspectiveOf(*box, aspect);
    else
        matrix = scene::projectionMatrix(projection, aspect);
    if (state_.scene == kIdentity) return matrix;
    return matrix * asMatrix(state_.scene);
}

glm::dmat4 ViewMatrices::projection(const scene::Draw& draw, double aspect) const {
    using base::DepthOrder;
    glm::dmat4 matrix = projection(*draw.projection, aspect);
    const DepthOrder order = draw.raster->depthOrder;
    if (order == DepthOrder::usual || std::holds_alternative<scene::ClipSpace>(*draw.projection))
        return matrix;
    // Of z from 0 to w floats tell the small values apart, which are far away.
    const bool fromZero = clipsFromZero_ && order == DepthOrder::reversed;
    for (int column = 0; column < 4; ++column) {
        glm::dvec4& each = matrix[column];
        each.z = fromZero ? (each.w - each.z) / 2 : -each.z;
    }
    return matrix;
}

bool isMoved(const scene::NodeList& nodes, const scene::Pass& pass) {
    return std::ranges::any_of(nodes.passes, [&](const scene::Pass& each) {
        return each.isWindow && each.rootCamera == pass.rootCamera;
    });
}

std::set<std::string> movedCameras(const scene::NodeList& nodes) {
    std::set<std::string> cameras;
    for (const scene::Pass& each : nodes.passes)
        if (each.isWindow) cameras.insert(each.rootCamera);
    return cameras;
}

ViewMatrices ViewMatrices::shifted(const glm::dmat4& shift) const {
    if (shift == glm::dmat4(1) || state_.eye == kIdentity) return *this;
    ViewMatrices moved = *this;
    moved.state_.eye = asNumbers(shift * asMatrix(state_.eye) * scene::inverseOrZero(shift));
    return moved;
}

ViewMatrices ViewMatrices::unmoved() const {
    ViewState state;
    state.objects = state_.objects;
    return {state, sceneView_, 0, clipsFromZero_};
}

glm::dmat4 ViewMatrices::model(const scene::Draw& draw) const {
    glm::dmat4 matrix = draw.model;
    for (const ViewState::Object& each : state_.objects)
        if (each.draw() == draw.id) matrix = matrix * asMatrix(each.matrix);
    return matrix;
}

glm::dmat4 ViewMatrices::view(const scene::Draw& draw) const {
    return modelView(draw) * scene::inverseOrZero(model(draw));
}

glm::dmat4 ViewMatrices::modelView(const scene::Draw& draw) const {
    if (std::holds_alternative<scene::ClipSpace>(*draw.projection)) return glm::dmat4(1);
    glm::dmat4 matrix = draw.modelView;
    if (eyeDistance_ != 0 && std::holds_alternative<scene::Perspective>(*draw.projection))
        matrix = scene::translation({0, 0, -eyeDistance_}) * matrix;
    if (state_.eye != kIdentity) matrix = asMatrix(state_.eye) * matrix;
    for (const ViewState::Object& each : state_.objects)
        if (each.draw() == draw.id) matrix = matrix * asMatrix(each.matrix);
    // projection() applies the scene transform after this; the product has no translation.
    if (draw.isSky) matrix[3] = scene::inverseOrZero(asMatrix(state_.scene))[3];
    return matrix;
}

glm::dmat4 ViewMatrices::worldView() const {
    const glm::dmat4 view = scene::translation({0, 0, -eyeDistance_}) * sceneView_;
    return state_.eye == kIdentity ? view : asMatrix(state_.eye) * view;
}

// ---- Tiles

namespace {

constexpr int kTileMargin = 64;
constexpr int kUsualSide = 4096;

}  // namespace

TileGrid tileGrid(int width, int height, int wanted, int largest, std::int64_t mostPixels) {
    TileGrid grid;
    const bool fits =
        width <= largest && height <= largest && static_cast<std::int64_t>(width) * height <= mostPixels;
    if (fits && (wanted <= 0 || (wanted >= width && wanted >= height))) {
        grid.tiles = grid.parts = {{0, 0, width, height}};
        return grid;
    }
    const int side = std::max(1, std::min(wanted > 0 ? wanted : kUsualSide, largest - 2 * kTileMargin));
    // All tiles have one size, so that one target serves them all. At the borders they are moved inside.
    const int tileWidth = std::min(width, side + 2 * kTileMargin);
    const int tileHeight = std::min(height, side + 2 * kTileMargin);
    for (int y = 0; y < height; y += side) {
        for (int x = 0; x < width; x += side) {
            grid.parts.push_back({x, y, std::min(side, width - x), std::min(side, height - y)});
            grid.tiles.push_back({std::clamp(x - kTileMargin, 0, width - tileWidth),
                                  std::clamp(y - kTileMargin, 0, height - tileHeight), tileWidth,
                                  tileHeight});
        }
    }
    return grid;
}

void pasteTile(std::span<const std::byte> pixels, const Tile& part, image::Image& picture) {
    const std::size_t pixelBytes =
        static_cast<std::size_t>(picture.components) * image::bytesOf(picture.type);
    const std::size_t partBytes = static_cast<std::size_t>(part.width) * pixelBytes;
    const int top = picture.height - part.y - part.height;
    for (int row = 0; row < part.height; ++row) {
        const std::size_t to = static_cast<std::size_t>(top + row) * picture.rowBytes() +
                               static_cast<std::size_t>(part.x) * pixelBytes;
        std::memcpy(picture.data.data() + to, pixels.data() + static_cast<std::size_t>(row) * partBytes,
                    partBytes);
    }
}

}  // namespace glibra::render
