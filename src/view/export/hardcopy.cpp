#include "view/export/hardcopy.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <new>
#include <optional>
#include <span>
#include <system_error>
#include <utility>
#include <vector>

#include "base/files.h"
#include "image/file.h"
#include "image/format.h"
#include "image/video/video_file.h"
#include "image/write.h"
#include "render/draw/axes.h"
#include "render/file/job.h"
#include "render/live/knobs.h"
#include "render/scene_renderer.h"
#include "suite/file/shot_name.h"
#include "suite/file/suite_file.h"
#include "suite/options/option_words.h"
#include "system/folder.h"

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
    std::string text =
        fmt::format("glibra render {} -o {}", suite::shellWord(session.path().generic_string()),
                    suite::shellWord(wanted.file.generic_string()));
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
    std::string stem = wanted.file.stem().generic_string();
    int number = 1;
    // The largest number that is counted on: longer ones are dates and the like.
    constexpr std::size_t kMostDigits = 4;
    const std::size_t dash = stem.find_last_not_of("0123456789");
    if (dash != std::string::npos && dash > 0 && stem[dash] == '-' && dash + 1 < stem.size() &&
        stem.size() - dash - 1 <= kMostDigits) {
        std::from_chars(stem.data() + dash + 1, stem.data() + stem.size(), number);
        stem.resize(dash);
    }
    const std::string ending = wanted.file.extension().generic_string();
    do wanted.file.replace_filename(fmt::format("{}-{}{}", stem, ++number, ending));
    while (replacesFile(wanted));
    return wanted.file;
}

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
                           render::onlyLabels(render::labelsOf(renderer->scene(), plans), labelled), corner);
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
    state->labelled = session.look().labelled();
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
    const auto whole = [](const auto& file) { return system::wholePath(file).generic_string(); };
    const std::string size = fmt::format("{} x {} pixels", state_->options.width, state_->options.height);
    if (state_->film) return fmt::format("{}: {} frames of {}", whole(wanted.file), count, size);
    const std::string first = whole(firstFile(wanted));
    if (count == 1) return fmt::format("{}: {}", first, size);
    return fmt::format("{} to {}: {} files of {}", first,
                       render::frameFile(wanted.file, count - 1, wanted.frames).filename().generic_string(),
                       count, size);
}
const Hardcopy& HardcopyJob::wanted() const {
    return state_->wanted;
}

namespace {

std::string fileText(const fs::path& file) {
    const auto bytes = image::readFile(file, {file.generic_string(), {}});
    return bytes ? std::string(base::asText(*bytes)) : std::string();
}

}  // namespace

std::string shotText(const Session& session, const std::string& name, const fs::path& folder) {
    suite::Shot shot;
    shot.options = session.renderOptions();
    if (!session.live().isAnimated()) shot.options.time = 0;
    std::string text = fmt::format("[[shot]]\nname = {}\nscript = {}\n", suite::tomlText(name),
                                   suite::tomlText(session.path(), folder));
    if (const std::string without = session.onlyOnScreen(); !without.empty())
        text += fmt::format("# The picture as glibra render draws it, without {}.\n", without);
    return text + suite::optionLines(shot, folder);
}

Diagnostics appendShot(const fs::path& suite, const std::string& name, const Session& session) {
    std::string text = fileText(suite);
    if (!text.empty()) text += text.ends_with('\n') ? "\n" : "\n\n";
    const fs::path folder = suite.parent_path().empty() ? fs::path(".") : suite.parent_path();
    text += shotText(session, name, folder);
    const Result<suite::Suite> read = suite::readSuiteText(text, suite);
    if (!read) return read.diagnostics;
    return image::writeFileAtomically(suite, std::as_bytes(std::span(text)));
}

std::string freeShotName(const fs::path& suite, const Session& session) {
    std::string name = suite::nameOfScene(session.path().filename().generic_string());
    const Result<suite::Suite> read = suite::readSuiteText(fileText(suite), suite);
    const auto isTaken = [&](const std::string& wanted) {
        return read && std::ranges::find(read->shots, wanted, &suite::Shot::name) != read->shots.end();
    };
    const std::string scene = name;
    for (int number = 2; isTaken(name); ++number) name = fmt::format("{}-{}", scene, number);
    return name;
}

}  // namespace glibra::view
