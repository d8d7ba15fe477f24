#include "render/job.h"

#include <fmt/format.h>

#include <condition_variable>
#include <cstdio>
#include <deque>
#include <mutex>
#include <set>
#include <string>
#include <thread>

#include "image/inspect.h"
#include "image/write.h"
#include "render/nan_search.h"
#include "render/scene_renderer.h"
#include "render/stats.h"

namespace glibra::render {
namespace {

/// Encodes and writes pictures on a thread of its own, in order, while the next one is drawn. At most two
/// wait, so that memory stays bounded when encoding is the slower part.
class PictureWriter {
  public:
    explicit PictureWriter(const std::function<void(int)>& written) : written_(written) {
        thread_ = std::jthread([this] { run(); });
    }
    PictureWriter(const PictureWriter&) = delete;
    PictureWriter& operator=(const PictureWriter&) = delete;
    ~PictureWriter() { finish(); }

    /// False once a picture could not be written: there is no use in drawing more.
    bool add(image::Image picture, std::filesystem::path file) {
        std::unique_lock lock(mutex_);
        changed_.wait(lock, [this] { return waiting_.size() < 2 || failed_; });
        if (failed_) return false;
        waiting_.push_back({std::move(picture), std::move(file)});
        changed_.notify_all();
        return true;
    }

    /// Waits for all pictures; returns what went wrong.
    Diagnostics finish() {
        {
            const std::scoped_lock lock(mutex_);
            closed_ = true;
            changed_.notify_all();
        }
        if (thread_.joinable()) thread_.join();
        return std::move(problems_);
    }

  private:
    struct Item {
        image::Image picture;
        std::filesystem::path file;
    };

    void run() {
        for (int count = 1;; ++count) {
            Item item;
            {
                std::unique_lock lock(mutex_);
                changed_.wait(lock, [this] { return !waiting_.empty() || closed_; });
                if (waiting_.empty()) return;
                item = std::move(waiting_.front());
                waiting_.pop_front();
                changed_.notify_all();
            }
            Diagnostics problems = image::writeImage(item.picture, item.file);
            const bool bad = hasError(problems);
            {
                const std::scoped_lock lock(mutex_);
                append(problems_, std::move(problems));
                if (bad) {
                    failed_ = true;
                    waiting_.clear();
                    changed_.notify_all();
                    return;
                }
            }
            written_(count);
        }
    }

    const std::function<void(int)>& written_;
    std::mutex mutex_;
    std::condition_variable changed_;
    std::deque<Item> waiting_;
    Diagnostics problems_;
    bool closed_ = false;
    bool failed_ = false;
    std::jthread thread_;
};

Diagnostics writeToStandardOutput(const image::Image& picture) {
    const std::vector<std::byte> png = image::encodePng(picture);
    if (std::fwrite(png.data(), 1, png.size(), stdout) == png.size() && std::fflush(stdout) == 0) return {};
    return {error("file-E10", "cannot write to standard output")};
}

bool wantsFloat(const std::filesystem::path& output) {
    std::string ending = output.extension().string();
    for (char& c : ending) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    return ending == ".exr" || ending == ".hdr" || ending == ".pfm";
}

}  // namespace

Diagnostics remarksOn(const image::Image& picture, const std::filesystem::path& scene, bool isSearched) {
    Diagnostics remarks;
    const Place place{scene.string(), 1, 1};
    if (image::isOneColor(picture))
        remarks.push_back(note("draw-N02", "the picture has only one colour", place));
    const image::NonFinite bad = image::countNonFinite(picture);
    if (bad.nan + bad.infinite > 0 && !isSearched)
        remarks.push_back(warning(
            "draw-W06",
            fmt::format("{} components of the picture are NaN, {} infinite; the first at pixel {}, {}",
                        bad.nan, bad.infinite, bad.x, bad.y),
            place));
    return remarks;
}

std::filesystem::path frameFile(const std::filesystem::path& output, int index, int frames) {
    if (frames <= 1) return output;
    const std::size_t digits = std::max<std::size_t>(4, std::to_string(frames - 1).size());
    std::filesystem::path file = output;
    file.replace_filename(
        fmt::format("{}_{:0{}}{}", output.stem().string(), index, digits, output.extension().string()));
    return file;
}

JobResult runJob(gpu::Context& context, const Job& job, const std::function<void(int)>& frameWritten) {
    JobResult result;
    Stats stats;
    RenderOptions options = job.options;
    options.floatPixels = options.floatPixels || wantsFloat(job.output);

    Result<SceneRenderer> loaded = SceneRenderer::load(context, job.scene, options, stats);
    append(result.diagnostics, std::move(loaded.diagnostics));
    if (!loaded) {
        result.failed = true;
        return result;
    }
    Result<NanSearch> search;
    if (options.checkNan) search = NanSearch::load(context, job.scene, options);
    const auto checkNan = [&](double time) {
        if (search) append(result.diagnostics, search->at(time));
    };
    // Of an animation the first frame of one colour and the first with NaN are told.
    std::set<std::string> told;
    const auto remark = [&](const image::Image& picture) {
        for (Diagnostic& each : remarksOn(picture, job.scene, options.checkNan))
            if (told.insert(each.id).second) result.diagnostics.push_back(std::move(each));
        applyStrict(result.diagnostics, options.strict);
        return !hasError(result.diagnostics);
    };
    const auto writeOne = [&](const image::Image& picture) {
        const StageTimer timer(stats, "write");
        return job.output == "-" ? writeToStandardOutput(picture) : image::writeImage(picture, job.output);
    };
    if (job.frames == 1) {
        Result<image::Image> picture = loaded->draw(options.time, stats);
        append(result.diagnostics, std::move(picture.diagnostics));
        checkNan(options.time);
        if (picture && remark(*picture)) append(result.diagnostics, writeOne(*picture));
    } else {
        PictureWriter writer(frameWritten);
        for (int i = 0; i < job.frames; ++i) {
            Result<image::Image> picture = loaded->draw(options.time + i / job.framesPerSecond, stats);
            append(result.diagnostics, std::move(picture.diagnostics));
            checkNan(options.time + i / job.framesPerSecond);
            if (!picture || !remark(*picture)) break;
            if (!writer.add(std::move(*picture), frameFile(job.output, i, job.frames))) break;
        }
        append(result.diagnostics, writer.finish());
    }
    result.failed = hasError(result.diagnostics);
    stats.skipped = loaded->plan().skipped;
    if (job.explain) result.explanation = job.scene.string() + "\n" + toText(stats);
    if (job.stats)
        result.statsJson = toJson(stats, job.scene.string(), loaded->width(), loaded->height(),
                                  context.capabilities().renderer);
    return result;
}

}  // namespace glibra::render
