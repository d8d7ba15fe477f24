#include "suite/report/report_files.h"

#include <fmt/format.h>

#include <algorithm>
#include <span>
#include <system_error>
#include <utility>

#include "base/files.h"
#include "base/utf8.h"
#include "image/convert.h"
#include "image/file.h"
#include "image/format.h"
#include "image/png/png_reader.h"
#include "image/png/png_writer.h"
#include "image/read.h"
#include "suite/golden/hash.h"
#include "suite/report/packed_pixels.h"
#include "suite/results/results_file.h"
#include "suite/write_below.h"

namespace glibra::suite {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMostWarnings = 20;
constexpr std::uint64_t kLargestSource = std::uint64_t{1} << 20;
// Unpacking more than this takes a browser seconds and hundreds of megabytes.
constexpr std::int64_t kMostPixels = std::int64_t{4096} * 4096;

const char* const kFolders[] = {"pictures", "pixels"};

/// "00012-5f0c82aa": number and content. The files of a new report stand beside those of an old one, whose
/// page stays valid until the new page replaces it.
std::string nameOf(std::size_t number, std::span<const std::byte> content) {
    constexpr std::size_t kDigits = 8;
    return fmt::format("{:05}-{}", number, toText(hashOf(content)).substr(0, kDigits));
}

/// True for "00012-5f0c82aa.got.png" and "00012.js": names that only a report gives.
bool isOurs(std::string_view name) {
    const std::size_t digits = name.find_first_not_of("0123456789");
    if (digits == std::string_view::npos || digits < 5) return false;
    std::string_view rest = name.substr(digits);
    if (rest.starts_with('-'))
        rest.remove_prefix(std::min(rest.size(), rest.find_first_not_of("0123456789abcdef", 1)));
    return rest == ".js" || rest == ".got.png" || rest == ".expected.png" || rest == ".difference.png";
}

}  // namespace

bool isPlain(const ShotResult& shot) {
    return (shot.verdict == Verdict::passed && !shot.changed) || shot.verdict == Verdict::skipped;
}

ReportFiles::ReportFiles(fs::path resultsFolder, fs::path reportFolder, ReportRoots roots)
    : resultsFolder_(std::move(resultsFolder)),
      reportFolder_(std::move(reportFolder)),
      roots_(std::move(roots)) {
    for (const char* folder : kFolders) {
        std::error_code ignored;  // reported with the first file that cannot be written
        fs::create_directories(reportFolder_ / folder, ignored);
    }
}

bool ReportFiles::write(const std::string& name, std::span<const std::byte> bytes) {
    if (hasError(problems_)) return false;  // a full disk is reported once
    if (const int problem = base::prepareBeneath(reportFolder_, name); problem != 0) {
        problems_.push_back(cannotWrite(reportFolder_ / name, problem));
        return false;
    }
    Diagnostics problems = image::writeFileAtomically(reportFolder_ / name, bytes, image::NamedBy::program);
    const bool good = problems.empty();
    append(problems_, std::move(problems));
    if (good) written_.insert(name);
    return good;
}

void ReportFiles::remark(ShownShot& shown, const ShotResult& shot, const std::string& text) {
    shown.remarks.push_back(text);
    if (problems_.size() < kMostWarnings)
        problems_.push_back(
            diagnose("result-W02", fmt::format("report of '{}/{}': {}", shot.suite, shot.shot, text)));
}

Diagnostics ReportFiles::problems() const {
    Diagnostics all = problems_;
    if (unnamedCount_ > 0)
        all.push_back(diagnose(
            "result-W02",
            fmt::format("{} not in the merged folders, so the report does not show {}; --root "
                        "FOLDER names the folder that has {}, such as --root .",
                        unnamedCount_ == 1 ? "1 picture is" : fmt::format("{} pictures are", unnamedCount_),
                        unnamedCount_ == 1 ? "it" : "them", unnamedCount_ == 1 ? "it" : "them")));
    return all;
}

fs::path ReportFiles::foundAt(const fs::path& picture) const {
    const fs::path inside = resultsFolder_ / picture;
    std::error_code ignored;
    return fs::exists(inside, ignored) ? inside : picture;
}

