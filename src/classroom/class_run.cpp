#include "classroom/class_run.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <system_error>
#include <utility>

#include "base/contained.h"
#include "base/files.h"
#include "base/workers.h"
#include "classroom/class_page.h"
#include "classroom/moments.h"
#include "classroom/review.h"
#include "image/png/png_writer.h"
#include "image/read.h"
#include "scene/file_lookup.h"
#include "suite/run/run.h"
#include "suite/write_below.h"
#include "system/folder.h"

namespace glibra::classroom {
namespace {

namespace fs = std::filesystem;
using suite::ShotReference;
using suite::Verdict;

constexpr const char* kPictures = "pictures";

/// The name of a picture: "0012-1", the submission (0 is the reference) and the moment. A name from the
/// submission would be one that a stranger chose.
std::string pictureName(std::size_t entry, std::size_t moment) {
    return fmt::format("{:04}-{}", entry, moment + 1);
}

/// True for the names of pictureName with their ending.
bool isOurs(std::string_view name) {
    const std::size_t dash = name.find('-');
    if (dash == std::string_view::npos || dash < 4 || !name.ends_with(".png")) return false;
    const auto isNumber = [](std::string_view text) {
        return !text.empty() && text.find_first_not_of("0123456789") == std::string_view::npos;
    };
    return isNumber(name.substr(0, dash)) && isNumber(name.substr(dash + 1, name.size() - dash - 5));
}

/// The files of an earlier run in the folder of pictures.
std::vector<std::string> earlierPictures(const fs::path& site) {
    std::vector<std::string> names;
    // A file that stays does no harm: the page names only those that were drawn.
    for (const fs::directory_entry& each : base::entriesOf(site / kPictures))
        if (std::string name = each.path().filename().generic_string(); isOurs(name))
            names.push_back(std::move(name));
    return names;
}

/// Removes links and the like, which writing a picture would follow.
void removeLinks(const fs::path& site) {
    for (const std::string& each : earlierPictures(site)) {
        const fs::path name = fs::path(kPictures) / each;
        std::error_code ignored;
        if (fs::symlink_status(site / name, ignored).type() != fs::file_type::regular)
            base::removeBeneath(site, name);
    }
}

/// Removes the page, the table and all pictures but those of this reference.
void removeEarlier(const fs::path& site, const Entry& reference) {
    for (const char* each : {"index.html", "grades.csv"}) base::removeBeneath(site, each);
    for (const std::string& each : earlierPictures(site)) {
        const fs::path name = fs::path(kPictures) / each;
        if (std::ranges::none_of(reference.pictures, [&](const Picture& one) { return name == one.file; }))
            base::removeBeneath(site, name);
    }
}

class ClassRun {
  public:
    ClassRun(const ClassPlan& plan, const suite::SiteWorkers& workers, const ClassEvents& events)
        : plan_(plan), workers_(workers), events_(events) {
        Classroom& room = end_.classroom;
        room.folder = plan.folder.generic_string();
        room.moments = plan.moments;
        room.sliders = slidersOf(plan.moments);
        room.leftOut = plan.submissions.leftOut;
        room.reference.submission = {
            plan.reference.filename().generic_string(), plan.reference.parent_path(), plan.reference, {}};
        if (!plan.pictures.empty()) room.reference.submission.scene.clear();  // there is nothing to read
        for (const Submission& each : plan.submissions.all) {
            room.entries.emplace_back().submission = each;
            if (!each.scene.empty()) room.entries.back().pictures.resize(plan.moments.size());
        }
        for (const EarlierClass& earlier : plan.earlier)
            for (const Submission& each : earlier.submissions.all) {
                room.earlier.emplace_back().submission = each;
                room.earlier.back().submission.name = earlier.name + "/" + each.name;
                earlierFolders_.push_back(earlier.folder);
            }
        if (!plan.reference.empty()) room.reference.pictures.resize(plan.moments.size());
        suite_.name = "class";
        suite_.file = plan.folder;
        makeShots();
    }

    ClassEnd run() {
        if (const int problem =
                base::prepareBeneath(plan_.site, fs::path(kPictures) / (pictureName(0, 0) + ".png"));
            problem != 0) {
            end_.diagnostics.push_back(
                diagnose("file-E10",
                         fmt::format("cannot write into '{}': {}", (plan_.site / kPictures).generic_string(),
                                     std::generic_category().message(problem))));
            return std::move(end_);
        }
        removeLinks(plan_.site);
        if (!plan_.pictures.empty() ? !takePictures()
                                    : !plan_.reference.empty() && (!knowsNames() || !drawReference()))
            return std::move(end_);
        removeEarlier(plan_.site, end_.classroom.reference);
        drawSubmissions();
        if (!end_.stopped && !end_.noDriver && !end_.misspelt) reviewAll();
        return std::move(end_);
    }

