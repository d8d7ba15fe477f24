#pragma once
// Writes an animation as one file: an animated PNG or GIF, or a video with the program ffmpeg.

#include <glibra/result.h>

#include <cstddef>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "image/image.h"

namespace glibra::image {

// Writes GIF files (CompuServe, "Graphics Interchange Format", version 89a): animations and single pictures.

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

/// True if the suffix is that of a video: .mp4, .webm, .mkv, .mov, .avi.
bool isVideo(const std::filesystem::path& file);

/// True if a file with that suffix can hold several pictures: a video, .gif or .apng.
bool holdsAnimation(const std::filesystem::path& file);

/// True if PATH has a program ffmpeg.
bool hasFfmpeg();

/// What a user without ffmpeg can do, for messages.
inline constexpr const char* kFfmpegIsMissing =
    "the program ffmpeg is not installed; install it, or write a .gif or .apng, or single frames to a .png";

/// A file that is being written. ffmpeg gets raw pixels and writes a temporary file, which gets its name when
/// it is complete; animated PNG and GIF files are kept in memory until then. Without finish(), no file
/// remains.
class VideoFile {
  public:
    /// Frames have width x height pixels. Videos whose width or height is odd get a black column or row more,
    /// since their formats need even numbers. Most videos store the comment. Errors:
    /// file-E10.
    static Result<VideoFile> create(const std::filesystem::path& file, int width, int height,
                                    double framesPerSecond, const std::string& comment);
    VideoFile(VideoFile&&) noexcept;
    VideoFile& operator=(VideoFile&&) noexcept;
    ~VideoFile();

    /// Adds a frame of that size, in any components and type. Errors: file-E10 with ffmpeg's own message.
    Diagnostics add(const Image& frame);
    /// Completes the file. Errors as for add().
    Diagnostics finish();

  private:
    struct State;
    explicit VideoFile(std::unique_ptr<State> state);
    std::unique_ptr<State> state_;
};

}  // namespace glibra::image
