#include "view/hardcopy.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

#include "image/write.h"
#include "render/job.h"
#include "render/scene_renderer.h"
#include "suite/verdict_commands.h"

namespace glibra::view {
namespace {

bool isFloatFormat(const std::filesystem::path& file) {
    std::string ending = file.extension().string();
    for (char& c : ending) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    return ending == ".exr" || ending == ".hdr" || ending == ".pfm";
}

}  // namespace

std::string setArguments(const Session& session) {
    std::string text;
    for (const std::string& each : session.renderOptions().set)
        text += (text.empty() ? "--set " : " --set ") + suite::shellWord(each);
    return text;
}

std::string renderCommand(const Session& session, const Hardcopy& wanted) {
    const RenderOptions options = session.renderOptions(wanted.width, wanted.height);
    std::string text =
        fmt::format("glibra render {} -o {} --size {}x{}", suite::shellWord(session.path().string()),
                    suite::shellWord(wanted.file.string()), options.width, options.height);
    if (options.time != 0) text += fmt::format(" --time {}", options.time);
    if (wanted.frames > 1)
        text += fmt::format(" --frames {} --fps {}", wanted.frames, wanted.framesPerSecond);
    if (options.view == ViewPolicy::glman) text += " --view glman";
    if (options.axes) text += " --axes";
    if (!options.shim) text += " --no-shim";
    for (const std::string& each : options.set) text += " --set " + suite::shellWord(each);
    return text + suite::viewArguments(options.viewState);
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
