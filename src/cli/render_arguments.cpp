#include "cli/render_arguments.h"

#include <fmt/format.h>
#include <algorithm>
#include <charconv>
#include <cstdio>
#include <ranges>
#include <set>
#include <span>
#include <system_error>
#include <utility>

#include "base/contained_call.h"
#include "base/utf8.h"
#include "base/workers.h"
#include "cli/commands.h"
#include "cli/file_access.h"
#include "cli/render_answer.h"
#include "cli/scene_arguments.h"
#include "gpu/context/context.h"
#include "image/png/png_reader.h"
#include "image/video/video_file.h"
#include "render/file/scene_inputs.h"
#include "suite/file/shot_name.h"
#include "suite/run/run_options.h"
#include "system/interruption.h"

namespace glibra::cli {

namespace fs = std::filesystem;

namespace {

/// False for a path that cannot be looked up, too: the file there is reported when it is written.
bool isFolder(const fs::path& path) {
    std::error_code failed;
    return fs::is_directory(path, failed);
}

bool writesIntoFolder(const RenderArguments& arguments) {
    return arguments.outputIsFolder || isFolder(arguments.output) || arguments.output.back() == '/';
}

/// The scene itself if there is no current folder any more.
fs::path absolutePath(const std::string& scene) {
    std::error_code failed;
    const fs::path path = fs::absolute(scene, failed);
    return (failed ? fs::path(scene) : path).lexically_normal();
}

/// The file that each scene is written to. Without -o it is the scene's name in the current folder. Where two
/// scenes have the same name, for a disk that ignores upper and lower case too, they keep the folders in
/// which they differ.
std::vector<fs::path> outputFiles(const RenderArguments& arguments) {
    std::vector<fs::path> names;
    std::set<std::string> distinct;
    for (const std::string& scene : arguments.scenes) {
        names.push_back(scene == kStandardInput ? "stdin.png"
                                                : fs::path(scene).filename().replace_extension(".png"));
        distinct.insert(suite::nameOnAnyDisk(names.back().generic_string()));
    }
    if (distinct.size() < names.size()) {
        fs::path common = absolutePath(arguments.scenes.front()).parent_path();
        for (const std::string& scene : arguments.scenes) {
            const fs::path folder = absolutePath(scene).parent_path();
            while (!common.empty() && common != common.parent_path() &&
                   std::mismatch(common.begin(), common.end(), folder.begin(), folder.end()).first !=
                       common.end())
                common = common.parent_path();
        }
        for (std::size_t i = 0; i < names.size(); ++i)
            names[i] = absolutePath(arguments.scenes[i]).lexically_relative(common).replace_extension(".png");
    }
    if (arguments.output.empty()) return names;
    const bool goesIntoFolder = writesIntoFolder(arguments);
    for (fs::path& name : names)
        name = goesIntoFolder ? fs::path(arguments.output) / name : fs::path(arguments.output);
    return names;
}

namespace fs = std::filesystem;

/// Reads a frame with the PNG reader alone, since a worker that a scene has taken over may have written
/// something else.
Result<image::Image> readFrame(const fs::path& file) {
    const image::FileLabel label{file.filename().generic_string(), {}};
    const auto bytes = image::readFile(file, label);
    if (!bytes) return bytes.diagnostics;
    return image::decodePng(*bytes, label);
}

namespace fs = std::filesystem;

constexpr Deed kDrawing{"drew", "drawn"};

/// The number of workers that draw so many pieces.
int jobsOf(const RenderArguments& arguments, std::size_t pieces) {
    return suite::drawingJobs(arguments.jobs, arguments.driver, pieces);
}

std::uint64_t memoryOf(const RenderArguments& arguments, std::size_t pieces) {
    return arguments.picture.memory.value_or(base::memoryShare(jobsOf(arguments, pieces), pieces));
}

/// A worker's count, at most `most`, whatever the text is.
int countIn(const std::string& text, int most) {
    int count = 0;
    std::from_chars(text.data(), text.data() + text.size(), count);
    return std::clamp(count, 0, most);
}

/// The number of processes that share the frames of an animation. On a software rasteriser two processes with
/// half of the frames each are faster than one with all its threads. Figures and explanations need one
/// process.
/// The frames that differ are counted in a worker, since that reads the scene and its shaders. Without a
/// value the worker did not answer in time, and the error is in `late`.
std::optional<int> partsOf(const RenderArguments& arguments, const system::Sandbox* sandbox,
                           const std::function<bool()>& stop, Diagnostics& late) {
    constexpr int kLeastFrames = 8;  // what the start of a process costs
    constexpr int kMostParts = 8;    // each holds everything that the scene reads
    const int most =
        std::min({arguments.frames / kLeastFrames, kMostParts, suite::readingJobs(arguments.jobs)});
    if (arguments.scenes.size() > 1 || arguments.output == "-" || arguments.explain || arguments.trace ||
        !arguments.statsFile.empty() || most < 2 || gpu::mayUseHardware(arguments.driver))
        return 1;
    std::optional<int> parts = 1;  // if the worker crashes, so does the one that draws, which is reported
    const std::string& scene = arguments.scenes.front();
    base::runInWorkers(
        1,
        {.timeout = arguments.picture.timeout,
         .memory = memoryOf(arguments, 1),
         .stop = stop,
         .sandbox = sandbox},
        [&](std::size_t, const base::Step&) {
            return std::to_string(render::mostDifferentFrames(
                scene, optionsFor(scene, arguments.standardInput, arguments.picture.options),
                arguments.frames, arguments.framesPerSecond, most * kLeastFrames));
        },
        [&](std::size_t, const base::Outcome& outcome) {
            if (outcome.end == base::Outcome::End::finished)
                parts = std::max(1, countIn(outcome.answer, most * kLeastFrames) / kLeastFrames);
            if (outcome.end == base::Outcome::End::timedOut) {
                parts.reset();
                late = answerOf(outcome, scene, arguments.picture, kDrawing).remarks.general;
            }
        },
        [](std::size_t, const std::string&) {});
    return parts;
}

/// Runs in the worker. It opens the context with its first job and keeps it.
class JobRunner {
  public:
    /// Each scene is drawn in `parts` pieces.
    /// `written` are the frames that earlier workers have written, per piece.
    JobRunner(const RenderArguments& arguments, std::vector<fs::path> outputs, std::size_t parts,
              const StagingFolder* staging, const std::vector<int>& written)
        : arguments_(arguments),
          outputs_(std::move(outputs)),
          parts_(parts),
          staging_(staging),
          written_(written) {}

