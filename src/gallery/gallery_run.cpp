#include "gallery/gallery_run.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <span>
#include <system_error>
#include <utility>

#include "base/contained.h"
#include "base/files.h"
#include "base/workers.h"
#include "gallery/gallery_page.h"
#include "image/png/png_reader.h"
#include "image/png/png_writer.h"
#include "suite/run/run.h"
#include "suite/write_below.h"

namespace glibra::gallery {
namespace {

namespace fs = std::filesystem;
using suite::ShotReference;

constexpr const char* kMark = ".glibra-gallery";  // a folder with this file is ours to write over
constexpr const char* kPictures = "pictures";
constexpr const char* kFilms = "films";
constexpr const char* kLive = "live";
constexpr std::uint64_t kLargestFrame = std::uint64_t{1} << 28;
constexpr std::uint64_t kLargestTable = 1 << 24;

/// Removes what an earlier gallery has written: its pages, pictures and films.
void removeEarlier(const fs::path& site) {
    for (const char* each : {"index.html", "chapters.html"}) base::removeBeneath(site, each);
    for (const auto& [folder, ending] :
         {std::pair{"scenes", ".html"}, {"scenes", ".js"}, {kPictures, ".png"}, {kFilms, ".png"}})
        // A file that stays does no harm: the pages name only those that were drawn.
        for (const fs::directory_entry& each : base::entriesOf(site / folder))
            if (each.path().extension() == ending)
                base::removeBeneath(site, fs::path(folder) / each.path().filename());
}

std::string frameName(const std::string& scene, int frame) {
    return fmt::format("{}@frame={:02}", scene, frame);
}

class GalleryRun {
  public:
    GalleryRun(const GalleryPlan& plan, const suite::SiteWorkers& workers, const GalleryEvents& events)
        : plan_(plan), workers_(workers), events_(events) {
        Gallery& gallery = end_.gallery;
        gallery.title = plan.title;
        gallery.isEmbedded = plan.live && plan.live->page.isEmbedded;
        gallery.folder = plan.folder.generic_string();
        for (const fs::path& each : plan.scenes)
            gallery.scenes.emplace_back().path = each.lexically_relative(plan.folder).generic_string();
        suite_.name = "gallery";
        suite_.file = plan.folder;
    }

    GalleryEnd run() {
        if (!prepareSite()) return std::move(end_);
        describeAll();
        if (end_.stopped) return std::move(end_);
        connect(end_.gallery);
        const std::map<std::string, std::string> chapters =
            source::chapterColumn(base::textIn(base::openBeneath(plan_.folder, "README.md"), kLargestTable)
                                      .value_or(std::string()));
        for (GalleryScene& each : end_.gallery.scenes)
            if (const auto found = chapters.find(each.path); found != chapters.end())
                each.chapters = source::chaptersIn(found->second);
        drawPictures();
        if (plan_.live && !end_.stopped && !end_.noDriver) makeLive();
        if (!end_.stopped && !end_.noDriver) drawFilms();
        for (const std::string& each : frames_)
            base::removeBeneath(plan_.site, fs::path(kPictures) / (each + ".png"));
        if (end_.stopped || end_.noDriver) return std::move(end_);
        append(end_.diagnostics, writePages(end_.gallery, plan_.site));
        return std::move(end_);
    }

  private:
    bool prepareSite() {
        const std::string text = "glibra gallery writes this folder.\n";
        for (const char* each : {kPictures, kFilms})
            if (const int problem = base::prepareBeneath(plan_.site, fs::path(each) / "x.png");
                problem != 0) {
                end_.diagnostics.push_back(suite::cannotWrite(plan_.site / each, problem));
                return false;
            }
        append(end_.diagnostics, suite::writeBelow(plan_.site, kMark, std::as_bytes(std::span(text))));
        if (hasError(end_.diagnostics)) return false;
        removeEarlier(plan_.site);
        return true;
    }

    [[nodiscard]] RenderOptions confined() const {
        RenderOptions options;
        options.libraryRoots = plan_.libraryRoots;
        options.within = plan_.folder;
        return options;
    }

