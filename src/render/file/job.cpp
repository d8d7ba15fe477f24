#include "render/file/job.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <deque>
#include <optional>
#include <string_view>
#include <utility>
#include <variant>

#include "gpu/context/call_counter.h"
#include "image/format.h"
#include "image/image.h"
#include "image/video/video_file.h"
#include "image/write.h"
#include "render/check/nan_search.h"
#include "render/check/run_checks.h"
#include "render/consequences.h"
#include "render/file/buffer_file.h"
#include "render/file/picture_writer.h"
#include "render/file/scene_inputs.h"
#include "render/gpu_times.h"
#include "render/scene_renderer.h"
#include "render/stats.h"
#include "scene/textures.h"
#include "system/folder.h"

namespace glibra::render {
namespace {

Diagnostics writeToStandardOutput(const std::vector<std::byte>& png) {
    if (std::fwrite(png.data(), 1, png.size(), stdout) == png.size() && std::fflush(stdout) == 0) return {};
    return {diagnose("file-E10", "cannot write to standard output")};
}

/// "; nothing is in sight: line 7, Teapot: it is behind ..." if all draws were skipped. Their shaders were
/// not compiled, so errors in them are not yet reported.
std::string whyNothingIsSeen(const plan::FramePlan& plan) {
    bool isAnySeen = false;
    plan.visitDraws([&](const auto&...) { isAnySeen = true; });
    if (isAnySeen) return {};
    for (const plan::Skipped& each : plan.skipped)
        if (each.what == "draw")
            return fmt::format("; nothing is in sight: line {}, {}; 'glibra check' compiles its shaders too",
                               each.place.line, each.why);
    return {};
}

/// True for diagnostics whose numbers differ from frame to frame.
bool isOfPixels(const Diagnostic& remark) {
    constexpr std::array<std::string_view, 7> kIds{"draw-N02", "draw-W06", "draw-W09", "glsl-W29",
                                                   "glsl-W30", "glsl-W31", "glsl-W32"};
    return std::ranges::find(kIds, remark.id) != kIds.end();
}

Diagnostics remarksOn(const image::Image& picture, const std::filesystem::path& scene,
                      const std::string& whyNothing, bool isSearched) {
    Diagnostics remarks;
    const Place place{scene.generic_string(), 1, 1};
    if (image::isOneColor(picture))
        remarks.push_back(diagnose("draw-N02", "the picture has only one colour" + whyNothing, place));
    const image::NonFinite bad = image::countNonFinite(picture);
    if (bad.nan + bad.infinite > 0 && !isSearched)
        remarks.push_back(diagnose(
            "draw-W06",
            fmt::format("{} components of the picture are NaN, {} infinite; the first at pixel {}, {}",
                        bad.nan, bad.infinite, bad.x, bad.y),
            place));
    return remarks;
}

}  // namespace

Diagnostics remarksOn(const image::Image& picture, const std::filesystem::path& scene,
                      const plan::FramePlan& plan, bool isSearched) {
    return remarksOn(picture, scene, whyNothingIsSeen(plan), isSearched);
}

std::filesystem::path frameFile(const std::filesystem::path& output, int index, int frames) {
    if (frames <= 1) return output;
    const std::size_t digits = std::max<std::size_t>(4, std::to_string(frames - 1).size());
    std::filesystem::path file = output;
    file.replace_filename(fmt::format("{}_{:0{}}{}", output.stem().generic_string(), index, digits,
                                      output.extension().generic_string()));
    return file;
}

std::filesystem::path filePlaceOf(const std::filesystem::path& file) {
    return system::realPath(file.parent_path()) / system::wholePath(file).filename();
}

namespace {

/// Reports file-E13 for each file of the scene that the job would write over.
Diagnostics reportOverwritten(const scene::Scene& scene, const Job& job) {
    std::vector<std::filesystem::path> written = job.targets;
    if (written.empty()) {
        if (job.output != "-") written.push_back(job.output);
        for (const Job::Save& each : job.saves) written.push_back(each.file);
    }
    std::map<std::filesystem::path, const scene::FileReference*> read;
    for (const scene::FileReference& each : scene.files) {
        if (each.path.empty()) continue;
        std::error_code failure;
        read.try_emplace(filePlaceOf(each.path), &each);
        if (const auto target = std::filesystem::canonical(each.path, failure); !failure)
            read.try_emplace(target, &each);
    }
    Diagnostics errors;
    if (read.empty()) return errors;
    for (const std::filesystem::path& each : written) {
        const bool isFilm = job.frames > 1 && image::holdsAnimation(each);
        const int count = isFilm ? 1 : job.frames;
        const std::filesystem::path place = filePlaceOf(each);
        if (std::ranges::none_of(
                read, [&](const auto& one) { return one.first.parent_path() == place.parent_path(); }))
            continue;
        for (int i = 0; i < count; ++i)
            if (const auto found = read.find(frameFile(place, i, count)); found != read.end())
                errors.push_back(
                    diagnose("file-E13",
                             fmt::format("the scene reads '{}', so nothing is written over it; choose "
                                         "another output name (-o, --save)",
                                         found->second->name),
                             found->second->place));
    }
    return errors;
}

/// A running job.
class JobRun {
  public:
    JobRun(gpu::Context& context, const Job& job) : context_(context), job_(job), options_(job.options) {
        options_.floatPixels = options_.floatPixels || image::holdsFloats(job.output);
        if (job.frames > 1) options_.lastTime = timeOf(job.frames - 1);
        for (const Job::Save& each : job.saves) options_.wantedObjects.push_back(each.object);
        if (job.trace) counter_.emplace();
        if (job.explain || job.stats) {
            if (!counter_) counter_.emplace();
            gpuTimes_.emplace(context.capabilities());
        }
    }