  private:
    Entry& entryOf(std::size_t index) {
        return index == 0 ? end_.classroom.reference : end_.classroom.entries[index - 1];
    }
    [[nodiscard]] std::size_t moments() const { return plan_.moments.size(); }
    [[nodiscard]] std::size_t givenTask() const { return end_.classroom.entries.size() + 1; }

    /// The shot of an entry at a moment is number entry * moments() + moment.
    void makeShots() {
        for (std::size_t entry = 0; entry <= end_.classroom.entries.size(); ++entry)
            for (std::size_t moment = 0; moment < moments(); ++moment) {
                suite::Shot shot = plan_.moments[moment].shot;
                shot.name = pictureName(entry, moment);
                shot.script = entryOf(entry).submission.scene;
                shot.ownUniforms.clear();  // what a submission lacks is a warning
                if (entry > 0) {
                    confine(entryOf(entry).submission, plan_.folder, shot.options);
                    shot.options.incomplete = true;
                }
                suite_.shots.push_back(std::move(shot));
            }
    }

    /// A submission reads its own folder, the library, and what was given to all: the hand-out, and `shaders`
    /// and `textures` beside the submissions. What lies above is the teacher's, as is the reference.
    void confine(const Submission& submission, const fs::path& beside, RenderOptions& options) const {
        options.within = submission.folder;
        if (submission.scene.empty()) return;
        for (const fs::path& each : plan_.given)
            if (std::error_code failure; fs::is_directory(each, failure))
                options.libraryRoots.push_back(each);
        if (submission.folder == beside) return;  // both are one library, which is found above the scene
        // A library of its own comes before the one beside the submissions.
        if (const auto own = scene::libraryAbove(system::wholePath(submission.scene.parent_path()),
                                                 system::wholePath(submission.folder)))
            options.libraryRoots.push_back(*own);
        options.libraryRoots.push_back(beside);
    }

    /// Draws the first picture once more, small and with all names that any moment sets, and reports those
    /// that the reference does not have. Nothing else has been drawn yet.
    bool knowsNames() {
        suite::Shot probe = suite_.shots.front();
        for (const Moment& each : plan_.moments) {
            for (const suite::PlacedUniform& one : each.shot.ownUniforms)
                if (std::ranges::find(probe.ownUniforms, one.name, &suite::PlacedUniform::name) ==
                    probe.ownUniforms.end())
                    probe.ownUniforms.push_back(one);
            for (const std::string& one : each.shot.options.set) {
                const std::string_view name = std::string_view(one).substr(0, one.find('=') + 1);
                if (std::ranges::none_of(probe.options.set,
                                         [&](const std::string& known) { return known.starts_with(name); }))
                    probe.options.set.push_back(one);
            }
        }
        if (probe.ownUniforms.empty()) return true;
        constexpr int kSide = 16;  // pixels
        probe.options.width = probe.options.height = kSide;
        probe.name = pictureName(0, moments());
        suite_.shots.push_back(probe);
        draw({suite_.shots.size() - 1}, [&](std::size_t, const suite::ShotResult& result) {
            for (const Diagnostic& each : result.diagnostics)
                if (each.id == "suite-E19") end_.diagnostics.push_back(each);
        });
        suite_.shots.pop_back();
        base::removeBeneath(plan_.site, fs::path(kPictures) / (probe.name + ".png"));
        end_.misspelt = hasError(end_.diagnostics);
        return !end_.misspelt && !end_.noDriver && !end_.stopped;
    }

    /// Without a reference: a name that no submission has is misspelt.
    void reportNamesOfNobody() {
        for (const Moment& moment : plan_.moments)
            for (const suite::PlacedUniform& name : moment.shot.ownUniforms) {
                const std::string_view tag = std::string_view(name.name).substr(name.name.rfind(':') + 1);
                const Diagnostic* found = nullptr;
                const auto lacks = [&](const Entry& entry) {
                    const auto one = std::ranges::find_if(entry.diagnostics, [&](const Diagnostic& each) {
                        return each.id == "glib-W23" && each.place.file.empty() && each.subject == tag;
                    });
                    if (one != entry.diagnostics.end() && (!found || found->suggestion.empty()))
                        found = &*one;
                    return one != entry.diagnostics.end() || !isDrawn(entry);
                };
                const std::vector<Entry>& all = end_.classroom.entries;
                if (!std::ranges::all_of(all, lacks) || !found) continue;
                end_.diagnostics.push_back(diagnose("suite-E19", found->text, name.place));
                end_.misspelt = true;
                return;
            }
    }