    void describeAll() {
        const std::size_t count = plan_.scenes.size();
        base::runInWorkers(
            count, suite::readingOptions(workers_, count, events_.stop),
            [&](std::size_t index, const base::Step&) -> std::string {
                try {
                    return toText(describe({plan_.folder, plan_.scenes[index], confined()}));
                } catch (const std::exception&) {
                    return {};
                }
            },
            [&](std::size_t index, const base::Outcome& outcome) {
                if (outcome.end == base::Outcome::End::stopped) end_.stopped = true;
                if (outcome.end != base::Outcome::End::finished) return;
                if (std::optional<Description> found = parseDescription(outcome.answer))
                    end_.gallery.scenes[index].description = std::move(*found);
            },
            [](std::size_t, const std::string&) {});
        end_.stopped = end_.stopped || (events_.stop && events_.stop());
    }

    /// Draws all shots of `suite_` and gives the results to `take`.
    void draw(const std::function<void(std::size_t shot, const suite::ShotResult&)>& take) {
        std::vector<ShotReference> all;
        std::map<std::string, std::size_t> numbers;
        for (std::size_t i = 0; i < suite_.shots.size(); ++i) {
            all.push_back({0, i});
            numbers.emplace(suite_.shots[i].name, i);
        }
        suite::RunEvents events;
        events.begins = [&](const ShotReference& each) {
            if (events_.begins) events_.begins(suite_.shots[each.shot].script.generic_string());
        };
        events.done = [&](const suite::ShotResult& result) {
            if (const auto found = numbers.find(result.shot); found != numbers.end())
                take(found->second, result);
            if (events_.done) events_.done(suite::isFailure(result.verdict));
        };
        events.stop = events_.stop;
        const suite::RunEnd end = suite::runShots(
            {&suite_, 1}, all, suite::drawingOptions(workers_, plan_.site / kPictures), events);
        append(end_.diagnostics, end.diagnostics);
        end_.noDriver = end_.noDriver || end.noDriver;
        end_.stopped = end_.stopped || end.stopped;
        if (!end.driver.empty()) end_.gallery.driver = end.driver;
    }

    void addShot(std::size_t scene, const std::string& name, int width, int height, double time) {
        suite::Shot shot;
        shot.name = name;
        shot.script = plan_.scenes[scene];
        shot.options = confined();
        const Description& about = end_.gallery.scenes[scene].description;
        std::tie(shot.options.width, shot.options.height) =
            page::fitting(about.width, about.height, width, height);
        shot.options.time = time;
        suite_.shots.push_back(std::move(shot));
    }

    void drawPictures() {
        std::size_t moving = 0;
        for (std::size_t i = 0; i < plan_.scenes.size(); ++i) {
            addShot(i, end_.gallery.scenes[i].name, plan_.width, plan_.height, 0);
            moving += end_.gallery.scenes[i].description.mayMove ? 1 : 0;
        }
        if (events_.starts) events_.starts(plan_.scenes.size() + moving * kFilmFrames);
        draw([&](std::size_t index, const suite::ShotResult& result) {
            GalleryScene& scene = end_.gallery.scenes[index];
            scene.verdict = result.verdict;
            scene.reason = result.reason;
            scene.diagnostics = result.diagnostics;
            scene.width = result.width;
            scene.height = result.height;
            if (isDrawn(scene)) scene.picture = fmt::format("{}/{}.png", kPictures, scene.name);
        });
    }

    /// Writes for each scene what it is made of, or its film, and the runtime if a scene needs it.
    void makeLive() {
        const auto write = [&](const std::string& name, const std::string& text) {
            Diagnostics problems = suite::writeBelow(plan_.site, name, std::as_bytes(std::span(text)));
            const bool isWritten = problems.empty();
            append(end_.diagnostics, std::move(problems));
            return isWritten;
        };
        bool needsRuntime = false;
        std::vector<page::PageTask> tasks;
        std::vector<std::size_t> scenes;  // of the tasks
        for (std::size_t i = 0; i < plan_.scenes.size(); ++i)
            if (isDrawn(end_.gallery.scenes[i])) {
                page::PageTask task{plan_.scenes[i], confined(), false, plan_.live->film};
                task.options.samples = plan_.live->page.samples;
                task.film.width = plan_.width;
                task.film.height = plan_.height;
                tasks.push_back(std::move(task));
                scenes.push_back(i);
            }
        page::makePages(
            tasks, workers_.driver, suite::checkingOptions(workers_, tasks.size(), events_.stop),
            [&](std::size_t task, const base::Outcome& outcome, std::optional<page::PageScene> made) {
                if (outcome.end == base::Outcome::End::stopped) end_.stopped = true;
                GalleryScene& scene = end_.gallery.scenes[scenes[task]];
                if (!made) return;
                if (made->isLive || page::isFilm(*made))
                    scene.isLive = write(fmt::format("scenes/{}.js", scene.name),
                                         page::sceneScript(*made, plan_.live->page));
                if (made->isLive) {
                    needsRuntime = true;
                    return;
                }
                if (scene.isLive) scene.whyFilm = page::whyNotLive(*made);
                append(scene.diagnostics, std::move(made->diagnostics));
            });
        for (const page::SiteFile& each :
             page::runtimeFiles(needsRuntime ? plan_.live->runtime : std::string_view()))
            if (!write(fmt::format("{}/{}", kLive, each.name), each.content)) return;
        end_.stopped = end_.stopped || (events_.stop && events_.stop());
    }

