#pragma once
// Writes animated PNG files (PNG specification, third edition, 11.3.6), which browsers show as they show PNG
// pictures; other programs show the first frame. Of each frame only the rectangle is stored in which it
// differs from the one before.

#include <cstddef>
#include <vector>

#include "image/image.h"

namespace glibra::image {

class AnimatedPng {
  public:
    /// The animation is repeated for ever.
    explicit AnimatedPng(double framesPerSecond) : framesPerSecond_(framesPerSecond) {}

    /// Adds a frame, of any components and type. All have the size of the first one.
    void add(const Image& frame);
    /// The number of frames that differ from the one before, with the first.
    [[nodiscard]] std::size_t differing() const { return frames_.size(); }
    /// The file; empty without frames, or if there is not enough memory.
    [[nodiscard]] std::vector<std::byte> finish() const;

  private:
    struct Frame {
        int left = 0, top = 0;
        int lasts = 1;  ///< in frames
        Image part;     ///< of the first frame: all of it
    };

    double framesPerSecond_;
    std::vector<Frame> frames_;
    Image last_;  ///< the frame before, RGB in bytes
};

}  // namespace glibra::image
