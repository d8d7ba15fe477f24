#include "suite/report/verdict_commands.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

namespace glibra::suite {

std::string shellWord(std::string_view text) {
    const auto isPlain = [](unsigned char c) {
        return std::isalnum(c) != 0 ||
               std::string_view("_-+=./,:@%").find(static_cast<char>(c)) != std::string_view::npos;
    };
    if (!text.empty() && std::all_of(text.begin(), text.end(), isPlain)) return std::string(text);
    std::string quoted = "'";
    for (const char c : text) quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
    return quoted + "'";
}

std::string viewArguments(const ViewState& view) {
    const auto numbers = [](const auto& values) {
        std::string text;
        for (const double each : values) text += fmt::format("{}{}", text.empty() ? "" : ",", each);
        return text;
    };
    std::string text;
    if (view.scene != kIdentity) text += " --scene-transform " + numbers(view.scene);
    if (view.eye != kIdentity) text += " --eye-transform " + numbers(view.eye);
    if (view.texture != kIdentity) text += " --texture-transform " + numbers(view.texture);
    for (const ViewState::Object& each : view.objects)
        text += fmt::format(" --object-transform {}:{}", each.line, numbers(each.matrix));
    if (view.projection == ProjectionMode::orthographic) text += " --projection orthographic";
    if (view.projection == ProjectionMode::perspective) text += " --projection perspective";
    if (view.background) text += " --background " + numbers(*view.background);
    return text;
}

std::string reproduceCommand(const Shot& shot) {
    const RenderOptions& options = shot.options;
    std::string command = "glibra render " + shellWord(shot.script.string());
    if (options.width > 0 && options.height > 0)
        command += fmt::format(" --size {}x{}", options.width, options.height);
    if (options.time != 0) command += fmt::format(" --time {}", options.time);
    for (const std::string& each : options.set) command += " --set " + shellWord(each);
    if (options.view == ViewPolicy::glman) command += " --view glman";
    if (options.samples > 0) command += fmt::format(" --samples {}", options.samples);
    if (options.maxError > 0) command += fmt::format(" --max-error {}px", options.maxError);
    if (options.overrideCounts) command += " --override-counts";
    if (options.axes) command += " --axes";
    if (options.alpha) command += " --alpha";
    if (options.strict) command += " --strict";
    if (!options.shim) command += " --no-shim";
    command += viewArguments(options.viewState);
    if (options.tileSize > 0) command += fmt::format(" --tile {}", options.tileSize);
    if (!shot.expectedError) {
        std::string file = shot.name;
        std::replace(file.begin(), file.end(), '/', '_');
        command += " -o " + shellWord(file + (options.floatPixels ? ".exr" : ".png"));
    }
    return command;
}

std::string acceptCommand(const Suite& suite, const Shot& shot) {
    return fmt::format("glibra test {} --only {} --update", shellWord(suite.file.string()),
                       shellWord(shot.name));
}

}  // namespace glibra::suite
