#include "view/browse/thumbnails.h"

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <span>
#include <system_error>
#include <utility>

#include "base/files.h"
#include "image/file.h"
#include "image/image.h"
#include "image/write.h"
#include "suite/golden/hash.h"
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
    std::error_code failure;
    const std::string path = fs::absolute(scene, failure).lexically_normal().string();
    return folder / (suite::toText(suite::hashOf(std::as_bytes(std::span(path)))) + ending);
}

std::string contentHash(const fs::path& file) {
    const auto bytes = image::readFile(file, {file.string(), {}});
    return bytes ? suite::toText(suite::hashOf(*bytes)) : std::string();
}

std::int64_t timeOf(const fs::path& file) {
    std::error_code failure;
    return fs::last_write_time(file, failure).time_since_epoch().count();
}

Json recordOf(const fs::path& file) {
    std::error_code failure;
    const fs::path whole = fs::absolute(file, failure).lexically_normal();
    return {{"file", whole.string()},
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
    Json json{{"version", kVersion}, {"scene", scene.string()}, {"problem", problem}};
    json["files"] = Json::array();
    for (const fs::path& each : files) json["files"].push_back(recordOf(each));
    const std::string text = json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
    image::writeFileAtomically(entryFile(folder, scene, ".json"), std::as_bytes(std::span(text)));
}

}  // namespace

fs::path thumbnailFolder() {
    if (const char* folder = std::getenv("XDG_CACHE_HOME"); folder && *folder)
        return fs::path(folder) / "glibra" / "thumbnails";
    if (const char* home = std::getenv("HOME"); home && *home)
        return fs::path(home) / ".cache" / "glibra" / "thumbnails";
    return {};
}

Thumbnail findThumbnail(const fs::path& folder, const fs::path& scene) {
    const fs::path record = entryFile(folder, scene, ".json");
    const auto bytes = image::readFile(record, {record.string(), {}}, kLargestRecord);
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

}  // namespace glibra::view