    JobResult run(const std::function<void(int)>& frameWritten, SharedParts* shared) && {
        Result<SceneRenderer> loaded = SceneRenderer::load(context_, job_.scene, options_, stats_, shared);
        append(result_.diagnostics, std::move(loaded.diagnostics));
        Diagnostics overwritten = loaded ? reportOverwritten(loaded->scene(), job_) : Diagnostics();
        result_.failed = !loaded || !overwritten.empty();
        append(result_.diagnostics, std::move(overwritten));
        if (result_.failed) return std::move(result_);
        if (gpuTimes_) loaded->measureGpu(*gpuTimes_);
        if (options_.checkNan) search_ = NanSearch::load(context_, job_.scene, options_);
        if (job_.frames == 1)
            drawPicture(*loaded);
        else
            drawFrames(*loaded, frameWritten);
        applyStrict(result_.diagnostics, options_.strict);
        result_.failed = hasErrors();
        explainTiles();
        countCalls();
        if (gpuTimes_ && gpuTimes_->measures()) stats_.gpu = gpuTimes_->finish();
        if (job_.explain) result_.explanation = job_.scene.generic_string() + "\n" + toText(stats_);
        result_.explanation += trace_;
        if (job_.stats)
            result_.statsJson = toJson(stats_, job_.scene.generic_string(), loaded->width(), loaded->height(),
                                       context_.capabilities().renderer);
        return std::move(result_);
    }

  private:
    /// Draws frame `index`; nothing if it must not be written.
    std::optional<image::Image> draw(SceneRenderer& scene, int index) {
        std::optional<gpu::CallTrace> trace;
        if (job_.trace && index == job_.frames - 1) trace.emplace(context_.debugLog().places());
        Result<image::Image> picture = scene.draw(timeOf(index), stats_);
        if (trace) trace_ = trace->text();
        trace.reset();
        return take(scene, index, std::move(picture), whyNothingIsSeen(scene.plan()));
    }

