#pragma once
// Encodes a video with the program ffmpeg.

#include <sys/types.h>

#include <cstddef>
#include <filesystem>
#include <span>
#include <string>

namespace glibra::view {

/// True if PATH has a program ffmpeg.
bool hasFfmpeg();

/// A running ffmpeg that reads raw pixels from its standard input. Its messages are discarded; its exit
/// status tells whether it succeeded.
class VideoEncoder {
  public:
    /// Frames have width x height pixels. The file's extension selects the format; most formats store the
    /// comment.
    VideoEncoder(const std::filesystem::path& file, int width, int height, double framesPerSecond,
                 const std::string& comment);
    VideoEncoder(const VideoEncoder&) = delete;
    VideoEncoder& operator=(const VideoEncoder&) = delete;
    /// Closes the input and waits for ffmpeg to end.
    ~VideoEncoder() { finish(); }

    [[nodiscard]] bool isRunning() const { return process_ > 0; }
    /// Sends one frame: RGB bytes, top row first. Returns false if ffmpeg has ended.
    bool write(std::span<const std::byte> frame) const;
    /// Closes the input and waits for ffmpeg to end. Returns true if it succeeded.
    bool finish();

  private:
    pid_t process_ = -1;
    int input_ = -1;
};

}  // namespace glibra::view
