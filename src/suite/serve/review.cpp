#include "suite/serve/review.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <iterator>
#include <memory>
#include <set>
#include <sstream>
#include <system_error>

#include "base/contained.h"
#include "base/files.h"
#include "base/page_template.h"
#include "embedded/review_page.h"
#include "gpu/context/capabilities.h"
#include "image/file.h"
#include "image/png/png_writer.h"
#include "image/read.h"
#include "suite/file/selection.h"
#include "suite/results/results_file.h"
#include "suite/run/verdict.h"
#include "system/folder.h"
#include "system/process.h"

namespace glibra::suite {
namespace {

// Which files have changed since a golden was accepted: the likely causes of a difference.

class ChangedFiles {
  public:
    /// Those of `files` that have changed since the golden: since the commit that changed it last, if git has
    /// it and it has not been changed since; otherwise those that were written later than it. Files that are
    /// missing count as unchanged. Git is asked once per folder of goldens and once per commit.
    std::vector<std::filesystem::path> since(const std::filesystem::path& golden,
                                             std::span<const std::filesystem::path> files);

  private:
    /// What git knows about a folder of goldens.
    struct Folder {
        std::filesystem::path top;  ///< of the working tree; empty: git does not know the folder
        std::map<std::string, std::string>
            commits;  ///< the last one of each golden, by its path below the folder
    };
    const Folder& folder(const std::filesystem::path& path);
    /// The files of the working tree that differ from a commit, from the top.
    const std::set<std::string>& changedSince(const std::filesystem::path& top, const std::string& commit);

