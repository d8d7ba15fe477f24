#include "suite/report_files.h"

#include <fmt/format.h>

#include <algorithm>
#include <span>
#include <system_error>
#include <utility>

#include "image/convert.h"
#include "image/file.h"
#include "image/format.h"
#include "image/png_writer.h"
#include "image/read.h"
#include "suite/results_file.h"
#include "suite/utf8.h"

namespace glibra::suite {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMostWarnings = 20;
constexpr std::uint64_t kLargestSource = std::uint64_t{1} << 20;
// Beyond it unpacking takes seconds and hundreds of megabytes in a browser.
constexpr std::int64_t kMostPixels = std::int64_t{4096} * 4096;

const char* const kFolders[] = {"pictures", "pixels"};

/// "00012.got.png", "00012.js": names that only a report has given.
bool isOurs(std::string_view name) {
    const std::size_t digits = name.find_first_not_of("0123456789");
    if (digits == std::string_view::npos || digits < 5) return false;
    const std::string_view rest = name.substr(digits);
    return rest == ".js" || rest == ".got.png" || rest == ".expected.png" || rest == ".difference.png";
}

std::string onlyUtf8(std::string_view text) {
    std::string valid;
    while (!text.empty()) {
        const Character next = firstCharacter(text);
        appendUtf8(valid, next.code);
        text.remove_prefix(next.bytes);
    }
    return valid;
}

}  // namespace

bool isPlain(const ShotResult& shot) {
    return (shot.verdict == Verdict::passed && !shot.changed) || shot.verdict == Verdict::skipped;
}

ReportFiles::ReportFiles(fs::path resultsFolder, fs::path reportFolder)
    : resultsFolder_(std::move(resultsFolder)), reportFolder_(std::move(reportFolder)) {
    for (const char* folder : kFolders) {
        std::error_code ignored;  // told with the first file that cannot be written
        fs::create_directories(reportFolder_ / folder, ignored);
    }
}

bool ReportFiles::write(const std::string& name, std::span<const std::byte> bytes) {
    if (hasError(problems_)) return false;  // a full disk is told once
    Diagnostics problems = image::writeFileAtomically(reportFolder_ / name, bytes);
    const bool good = problems.empty();
    append(problems_, std::move(problems));
    if (good) written_.insert(name);
    return good;
}

void ReportFiles::remark(ShownShot& shown, const ShotResult& shot, const std::string& text) {
    shown.remarks.push_back(text);
    if (problems_.size() < kMostWarnings)
        problems_.push_back(
            warning("result-W02", fmt::format("report of '{}/{}': {}", shot.suite, shot.shot, text)));
}

std::string ReportFiles::addPicture(const fs::path& picture, const ShotResult& shot, const std::string& name,
                                    ShownShot& shown) {
    if (picture.empty()) return {};
    const fs::path file = located(picture, resultsFolder_);
    Result<std::vector<std::byte>> bytes = image::readFile(file, {picture.string(), {}});
    if (!bytes) {
        remark(shown, shot, bytes.diagnostics.front().text);
        return {};
    }
    if (image::formatOf(*bytes) != image::Format::png) {
        const Result<image::Image> decoded = image::decodeImage(*bytes, picture);
        if (!decoded) {
            remark(shown, shot, decoded.diagnostics.front().text);
            return {};
        }
        *bytes = image::encodePng(image::withType(*decoded, image::Component::u8));
    }
    const std::string to = "pictures/" + name + ".png";
    return write(to, *bytes) ? to : std::string();
}

void ReportFiles::addPixels(const ShotResult& shot, const std::string& name, ShownShot& shown) {
    const std::string file = "pixels/" + name + ".js";
    std::string members;
    for (const auto& [key, path, copy] : {std::tuple<const char*, const fs::path&, const std::string&>(
                                              "expected", shot.expected, shown.expected),
                                          {"got", shot.got, shown.got}}) {
        if (copy.empty()) continue;
        const Result<image::Image> picture = image::readImage(located(path, resultsFolder_));
        if (!picture) {
            remark(shown, shot, picture.diagnostics.front().text);
            continue;
        }
        if (std::int64_t{picture->width} * picture->height > kMostPixels) {
            shown.remarks.push_back(
                fmt::format("the pixels of '{}' are too many to be read here", path.string()));
            continue;
        }
        members += fmt::format("{}\"{}\":{}", members.empty() ? "" : ",", key, packedPixels(*picture));
    }
    if (members.empty()) return;
    const std::string script = fmt::format("glibraPixels(\"{}\",{{{}}});\n", file, members);
    if (write(file, std::as_bytes(std::span(script)))) shown.pixels = file;
}

void ReportFiles::addSource(const fs::path& path, ShownShot& shown) {
    const std::string file = path.string();
    if (file.empty()) return;
    auto known = sourceOf_.find(file);
    if (known == sourceOf_.end()) {
        const Result<std::vector<std::byte>> bytes =
            image::readFile(located(path, resultsFolder_), {file, {}}, kLargestSource);
        // The diagnostics say what is wrong with a scene that cannot be read; they are shown without it.
        if (!bytes) return;
        const std::string_view text(reinterpret_cast<const char*>(bytes->data()), bytes->size());
        if (text.find('\0') != std::string_view::npos) return;
        known = sourceOf_.emplace(file, sources_.size()).first;
        sources_.push_back({file, onlyUtf8(text)});
    }
    if (std::find(shown.sources.begin(), shown.sources.end(), known->second) == shown.sources.end())
        shown.sources.push_back(known->second);
}

ShownShot ReportFiles::add(const ShotResult& shot, std::size_t number) {
    ShownShot shown;
    const std::string name = fmt::format("{:05}", number);
    if (isPlain(shot)) {
        const bool same = shot.exact || shot.got.empty() || shot.expected.empty();
        shown.got = addPicture(shot.got.empty() ? shot.expected : shot.got, shot, name + ".got", shown);
        shown.expected = same ? shown.got : addPicture(shot.expected, shot, name + ".expected", shown);
        return shown;
    }
    shown.expected = addPicture(shot.expected, shot, name + ".expected", shown);
    shown.got = addPicture(shot.got, shot, name + ".got", shown);
    shown.difference = addPicture(shot.difference, shot, name + ".difference", shown);
    addPixels(shot, name, shown);
    addSource(shot.script, shown);
    for (const Diagnostic& each : shot.diagnostics) addSource(each.place.file, shown);
    return shown;
}

void ReportFiles::removeOthers() const {
    for (const char* folder : kFolders) {
        std::error_code ignored;  // what stays is only in the way of nobody
        for (const fs::directory_entry& each : fs::directory_iterator(reportFolder_ / folder, ignored)) {
            const std::string name = each.path().filename().string();
            if (isOurs(name) && !written_.contains(std::string(folder) + "/" + name))
                fs::remove(each.path(), ignored);
        }
    }
}

}  // namespace glibra::suite
