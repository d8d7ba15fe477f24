#include "view/export/hardcopy_job.h"

#include <fmt/format.h>

#include <array>
#include <new>
#include <optional>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include "image/file.h"
#include "image/format.h"
#include "image/video/video_file.h"
#include "image/write.h"
#include "render/draw/labels.h"
#include "render/file/job.h"
#include "render/scene_renderer.h"
#include "view/scene/knobs.h"

namespace glibra::view {

struct HardcopyJob::State {
    Hardcopy wanted;
    RenderOptions options;
    image::WriteOptions writing;
    render::Stats stats;
    std::optional<render::SceneRenderer> renderer;
    std::optional<image::VideoFile> film;
    LabelCorner corner = LabelCorner::none;  ///< of the labels that are drawn here, which are not all
    std::vector<std::string> labelled;
    int written = 0;
    bool failed = false;

    [[nodiscard]] Diagnostic outOfMemory() const {
        return image::cannotWrite(wanted.file,
                                  fmt::format("not enough memory for {} x {} pixels; choose a smaller size",
                                              options.width, options.height));
    }
    Diagnostics begin(gpu::Context& context, const std::filesystem::path& scene);
    Diagnostics drawNext();
    void drawChosenLabels(image::Image& picture) const;
    Diagnostics write(const image::Image& picture);
};

Diagnostics HardcopyJob::State::begin(gpu::Context& context, const std::filesystem::path& scene) {
    Result<render::SceneRenderer> loaded = render::SceneRenderer::load(context, scene, options, stats);
    Diagnostics diagnostics = std::move(loaded.diagnostics);
    if (!loaded) return diagnostics;
    renderer = std::move(loaded.value);
    if (!isFilm(wanted)) return diagnostics;
    Result<image::VideoFile> begun = image::VideoFile::create(wanted.file, options.width, options.height,
                                                              wanted.framesPerSecond, writing.comment);
    film = std::move(begun.value);
    append(diagnostics, std::move(begun.diagnostics));
    return diagnostics;
}

Diagnostics HardcopyJob::State::drawNext() {
    Result<image::Image> picture = renderer->draw(options.time + written / wanted.framesPerSecond, stats);
    Diagnostics diagnostics = std::move(picture.diagnostics);
    if (picture) {
        drawChosenLabels(*picture);
        append(diagnostics, write(*picture));
    }
    failed = !picture || hasError(diagnostics);
    if (!failed) ++written;
    return diagnostics;
}

void HardcopyJob::State::drawChosenLabels(image::Image& picture) const {
    if (corner == LabelCorner::none) return;
    const std::array<const plan::FramePlan*, 1> plans{&renderer->plan()};
    const render::LabelBlock block =
        render::labelBlock(picture.width, picture.height,
                           onlyLabels(render::labelsOf(renderer->scene(), plans), labelled), corner);
    if (!block.lines.empty()) render::drawLabels(picture, block, block.left, block.top);
}

Diagnostics HardcopyJob::State::write(const image::Image& picture) {
    if (!film)
        return image::writeImage(picture, render::frameFile(wanted.file, written, wanted.frames), writing);
    Diagnostics problems = film->add(picture);
    if (!problems.empty() || written + 1 < wanted.frames) return problems;
    return film->finish();
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
    if (wanted.samples > 1) state->options.samples = wanted.samples;
    state->labelled = session.labelled();
    if (!state->labelled.empty()) state->corner = std::exchange(state->options.labels, LabelCorner::none);
    state->options.floatPixels = image::holdsFloats(wanted.file);
    state->writing.comment = renderCommand(session, wanted);
    state->writing.png.text = {{"Software", "glibra"}, {"Comment", state->writing.comment}};
    try {
        Diagnostics diagnostics = state->begin(context, session.path());
        if (!state->renderer || hasError(diagnostics)) return diagnostics;
        return {HardcopyJob(std::move(state)), std::move(diagnostics)};
    } catch (const std::bad_alloc&) {
        return state->outOfMemory();
    }
}

Diagnostics HardcopyJob::step() {
    State& state = *state_;
    if (isDone()) return {};
    try {
        return state.drawNext();
    } catch (const std::bad_alloc&) {
        state.failed = true;
        return {state.outOfMemory()};
    }
}

bool HardcopyJob::isDone() const {
    return state_->failed || state_->written >= state_->wanted.frames;
}
int HardcopyJob::framesWritten() const {
    return state_->written;
}
std::string HardcopyJob::filesWritten() const {
    const Hardcopy& wanted = state_->wanted;
    const int count = state_->written;
    if (count == 0 || (state_->film && count < wanted.frames)) return {};
    std::error_code failure;
    const auto whole = [&](const std::filesystem::path& file) {
        return std::filesystem::absolute(file, failure).lexically_normal().string();
    };
    const std::string size = fmt::format("{} x {} pixels", state_->options.width, state_->options.height);
    if (state_->film) return fmt::format("{}: {} frames of {}", whole(wanted.file), count, size);
    const std::string first = whole(firstFile(wanted));
    if (count == 1) return fmt::format("{}: {}", first, size);
    return fmt::format("{} to {}: {} files of {}", first,
                       render::frameFile(wanted.file, count - 1, wanted.frames).filename().string(), count,
                       size);
}
const Hardcopy& HardcopyJob::wanted() const {
    return state_->wanted;
}

}  // namespace glibra::view
