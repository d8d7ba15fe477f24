#include "cli/film.h"

#include <string>
#include <utility>

#include "image/file.h"
#include "image/png/png_reader.h"
#include "image/video/video_file.h"

namespace glibra::cli {
namespace {

namespace fs = std::filesystem;

/// Reads a frame with the PNG reader alone, since a worker that a scene has taken over may have written
/// something else.
Result<image::Image> readFrame(const fs::path& file) {
    const image::FileLabel label{file.filename().string(), {}};
    const auto bytes = image::readFile(file, label);
    if (!bytes) return bytes.diagnostics;
    return image::decodePng(*bytes, label);
}

}  // namespace

Diagnostics writeFilm(const Film& film, const std::function<std::optional<fs::path>(int)>& frameFile,
                      const std::function<bool()>& stop) {
    for (int i = 0; i < film.frames; ++i)
        if (!frameFile(i)) return {};
    std::optional<image::VideoFile> video;
    for (int i = 0; i < film.frames && !stop(); ++i) {
        const Result<image::Image> frame = readFrame(*frameFile(i));
        if (!frame) return frame.diagnostics;
        if (!video) {
            Result<image::VideoFile> begun = image::VideoFile::create(film.file, frame->width, frame->height,
                                                                      film.framesPerSecond, "glibra");
            if (!begun) return begun.diagnostics;
            video = std::move(begun.value);
        }
        if (Diagnostics problems = video->add(*frame); !problems.empty()) return problems;
    }
    if (stop() || !video) return {};
    return video->finish();
}

}  // namespace glibra::cli
