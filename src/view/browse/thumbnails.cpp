#include "view/browse/thumbnails.h"

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <exception>
#include <nlohmann/json.hpp>
#include <span>
#include <system_error>
#include <utility>

#include "base/files.h"
#include "gpu/context/context.h"
#include "image/file.h"
#include "image/image.h"
#include "image/write.h"
#include "suite/golden/hash_list.h"
#include "system/folder.h"
#include "system/memory.h"
#include "system/places.h"
#include "system/process.h"
#include "view/scene/window_target.h"
#include "view/session/session.h"

namespace glibra::view {
namespace {

namespace fs = std::filesystem;
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

}  // namespace

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
        session.resize(kThumbnailWidth, kThumbnailHeight);
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

void rememberFailure(const fs::path& folder, const fs::path& scene, const std::string& problem) {
    std::error_code ignored;
    fs::create_directories(folder, ignored);
    writeRecord(folder, scene, {scene}, problem);
}

namespace {

constexpr int kLongestScene = 30'000;  ///< milliseconds
constexpr int kNoDriver = 4;           ///< exit status

}  // namespace

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