    std::string operator()(std::size_t piece, const base::Step& step) {
        const std::size_t index = piece / parts_;
        if (!context_) {
            const std::size_t pieces = arguments_.scenes.size() * parts_;
            suite::shareProcessors(jobsOf(arguments_, pieces), pieces);
            Result<gpu::Context> opened = gpu::openContext({.driver = arguments_.driver});
            if (!opened) return pack({.status = kNoDriver, .remarks = {std::move(opened.diagnostics), {}}});
            context_.emplace(std::move(*opened));
        }
        render::Job job;
        static_cast<render::JobOptions&>(job) = arguments_;
        job.scene = arguments_.scenes[index];
        const auto fileOf = [&](const fs::path& file) {
            return staging_ && file != "-" ? staging_->fileOf(piece, file) : file;
        };
        job.output = fileOf(isFilm(arguments_) ? framesOf(outputs_[index]) : outputs_[index]);
        if (staging_ && arguments_.output != "-") job.targets.push_back(outputs_[index]);
        for (const std::string& each : arguments_.saves) {
            render::Job::Save save = readSave(each).value();
            if (staging_) job.targets.push_back(save.file);
            save.file = fileOf(save.file);
            job.saves.push_back(std::move(save));
        }
        job.named = namedBy(arguments_);
        job.options =
            optionsFor(job.scene.generic_string(), arguments_.standardInput, arguments_.picture.options);
        job.written = written_[piece];
        job.part = static_cast<int>(piece % parts_);
        job.parts = static_cast<int>(parts_);
        job.stats = !arguments_.statsFile.empty();
        return pack(guarded(arguments_.scenes[index], [&] {
            render::JobResult result =
                render::runJob(*context_, job, [&](int written) { step(std::to_string(written)); }, &shared_);
            Answer answer{.status = result.failed ? kSceneIsWrong : kDone,
                          .remarks = {std::move(result.diagnostics), std::move(result.ofFrames)},
                          .explanation = std::move(result.explanation),
                          .statsJson = std::move(result.statsJson)};
            if (quotesLines_) answer.lines = linesOf(answer.remarks.general, arguments_.standardInput);
            return answer;
        }));
    }