    /// What remains to be done for the picture of frame `index`. `whyNothing`: of the frame's plan.
    std::optional<image::Image> take(SceneRenderer& scene, int index, Result<image::Image> picture,
                                     const std::string& whyNothing) {
        Diagnostics remarks = std::move(picture.diagnostics);
        if (search_) append(remarks, search_->at(timeOf(index)));
        if (picture && job_.checkOrder && index == 0) append(remarks, checkedOrder());
        if (picture) append(remarks, printed(scene));
        scene::hideTexts(remarks, scene.scene().hiddenFiles);
        if (picture) append(remarks, remarksOn(*picture, job_.scene, whyNothing, options_.checkNan));
        applyStrict(remarks, options_.strict);
        if (picture && (!hasError(remarks) || options_.incomplete)) append(remarks, save(scene, index));
        keepFirst(std::move(remarks), index);
        // What a missing file did not feed is shown all the same; the job has failed.
        return hasErrors() && !options_.incomplete ? std::nullopt : std::move(picture.value);
    }

    [[nodiscard]] Diagnostics checkedOrder() const {
        RenderOptions first = options_;
        first.time = timeOf(0);
        return checkOrder(context_, job_.scene, first);
    }

    /// Writes the textures and buffers of Job::saves.
    Diagnostics save(SceneRenderer& scene, int index) {
        Diagnostics problems;
        // No file appears unless all can be read.
        std::vector<std::variant<image::Image, BufferContent>> contents;
        const auto keep = [&](auto&& content) {
            append(problems, std::move(content.diagnostics));
            if (content) contents.emplace_back(std::move(*content));
            return content.value.has_value();
        };
        for (const Job::Save& each : job_.saves) {
            const Result<scene::ObjectView> view = scene::objectNamed(scene.scene(), each.object);
            if (!view) return view.diagnostics;
            const auto* buffer = std::get_if<scene::BufferView>(&*view);
            const bool isRead = buffer != nullptr
                                    ? keep(scene.bufferContent(*buffer))
                                    : keep(scene.textureImage(std::get<scene::TextureView>(*view)));
            if (!isRead) return problems;
        }
        const StageTimer timer(stats_, "write");
        // The names of frames are this program's.
        const image::NamedBy named = job_.frames > 1 ? image::NamedBy::program : image::NamedBy::user;
        for (std::size_t i = 0; i < contents.size(); ++i) {
            const std::filesystem::path file = frameFile(job_.saves[i].file, index, job_.frames);
            const auto* picture = std::get_if<image::Image>(&contents[i]);
            append(problems, picture != nullptr
                                 ? image::writeImage(*picture, file, image::writtenAs(named))
                                 : writeBuffer(std::get<BufferContent>(contents[i]), file, named));
        }
        return problems;
    }

    /// Keeps a diagnostic only in the first frame that has one of its subject.
    void keepFirst(Diagnostics remarks, int frame) {
        for (Diagnostic& each : remarks) {
            const auto first = reported_.try_emplace(subjectOf(each), frame).first;
            if (first->second != frame) continue;
            if (job_.frames == 1) {
                result_.diagnostics.push_back(std::move(each));
                continue;
            }
            if (isOfPixels(each)) each.text += fmt::format(" (frame {})", frame);
            result_.ofFrames[frame].push_back(std::move(each));
        }
    }

    [[nodiscard]] bool hasErrors() const {
        return hasError(result_.diagnostics) ||
               std::ranges::any_of(result_.ofFrames, [](const auto& each) { return hasError(each.second); });
    }

    void drawPicture(SceneRenderer& scene) {
        const std::optional<image::Image> picture = draw(scene, 0);
        if (!picture) return;
        const StageTimer timer(stats_, "write");
        append(result_.diagnostics,
               job_.output == "-" ? writeToStandardOutput(image::encodePng(*picture))
                                  : image::writeImage(*picture, job_.output, image::writtenAs(job_.named)));
    }

