#include "view/scene/transforms.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "scene/view.h"

namespace glibra::view {
namespace {

constexpr double kDegreesAcross = 180;
constexpr double kGrowthAcross = 10;
constexpr double kLeastDegrees = 1e-10, kLeastMove = 1e-12;  ///< below these, numbers are rounding errors

double degreesOf(double radians) {
    return radians * 180 / std::numbers::pi;
}

/// The size of a pixel at that point, along x and y of the point's space.
glm::dvec2 sizeOfPixel(const glm::dmat4& projection, const glm::dvec4& point, const glm::dvec2& picture) {
    const double w = (projection * point).w;
    const double scaleX = std::abs(projection[0][0]);
    const double scaleY = std::abs(projection[1][1]);
    if (scaleX == 0 || scaleY == 0) return {0, 0};
    return {2 * std::abs(w) / (scaleX * picture.x), 2 * std::abs(w) / (scaleY * picture.y)};
}

/// 0 for the elements that dragging there and back leaves of 0, far below what moves a pixel.
glm::dmat4 withoutLeftovers(glm::dmat4 matrix) {
    constexpr double kLeftover = 1e-13;
    double largest = 0;
    for (int column = 0; column < 4; ++column)
        for (int row = 0; row < 4; ++row) largest = std::max(largest, std::abs(matrix[column][row]));
    for (int column = 0; column < 4; ++column)
        for (int row = 0; row < 4; ++row)
            if (std::abs(matrix[column][row]) < kLeftover * largest) matrix[column][row] = 0;
    return matrix;
}

double growthOf(const Drag& drag) {
    return std::pow(kGrowthAcross, (drag.pixels.x + drag.pixels.y) / drag.pictureSize.y);
}

}  // namespace

glm::dmat4 dragged(const glm::dmat4& transform, const Drag& drag, const Surroundings& around) {
    if (drag.pictureSize.x < 1 || drag.pictureSize.y < 1 || scene::isSingular(around.after)) return transform;
    const glm::dvec4 origin(0, 0, 0, 1);
    glm::dvec4 pivot = around.after * transform * around.before * origin;
    if (pivot.w == 0) return transform;
    pivot /= pivot.w;
    glm::dmat4 change(1.0);
    switch (drag.gesture) {
        case Gesture::rotate: {
            const double perPixel = kDegreesAcross / std::min(drag.pictureSize.x, drag.pictureSize.y);
            change = scene::translation(pivot) * scene::rotation(drag.pixels.x * perPixel, {0, 1, 0}) *
                     scene::rotation(-drag.pixels.y * perPixel, {1, 0, 0}) *
                     scene::translation(-glm::dvec3(pivot));
            break;
        }
        case Gesture::scale:
            change = scene::translation(pivot) * scene::scaling(glm::dvec3(growthOf(drag))) *
                     scene::translation(-glm::dvec3(pivot));
            break;
        case Gesture::pan: {
            const glm::dvec2 moved = drag.pixels * sizeOfPixel(around.projection, pivot, drag.pictureSize);
            change = scene::translation({moved, 0});
            break;
        }
    }
    const glm::dmat4 result =
        withoutLeftovers(scene::inverseOrZero(around.after) * change * around.after * transform);
    return scene::isFinite(result) && !scene::isSingular(result) ? result : transform;
}

glm::dmat4 draggedTexture(const glm::dmat4& transform, const Drag& drag) {
    const glm::dvec3 centre(.5, .5, .5);
    glm::dmat4 change(1.0);
    switch (drag.gesture) {
        case Gesture::rotate:
            change = scene::rotation(kDegreesAcross * drag.pixels.x / drag.pictureSize.x, {0, 0, 1});
            break;
        case Gesture::scale:
            change = scene::scaling(glm::dvec3(growthOf(drag)));
            break;
        case Gesture::pan:
            change = scene::translation({drag.pixels / drag.pictureSize, 0});
            break;
    }
    const glm::dmat4 result =
        withoutLeftovers(scene::translation(centre) * change * scene::translation(-centre) * transform);
    return scene::isFinite(result) && !scene::isSingular(result) ? result : transform;
}

Similarity similarityOf(const glm::dmat4& matrix) {
    Similarity result;
    result.translation = glm::dvec3(matrix[3]);
    result.scale = glm::length(glm::dvec3(matrix[0]));
    if (result.scale == 0) return result;
    const glm::dmat4 turn = matrix / result.scale;
    // turn = Rz * Ry * Rx (Shoemake, "Euler angle conversion", Graphics Gems IV).
    const double cosineY = std::hypot(turn[0][0], turn[0][1]);
    if (cosineY > 1e-9) {
        result.degrees = {degreesOf(std::atan2(turn[1][2], turn[2][2])),
                          degreesOf(std::atan2(-turn[0][2], cosineY)),
                          degreesOf(std::atan2(turn[0][1], turn[0][0]))};
    } else {
        result.degrees = {degreesOf(std::atan2(-turn[2][1], turn[1][1])),
                          degreesOf(std::atan2(-turn[0][2], cosineY)), 0};
    }
    // Angles of rounding errors are 0. Adding 0 turns -0 into 0, so that no widget shows -0.
    for (int axis = 0; axis < 3; ++axis) {
        if (std::abs(result.degrees[axis]) < kLeastDegrees) result.degrees[axis] = 0;
        if (std::abs(result.translation[axis]) < kLeastMove * result.scale) result.translation[axis] = 0;
    }
    result.degrees += 0.0;
    result.translation += 0.0;
    return result;
}

glm::dmat4 matrixOf(const Similarity& similarity) {
    return withoutLeftovers(
        scene::translation(similarity.translation) * scene::rotation(similarity.degrees.z, {0, 0, 1}) *
        scene::rotation(similarity.degrees.y, {0, 1, 0}) * scene::rotation(similarity.degrees.x, {1, 0, 0}) *
        scene::scaling(glm::dvec3(similarity.scale)));
}

double Wheel::take(double notches, double seconds) {
    constexpr double kBurstEnds = .12;  // seconds without a step
    constexpr int kMomentum = 3;        // a finger rarely slows down that evenly
    constexpr double kMostAtOnce = 2;
    if (notches == 0 || !std::isfinite(notches)) return 0;
    const bool continues = seconds - lastTime_ < kBurstEnds && (notches > 0) == (last_ > 0);
    const bool isWheel = notches == std::round(notches);
    if (!continues || std::abs(notches) > std::abs(last_) || isWheel)
        shrinking_ = 0;
    else if (std::abs(notches) < std::abs(last_))
        ++shrinking_;
    last_ = notches;
    lastTime_ = seconds;
    return shrinking_ >= kMomentum ? 0 : std::clamp(notches, -kMostAtOnce, kMostAtOnce);
}

}  // namespace glibra::view
