#pragma once
// Writes PNG files and animations fast: filters chosen by a quick estimate of the packed size, libdeflate,
// and several threads for large pictures.

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "image/image.h"

namespace glibra::image {

struct PngOptions {
    /// libdeflate's levels, 1 (fast) to 12 (smallest). 0: level 1 with the filter `up` for all rows, without
    /// a choice of filters; it suits the frames of animations.
    int level = 4;
    /// Keyword and text (UTF-8), stored as tEXt, or as iTXt if the text is not plain ASCII. Keywords have 1
    /// to 79 printable ASCII characters; others are left out.
    std::vector<std::pair<std::string, std::string>> text;
    /// The number of threads that pack large pictures; 0: one per processor. It does not change the file.
    unsigned threads = 0;
};

/// The image as a PNG file: 8 or 16 bits, 1 to 4 components as grey, grey + alpha, RGB, RGBA. Empty if PNG
/// cannot hold it: float components, no pixels, or data whose length contradicts the size.
std::vector<std::byte> encodePng(const Image& image, const PngOptions& options = {});

/// Appends a chunk with its length and checksum. `type` has four letters.
void putPngChunk(std::vector<std::byte>& png, std::string_view type, std::span<const std::byte> content);
/// Appends the signature and the chunk IHDR of a picture of u8 or u16 components.
void putPngHeader(std::vector<std::byte>& png, const Image& image);

/// Writes animated PNG files (PNG specification, third edition, 11.3.6), which browsers show as they show PNG
/// pictures; other programs show the first frame. Of each frame only the rectangle is stored in which it
/// differs from the one before.
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
