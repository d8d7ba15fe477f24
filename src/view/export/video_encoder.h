#pragma once
// A video, encoded by the program ffmpeg.

#include <sys/types.h>

#include <cstddef>
#include <filesystem>
#include <span>
#include <string>

namespace glibra::view {

/// True if a program ffmpeg is found in PATH.
bool hasFfmpeg();

/// A running ffmpeg, which takes raw pixels at its standard input. Its messages are thrown away; its exit
/// status says how it went.
class VideoEncoder {
  public:
    /// Of frames of width x height pixels, RGB bytes, top row first. The ending of the file decides the
    /// format; most formats keep the comment.
    VideoEncoder(const std::filesystem::path& file, int width, int height, double framesPerSecond,
                 const std::string& comment);
    VideoEncoder(const VideoEncoder&) = delete;
    VideoEncoder& operator=(const VideoEncoder&) = delete;
    /// Ends it, however far it is.
    ~VideoEncoder() { finish(); }

    [[nodiscard]] bool isRunning() const { return process_ > 0; }
    /// False if it has ended.
    bool write(std::span<const std::byte> frame) const;
    /// True if it ended well.
    bool finish();

  private:
    pid_t process_ = -1;
    int input_ = -1;
};

}  // namespace glibra::view