  private:
    const RenderArguments& arguments_;
    std::vector<fs::path> outputs_;
    std::size_t parts_;
    const StagingFolder* staging_;
    const std::vector<int>& written_;
    bool quotesLines_ = system::isTerminal(system::Standard::error);  // a confined worker has no terminal
    std::optional<gpu::Context> context_;
    render::SharedParts shared_;  // after the context, because it must be destroyed first
};

/// The line "[3/60] scene.glib", which is rewritten on a terminal and not shown elsewhere.
class ProgressLine {
  public:
    ProgressLine(bool shown, std::size_t scenes, int frames)
        : shown_(shown && (scenes > 1 || frames > 1)), total_(scenes * static_cast<std::size_t>(frames)) {}
    void show(std::size_t done, const std::string& what) const {
        if (shown_)
            std::fprintf(stderr, "\r\033[K[%zu/%zu] %s", done, total_, base::printableText(what).c_str());
    }
    void clear() const {
        if (shown_) std::fputs("\r\033[K", stderr);
    }

  private:
    bool shown_;
    std::size_t total_;
};

/// All scenes of one command: gives them to worker processes and collects the answers.
class SceneBatch {
  public:
    /// Each scene is drawn in `parts` pieces, in the sandbox if there is one.
    SceneBatch(const RenderArguments& arguments, std::size_t parts, std::optional<system::Sandbox> sandbox,
               const system::Interruption& interruption)
        : arguments_(arguments),
          interruption_(interruption),
          outputs_(outputFiles(arguments)),
          parts_(parts),
          sandbox_(std::move(sandbox)),
          progress_(system::isTerminal(system::Standard::error), arguments.scenes.size(), arguments.frames),
          stats_(arguments.scenes.size()),
          framesWritten_(arguments.scenes.size() * parts_) {}

    /// Returns the exit status.
    int run() {
        if (printErrors(overwritten())) return kSceneIsWrong;
        if (printErrors(linkedFolders())) return kSceneIsWrong;
        std::set<fs::path> folders;
        for (const fs::path& each : writtenFiles()) folders.insert(each.parent_path());
        for (const fs::path& each : folders) {
            makeFolders(each);
            image::removeAbandonedFiles(each);
        }
        if (!confine()) return kSceneIsWrong;
        JobRunner runner(arguments_, outputs_, parts_, staging_ ? &*staging_ : nullptr, framesWritten_);
        base::runInWorkers(
            framesWritten_.size(),
            {.workers = jobsOf(arguments_, framesWritten_.size()),
             .timeout = arguments_.picture.timeout,
             .memory = memoryOf(arguments_, framesWritten_.size()),
             .stop = [this] { return interruption_.signal() != 0; },
             .sharesDevice = gpu::mayUseHardware(arguments_.driver),
             .repeated = [this](std::size_t piece, const base::Outcome& outcome) { clean(piece, outcome); },
             .sandbox = sandbox_ ? &*sandbox_ : nullptr},
            std::ref(runner),
            [this](std::size_t piece, const base::Outcome& outcome) { pieceEnds(piece, outcome); },
            [this](std::size_t piece, const std::string& text) {
                countFrames(piece, countIn(text, arguments_.frames));
            });
        if (isFilm(arguments_)) joinFrames();
        staging_.reset();
        removeEmptyFolders();
        progress_.clear();
        print(render::joined(remarks_), lines_);
        interruption_.obey();
        if (arguments_.scenes.size() > 1) printSummary();
        if (!arguments_.statsFile.empty()) writeStats();
        return status_;
    }