    void draw(const std::vector<std::size_t>& shots) {
        draw(shots, [&](std::size_t number, const suite::ShotResult& result) { take(number, result); });
    }

    using Take = std::function<void(std::size_t number, const suite::ShotResult&)>;
    void draw(const std::vector<std::size_t>& shots, const Take& taken) {
        std::vector<ShotReference> open;
        for (const std::size_t each : shots) open.push_back({0, each});
        suite::RunOptions options = suite::drawingOptions(workers_, plan_.site / kPictures);
        options.refusesMisspelt = true;
        suite::RunEvents events;
        events.begins = [&](const ShotReference& each) {
            if (events_.begins && each.shot / moments() <= end_.classroom.entries.size())
                events_.begins(entryOf(each.shot / moments()).submission.name);
        };
        std::map<std::string, std::size_t> numbers;
        for (const std::size_t each : shots) numbers.emplace(suite_.shots[each].name, each);
        events.done = [&](const suite::ShotResult& result) {
            if (const auto found = numbers.find(result.shot); found != numbers.end())
                taken(found->second, result);
        };
        events.stop = events_.stop;
        const suite::RunEnd end = suite::runShots({&suite_, 1}, open, options, events);
        append(end_.diagnostics, end.diagnostics);
        end_.noDriver = end.noDriver;
        end_.stopped = end.stopped;
        if (!end.driver.empty()) end_.classroom.driver = end.driver;
    }

    void take(std::size_t number, const suite::ShotResult& result) {
        Entry& entry = entryOf(number / moments());
        Picture& picture = entry.pictures[number % moments()];
        picture.verdict = result.verdict;
        picture.reason = result.reason;
        picture.width = result.width;
        picture.height = result.height;
        picture.milliseconds = result.milliseconds;
        picture.isIncomplete = result.verdict == Verdict::failed && !result.got.empty();
        if (result.verdict == Verdict::passed || picture.isIncomplete)
            picture.file = fmt::format("{}/{}.png", kPictures, suite_.shots[number].name);
        for (const Diagnostic& each : result.diagnostics) {
            const auto isSame = [&](const Diagnostic& other) {
                return other.severity == each.severity && other.id == each.id && other.text == each.text &&
                       other.place == each.place;
            };
            if (std::ranges::none_of(entry.diagnostics, isSame)) entry.diagnostics.push_back(each);
        }
        if (entry.reproduce.empty()) entry.reproduce = result.reproduce;
        if (events_.done) events_.done(suite::isFailure(result.verdict));
    }

    bool drawReference() {
        std::vector<std::size_t> shots;
        for (std::size_t moment = 0; moment < moments(); ++moment) shots.push_back(moment);
        draw(shots);
        const Entry& reference = end_.classroom.reference;
        if (end_.noDriver || end_.stopped) return false;
        if (!isDrawn(reference)) {
            const Diagnostics& own = reference.diagnostics;
            const std::string reason = hasError(own) ? "" : ": " + reasonOf(reference);
            append(end_.diagnostics, own);
            end_.diagnostics.push_back(withoutId(Severity::error, "the reference cannot be drawn" + reason,
                                                 {plan_.reference.generic_string(), 1, 1}));
            return false;
        }
        useSizes();
        return true;
    }

    /// Submissions are drawn in the sizes of the reference.
    void useSizes() {
        for (std::size_t i = moments(); i < suite_.shots.size(); ++i) {
            const Picture& picture = end_.classroom.reference.pictures[i % moments()];
            suite_.shots[i].options.width = picture.width;
            suite_.shots[i].options.height = picture.height;
        }
    }