    /// For each frame, the first frame that shows the same picture.
    [[nodiscard]] std::vector<int> firstAlike(const SceneRenderer& scene) const {
        std::map<Moment, int> known;
        std::vector<int> first(static_cast<std::size_t>(job_.frames));
        for (int i = 0; i < job_.frames; ++i) {
            const std::optional<Moment> moment = options_.skip ? scene.momentOf(timeOf(i)) : std::nullopt;
            first[static_cast<std::size_t>(i)] = moment ? known.try_emplace(*moment, i).first->second : i;
        }
        return first;
    }

    /// For each frame, whether this part draws it or copies it from one that it draws. The parts take turns,
    /// so that each has as much to do.
    [[nodiscard]] std::vector<bool> ownFrames(const SceneRenderer& scene,
                                              const std::vector<int>& firstAlike) const {
        const bool isDivided = job_.parts > 1 && !scene.remembersFrames() && !scene.runsSteps() &&
                               context_.capabilities().isSoftware;
        std::vector<bool> isOwn(firstAlike.size(), !isDivided && job_.part == 0);
        if (!isDivided) return isOwn;
        int turn = 0;
        for (std::size_t i = 0; i < firstAlike.size(); ++i) {
            const auto first = static_cast<std::size_t>(firstAlike[i]);
            isOwn[i] = first == i ? turn++ % job_.parts == job_.part : static_cast<bool>(isOwn[first]);
        }
        return isOwn;
    }

    [[nodiscard]] double timeOf(int frame) const { return options_.time + frame / job_.framesPerSecond; }

    /// Draws frames. Where the device works beside this process, a frame is read while the next one is drawn,
    /// unless something else is read between two frames.
    class PicturesAhead {
      public:
        /// `give` gets the pictures in order, and returns false to stop.
        PicturesAhead(JobRun& run, SceneRenderer& scene, std::function<bool(int, image::Image)> give)
            : run_(run),
              scene_(scene),
              give_(std::move(give)),
              isAhead_(scene.gainsFromDrawingAhead() && !run.search_ && run.job_.saves.empty() &&
                       !run.job_.trace && scene.scene().prints.empty()) {}

        /// False if no more frames are to be drawn.
        bool draw(int frame) {
            if (!isAhead_) {
                std::optional<image::Image> picture = run_.draw(scene_, frame);
                return picture && give_(frame, std::move(*picture));
            }
            scene_.drawAhead(run_.timeOf(frame), run_.stats_);
            begun_.push_back({frame, whyNothingIsSeen(scene_.plan())});
            return begun_.size() < SceneRenderer::kMostAhead || finishFirst();
        }
        /// Gives the pictures that were begun.
        bool finish() {
            while (!begun_.empty())
                if (!finishFirst()) return false;
            return true;
        }

      private:
        struct Begun {
            int frame;
            std::string whyNothing;
        };
        bool finishFirst() {
            const Begun begun = std::move(begun_.front());
            begun_.pop_front();
            std::optional<image::Image> picture =
                run_.take(scene_, begun.frame, scene_.takeDrawn(run_.stats_), begun.whyNothing);
            return picture && give_(begun.frame, std::move(*picture));
        }

        JobRun& run_;
        SceneRenderer& scene_;
        std::function<bool(int, image::Image)> give_;
        bool isAhead_;
        std::deque<Begun> begun_;
    };