  private:
    /// file-E13 for files that would replace one that another scene of the command reads, or a scene. What a
    /// scene itself reads is known to its worker; this pass asks for all before the first is drawn.
    [[nodiscard]] Diagnostics overwritten() const {
        const bool hasStats = !arguments_.statsFile.empty() && arguments_.statsFile != "-";
        if (arguments_.scenes.size() == 1 && !hasStats) return {};
        std::vector<fs::path> written;
        for (const fs::path& file : writtenFiles())
            for (int frame = 0; frame < arguments_.frames; ++frame)
                written.push_back(render::frameFile(file, frame, arguments_.frames));
        if (!anyExists(written) && !(hasStats && anyExists(std::vector<fs::path>{arguments_.statsFile})))
            return {};
        const ReadFiles read =
            filesReadBy(arguments_.scenes, arguments_.standardInput, arguments_.picture.options,
                        {.workers = suite::readingJobs(arguments_.jobs),
                         .timeout = arguments_.picture.timeout,
                         .memory = memoryOf(arguments_, arguments_.scenes.size()),
                         .stop = [this] { return interruption_.signal() != 0; },
                         .sandbox = sandbox_ ? &*sandbox_ : nullptr});
        Diagnostics problems;
        for (const fs::path& each : written) append(problems, read.overwrittenBy(each, "-o"));
        if (hasStats) append(problems, read.overwrittenBy(arguments_.statsFile, "--stats"));
        return problems;
    }

    void makeFolders(const fs::path& folder) {
        std::error_code failure;
        if (folder.empty() || fs::exists(folder, failure)) return;
        makeFolders(folder.parent_path());
        // A failure is reported with the file that cannot be written.
        if (fs::create_directory(folder, failure)) madeFolders_.push_back(folder);
    }
    /// Scenes that failed leave no folders behind.
    void removeEmptyFolders() const {
        std::error_code notEmpty;
        for (const auto& madeFolder : std::ranges::reverse_view(madeFolders_))
            fs::remove(madeFolder, notEmpty);
    }

    /// With --untrusted, and for the frames of a film, the workers write to a folder of their own.
    bool confine() {
        if (!sandbox_ && !isFilm(arguments_)) return true;
        if (sandbox_ && arguments_.output == "-") sandbox_->standardOutput = true;
        const std::vector<fs::path> files = writtenFiles();
        if (files.empty()) return true;
        const fs::path folder = files.front().parent_path();
        staging_.emplace(folder);
        if (staging_->path().empty()) {
            print({image::cannotWrite(folder.empty() ? "." : folder, "no folder can be made in it")});
            return false;
        }
        if (sandbox_) sandbox_->writable.emplace_back(staging_->path());
        return true;
    }

    /// file-E10 for folders of pictures that this command names and that are links: scenes of one name lie
    /// below the output folder as the scenes lie below theirs.
    [[nodiscard]] Diagnostics linkedFolders() const {
        Diagnostics problems;
        const fs::path root = arguments_.output.empty() ? fs::path(".") : fs::path(arguments_.output);
        std::set<fs::path> seen;
        for (const fs::path& each : outputs_) {
            const fs::path below = each.parent_path().lexically_relative(root);
            fs::path way = root;
            for (const fs::path& part : below.empty() || *below.begin() == ".." ? fs::path() : below) {
                way /= part;
                std::error_code failure;
                if (seen.insert(way).second && fs::is_symlink(fs::symlink_status(way, failure)))
                    problems.push_back(image::cannotWrite(
                        each,
                        fmt::format("the folder '{}' is a link; name it with -o", way.generic_string())));
            }
        }
        return problems;
    }

