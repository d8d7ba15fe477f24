#include "view/export/hardcopy.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <string_view>
#include <utility>

#include "suite/options/option_words.h"

namespace glibra::view {
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
    std::string text = fmt::format("glibra render {} -o {}", suite::shellWord(session.path().string()),
                                   suite::shellWord(wanted.file.string()));
    if (wanted.frames > 1)
        text += fmt::format(" --frames {} --fps {}", wanted.frames, wanted.framesPerSecond);
    return text + suite::optionArguments(shot);
}

bool isVideo(const std::filesystem::path& file) {
    constexpr std::array<std::string_view, 6> kEndings{".mp4", ".webm", ".mkv", ".avi", ".mov", ".gif"};
    std::string ending = file.extension().string();
    for (char& c : ending) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    return std::find(kEndings.begin(), kEndings.end(), ending) != kEndings.end();
}

}  // namespace glibra::view