    void drawFilms() {
        suite_.shots.clear();
        std::vector<std::size_t> scenes;  // of the shots
        for (std::size_t i = 0; i < plan_.scenes.size(); ++i) {
            const GalleryScene& scene = end_.gallery.scenes[i];
            if (!scene.description.mayMove || !isDrawn(scene) || scene.isLive) continue;
            for (int frame = 0; frame < kFilmFrames; ++frame) {
                addShot(i, frameName(scene.name, frame), plan_.width / 2, plan_.height / 2,
                        frame / kFilmRate);
                scenes.push_back(i);
                frames_.push_back(suite_.shots.back().name);
            }
        }
        std::map<std::size_t, int> drawn;
        draw([&](std::size_t shot, const suite::ShotResult& result) {
            // A film is joined when its last frame is drawn, so that the frames of few scenes exist at a
            // time.
            const std::size_t scene = scenes[shot];
            if (result.verdict == suite::Verdict::passed && ++drawn[scene] == kFilmFrames) join(scene);
        });
    }

    /// Joins the frames of a scene, unless they are all equal, and removes them.
    void join(std::size_t index) {
        GalleryScene& scene = end_.gallery.scenes[index];
        image::AnimatedPng film(kFilmRate);
        int width = 0, height = 0;
        image::Limits limits;
        limits.side = std::max(plan_.width, plan_.height);
        for (int frame = 0; frame < kFilmFrames; ++frame) {
            const fs::path name = fs::path(kPictures) / (frameName(scene.name, frame) + ".png");
            const auto bytes = base::bytesIn(base::openBeneath(plan_.site, name), kLargestFrame);
            if (!bytes) return;
            // With the PNG reader alone, since a worker that a scene has taken over may have written
            // something else.
            const Result<image::Image> picture =
                image::decodePng(*bytes, {name.generic_string(), {}}, limits);
            if (!picture) return;
            if (frame > 0 && (picture->width != width || picture->height != height)) return;
            width = picture->width;
            height = picture->height;
            film.add(*picture);
        }
        for (int frame = 0; frame < kFilmFrames; ++frame)
            base::removeBeneath(plan_.site, fs::path(kPictures) / (frameName(scene.name, frame) + ".png"));
        if (film.differing() < 2) return;
        const std::string file = fmt::format("{}/{}.png", kFilms, scene.name);
        Diagnostics problems = suite::writeBelow(plan_.site, file, film.finish());
        if (problems.empty()) scene.film = file;
        append(end_.diagnostics, std::move(problems));
    }

    const GalleryPlan& plan_;
    const suite::SiteWorkers& workers_;
    const GalleryEvents& events_;
    suite::Suite suite_;
    std::vector<std::string> frames_;  ///< names of their shots
    GalleryEnd end_;
};

}  // namespace

std::string whyNoSite(const fs::path& site) {
    std::error_code failure;
    if (!fs::exists(fs::symlink_status(site, failure))) return {};
    if (!fs::is_directory(site, failure)) return "it is not a folder";
    if (fs::exists(site / kMark, failure)) return {};
    return fs::is_empty(site, failure) && !failure
               ? std::string()
               : "the folder has files and is not one that glibra gallery has written; name another one";
}

GalleryEnd runGallery(const GalleryPlan& plan, const suite::SiteWorkers& workers,
                      const GalleryEvents& events) {
    return GalleryRun(plan, workers, events).run();
}

}  // namespace glibra::gallery