    /// Makes the film of the frames that the workers have drawn.
    void joinFrames() {
        const auto stop = [this] { return interruption_.signal() != 0; };
        const auto fileOf = [this](int frame) {
            const fs::path file = render::frameFile(framesOf(outputs_.front()), frame, arguments_.frames);
            for (std::size_t piece = 0; piece < parts_; ++piece)
                if (auto found = staging_->find(piece, file)) return found;
            return std::optional<fs::path>();
        };
        Diagnostics problems =
            writeFilm({outputs_.front(), arguments_.frames, arguments_.framesPerSecond}, fileOf, stop);
        if (problems.empty()) return;
        status_ = std::max(status_, kSceneIsWrong);
        remarks_.push_back({std::move(problems), {}});
    }

    /// The pictures and the saved textures, without standard output.
    [[nodiscard]] std::vector<fs::path> writtenFiles() const {
        std::vector<fs::path> files;
        if (arguments_.output != "-") files = outputs_;
        for (const std::string& each : arguments_.saves) files.push_back(readSave(each).value().file);
        return files;
    }

    void countFrames(std::size_t piece, int written) {
        doneCount_ += static_cast<std::size_t>(written - framesWritten_[piece]);
        framesWritten_[piece] = written;
        progress_.show(doneCount_, arguments_.scenes[piece / parts_]);
    }

    /// A worker that ends by itself cannot remove what it has half written.
    void clean(std::size_t piece, const base::Outcome& outcome) const {
        image::removeTemporaryFiles(outputs_[piece / parts_].parent_path(), outcome.process);
    }

    /// Has messages about files in the staging folder name the film, or the files without the folder.
    void nameTargets(Diagnostics& messages, std::size_t piece) const {
        const std::string folder = staging_ ? staging_->fileOf(piece, "").generic_string() : "\n";
        for (Diagnostic& each : messages)
            if (const std::size_t at = each.text.find(folder); at != std::string::npos)
                each.text.replace(at, isFilm(arguments_) ? each.text.find('\'', at) - at : folder.size(),
                                  isFilm(arguments_) ? outputs_[piece / parts_].generic_string() : "");
    }

    void pieceEnds(std::size_t piece, const base::Outcome& outcome) {
        const std::size_t index = piece / parts_;
        const std::string& scene = arguments_.scenes[index];
        if (outcome.end != base::Outcome::End::finished) clean(piece, outcome);
        Diagnostics undelivered;
        std::vector<std::pair<fs::path, image::NamedBy>> delivered;
        if (staging_ && arguments_.output != "-" && !isFilm(arguments_))
            delivered.emplace_back(outputs_[index], namedBy(arguments_));
        if (staging_)
            for (const std::string& each : arguments_.saves)
                delivered.emplace_back(readSave(each).value().file, arguments_.frames > 1
                                                                        ? image::NamedBy::program
                                                                        : image::NamedBy::user);
        for (const auto& [file, named] : delivered)
            for (int frame = 0; frame < arguments_.frames; ++frame)
                append(undelivered,
                       staging_->deliver(piece, render::frameFile(file, frame, arguments_.frames), named));
        if (outcome.end == base::Outcome::End::stopped) return;
        Answer answer = answerOf(outcome, scene, arguments_.picture, kDrawing);
        nameTargets(answer.remarks.general, piece);
        for (auto& [frame, remarks] : answer.remarks.ofFrames) nameTargets(remarks, piece);
        if (hasError(undelivered)) answer.status = std::max(answer.status, kSceneIsWrong);
        append(answer.remarks.general, std::move(undelivered));
        progress_.clear();
        if (parts_ > 1) {
            remarks_.push_back(std::move(answer.remarks));
            lines_.merge(answer.lines);
        } else {
            print(render::joined({answer.remarks}), answer.lines);
        }
        const std::string explanation = base::printableText(answer.explanation, true);
        std::fwrite(explanation.data(), 1, explanation.size(), stdout);
        std::fflush(stdout);
        stats_[index] = std::move(answer.statsJson);
        status_ = std::max(status_, answer.status);
        if (answer.status != kDone) failed_.push_back(scene);
        if (parts_ == 1)
            countFrames(piece, arguments_.frames);
        else
            progress_.show(doneCount_, scene);
    }

