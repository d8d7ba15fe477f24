#include "view/export/hardcopy_job.h"

#include <fmt/format.h>

#include <cctype>
#include <optional>
#include <string>
#include <utility>

#include "image/file.h"
#include "image/write.h"
#include "render/job.h"
#include "render/scene_renderer.h"
#include "view/export/video_encoder.h"

namespace glibra::view {
namespace {

bool isFloatFormat(const std::filesystem::path& file) {
    std::string ending = file.extension().string();
    for (char& c : ending) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    return ending == ".exr" || ending == ".hdr" || ending == ".pfm";
}

}  // namespace

struct HardcopyJob::State {
    Hardcopy wanted;
    RenderOptions options;
    image::WriteOptions writing;
    render::Stats stats;
    std::optional<render::SceneRenderer> renderer;
    std::optional<image::TemporaryFile> unfinished;
    std::optional<VideoEncoder> encoder;
    int written = 0;
    bool failed = false;

    [[nodiscard]] Diagnostic bad(const std::string& why) const {
        return error("file-E10", fmt::format("cannot write '{}': {}", wanted.file.string(), why));
    }
    Diagnostics beginVideo();
    Diagnostics write(const image::Image& picture);
};

Diagnostics HardcopyJob::State::beginVideo() {
    if (!hasFfmpeg()) return {bad("the program ffmpeg is not installed; write single frames instead")};
    unfinished.emplace(wanted.file);
    if (unfinished->path().empty()) return {unfinished->failure()};
    encoder.emplace(unfinished->path(), options.width, options.height, wanted.framesPerSecond,
                    writing.comment);
    if (!encoder->isRunning()) return {bad("ffmpeg cannot be started")};
    return {};
}

Diagnostics HardcopyJob::State::write(const image::Image& picture) {
    if (!encoder)
        return image::writeImage(picture, render::frameFile(wanted.file, written, wanted.frames), writing);
    const bool isTaken = encoder->write(picture.data);
    if (isTaken && written + 1 < wanted.frames) return {};
    if (!encoder->finish() || !isTaken) return {bad("ffmpeg refuses it")};
    return unfinished->commit();
}

HardcopyJob::HardcopyJob(std::unique_ptr<State> state) : state_(std::move(state)) {}
HardcopyJob::HardcopyJob(HardcopyJob&&) noexcept = default;
HardcopyJob& HardcopyJob::operator=(HardcopyJob&&) noexcept = default;
HardcopyJob::~HardcopyJob() = default;

Result<HardcopyJob> HardcopyJob::begin(gpu::Context& context, const Session& session,
                                       const Hardcopy& wanted) {
    auto state = std::make_unique<State>();
    state->wanted = wanted;
    state->options = session.renderOptions(wanted.width, wanted.height);
    state->options.floatPixels = isFloatFormat(wanted.file);
    state->writing.comment = renderCommand(session, wanted);
    state->writing.png.text = {{"Software", "glibra"}, {"Comment", state->writing.comment}};
    Result<render::SceneRenderer> loaded =
        render::SceneRenderer::load(context, session.path(), state->options, state->stats);
    if (!loaded) return std::move(loaded.diagnostics);
    Diagnostics diagnostics = std::move(loaded.diagnostics);
    state->renderer = std::move(loaded.value);
    if (isVideo(wanted.file)) append(diagnostics, state->beginVideo());
    if (hasError(diagnostics)) return diagnostics;
    return {HardcopyJob(std::move(state)), std::move(diagnostics)};
}

Diagnostics HardcopyJob::step() {
    State& state = *state_;
    if (isDone()) return {};
    Result<image::Image> picture =
        state.renderer->draw(state.options.time + state.written / state.wanted.framesPerSecond, state.stats);
    Diagnostics diagnostics = std::move(picture.diagnostics);
    if (picture) append(diagnostics, state.write(*picture));
    state.failed = !picture || hasError(diagnostics);
    if (!state.failed) ++state.written;
    return diagnostics;
}

bool HardcopyJob::isDone() const {
    return state_->failed || state_->written >= state_->wanted.frames;
}
int HardcopyJob::framesWritten() const {
    return state_->written;
}
const Hardcopy& HardcopyJob::wanted() const {
    return state_->wanted;
}

}  // namespace glibra::view
