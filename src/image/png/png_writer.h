#pragma once
// Writes PNG files and animations fast: filters chosen by a quick estimate of the packed size, libdeflate,
// and several threads for large pictures.

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "image/image.h"

namespace glibra::image {

// The rows of a picture as PNG packs them: in its byte order and filtered, each after the number of its
// filter.

/// One filter for all rows, or for each row the one that writeBest chooses.
enum class PngFiltering : std::uint8_t { none, sub, up, bestOfEachRow };

/// Writes `rows` rows from `firstRow`, of u8 or u16 components, to `to`: rows * (1 + image.rowBytes()) bytes.
void filterRows(const Image& image, int firstRow, int rows, PngFiltering filtering, std::uint8_t* to);

/// The way to filter that packs these rows best, judged by a seventh of them. Small differences do not
/// predict repetitions: if a picture repeats the same colours, unfiltered rows can be packed to half the
/// size.
PngFiltering chooseFiltering(const Image& image, int firstRow, int rows);

/// A filter of rows (PNG specification, section 9), the difference of each byte from a prediction by its
/// neighbours: the number that precedes the filtered row in the file.
enum class PngFilter : std::uint8_t { none = 0, sub = 1, up = 2, paeth = 4 };

class PngRowFilter {
  public:
    /// Rows of `rowBytes`; `pixelBytes`, the size of a pixel, divides it.
    PngRowFilter(std::size_t rowBytes, std::size_t pixelBytes);

    /// Writes the number of the filter and the filtered row to `to`: 1 + rowBytes bytes.
    void write(PngFilter filter, const std::uint8_t* row, const std::uint8_t* above, std::uint8_t* to) const;
    /// The same with the best of none, sub, up and Paeth: the one with the least sum of absolute differences,
    /// by which libpng chooses among all five (PNG specification, 12.8). The fifth filter made the pictures
    /// of 22 scenes smaller by only 0.1 %.
    void writeBest(const std::uint8_t* row, const std::uint8_t* above, std::uint8_t* to);

  private:
    std::size_t rowBytes_, pixelBytes_;
    std::vector<std::uint8_t> other_;  ///< a candidate that may be better than the output so far
};

/// Estimates the size of data packed by DEFLATE, in a small part of the time that packing takes: searches for
/// matches as a quick packer does, one candidate per position, and adds up the entropy of the matches and of
/// the literals between them. Good for comparing data of one kind: the estimate is some percent more than
/// libdeflate's level 4 needs.
class PackedSize {
  public:
    /// Continues from the previous position to `end` bytes after `text`, whose earlier bytes must be
    /// unchanged. The last seven bytes wait for the next call.
    void readTo(const std::uint8_t* text, std::size_t end);

    /// Counts only from here; the earlier bytes can still be repeated by matches.
    void startCounting();

    /// The bits of everything read, without the descriptions of the codes.
    [[nodiscard]] double bits() const;

  private:
    static constexpr unsigned kHashBits = 13;

    // Four symbols per doubling of the length, two per doubling of the distance; extra bits hold the rest
    // (RFC 1951, 3.2.5).
    void addLength(std::size_t length);
    void addDistance(std::size_t distance);

    std::size_t at_ = 0;
    std::array<std::uint32_t, std::size_t{1} << kHashBits>
        last_{};                                 ///< 1 + the last position of four such bytes
    std::array<std::uint32_t, 286> symbols_{};   ///< DEFLATE's symbols: literals and lengths
    std::array<std::uint32_t, 30> distances_{};  ///< DEFLATE's symbols
    std::uint64_t extraBits_ = 0;
};

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
