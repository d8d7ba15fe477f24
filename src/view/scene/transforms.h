#pragma once
// What the mouse does to the matrices of a view, and the numbers that describe them. All matrices act on
// column vectors; angles are degrees.

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace glibra::view {

/// Which matrix the mouse changes: that of the whole scene (in Projection), the eye's (in ModelView), the
/// picked object's own, or that of texture coordinates.
enum class TransformMode { scene, eye, object, texture };

enum class Gesture { rotate, scale, pan };

/// A drag of the mouse in pixels, x to the right, y upwards, over a picture of that size.
struct Drag {
    Gesture gesture = Gesture::rotate;
    glm::dvec2 pixels{0.0};
    glm::dvec2 pictureSize{1.0};
};

/// Where a transform acts: `before` is everything that a point passes ahead of it, `after` what follows up to
/// eye space (up to the projection for the scene's). Turning and growing happen about the image of the
/// origin.
struct Surroundings {
    glm::dmat4 before{1.0};
    glm::dmat4 after{1.0};
    /// From the space where the mouse moves things to clip space: decides how far a pixel is.
    glm::dmat4 projection{1.0};
};

/// The transform after the drag. A full width turns by 180 degrees, a full height grows tenfold, and panning
/// keeps the origin under the mouse. Unchanged if `after` is singular.
glm::dmat4 dragged(const glm::dmat4& transform, const Drag& drag, const Surroundings& around);

/// The same for texture coordinates, in the unit square about its centre: rotation is about p.
glm::dmat4 draggedTexture(const glm::dmat4& transform, const Drag& drag);

/// Translation * rotation about x, then y, then z * one scale. What dragging makes is always of this kind.
struct Similarity {
    glm::dvec3 translation{0.0};
    glm::dvec3 degrees{0.0};
    double scale = 1;
};
Similarity similarityOf(const glm::dmat4& matrix);
glm::dmat4 matrixOf(const Similarity& similarity);

}  // namespace glibra::view
