#pragma once
// Writes GIF files (CompuServe, "Graphics Interchange Format", version 89a): animations and single pictures.

#include <cstddef>
#include <vector>

#include "image/image.h"

namespace glibra::image {

inline constexpr int kLargestGifSide = 65'535;  ///< pixels

/// Of each frame only the rectangle is stored in which it differs from the one before. A rectangle has a
/// palette of its own: its colours, if these are 256 at most, otherwise the 256 that median cut chooses
/// (P. Heckbert, "Color image quantization for frame buffer display", SIGGRAPH 1982), with the error of each
/// pixel given to its neighbours (R. Floyd, L. Steinberg, "An adaptive algorithm for spatial greyscale",
/// 1976).
class AnimatedGif {
  public:
    /// The animation is repeated for ever. Times are multiples of 1/100 s; those of the frames are rounded,
    /// so that the whole lasts as long as it should. Above 50 frames per second frames are left out, since
    /// browsers show none for less than 1/50 s.
    explicit AnimatedGif(double framesPerSecond) : framesPerSecond_(framesPerSecond) {}

    /// Adds a frame of any components and type, without its alpha. All have the size of the first one, with
    /// sides up to kLargestGifSide.
    void add(const Image& frame);
    /// The file; empty without frames.
    [[nodiscard]] std::vector<std::byte> finish();

  private:
    [[nodiscard]] long long hundredthsAt(long long frame) const;
    void endShown();

    double framesPerSecond_;
    std::vector<std::byte> body_;
    std::size_t delayAt_ = 0;   ///< in body_, of the shown frame
    long long added_ = 0;       ///< frames
    long long shownSince_ = 0;  ///< hundredths of a second
    int stored_ = 0;
    Image last_;  ///< the frame that is shown, RGB in bytes
};

/// A GIF picture.
std::vector<std::byte> encodeGif(const Image& image);

}  // namespace glibra::image
