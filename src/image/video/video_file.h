#pragma once
// Writes an animation as one file: an animated PNG or GIF, or a video with the program ffmpeg.

#include <glibra/result.h>

#include <filesystem>
#include <memory>
#include <string>

#include "image/image.h"

namespace glibra::image {

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