    std::map<std::filesystem::path, Folder> folders_;
    std::map<std::string, std::set<std::string>> changed_;
};

namespace fs = std::filesystem;

struct CloseFile {
    void operator()(std::FILE* each) const { std::fclose(each); }
};

/// What git prints, cut at its zero bytes or line ends; nothing if it fails or is not installed.
std::vector<std::string> git(const fs::path& folder, std::vector<std::string> arguments) {
    // Nothing that the settings of a repository name is started.
    std::vector<std::string> words{"git",       "-C", folder.generic_string(), "-c", "core.fsmonitor=false",
                                   "--no-pager"};
    words.insert(words.end(), arguments.begin(), arguments.end());
    const std::unique_ptr<std::FILE, CloseFile> output(std::tmpfile());
    if (!output) return {};
    using To = system::Stream::To;
    system::Process process = system::startProgram(words, {To::nothing, output.get(), To::nothing});
    if (!process || !waitFor(process).isGood() || std::fseek(output.get(), 0, SEEK_SET) != 0) return {};
    std::vector<std::string> parts;
    std::string part;
    std::array<char, 4096> buffer{};
    for (std::size_t count = 0; (count = std::fread(buffer.data(), 1, buffer.size(), output.get())) > 0;)
        for (const char c : std::span(buffer).first(count)) {
            if (c != '\0' && c != '\n') {
                part += c;
            } else if (!part.empty()) {
                parts.push_back(std::move(part));
                part.clear();
            }
        }
    if (!part.empty()) parts.push_back(std::move(part));
    return parts;
}

const ChangedFiles::Folder& ChangedFiles::folder(const fs::path& path) {
    const auto [at, isNew] = folders_.try_emplace(path);
    Folder& known = at->second;
    if (!isNew) return known;
    const std::vector<std::string> top = git(path, {"rev-parse", "--show-toplevel"});
    if (top.size() != 1) return known;
    known.top = top.front();
    std::string commit;
    for (const std::string& line :
         git(path, {"log", "-z", "--format=/%H", "--name-only", "--relative", "--", "."})) {
        if (line.starts_with('/'))  // as no relative path does
            commit = line.substr(1);
        else
            known.commits.emplace(line, commit);  // the latest comes first
    }
    return known;
}

const std::set<std::string>& ChangedFiles::changedSince(const fs::path& top, const std::string& commit) {
    const auto [at, isNew] = changed_.try_emplace(top.generic_string() + "\n" + commit);
    if (isNew) {
        std::vector<std::string> names =
            git(top, {"diff", "-z", "--name-only", "--no-renames", "--no-ext-diff", "--no-textconv", commit});
        at->second.insert(std::make_move_iterator(names.begin()), std::make_move_iterator(names.end()));
    }
    return at->second;
}

std::vector<fs::path> ChangedFiles::since(const fs::path& golden, std::span<const fs::path> files) {
    const fs::path whole = system::realPath(golden);
    const Folder& known = folder(whole.parent_path());
    const auto commit = known.commits.find(whole.filename().generic_string());
    std::vector<fs::path> changed(files.begin(), files.end());
    if (commit != known.commits.end()) {
        const std::set<std::string>& names = changedSince(known.top, commit->second);
        const auto isChanged = [&](const fs::path& file) {
            return names.contains(file.lexically_relative(known.top).generic_string());
        };
        if (!isChanged(whole)) {
            std::erase_if(changed, [&](const fs::path& each) { return !isChanged(system::realPath(each)); });
            return changed;
        }
    }
    std::error_code failed;
    const fs::file_time_type accepted = fs::last_write_time(whole, failed);
    std::erase_if(changed, [&](const fs::path& each) {
        std::error_code missing;
        const fs::file_time_type written = fs::last_write_time(each, missing);
        return failed || missing || written <= accepted;
    });
    return changed;
}

double lengthOf(const std::array<double, 3>& color) {
    return std::hypot(color[0], color[1], color[2]);
}

}  // namespace

std::optional<DifferenceSign> differenceSign(const image::Image& expected, const image::Image& got) {
    if (expected.width != got.width || expected.height != got.height) return std::nullopt;
    const auto bytes = [](const image::Image& each) {
        return image::withComponents(image::withType(each, image::Component::u8), 3);
    };
    const image::Image before = bytes(expected), after = bytes(got);
    DifferenceSign sign;
    double differing = 0;
    for (std::size_t at = 0; at + 2 < after.data.size(); at += 3) {
        std::array<int, 3> change{};
        for (std::size_t c = 0; c < 3; ++c)
            change[c] = std::to_integer<int>(after.data[at + c]) - std::to_integer<int>(before.data[at + c]);
        if (change == std::array<int, 3>{}) continue;
        ++differing;
        for (std::size_t c = 0; c < 3; ++c) {
            sign.color[c] += change[c];
            sign.size += std::abs(change[c]) / 3.;
        }
    }
    if (differing == 0) return std::nullopt;
    for (double& each : sign.color) each /= differing;
    sign.size /= differing;
    sign.share = differing / (static_cast<double>(after.width) * after.height);
    return sign;
}

bool areAlike(const DifferenceSign& a, const DifferenceSign& b) {
    constexpr double kFactor = 2, kSameDirection = .9, kNoDirection = .3;
    const auto isNear = [](double x, double y) { return x <= kFactor * y && y <= kFactor * x; };
    if (!isNear(a.size, b.size) || !isNear(a.share, b.share)) return false;
    // Where pixels become lighter as well as darker, the mean says nothing.
    const double lengthA = lengthOf(a.color), lengthB = lengthOf(b.color);
    const bool isMixedA = lengthA < kNoDirection * a.size, isMixedB = lengthB < kNoDirection * b.size;
    if (isMixedA || isMixedB) return isMixedA && isMixedB;
    double product = 0;
    for (std::size_t c = 0; c < 3; ++c) product += a.color[c] * b.color[c];
    return product >= kSameDirection * lengthA * lengthB;
}

std::string toText(const DifferenceSign& sign) {
    const double mean = (sign.color[0] + sign.color[1] + sign.color[2]) / 3;
    constexpr double kMostly = .7;
    const char* way = std::abs(mean) < kMostly * sign.size ? "other colours"
                      : mean > 0                           ? "lighter"
                                                           : "darker";
    return fmt::format("{:.3g} of 255 {} in {:.3g} % of the pixels", sign.size, way, 100 * sign.share);
}

namespace {

using ReviewJson = nlohmann::ordered_json;

constexpr const char* kExpectedShots = "expected {\"shots\": [numbers]}";

std::string textOf(const ReviewJson& json) {
    return json.dump(-1, ' ', false, ReviewJson::error_handler_t::replace);
}

WebReply refuse(int status, const std::string& why) {
    return {status, "application/json", textOf({{"error", why}})};
}

/// The kind of a difference, so that shots that differ in the same way stand together.
std::string kindOf(const ShotResult& shot) {
    if (isChangedPass(shot)) return "changed within the tolerance";
    if (shot.verdict != Verdict::failed) return name(shot.verdict);
    const std::string decided = decision(shot);
    return decided.empty() ? "failed" : decided;
}

/// The files besides its script that the scene of a shot read, or else the shader files that it names: words
/// with an ending of shaders.
std::set<std::string> sharedFilesOf(const ShotResult& shot, const fs::path& script) {
    std::set<std::string> read;
    for (const fs::path& each : shot.reads)
        if (each != shot.script) read.insert(each.generic_string());
    if (!read.empty()) return read;
    constexpr std::size_t kMostBytes = std::size_t{1} << 20;
    const auto bytes =
        image::readFile(script, {script.generic_string(), {script.generic_string(), 1, 1}}, kMostBytes);
    if (!bytes) return {};
    std::set<std::string> shaders;
    std::istringstream words{std::string(base::asText(*bytes))};
    for (std::string line; std::getline(words, line);) {
        std::istringstream rest(line.substr(0, line.find('#')));
        for (std::string word; rest >> word;) {
            std::erase(word, '"');
            const std::string ending = fs::path(word).extension().generic_string();
            for (const char* each : {".vert", ".frag", ".geom", ".tesc", ".tese", ".tcs", ".tes", ".comp"})
                if (ending == each) shaders.insert(fs::path(word).filename().generic_string());
        }
    }
    return shaders;
}

Diagnostic cannotKeep() {
    return diagnose("file-E10", fmt::format("cannot write '{}' in the folder of the results", kReviewFile));
}

/// The shots that a request names.
struct Asked {
    std::vector<std::size_t> shots;
    bool force = false, also = false;
};

std::optional<Asked> parse(const std::string& body, std::size_t count) {
    const ReviewJson json = ReviewJson::parse(body, nullptr, false);
    if (!json.is_object() || !json.contains("shots") || !json.at("shots").is_array()) return std::nullopt;
    Asked asked;
    std::set<std::size_t> known;  // a repetition counts once
    for (const ReviewJson& each : json.at("shots")) {
        if (!each.is_number_unsigned() || each.get<std::uint64_t>() >= count) return std::nullopt;
        if (known.insert(each.get<std::size_t>()).second) asked.shots.push_back(each.get<std::size_t>());
    }
    const auto flag = [&](const char* name) { return json.contains(name) && json.at(name) == true; };
    asked.force = flag("force");
    asked.also = flag("also");
    return asked;
}

/// Decides about each shot: {"accepted": [3], "refused": [[5, "why"]]}. `decide` returns why not, or nothing.
WebReply answer(const char* word, const std::optional<Asked>& asked,
                const std::function<std::string(std::size_t)>& decide) {
    if (!asked) return refuse(400, kExpectedShots);
    ReviewJson json = {{word, ReviewJson::array()}, {"refused", ReviewJson::array()}};
    for (const std::size_t each : asked->shots) {
        const std::string why = decide(each);
        if (why.empty())
            json[word].push_back(each);
        else
            json["refused"].push_back({each, why});
    }
    return {200, "application/json", textOf(json)};
}

/// Why --update would not replace a golden without being told to: it cannot be read, or another family of
/// drivers drew it. Empty if it would.
std::string whyKept(const GoldenStore& store, const Shot& shot, const std::string& variant,
                    const ShotResult& result) {
    std::error_code failure;
    std::optional<image::Image> picture;
    if (fs::exists(store.file(shot, variant), failure)) {
        const Result<Golden> golden = store.read(shot, variant);
        if (!golden) return golden.message();
        // A picture that is not on this machine can be read where it lies.
        Result<image::Image> decoded = golden->isAbsent ? Result<image::Image>() : decode(*golden);
        if (!decoded && !golden->isAbsent) return decoded.message();
        picture = std::move(decoded.value);
    }
    if (!variant.empty() || !isKey(result.acceptKey)) return {};
    const std::set<std::string> families = store.familiesOf(shot, picture);
    const std::string family = gpu::familyOf(result.acceptKey);
    if (families.empty() || families.contains(family)) return {};
    return fmt::format("the golden for all drivers was drawn by {}, and this picture by {}",
                       fmt::join(families, " and "), family);
}

/// The bytes of a golden that may be replaced; nothing if there is no such file.
std::optional<std::vector<std::byte>> bytesOf(const fs::path& golden) {
    std::error_code failure;
    if (!fs::exists(golden, failure)) return std::nullopt;
    auto bytes = image::readFile(golden, {golden.generic_string(), {golden.generic_string(), 1, 1}});
    return std::move(bytes.value);
}

}  // namespace

Review::Review(const RunResult& run, std::vector<Suite> suites, ReviewOptions options)
    : suites_(std::move(suites)), options_(std::move(options)) {
    std::ranges::copy_if(run.shots, std::back_inserter(shots_), needsALook);
    groups_ = findGroups();
    readDecisions();
}

std::vector<ReviewGroup> Review::findGroups() const {
    // The files that have changed since the golden are the likely cause; otherwise those that most scenes
    // share. Files that only the results name are not read.
    std::map<fs::path, std::set<std::string>> shaders;
    std::vector<std::set<std::string>> candidates(shots_.size());
    std::map<std::string, std::set<fs::path>> scenesOf;
    ChangedFiles changed;
    std::map<const Suite*, GoldenStore> stores;
    for (std::size_t i = 0; i < shots_.size(); ++i) {
        const Known known = find(shots_[i]);
        if (!known.shot) continue;
        if (!stores.contains(known.suite)) stores.emplace(known.suite, *storeOf(*known.suite));
        const fs::path golden = stores.at(known.suite).file(*known.shot, shots_[i].goldenVariant);
        for (const fs::path& each : changed.since(golden, shots_[i].reads))
            candidates[i].insert(each.generic_string());
        if (candidates[i].empty()) {
            const auto [at, isNew] = shaders.try_emplace(known.shot->script);
            if (isNew) at->second = sharedFilesOf(shots_[i], known.shot->script);
            candidates[i] = at->second;
        }
        for (const std::string& each : candidates[i]) scenesOf[each].insert(shots_[i].script);
    }
    // All files that as many scenes have as the most common one: nothing tells which of them it is.
    const auto causesOf = [&](std::size_t index) {
        std::size_t most = 1;
        for (const std::string& each : candidates[index]) most = std::max(most, scenesOf[each].size());
        std::vector<std::string> causes;
        for (const std::string& each : candidates[index])
            if (scenesOf[each].size() == most) causes.push_back(each);
        if (causes.empty()) causes.push_back(shots_[index].script.generic_string());
        return causes;
    };
    std::vector<ReviewGroup> groups;
    std::map<std::string, std::size_t> known;
    for (std::size_t i = 0; i < shots_.size(); ++i) {
        constexpr std::size_t kMostNames = 4;
        const std::vector<std::string> causes = causesOf(i);
        const std::string kind = kindOf(shots_[i]);
        std::string names;
        for (std::size_t each = 0; each < std::min(causes.size(), kMostNames); ++each)
            names += (each > 0 ? ", " : "") + fs::path(causes[each]).filename().generic_string();
        if (causes.size() > kMostNames) names += fmt::format(" and {} more", causes.size() - kMostNames);
        const auto [at, isNew] =
            known.emplace(fmt::format("{}\n{}", fmt::join(causes, "\n"), kind), groups.size());
        if (isNew) groups.push_back({fmt::format("{}: {}", names, kind), {}, {}});
        groups[at->second].shots.push_back(i);
    }
    for (ReviewGroup& each : groups) each.alike = alikeOf(each.shots);
    return groups;
}

std::optional<DifferenceSign> Review::signOf(std::size_t index) const {
    const auto decoded = [&](const fs::path& file) -> std::optional<image::Image> {
        if (file.empty()) return std::nullopt;
        const auto bytes = read(file);
        return bytes ? image::decodeImage(*bytes, file, {}, {.limits = image::kDrawnLimits}).value
                     : std::nullopt;
    };
    const auto expected = decoded(shots_[index].expected), got = decoded(shots_[index].got);
    return expected && got ? differenceSign(*expected, *got) : std::nullopt;
}

std::vector<AlikeShots> Review::alikeOf(const std::vector<std::size_t>& shots) const {
    std::vector<AlikeShots> parts;
    std::vector<std::optional<DifferenceSign>> signs;  // of the first shot of each part
    for (const std::size_t each : shots) {
        const std::optional<DifferenceSign> sign = signOf(each);
        const auto same = std::ranges::find_if(signs, [&](const auto& other) {
            return sign && other ? areAlike(*sign, *other) : !sign && !other;
        });
        const auto at = static_cast<std::size_t>(same - signs.begin());
        if (same == signs.end()) {
            signs.push_back(sign);
            parts.push_back({sign ? toText(*sign) : "", {}});
        }
        parts[at].shots.push_back(each);
    }
    std::ranges::stable_sort(parts, std::ranges::greater(),
                             [](const AlikeShots& each) { return each.shots.size(); });
    return parts;
}

void Review::serve(LoopbackServer& server) {
    const std::string page = base::filled(review_page::review_html(), {{"style", review_page::review_css()},
                                                                       {"script", review_page::review_js()}});
    server.get("", [page](const WebRequest&) { return WebReply{200, "text/html; charset=utf-8", page}; });
    server.get("data", [this](const WebRequest&) { return data(); });
    server.get("picture", [this](const WebRequest& request) { return picture(request); });
    server.post("see", [this](const WebRequest& request) { return see(request); });
    server.post("accept", [this](const WebRequest& request) { return accept(request); });
    server.post("reject", [this](const WebRequest& request) { return reject(request); });
}

Review::Known Review::find(const ShotResult& result) const {
    for (const Suite& suite : suites_)
        if (suite.name == result.suite)
            for (const Shot& shot : suite.shots)
                if (shot.name == result.shot) return {&suite, &shot};
    return {};
}

Result<GoldenStore> Review::storeOf(const Suite& suite) const {
    return GoldenStore::open(suite, options_.goldens, options_.allowOutside, options_.results / kUploads);
}

/// Pictures of the results folder only: what a run has copied there. Results may come from somebody else.
Result<std::vector<std::byte>> Review::read(const fs::path& file) const {
    return readNamed(file, options_.results, base::Roots());
}

std::string Review::whyNot(std::size_t index) const {
    const ShotResult& result = shots_[index];
    const Known known = find(result);
    if (result.got.empty()) return "there is no picture";
    if (result.verdict == Verdict::unstable || result.verdict == Verdict::flaky)
        return "its drawings differ: no picture of it can be accepted";
    if (!known.shot) return "the suite has no such shot now";
    if (result.accept.empty() && result.verdict != Verdict::quarantined)
        return "another golden does not help";
    if (!options_.allowOutside && hasError(checkGoldenFolder(*known.suite, options_.goldens)))
        return "its golden is outside of the suite's folder (--allow-outside)";
    return {};
}

WebReply Review::data() const {
    ReviewJson json = {{"shots", ReviewJson::array()}, {"groups", ReviewJson::array()}};
    for (std::size_t i = 0; i < shots_.size(); ++i) {
        const ShotResult& shot = shots_[i];
        const PictureTitles titles = titlesOf(shot);
        ReviewJson figuresOf = ReviewJson::array();
        for (const Figure& each : figures(shot))
            figuresOf.push_back({each.name, each.value, each.limit, each.beyond});
        json["shots"].push_back({{"name", shot.suite + "/" + shot.shot},
                                 {"verdict", isChangedPass(shot) ? "changed" : name(shot.verdict)},
                                 {"reason", reasonOf(shot)},
                                 {"titles", {titles.expected, titles.got}},
                                 {"expected", !shot.expected.empty()},
                                 {"got", !shot.got.empty()},
                                 {"difference", !shot.difference.empty()},
                                 {"size", {shot.width, shot.height}},
                                 {"figures", std::move(figuresOf)},
                                 {"whyNot", whyNot(i)},
                                 {"decided", decisionOf(i)}});
    }
    for (const ReviewGroup& each : groups()) {
        ReviewJson alike = ReviewJson::array();
        for (const AlikeShots& part : each.alike)
            alike.push_back({{"difference", part.difference}, {"shots", part.shots}});
        json["groups"].push_back({{"cause", each.cause}, {"shots", each.shots}, {"alike", std::move(alike)}});
    }
    return {200, "application/json", textOf(json)};
}

WebReply Review::picture(const WebRequest& request) {
    const auto parameter = [&](const char* name) {
        const auto found = request.parameters.find(name);
        return found == request.parameters.end() ? std::string() : found->second;
    };
    const std::string number = parameter("shot"), what = parameter("what");
    const auto index = parse("{\"shots\": [" + number + "]}", shots_.size());
    if (!index || index->shots.size() != 1) return refuse(404, "there is no such shot");
    const std::size_t shot = index->shots.front();
    const ShotResult& result = shots_[shot];
    const fs::path* file = what == "got"          ? &result.got
                           : what == "expected"   ? &result.expected
                           : what == "difference" ? &result.difference
                                                  : nullptr;
    if (!file || file->empty()) return refuse(404, "there is no such picture");
    const auto bytes = read(*file);
    if (!bytes) return refuse(404, bytes.message());
    const Result<image::Image> picture =
        image::decodeImage(*bytes, *file, {}, {.limits = image::kDrawnLimits});
    if (!picture) return refuse(404, picture.message());
    if (what == "got") fetched_[shot] = hashOf(*bytes);
    const std::vector<std::byte> png = image::encodePng(image::withType(*picture, image::Component::u8));
    return {200, "image/png", std::string(base::asText(png))};
}

WebReply Review::see(const WebRequest& request) {
    const auto asked = parse(request.body, shots_.size());
    if (!asked) return refuse(400, kExpectedShots);
    for (const std::size_t each : asked->shots)
        if (const auto known = fetched_.find(each); known != fetched_.end()) seen_[each] = known->second;
    return {200, "application/json", "{}"};
}

std::string Review::acceptOne(std::size_t index, bool force, bool also) {
    if (std::string why = whyNot(index); !why.empty()) return why;
    const auto seen = seen_.find(index);
    if (seen == seen_.end()) return "nobody has looked at its picture";
    const ShotResult& result = shots_[index];
    const Known known = find(result);
    const auto bytes = read(result.got);
    if (!bytes) return bytes.message();
    if (hashOf(*bytes) != seen->second) return "its picture has changed since it was shown; look again";
    const Result<image::Image> decoded =
        image::decodeImage(*bytes, result.got, {}, {.limits = image::kDrawnLimits});
    if (!decoded) return decoded.message();
    // A picture without alpha was read with one.
    const image::Image picture = image::withComponents(*decoded, known.shot->options.alpha ? 4 : 3);
    if (const std::string why = whyNoGolden(picture); !why.empty() && !force)
        return why + "; force accepts it";
    const auto store = storeOf(*known.suite);
    if (!store) return store.message();
    const bool isFurther = also && result.verdict != Verdict::missing;
    const std::string variant = isFurther ? store->freeVariant(*known.shot) : result.goldenVariant;
    if (isFurther && variant.empty()) return "it has nine further accepted pictures; remove one";
    if (!force)
        if (const std::string why = whyKept(*store, *known.shot, variant, result); !why.empty())
            return why + "; force accepts it";
    Before before{variant, bytesOf(store->file(*known.shot, variant)), {}, {}};
    for (AcceptedHash& line : store->accepted().linesOf(known.shot->name))
        if (line.variant == variant) before.lines.push_back(std::move(line));
    const Result<Golden> golden = store->replace(*known.shot, variant, picture);
    if (!golden) return golden.message();
    before.accepted = hashOf(golden->bytes);
    before_[index] = std::move(before);
    Diagnostics problems;
    if (isKey(result.acceptKey)) {
        const AcceptedHash line{known.shot->name, variant, golden->identity, hashOf(picture),
                                result.acceptKey};
        problems = acceptHashes(store->hashFile(), {&line, 1});
    }
    if (!decide(index, "accepted")) problems.push_back(cannotKeep());
    return problems.empty() ? std::string() : "accepted, but " + problems.front().text;
}

std::string Review::acceptUnseen(std::size_t index) {
    if (decisionOf(index) == "accepted") return {};
    if (!shots_[index].got.empty())
        if (const auto bytes = read(shots_[index].got)) seen_[index] = hashOf(*bytes);
    return acceptOne(index, false, false);
}

bool Review::isNamed(std::size_t index, std::span<const std::string> patterns) const {
    const Known known = find(shots_[index]);
    return std::ranges::any_of(patterns, [&](const std::string& each) {
        return fits(each, shots_[index].suite + "/" + shots_[index].shot) ||
               (known.shot ? isMeant(*known.shot, each) : fits(each, shots_[index].shot));
    });
}

WebReply Review::accept(const WebRequest& request) {
    const auto asked = parse(request.body, shots_.size());
    return answer("accepted", asked, [&](std::size_t each) {
        return decisionOf(each) == "accepted" ? "it has been accepted already"
                                              : acceptOne(each, asked->force, asked->also);
    });
}

std::string Review::undo(std::size_t index) {
    const auto found = before_.find(index);
    if (found == before_.end())
        return "it was accepted in an earlier review; restore its golden from version control";
    const Before& before = found->second;
    const Known known = find(shots_[index]);
    const auto store = storeOf(*known.suite);
    if (!store) return store.message();
    const Result<Golden> golden = store->read(*known.shot, before.variant);
    if (!golden || hashOf(golden->bytes) != before.accepted)
        return "its golden has changed since it was accepted; restore it from version control";
    // Lines without their golden only cost time, so they come first.
    Diagnostics problems = restoreHashes(store->hashFile(), known.shot->name, before.variant, before.lines);
    if (problems.empty()) problems = store->restore(*known.shot, before.variant, before.golden);
    if (!problems.empty()) return problems.front().text;
    before_.erase(found);
    return {};
}

std::string Review::rejectOne(std::size_t index) {
    if (decisionOf(index) == "accepted")
        if (std::string why = undo(index); !why.empty()) return why;
    return decide(index, "rejected") ? std::string() : "rejected, but " + cannotKeep().text;
}

WebReply Review::reject(const WebRequest& request) {
    return answer("rejected", parse(request.body, shots_.size()),
                  [this](std::size_t each) { return rejectOne(each); });
}

std::string Review::decisionOf(std::size_t index) const {
    const auto found = decided_.find(index);
    return found == decided_.end() ? std::string() : found->second.word;
}

std::string Review::contentOf(std::size_t index) const {
    const ShotResult& result = shots_[index];
    if (result.got.empty()) return toText(hashOf(std::as_bytes(std::span(result.reason))));
    const auto got = read(result.got);
    return got ? toText(hashOf(*got)) : std::string();
}

bool Review::isGolden(std::size_t index) const {
    const ShotResult& result = shots_[index];
    const Known known = find(result);
    if (!known.shot || result.got.empty()) return false;
    const auto bytes = read(result.got);
    if (!bytes) return false;
    const auto store = storeOf(*known.suite);
    const Result<image::Image> picture =
        image::decodeImage(*bytes, result.got, {}, {.limits = image::kDrawnLimits});
    if (!store || !picture) return false;
    const int components = known.shot->options.alpha ? 4 : 3;
    const Hash wanted = hashOf(image::withComponents(*picture, components));
    std::vector<std::string> variants = store->furtherVariants(*known.shot);
    variants.push_back(result.goldenVariant);
    for (std::string& variant : variants) {
        const Result<Golden> golden = store->read(*known.shot, std::move(variant));
        if (!golden) continue;
        const Result<image::Image> other = decode(*golden);
        if (other && hashOf(image::withComponents(*other, components)) == wanted) return true;
    }
    return false;
}

void Review::readDecisions() {
    constexpr std::uint64_t kLargest = std::uint64_t{64} << 20U;
    const system::File file = base::openBeneath(options_.results, kReviewFile);
    if (!file && (errno == ENOENT || errno == ENOTDIR)) return;
    std::vector<std::byte> bytes;
    const int problem = file ? base::readAll(file, kLargest, bytes) : errno;
    const ReviewJson json = ReviewJson::parse(base::asText(bytes), nullptr, false);
    if (problem != 0 || !json.is_object()) {
        const std::string why =
            problem != 0 ? std::generic_category().message(problem) : "it is not what a review has written";
        problems_.push_back(
            diagnose("result-W02", fmt::format("cannot read '{}': {}; earlier decisions are not known",
                                               (options_.results / kReviewFile).generic_string(), why)));
        return;
    }
    for (std::size_t i = 0; i < shots_.size(); ++i) {
        const auto found = json.find(shots_[i].suite + "/" + shots_[i].shot);
        if (found == json.end() || !found->is_array() || found->size() != 2) continue;
        const std::string content = contentOf(i);
        if (content.empty() || found->at(1) != content) continue;
        if (found->at(0) == "rejected" || (found->at(0) == "accepted" && isGolden(i)))
            decided_[i] = {found->at(0).get<std::string>(), content};
    }
}

bool Review::decide(std::size_t index, std::string word) {
    decided_[index] = {std::move(word), contentOf(index)};
    ReviewJson json = ReviewJson::object();
    for (const auto& [each, decision] : decided_)
        json[shots_[each].suite + "/" + shots_[each].shot] = {decision.word, decision.content};
    const std::string text = json.dump(1, ' ', false, ReviewJson::error_handler_t::replace) + "\n";
    return base::writeBeneath(options_.results, kReviewFile, std::as_bytes(std::span(text))) == 0;
}

}  // namespace glibra::suite
