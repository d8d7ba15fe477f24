#pragma once
// The scroll events of mouse wheels and touchpads, turned into notches that scale the picture.

namespace glibra::view {

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