    /// The pictures follow each other, as ffmpeg -f image2pipe reads them.
    void drawFramesToStandardOutput(SceneRenderer& scene, const std::function<void(int)>& frameWritten) {
        const std::vector<int> first = firstAlike(scene);
        PictureStream stream(writeToStandardOutput, [&](int frame) { frameWritten(frame + 1); });
        PicturesAhead pictures(*this, scene, [&](int frame, image::Image picture) {
            return frame < job_.written || stream.add(frame, std::move(picture));
        });
        int shown = -1;  // the first frame like the one before
        bool goesOn = true;
        for (int i = 0; i < job_.frames && goesOn; ++i) {
            const bool isWritten = i < job_.written;
            if (isWritten && !scene.remembersFrames()) continue;
            if (std::exchange(shown, first[static_cast<std::size_t>(i)]) !=
                first[static_cast<std::size_t>(i)])
                goesOn = pictures.draw(i);
            else if (!isWritten)
                goesOn = pictures.finish() && stream.addAgain(i);
        }
        if (goesOn) pictures.finish();
        const StageTimer timer(stats_, "write");
        append(result_.diagnostics, stream.finish());
    }

    void drawFrames(SceneRenderer& scene, const std::function<void(int)>& frameWritten) {
        if (job_.output == "-") return drawFramesToStandardOutput(scene, frameWritten);
        const std::vector<int> first = firstAlike(scene);
        const std::vector<bool> isOwn = ownFrames(scene, first);
        PictureWriter writer(frameWritten);
        const auto fileOf = [this](int frame) { return frameFile(job_.output, frame, job_.frames); };
        PicturesAhead pictures(*this, scene, [&](int frame, image::Image picture) {
            return writer.add(std::move(picture), fileOf(frame));
        });
        int drawn = 0, copies = 0;
        bool goesOn = true;
        for (int i = 0; i < job_.frames && goesOn; ++i) {
            const auto index = static_cast<std::size_t>(i);
            if (!isOwn[index]) continue;
            if (first[index] == i) {
                ++drawn;
                goesOn = pictures.draw(i);
                continue;
            }
            ++copies;
            goesOn = pictures.finish() && writer.addCopy(fileOf(first[index]), fileOf(i));
            if (goesOn) copySaves(first[index], i);
        }
        if (goesOn) pictures.finish();
        append(result_.diagnostics, writer.finish());
        if (copies == 0) return;
        stats_.add("frames copied", static_cast<std::uint64_t>(copies));
        stats_.skip("frames",
                    drawn == 1 ? fmt::format("{} of {} are copies of the first: no draw reads Timer", copies,
                                             job_.frames)
                               : fmt::format("{} of {} are copies of earlier frames with the same Timer",
                                             copies, job_.frames),
                    {job_.scene.generic_string(), 1, 1});
    }

    void copySaves(int from, int to) {
        for (const Job::Save& each : job_.saves)
            append(result_.diagnostics,
                   copyFile(frameFile(each.file, from, job_.frames), frameFile(each.file, to, job_.frames)));
    }

    void explainTiles() {
        for (const Stats::Count& each : stats_.counts)
            if (each.name == kDrawsOutOfTheirTile)
                stats_.skip("draws", fmt::format("{} lie outside their tile", each.value),
                            {job_.scene.generic_string(), 1, 1});
    }

    void countCalls() {
        if (!counter_) return;
        const gpu::CallCounts& counts = counter_->counts();
        stats_.add("GL calls", counts.calls);
        stats_.add("GL draws", counts.draws);
        stats_.add("programs linked", counts.programsLinked);
        stats_.add("buffers filled", counts.buffersFilled);
        stats_.add("textures filled", counts.texturesFilled);
        stats_.add("bytes uploaded", counts.bytesUploaded);
        stats_.add("pixels read", counts.pixelsRead);
    }

    gpu::Context& context_;
    const Job& job_;
    RenderOptions options_;
    Stats stats_;
    std::optional<gpu::CallCounter> counter_;
    std::optional<GpuTimes> gpuTimes_;
    Result<NanSearch> search_;
    JobResult result_;
    std::string trace_;
    std::map<Subject, int> reported_;  ///< the first frame of each subject
};

}  // namespace

JobResult runJob(gpu::Context& context, const Job& job, const std::function<void(int)>& frameWritten,
                 SharedParts* shared) {
    return JobRun(context, job).run(frameWritten, shared);
}

}  // namespace glibra::render
