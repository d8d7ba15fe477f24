#include "suite/report/report_files.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <string_view>
#include <system_error>
#include <utility>

#include "base/files.h"
#include "base/page_template.h"
#include "base/text.h"
#include "base/utf8.h"
#include "embedded/report_page.h"
#include "image/file.h"
#include "image/format.h"
#include "image/png/png_reader.h"
#include "image/png/png_writer.h"
#include "image/read.h"
#include "suite/golden/hash_list.h"
#include "suite/report/report_pictures.h"
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
        image::ReadOptions options{.limits = image::kDrawnLimits};
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

namespace {

base::Fields fieldsOf(const Diagnostic& remark) {
    return {{"severity", name(remark.severity)}, {"text", toString(remark)}};
}

/// The lines of a file, each with its diagnostics.
base::Fields fieldsOf(const Source& source, const Diagnostics& diagnostics) {
    std::vector<base::Fields> lines;
    for (std::string_view rest = source.text; !rest.empty();) {
        const int line = static_cast<int>(lines.size()) + 1;
        std::vector<base::Fields> remarks;
        for (const Diagnostic& each : diagnostics)
            if (each.place.file == source.file && each.place.line == line) remarks.push_back(fieldsOf(each));
        lines.push_back({{"line", line}, {"text", base::nextLine(rest)}, {"remarks", std::move(remarks)}});
    }
    return {{"file", source.file}, {"lines", std::move(lines)}};
}

std::string labelOf(const ShotResult& shot) {
    return shot.suite + "/" + shot.shot;
}

base::Fields fieldsOf(const ShotResult& shot, const ShownShot& shown, std::span<const Source> sources) {
    std::vector<base::Fields> pictures;
    if (!shown.expected.empty() || !shown.got.empty())
        pictures = {{{"title", titlesOf(shot).expected}, {"file", shown.expected}},
                    {{"title", titlesOf(shot).got}, {"file", shown.got}},
                    {{"title", "difference"}, {"file", shown.difference}}};
    const auto figure = [](const Figure& each) {
        return base::Fields{
            {"name", each.name}, {"value", each.value}, {"limit", each.limit}, {"beyond", each.beyond}};
    };
    const auto listing = [&](std::size_t source) { return fieldsOf(sources[source], shot.diagnostics); };
    return {
        {"verdict", name(shot.verdict)},
        {"label", labelOf(shot)},
        {"reason", reasonOf(shot)},
        {"pictures", std::move(pictures)},
        {"figures", base::rowsOf(figures(shot), figure)},
        {"commands", base::titledRows({{"Reproduce", shot.reproduce},
                                       {"Accept", shot.accept},
                                       {"Would pass, in the [[shot]] of the suite", shot.toPass},
                                       {"No tolerance is sensible", shot.noTolerance}})},
        {"remarks", base::rowsOf(shot.diagnostics, [](const Diagnostic& each) { return fieldsOf(each); })},
        {"sources", base::rowsOf(shown.sources, listing)}};
}

}  // namespace

/// HTML for the inside of <noscript>: every shot that is not a plain pass, with its pictures, figures,
/// commands and scene, the most urgent first; then the names of the others.
static std::string plainPage(const RunResult& run, std::span<const ShownShot> shown,
                             std::span<const Source> sources) {
    std::vector<base::Fields> articles, lists;
    for (const Verdict verdict : kVerdictsByConcern)
        for (std::size_t i = 0; i < run.shots.size(); ++i)
            if (run.shots[i].verdict == verdict && !isPlain(run.shots[i]))
                articles.push_back(fieldsOf(run.shots[i], shown[i], sources));
    for (const Verdict verdict : {Verdict::skipped, Verdict::passed}) {
        std::vector<base::Fields> shots;
        for (std::size_t i = 0; i < run.shots.size(); ++i)
            if (run.shots[i].verdict == verdict && isPlain(run.shots[i]))
                shots.push_back({{"label", labelOf(run.shots[i])}, {"file", shown[i].got}});
        if (!shots.empty())
            lists.push_back({{"count", shots.size()}, {"verdict", name(verdict)}, {"shots", shots}});
    }
    return loadingFirstScreen(base::filled(
        report_page::plain_html(), {{"counts", counts(run)}, {"articles", articles}, {"lists", lists}}));
}

std::string loadingFirstScreen(std::string html) {
    constexpr std::string_view kLazy = " loading=\"lazy\"";
    constexpr int kFirst = 24;
    std::size_t at = 0;
    for (int i = 0; i < kFirst && (at = html.find(kLazy, at)) != std::string::npos; ++i)
        html.erase(at, kLazy.size());
    return html;
}

namespace {

/// JSON for a <script> element. Without '<' nothing in it can close or open an element.
std::string inScript(const nlohmann::ordered_json& json) {
    std::string text;
    for (const char each : json.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace))
        if (each == '<')
            text += "\\u003c";
        else
            text += each;
    return text;
}

