#include "view/browse/example_scenes.h"

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <exception>
#include <fstream>
#include <iterator>
#include <map>
#include <nlohmann/json.hpp>
#include <ranges>
#include <system_error>
#include <tuple>
#include <utility>

#include "base/files.h"
#include "glib/text.h"
#include "image/file.h"
#include "image/image.h"
#include "image/write.h"
#include "source/scene_head.h"
#include "suite/golden/hash_list.h"
#include "system/folder.h"
#include "system/memory.h"
#include "system/places.h"
#include "system/process.h"
#include "view/scene/window_target.h"
#include "view/session/session.h"

namespace glibra::view {

namespace fs = std::filesystem;

namespace {

bool endsWithOneOf(const fs::path& file, std::string_view endings) {
    const std::string own = file.extension().generic_string();
    return endings.empty() || std::ranges::any_of(std::views::split(endings, ' '), [&](const auto& each) {
               return glib::sameWord(own, std::string_view(each.begin(), each.end()));
           });
}

std::string textOf(const fs::path& file) {
    std::ifstream stream(file);
    return {std::istreambuf_iterator<char>(stream), {}};
}

using Json = nlohmann::ordered_json;

/// Increase this when pictures of unchanged files should be made again.
constexpr int kVersion = 1;
constexpr std::uint64_t kLargestRecord = 1ULL << 20;

/// The cache file for a scene, named after its absolute path.
fs::path entryFile(const fs::path& folder, const fs::path& scene, const char* ending) {
    const std::string path = system::wholePath(scene).generic_string();
    return folder / (suite::toText(suite::hashOf(std::as_bytes(std::span(path)))) + ending);
}

std::string contentHash(const fs::path& file) {
    const auto bytes = image::readFile(file, {file.generic_string(), {}});
    return bytes ? suite::toText(suite::hashOf(*bytes)) : std::string();
}

std::int64_t timeOf(const fs::path& file) {
    std::error_code failure;
    return fs::last_write_time(file, failure).time_since_epoch().count();
}

Json recordOf(const fs::path& file) {
    std::error_code failure;
    const fs::path whole = system::wholePath(file);
    return {{"file", whole.generic_string()},
            {"bytes", fs::file_size(whole, failure)},
            {"time", timeOf(whole)},
            {"hash", contentHash(whole)}};
}

bool isUnchanged(const Json& record) {
    const fs::path file = record.value("file", "");
    std::error_code failure;
    const std::uintmax_t bytes = fs::file_size(file, failure);
    if (failure || bytes != record.value("bytes", std::uintmax_t{0})) return false;
    if (timeOf(file) == record.value("time", std::int64_t{0})) return true;
    return contentHash(file) == record.value("hash", "");
}

void writeRecord(const fs::path& folder, const fs::path& scene, const std::vector<fs::path>& files,
                 const std::string& problem) {
    Json json{{"version", kVersion}, {"scene", scene.generic_string()}, {"problem", problem}};
    json["files"] = Json::array();
    for (const fs::path& each : files) json["files"].push_back(recordOf(each));
    const std::string text = json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
    image::writeFileAtomically(entryFile(folder, scene, ".json"), std::as_bytes(std::span(text)));
}

/// Caches a failure that is valid until the scene's own file changes: for a scene that cannot be drawn to the
/// end.
void rememberFailure(const fs::path& folder, const fs::path& scene, const std::string& problem) {
    std::error_code ignored;
    fs::create_directories(folder, ignored);
    writeRecord(folder, scene, {scene}, problem);
}

constexpr int kLongestScene = 30'000;  ///< milliseconds
constexpr int kNoDriver = 4;           ///< exit status

}  // namespace

FolderList listFolder(const fs::path& folder, std::string_view endings) {
    FolderList list;
    std::error_code failure;
    list.folder = fs::absolute(folder.empty() ? "." : folder, failure).lexically_normal();
    if (!list.folder.has_filename() && list.folder.has_relative_path())
        list.folder = list.folder.parent_path();
    fs::directory_iterator each(list.folder, fs::directory_options::none, failure);
    if (failure) {
        list.problem = "Cannot read this folder: " + failure.message() + ".";
        return list;
    }
    for (const fs::directory_iterator end; !failure && each != end; each.increment(failure)) {
        const std::string name = each->path().filename().generic_string();
        std::error_code unknown;
        if (name.starts_with('.')) continue;
        if (each->is_directory(unknown))
            list.entries.push_back({name, true});
        else if (each->is_regular_file(unknown) && endsWithOneOf(each->path(), endings))
            list.entries.push_back({name, false});
    }
    std::sort(list.entries.begin(), list.entries.end(), [](const FolderEntry& a, const FolderEntry& b) {
        return std::tuple(!a.isFolder, glib::lower(a.name), a.name) <
               std::tuple(!b.isFolder, glib::lower(b.name), b.name);
    });
    return list;
}

std::vector<ExampleScene> exampleScenes(const fs::path& root) {
    std::vector<ExampleScene> scenes;
    const fs::path folder = root / "glib";
    std::map<std::string, std::string> sources = source::chapterColumn(textOf(folder / "README.md"));
    std::error_code failure;
    for (fs::recursive_directory_iterator
             each(folder, fs::directory_options::skip_permission_denied, failure),
         end;
         !failure && each != end; each.increment(failure)) {
        const fs::path& file = each->path();
        std::error_code unknown;
        if (!glib::sameWord(file.extension().generic_string(), ".glib") || !each->is_regular_file(unknown))
            continue;
        const fs::path topic = file.parent_path().lexically_relative(folder);
        scenes.push_back({file, topic == "." ? "" : topic.generic_string(), file.stem().generic_string(),
                          source::headOf(textOf(file)).summary,
                          sources[file.lexically_relative(folder).generic_string()]});
    }
    std::sort(scenes.begin(), scenes.end(), [](const ExampleScene& a, const ExampleScene& b) {
        return std::tuple(a.topic != "start", a.topic, a.name) <
               std::tuple(b.topic != "start", b.topic, b.name);
    });
    return scenes;
}

std::vector<std::string> chaptersOf(std::span<const ExampleScene> scenes) {
    std::vector<std::string> chapters;
    for (const ExampleScene& scene : scenes)
        for (std::string& each : source::chaptersIn(scene.source)) chapters.push_back(std::move(each));
    std::sort(chapters.begin(), chapters.end(), source::isBefore);
    chapters.erase(std::unique(chapters.begin(), chapters.end()), chapters.end());
    return chapters;
}

bool isOfChapter(const ExampleScene& scene, const std::string& chapter) {
    if (chapter.empty()) return true;
    const std::vector<std::string> own = source::chaptersIn(scene.source);
    return std::ranges::find(own, chapter) != own.end();
}

fs::path thumbnailFolder() {
    const fs::path folder = system::userFolder(system::UserFolder::cache);
    return folder.empty() ? folder : folder / "thumbnails";
}

Thumbnail findThumbnail(const fs::path& folder, const fs::path& scene) {
    const fs::path record = entryFile(folder, scene, ".json");
    const auto bytes = image::readFile(record, {record.generic_string(), {}}, kLargestRecord);
    if (!bytes) return {};
    const Json json = Json::parse(base::asText(*bytes), nullptr, false);
    try {
        if (!json.is_object() || json.value("version", 0) != kVersion) return {};
        const Json& files = json.at("files");
        if (!std::all_of(files.begin(), files.end(), isUnchanged)) return {};
        const std::string problem = json.value("problem", "");
        if (!problem.empty()) return {Thumbnail::State::failed, {}, problem};
    } catch (const Json::exception&) {
        return {};  // not written by this program
    }
    fs::path picture = entryFile(folder, scene, ".png");
    std::error_code failure;
    if (!fs::is_regular_file(picture, failure)) return {};
    return {Thumbnail::State::ready, std::move(picture), {}};
}

Thumbnail makeThumbnail(gpu::Context& context, const fs::path& folder, const fs::path& scene,
                        const std::vector<fs::path>& libraryRoots) {
    std::error_code ignored;
    fs::create_directories(folder, ignored);
    RenderOptions options;
    options.libraryRoots = libraryRoots;
    Session session(context, options);
    std::vector<fs::path> files{scene};
    if (session.open(scene)) {
        session.look().resize(kThumbnailWidth, kThumbnailHeight);
        session.drawIfNeeded();
        files = session.live().files();
    }
    Diagnostics problems = session.diagnostics();
    if (session.picture() && !hasError(problems)) {
        const Result<image::Image> picture = imageOf(context.capabilities(), *session.picture(), 3);
        append(problems, picture.diagnostics);
        if (picture) append(problems, image::writeImage(*picture, entryFile(folder, scene, ".png"), {}));
    }
    const auto error = std::ranges::find(problems, Severity::error, &Diagnostic::severity);
    writeRecord(folder, scene, files, error == problems.end() ? "" : toString(*error));
    return findThumbnail(folder, scene);
}

ThumbnailMaker::ThumbnailMaker(std::filesystem::path folder, std::vector<std::filesystem::path> scenes,
                               std::function<void()> wake)
    : folder_(std::move(folder)), scenes_(std::move(scenes)), wake_(std::move(wake)) {
    // finish() must not allocate: it also reports the scenes that no memory is left for.
    finished_.reserve(scenes_.size());
    try {
        thread_ = std::thread([this] { run(); });
    } catch (const std::system_error&) {
        for (std::size_t i = 0; i < scenes_.size(); ++i) finish(i);
    }
}

ThumbnailMaker::~ThumbnailMaker() {
    if (thread_.joinable()) {
        if (stop_.wake())
            thread_.join();
        else
            thread_.detach();
    }
}

std::vector<std::filesystem::path> ThumbnailMaker::takeFinished() {
    const std::scoped_lock lock(mutex_);
    std::vector<std::filesystem::path> files;
    files.reserve(finished_.size());
    for (const std::size_t each : finished_) files.push_back(scenes_[each]);
    finished_.clear();
    return files;
}

bool ThumbnailMaker::hasFinished() {
    const std::scoped_lock lock(mutex_);
    return !finished_.empty();
}

void ThumbnailMaker::finish(std::size_t scene) {
    {
        const std::scoped_lock lock(mutex_);
        finished_.push_back(scene);
    }
    wake_();
}

std::size_t ThumbnailMaker::runProcess(std::size_t first, const char*& why) {
    std::vector<std::string> words{"glibra-view", "--thumbnails", folder_.generic_string()};
    for (std::size_t i = first; i < scenes_.size(); ++i) words.push_back(scenes_[i].generic_string());
    system::File reading, writing;
    if (makePipe(reading, writing) != 0) return scenes_.size();
    using To = system::Stream::To;
    system::Process process = system::startAgain(words, {To::inherited, writing, To::nothing});
    writing.close();
    std::size_t done = process ? first : scenes_.size();
    why = "the program that drew it ended unexpectedly";
    std::string answers;
    while (done < scenes_.size()) {
        answers.clear();
        const system::News news = receive(reading, kLongestScene, &stop_, answers);
        if (news == system::News::woken) {
            kill(process);
            done = scenes_.size();
        } else if (news == system::News::late) {
            kill(process);
            why = "drawing it takes longer than 30 seconds";
        }
        if (news != system::News::bytes) break;
        for (auto lines = std::ranges::count(answers, '\n'); lines > 0 && done < scenes_.size(); --lines)
            finish(done++);
    }
    reading.close();
    const system::End end = waitFor(process);
    // Without a driver that draws off screen there are no pictures of any scene.
    if (end.status == kNoDriver)
        while (done < scenes_.size()) finish(done++);
    return done;
}

void ThumbnailMaker::run() {
    std::size_t next = 0;
    try {
        while (next < scenes_.size()) {
            const char* why = "";
            next = runProcess(next, why);
            if (next >= scenes_.size()) return;
            rememberFailure(folder_, scenes_[next], why);
            finish(next++);
        }
    } catch (const std::exception&) {
        // Out of memory: the remaining scenes have no picture this time.
        while (next < scenes_.size()) finish(next++);
    }
}

int makeThumbnails(const std::filesystem::path& folder, const std::vector<std::filesystem::path>& scenes,
                   const std::vector<std::filesystem::path>& libraryRoots) {
    system::stepBack();
    gpu::prepareEnvironment();
    Result<gpu::Context> context = gpu::openContext();
    if (!context) return kNoDriver;
    for (const std::filesystem::path& each : scenes) {
        makeThumbnail(*context, folder, each, libraryRoots);
        std::puts("");
        std::fflush(stdout);
    }
    return 0;
}

}  // namespace glibra::view
