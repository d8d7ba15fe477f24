#pragma once
// How a drag of the mouse changes the matrices of a view, and the numbers that describe such a matrix. All
// matrices act on column vectors; angles are in degrees.

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace glibra::view {

/// The matrix that the mouse changes: the whole scene's (part of Projection), the eye's (part of ModelView),
/// the picked object's own, or that of texture coordinates.
enum class TransformMode { scene, eye, object, texture };

enum class Gesture { rotate, scale, pan };

/// A drag of the mouse in pixels, x to the right and y upwards, over a picture of `pictureSize` pixels.
struct Drag {
    Gesture gesture = Gesture::rotate;
    glm::dvec2 pixels{0.0};
    glm::dvec2 pictureSize{1.0};
};

/// Where a transform stands in the chain of matrices: `before` is applied to a point before it, `after` after
/// it, up to eye space (up to the projection for the scene's transform). Rotation and scaling keep the image
/// of the origin in place.
struct Surroundings {
    glm::dmat4 before{1.0};
    glm::dmat4 after{1.0};
    /// From the space in which the mouse moves things to clip space; gives the size of a pixel there.
    glm::dmat4 projection{1.0};
};

/// The transform after the drag. A drag across the shorter side of the picture rotates by 180 degrees, one
/// over its height scales by ten, and panning keeps the origin under the mouse. The transform is returned
/// unchanged if `after` or the result is singular.
glm::dmat4 dragged(const glm::dmat4& transform, const Drag& drag, const Surroundings& around);

/// The same for texture coordinates: in the unit square about its centre, rotation about the p axis.
glm::dmat4 draggedTexture(const glm::dmat4& transform, const Drag& drag);

/// translation * rotation about z * about y * about x * uniform scale. Every dragged matrix has this form.
struct Similarity {
    glm::dvec3 translation{0.0};
    glm::dvec3 degrees{0.0};
    double scale = 1;
};
Similarity similarityOf(const glm::dmat4& matrix);
glm::dmat4 matrixOf(const Similarity& similarity);

// The scroll events of mouse wheels and touchpads, turned into notches that scale the picture.

/// A touchpad goes on scrolling after the fingers have left it, with shorter and shorter steps. That momentum
/// suits pages, but it carries a picture past the size that the fingers have chosen; it is left out.
class Wheel {
  public:
    /// What of `notches`, scrolled at that time in seconds, scales the picture. Whole notches of a wheel all
    /// do; a burst of a touchpad ends with its third smaller step in a row. At most two notches act at once.
    double take(double notches, double seconds);

  private:
    double last_ = 0, lastTime_ = -1e9;
    int shrinking_ = 0;  ///< steps of the burst that were smaller than the one before, in a row
};

}  // namespace glibra::view