    /// Copies the pictures of the reference into the site.
    bool takePictures() {
        for (std::size_t moment = 0; moment < moments(); ++moment) {
            const fs::path& from = plan_.pictures[moment];
            Result<image::Image> read =
                image::readImage(from, {(from.parent_path() / kReferenceFile).generic_string(), 1, 1});
            append(end_.diagnostics, read.diagnostics);
            if (!read) return false;
            const std::string file = fmt::format("{}/{}.png", kPictures, suite_.shots[moment].name);
            const std::vector<std::byte> png = image::encodePng(*read);
            if (png.empty()) {
                end_.diagnostics.push_back(withoutId(Severity::error,
                                                     "the picture of the reference is none of 8 or 16 bits",
                                                     {from.generic_string(), 1, 1}));
                return false;
            }
            append(end_.diagnostics, suite::writeBelow(plan_.site, file, png));
            if (hasError(end_.diagnostics)) return false;
            Picture& picture = end_.classroom.reference.pictures[moment];
            picture.verdict = Verdict::passed;
            picture.file = file;
            picture.width = read->width;
            picture.height = read->height;
        }
        useSizes();
        return true;
    }

    void drawSubmissions() {
        // In rounds of 1, 1, 2, 4, 8, 8, ... pictures of each submission: one that ends its process, or is
        // late, waits for no more time limits than a round has.
        constexpr std::size_t kMostOfRound = 8;
        for (std::size_t begin = 0, end = 1; begin < moments();
             begin = std::exchange(end, std::min(moments(), end + std::min(end, kMostOfRound)))) {
            std::vector<std::size_t> shots;
            for (std::size_t i = begin + moments(); i < suite_.shots.size(); ++i) {
                if (i % moments() < begin || i % moments() >= end || suite_.shots[i].script.empty()) continue;
                std::vector<Picture>& pictures = entryOf(i / moments()).pictures;
                const auto before = std::ranges::find_if(pictures, [](const Picture& each) {
                    return each.verdict == Verdict::crashed || each.verdict == Verdict::timedOut;
                });
                if (before == pictures.end()) {
                    shots.push_back(i);
                    continue;
                }
                pictures[i % moments()].reason =
                    "not drawn, because an earlier picture of this submission was not: " + before->reason;
                if (events_.done) events_.done(true);
            }
            if (!shots.empty()) draw(shots);
            if (begin == 0 && plan_.reference.empty()) reportNamesOfNobody();
            if (end_.stopped || end_.noDriver || end_.misspelt) return;
        }
    }

    /// The reference is number 0, the entries follow, then the given code, then the earlier submissions.
    ReviewTask taskOf(std::size_t index) {
        ReviewTask task;
        task.site = plan_.site;
        if (index == givenTask()) {
            task.sources = plan_.given;
            return task;
        }
        if (index > givenTask()) {
            const std::size_t number = index - givenTask() - 1;
            const Submission& earlier = end_.classroom.earlier[number].submission;
            task.scene = earlier.scene;
            task.options = plan_.moments.front().shot.options;
            confine(earlier, earlierFolders_[number], task.options);
            return task;
        }
        const Entry& entry = entryOf(index);
        task.scene = entry.submission.scene;
        if (index > 0) {
            const bool isFile = entry.submission.folder == plan_.folder;
            task.handedIn = isFile ? entry.submission.scene : entry.submission.folder;
        }
        task.options = suite_.shots[index * moments()].options;
        task.has = plan_.moments.front().has;
        for (std::size_t moment = 1; moment < moments(); ++moment)
            task.others.push_back(suite_.shots[index * moments() + moment].options);
        for (std::size_t moment = 0; moment < entry.pictures.size(); ++moment)
            task.pictures.emplace_back(
                index > 0 && hasReference(end_.classroom) ? entryOf(0).pictures[moment].file : std::string(),
                entry.pictures[moment].isIncomplete ? std::string() : entry.pictures[moment].file);
        if (!entry.pictures.empty()) task.sliders = end_.classroom.sliders;
        if (plan_.studentPages)
            for (std::size_t moment = 0; moment < std::min(entry.pictures.size(), kMostStudentPictures);
                 ++moment)
                task.shown.push_back(entry.pictures[moment].file);
        return task;
    }

    /// The reference and the given code come first: what they have is not looked for in the others.
    void reviewAll() {
        std::vector<SourceFile> given;
        std::set<std::uint64_t> functions;
        const auto isGiven = [&](std::size_t index) { return index == 0 || index == givenTask(); };
        for (const bool first : {true, false}) {
            std::vector<std::size_t> indices;
            for (std::size_t i = 0; i <= givenTask() + end_.classroom.earlier.size(); ++i)
                if (isGiven(i) == first) indices.push_back(i);
            reviewSome(indices, functions, [&](std::size_t index, std::optional<Review> found) {
                if (found && first) functions.insert(found->functions.begin(), found->functions.end());
                if (index != givenTask())
                    takeReview(reviewedEntry(index), std::move(found));
                else if (found)
                    given = std::move(found->files);
            });
        }
        end_.stopped = end_.stopped || (events_.stop && events_.stop());
        findEmpty();
        if (!end_.stopped) compareSources(end_.classroom, given, plan_.common);
    }