    void printSummary() const {
        std::string summary = fmt::format(
            "{} of {} scenes rendered", arguments_.scenes.size() - failed_.size(), arguments_.scenes.size());
        for (std::size_t i = 0; i < failed_.size(); ++i)
            summary += (i == 0 ? ", failed: " : ", ") + failed_[i];
        printLine(summary);
    }

    void writeStats() {
        std::string all;
        for (const std::string& each : stats_)
            if (!each.empty()) all += (all.empty() ? "" : ",\n") + each;
        if (arguments_.scenes.size() > 1) all = "[" + all + "]";
        all += '\n';
        if (arguments_.statsFile == "-") {
            const std::string safe = base::printableText(all, true);
            std::fwrite(safe.data(), 1, safe.size(), stdout);
            return;
        }
        if (printErrors(image::writeFileAtomically(arguments_.statsFile, std::as_bytes(std::span(all)))))
            status_ = std::max(status_, kSceneIsWrong);
    }

    const RenderArguments& arguments_;
    const system::Interruption& interruption_;
    std::vector<fs::path> outputs_;
    std::size_t parts_;
    std::optional<system::Sandbox> sandbox_;
    std::optional<StagingFolder> staging_;
    ProgressLine progress_;
    int status_ = kDone;
    std::vector<std::string> failed_;
    std::vector<fs::path> madeFolders_;              ///< each after the one that it is in
    SourceLines lines_;                              ///< for remarks_
    std::vector<std::string> stats_;                 ///< JSON, one per scene
    std::vector<int> framesWritten_;                 ///< one per piece
    std::size_t doneCount_ = 0;                      ///< frames of all pieces
    std::vector<render::AnimationRemarks> remarks_;  ///< of the parts of an animation, printed at the end
};

}  // namespace

image::NamedBy namedBy(const RenderArguments& arguments) {
    return arguments.output.empty() || arguments.frames > 1 || writesIntoFolder(arguments)
               ? image::NamedBy::program
               : image::NamedBy::user;
}

bool isFilm(const RenderArguments& arguments) {
    return arguments.frames > 1 && !arguments.outputIsFolder && !isFolder(arguments.output) &&
           image::holdsAnimation(arguments.output);
}

fs::path framesOf(fs::path film) {
    return film.replace_extension(".png");
}

Diagnostics writeFilm(const Film& film, const std::function<std::optional<fs::path>(int)>& frameFile,
                      const std::function<bool()>& stop) {
    for (int i = 0; i < film.frames; ++i)
        if (!frameFile(i)) return {};
    std::optional<image::VideoFile> video;
    for (int i = 0; i < film.frames && !stop(); ++i) {
        const Result<image::Image> frame = readFrame(*frameFile(i));
        if (!frame) return frame.diagnostics;
        if (!video) {
            Result<image::VideoFile> begun = image::VideoFile::create(film.file, frame->width, frame->height,
                                                                      film.framesPerSecond, "glibra");
            if (!begun) return begun.diagnostics;
            video = std::move(begun.value);
        }
        if (Diagnostics problems = video->add(*frame); !problems.empty()) return problems;
    }
    if (stop() || !video) return {};
    return video->finish();
}

std::optional<render::Job::Save> readSave(const std::string& text) {
    const std::size_t equals = text.find('=');
    if (equals == 0 || equals == std::string::npos || equals + 1 == text.size()) return std::nullopt;
    return render::Job::Save{text.substr(0, equals), text.substr(equals + 1)};
}

int renderScenes(const RenderArguments& arguments) {
    const system::Interruption interruption;
    std::optional<system::Sandbox> sandbox;
    if (arguments.untrusted)
        sandbox = sandboxOf(arguments.scenes, arguments.picture.options, arguments.driver);
    Diagnostics late;
    const std::optional<int> parts =
        partsOf(arguments, sandbox ? &*sandbox : nullptr, [&] { return interruption.signal() != 0; }, late);
    interruption.obey();
    if (parts)
        return SceneBatch(arguments, static_cast<std::size_t>(*parts), std::move(sandbox), interruption)
            .run();
    print(late);
    return kSceneIsWrong;
}

}  // namespace glibra::cli