nlohmann::ordered_json toJson(const ShotResult& shot, const ShownShot& shown) {
    nlohmann::ordered_json json = {
        {"suite", shot.suite}, {"shot", shot.shot}, {"verdict", name(shot.verdict)}};
    const auto add = [&](const char* key, const auto& value) {
        if (!value.empty()) json[key] = value;
    };
    add("reason", reasonOf(shot));
    add("script", shot.script.generic_string());
    add("expected", shown.expected);
    add("got", shown.got);
    add("difference", shown.difference);
    add("pixels", shown.pixels);
    if (const PictureTitles titles = titlesOf(shot); std::string_view(titles.expected) != "expected")
        json["titles"] = {{"expected", titles.expected}, {"got", titles.got}};
    add("variant", shot.goldenVariant);
    add("driver", shot.driver);
    add("decision", decision(shot));
    add("reproduce", shot.reproduce);
    add("accept", shot.accept);
    add("toPass", shot.toPass);
    add("noTolerance", shot.noTolerance);
    add("sources", shown.sources);
    add("remarks", shown.remarks);
    if (shot.changed) json["changed"] = true;
    if (shot.width > 0) {
        json["width"] = shot.width;
        json["height"] = shot.height;
    }
    if (shot.milliseconds > 0) json["milliseconds"] = shot.milliseconds;
    nlohmann::ordered_json list = nlohmann::ordered_json::array();
    for (const Figure& each : figures(shot)) list.push_back({each.name, each.value, each.limit, each.beyond});
    add("figures", list);
    nlohmann::ordered_json told = nlohmann::ordered_json::array();
    for (const Diagnostic& each : shot.diagnostics)
        if (!isPlain(shot) || each.severity == Severity::warning)
            told.push_back({name(each.severity), each.id, each.text, each.place.file, each.place.line,
                            each.place.column});
    add("diagnostics", told);
    return json;
}

std::string toJson(const RunResult& run, std::span<const ShownShot> shown, const ReportFiles& files) {
    nlohmann::ordered_json json = {{"run", {{"driver", run.driver}}}};
    for (const Verdict verdict : kVerdictsByConcern) json["groups"].push_back(name(verdict));
    json["sources"] = nlohmann::ordered_json::array();
    for (const Source& source : files.sources())
        json["sources"].push_back({{"file", source.file}, {"text", source.text}});
    json["shots"] = nlohmann::ordered_json::array();
    for (std::size_t i = 0; i < run.shots.size(); ++i)
        json["shots"].push_back(toJson(run.shots[i], shown[i]));
    return inScript(json);
}

std::string headline(const RunResult& run) {
    const auto count = [&](const auto& fits) { return std::ranges::count_if(run.shots, fits); };
    const auto drawn = count([](const ShotResult& shot) { return shot.verdict == Verdict::missing; });
    const auto failures = count([](const ShotResult& shot) { return isFailure(shot.verdict); }) - drawn;
    std::string text = fmt::format("{} of {} shots failed", failures, run.shots.size());
    if (failures == 0 && drawn == 0)
        text = run.shots.empty() ? "No shots" : fmt::format("None of {} shots failed", run.shots.size());
    if (drawn > 0) text += fmt::format(", {} drawn without a golden", drawn);
    if (const std::size_t missing = missingShots(run).size(); missing > 0)
        text += fmt::format(", {} of {} planned shots have no verdict", missing, plannedCount(run));
    if (!run.missingShards.empty()) text += ", " + run.missingShards;
    if (!run.orphans.empty())
        text += fmt::format(", {} of no shot", base::counted(run.orphans.size(), "golden"));
    return text;
}

}  // namespace

Diagnostics writeHtmlReport(const RunResult& run, const std::filesystem::path& resultsFolder,
                            const std::filesystem::path& reportFolder, const ReportRoots& roots) {
    ReportFiles files(resultsFolder, reportFolder, roots);
    std::vector<ShownShot> shown;
    shown.reserve(run.shots.size());
    for (const ShotResult& shot : run.shots) shown.push_back(files.add(shot, shown.size() + 1));
    if (hasError(files.problems())) return files.problems();

    std::string script;
    for (const std::string_view part :
         {report_page::pixels_js(), report_page::viewer_js(), report_page::list_js(), report_page::main_js()})
        script += part;
    constexpr std::size_t kMostOrphans = 100;
    const base::Fields fields = {
        {"title", counts(run) + " - glibra"},
        {"headline", headline(run)},
        {"run", fmt::format("About this run ({})", readableTime(run.seconds))},
        {"details", base::titledRows({{"Driver", run.driver},
                                      {"Machine", run.machine},
                                      {"Command", run.command},
                                      {"Shard", run.shard},
                                      {"Began", run.began},
                                      {"Time", readableTime(run.seconds)}})},
        {"orphans", orphanLines(run, kMostOrphans)},  // no shot of the list speaks of them
        {"style", report_page::report_css()},
        {"script", std::move(script)},
        {"static", plainPage(run, shown, files.sources())},
        {"data", toJson(run, shown, files)},
    };
    const std::string page = base::filled(report_page::page_html(), fields);
    Diagnostics problems = files.problems();
    static_cast<void>(base::prepareBeneath(reportFolder, "index.html"));  // the write below reports a failure
    append(problems, image::writeFileAtomically(reportFolder / "index.html", std::as_bytes(std::span(page)),
                                                image::NamedBy::program));
    if (!hasError(problems)) files.removeOthers();
    return problems;
}

}  // namespace glibra::suite