    /// The entry of a task that is not that of the given code.
    Entry& reviewedEntry(std::size_t index) {
        return index < givenTask() ? entryOf(index) : end_.classroom.earlier[index - givenTask() - 1];
    }

    using TakeReview = std::function<void(std::size_t index, std::optional<Review>)>;
    void reviewSome(const std::vector<std::size_t>& indices, const std::set<std::uint64_t>& functions,
                    const TakeReview& taken) {
        std::vector<ReviewTask> tasks;
        for (const std::size_t each : indices) tasks.push_back(taskOf(each));
        for (ReviewTask& each : tasks) each.givenFunctions = functions;
        base::runInWorkers(
            tasks.size(), suite::readingOptions(workers_, tasks.size(), events_.stop),
            [&](std::size_t index, const base::Step& step) -> std::string {
                try {
                    // The limit of time is that of a picture, and a submission may have a hundred.
                    return toText(review(tasks[index], [&] { step({}); }));
                } catch (const std::exception&) {
                    return {};
                }
            },
            [&](std::size_t index, const base::Outcome& outcome) {
                if (outcome.end == base::Outcome::End::stopped) end_.stopped = true;
                taken(indices[index], outcome.end == base::Outcome::End::finished
                                          ? parseReview(outcome.answer)
                                          : std::nullopt);
            },
            [](std::size_t, const std::string&) {});
    }

    void takeReview(Entry& entry, std::optional<Review> found) {
        if (!found) {
            if (!entry.submission.scene.empty())
                entry.diagnostics.push_back(
                    withoutId(Severity::warning,
                              "the scene, its shaders and pictures could not be reviewed within the limits",
                              {entry.submission.scene.generic_string(), 1, 1}));
            entry.notCompared.emplace_back("everything, because the review did not end");
            return;
        }
        if (found->reactions.size() > end_.classroom.sliders.size()) found->reactions.clear();
        static_cast<Findings&>(entry) = std::move(*found);
        if (entry.submission.scene.empty())
            entry.notCompared.emplace_back("everything, because there is no scene");
        for (std::size_t i = 0; i < std::min(found->scores.size(), entry.pictures.size()); ++i)
            entry.pictures[i].score = found->scores[i];
        for (std::size_t i = 0; i < std::min(found->showNothing.size(), entry.pictures.size()); ++i)
            entry.pictures[i].showsNothing = found->showNothing[i];
        for (std::size_t i = 0; i < std::min(found->small.size(), entry.pictures.size()); ++i)
            entry.pictures[i].small = std::move(found->small[i]);
    }

    /// A submission draws nothing if it shows nothing wherever the reference shows something.
    void findEmpty() {
        const Entry& reference = end_.classroom.reference;
        for (Entry& entry : end_.classroom.entries) {
            bool any = false, all = isDrawn(entry);
            for (std::size_t i = 0; i < entry.pictures.size(); ++i) {
                if (hasReference(end_.classroom) && reference.pictures[i].showsNothing) continue;
                any = true;
                all = all && entry.pictures[i].showsNothing;
            }
            entry.drawsNothing = any && all;
        }
    }

    const ClassPlan& plan_;
    const suite::SiteWorkers& workers_;
    const ClassEvents& events_;
    suite::Suite suite_;
    std::vector<fs::path> earlierFolders_;  ///< of each earlier submission
    ClassEnd end_;
};

}  // namespace

std::size_t pictureCount(const ClassPlan& plan) {
    const auto scenes = std::ranges::count_if(plan.submissions.all,
                                              [](const Submission& each) { return !each.scene.empty(); });
    const bool drawsReference = !plan.reference.empty() && plan.pictures.empty();
    return (static_cast<std::size_t>(scenes) + (drawsReference ? 1 : 0)) * plan.moments.size();
}

ClassEnd runClass(const ClassPlan& plan, const suite::SiteWorkers& workers, const ClassEvents& events) {
    return ClassRun(plan, workers, events).run();
}

}  // namespace glibra::classroom
