#include "view/hardcopy.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <string_view>

#include "image/write.h"
#include "render/job.h"
#include "render/scene_renderer.h"

namespace glibra::view {
namespace {

/// As one word of a shell.
std::string quoted(const std::string& word) {
    const bool isPlain = !word.empty() && std::all_of(word.begin(), word.end(), [](unsigned char c) {
        return std::isalnum(c) != 0 ||
               std::string_view("-_./=,:+@%").find(static_cast<char>(c)) != std::string_view::npos;
    });
    if (isPlain) return word;
    std::string text = "'";
    for (const char c : word) text += c == '\'' ? "'\\''" : std::string(1, c);
    return text + "'";
}

std::string numbers(const auto& values) {
    std::string text;
    for (const double each : values) text += fmt::format("{}{}", text.empty() ? "" : ",", each);
    return text;
}

std::string viewArguments(const ViewState& view) {
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

bool isFloatFormat(const std::filesystem::path& file) {
    std::string ending = file.extension().string();
    for (char& c : ending) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    return ending == ".exr" || ending == ".hdr" || ending == ".pfm";
}

}  // namespace

std::string setArguments(const Session& session) {
    std::string text;
    for (const std::string& each : session.renderOptions().set)
        text += (text.empty() ? "--set " : " --set ") + quoted(each);
    return text;
}

std::string renderCommand(const Session& session, const Hardcopy& wanted) {
    const RenderOptions options = session.renderOptions(wanted.width, wanted.height);
    std::string text = fmt::format("glibra render {} -o {} --size {}x{}", quoted(session.path().string()),
                                   quoted(wanted.file.string()), options.width, options.height);
    if (options.time != 0) text += fmt::format(" --time {}", options.time);
    if (wanted.frames > 1)
        text += fmt::format(" --frames {} --fps {}", wanted.frames, wanted.framesPerSecond);
    if (options.view == ViewPolicy::glman) text += " --view glman";
    if (options.axes) text += " --axes";
    if (!options.shim) text += " --no-shim";
    for (const std::string& each : options.set) text += " --set " + quoted(each);
    return text + viewArguments(options.viewState);
}

Diagnostics writeHardcopy(gpu::Context& context, const Session& session, const Hardcopy& wanted,
                          const std::function<bool(int)>& progress) {
    RenderOptions options = session.renderOptions(wanted.width, wanted.height);
    options.floatPixels = isFloatFormat(wanted.file);
    image::WriteOptions writing;
    writing.png.text = {{"Software", "glibra"}, {"Comment", renderCommand(session, wanted)}};
    render::Stats stats;
    Result<render::SceneRenderer> loaded =
        render::SceneRenderer::load(context, session.path(), options, stats);
    Diagnostics diagnostics = std::move(loaded.diagnostics);
    if (!loaded) return diagnostics;
    for (int i = 0; i < wanted.frames; ++i) {
        Result<image::Image> picture = loaded->draw(options.time + i / wanted.framesPerSecond, stats);
        append(diagnostics, std::move(picture.diagnostics));
        if (!picture) break;
        append(diagnostics,
               image::writeImage(*picture, render::frameFile(wanted.file, i, wanted.frames), writing));
        if (hasError(diagnostics) || (progress && !progress(i + 1))) break;
    }
    return diagnostics;
}

}  // namespace glibra::view
