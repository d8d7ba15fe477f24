#include "view/export/hardcopy.h"

#include <fmt/format.h>

#include <charconv>
#include <system_error>

#include "image/video/video_file.h"
#include "render/file/job.h"
#include "suite/options/option_words.h"

namespace glibra::view {

namespace fs = std::filesystem;

std::string setArguments(const Session& session) {
    std::string text;
    for (const std::string& each : session.renderOptions().set)
        text += (text.empty() ? "--set " : " --set ") + suite::shellWord(each);
    return text;
}

std::string renderCommand(const Session& session, const Hardcopy& wanted) {
    suite::Shot shot;
    shot.options = session.renderOptions(wanted.width, wanted.height);
    if (!session.live().isAnimated()) shot.options.time = 0;
    if (wanted.samples > 1) shot.options.samples = wanted.samples;
    std::string text = fmt::format("glibra render {} -o {}", suite::shellWord(session.path().string()),
                                   suite::shellWord(wanted.file.string()));
    if (wanted.frames > 1)
        text += fmt::format(" --frames {} --fps {}", wanted.frames, wanted.framesPerSecond);
    return text + suite::optionArguments(shot);
}

bool isFilm(const Hardcopy& wanted) {
    return image::isVideo(wanted.file) || (wanted.frames > 1 && image::holdsAnimation(wanted.file));
}

fs::path firstFile(const Hardcopy& wanted) {
    return isFilm(wanted) ? wanted.file : render::frameFile(wanted.file, 0, wanted.frames);
}

bool replacesFile(const Hardcopy& wanted) {
    std::error_code failure;
    return fs::exists(fs::symlink_status(firstFile(wanted), failure));
}

fs::path freeName(Hardcopy wanted) {
    if (!replacesFile(wanted)) return wanted.file;
    std::string stem = wanted.file.stem().string();
    int number = 1;
    // The largest number that is counted on: longer ones are dates and the like.
    constexpr std::size_t kMostDigits = 4;
    const std::size_t dash = stem.find_last_not_of("0123456789");
    if (dash != std::string::npos && dash > 0 && stem[dash] == '-' && dash + 1 < stem.size() &&
        stem.size() - dash - 1 <= kMostDigits) {
        std::from_chars(stem.data() + dash + 1, stem.data() + stem.size(), number);
        stem.resize(dash);
    }
    const std::string ending = wanted.file.extension().string();
    do wanted.file.replace_filename(fmt::format("{}-{}{}", stem, ++number, ending));
    while (replacesFile(wanted));
    return wanted.file;
}

}  // namespace glibra::view