ReportFiles::Copy ReportFiles::addPicture(const fs::path& picture, const ShotResult& shot, std::size_t number,
                                          std::string_view ending, bool wantsPixels, ShownShot& shown) {
    if (picture.empty()) return {};
    Result<std::vector<std::byte>> bytes = readNamed(picture, resultsFolder_, roots_.pictures);
    if (!bytes) {
        const std::string& why = bytes.diagnostics.front().text;
        if (roots_.areUnnamed && picture == shot.expected) {
            shown.remarks.push_back(why);
            ++unnamedCount_;
        } else {
            remark(shown, shot, why);
        }
        return {};
    }
    Copy copy;
    const bool isPng = image::formatOf(*bytes) == image::Format::png;
    if (isPng && !image::pngChunks(*bytes)) {
        remark(shown, shot, fmt::format("'{}' is a damaged PNG picture", picture.generic_string()));
        return {};
    }
    // The page shows what was compared.
    const bool isCopied = isPng && image::shownOtherwise(*bytes).empty();
    if (wantsPixels || !isCopied) {
        image::ReadOptions options;
        options.decoder = roots_.decoder;
        Result<image::Image> decoded = image::decodeImage(*bytes, foundAt(picture), {}, options);
        if (!decoded) {
            remark(shown, shot, decoded.diagnostics.front().text);
            return {};
        }
        if (!isCopied) *bytes = image::encodePng(image::withType(*decoded, image::Component::u8));
        copy.pixels = std::move(*decoded);
    }
    const std::string to = fmt::format("pictures/{}.{}.png", nameOf(number, *bytes), ending);
    if (write(to, *bytes)) copy.file = to;
    return copy;
}

std::string ReportFiles::addPixels(const Copy& expected, const Copy& got, std::size_t number,
                                   ShownShot& shown) {
    std::string members;
    for (const auto& [key, copy] :
         {std::pair<const char*, const Copy&>{"expected", expected}, {"got", got}}) {
        if (copy.file.empty()) continue;
        if (std::int64_t{copy.pixels.width} * copy.pixels.height > kMostPixels) {
            shown.remarks.push_back(
                fmt::format("the picture '{}' is too large for reading its pixels here", key));
            continue;
        }
        members += fmt::format("{}\"{}\":{}", members.empty() ? "" : ",", key, packedPixels(copy.pixels));
    }
    if (members.empty()) return {};
    const std::string file = fmt::format("pixels/{}.js", nameOf(number, std::as_bytes(std::span(members))));
    const std::string script = fmt::format("glibraPixels(\"{}\",{{{}}});\n", file, members);
    return write(file, std::as_bytes(std::span(script))) ? file : std::string();
}

void ReportFiles::addSource(const fs::path& path, ShownShot& shown) {
    const std::string file = path.generic_string();
    if (file.empty()) return;
    auto known = sourceOf_.find(file);
    if (known == sourceOf_.end()) {
        // A results file may name any file of this machine, so only files below the roots are shown. Of
        // others the report has the name, and the diagnostics say why a scene cannot be read.
        const Result<std::vector<std::byte>> bytes =
            readNamed(path, resultsFolder_, roots_.texts, kLargestSource);
        if (!bytes) return;
        const std::string_view text = base::asText(*bytes);
        if (text.find('\0') != std::string_view::npos) return;
        known = sourceOf_.emplace(file, sources_.size()).first;
        sources_.push_back({file, base::onlyUtf8(text)});
    }
    if (std::ranges::find(shown.sources, known->second) == shown.sources.end())
        shown.sources.push_back(known->second);
}

ShownShot ReportFiles::add(const ShotResult& shot, std::size_t number) {
    ShownShot shown;
    const auto add = [&](const fs::path& picture, const char* ending, bool wantsPixels = false) {
        return addPicture(picture, shot, number, ending, wantsPixels, shown);
    };
    if (isPlain(shot)) {
        const bool same = shot.exact || shot.got.empty() || shot.expected.empty();
        shown.got = add(shot.got.empty() ? shot.expected : shot.got, "got").file;
        shown.expected = same ? shown.got : add(shot.expected, "expected").file;
        return shown;
    }
    const Copy expected = add(shot.expected, "expected", true), got = add(shot.got, "got", true);
    shown.expected = expected.file;
    shown.got = got.file;
    shown.difference = add(shot.difference, "difference").file;
    shown.pixels = addPixels(expected, got, number, shown);
    addSource(shot.script, shown);
    for (const Diagnostic& each : shot.diagnostics) addSource(each.place.file, shown);
    return shown;
}

void ReportFiles::removeOthers() const {
    for (const char* folder : kFolders) {
        for (const fs::directory_entry& each : base::entriesOf(reportFolder_ / folder)) {
            const std::string name = each.path().filename().generic_string();
            std::error_code ignored;  // a file that stays does no harm
            if (isOurs(name) && !written_.contains(std::string(folder) + "/" + name))
                fs::remove(each.path(), ignored);
        }
    }
}

}  // namespace glibra::suite
