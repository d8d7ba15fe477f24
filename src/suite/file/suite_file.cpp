#include "suite/file/suite_file.h"

#include <fmt/format.h>
#include <algorithm>
#include <array>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <system_error>
#include <tuple>
#include <unordered_map>
#include <utility>
#include <vector>

#include "base/files.h"
#include "base/suggest.h"
#include "base/text.h"
#include "glib/messages.h"
#include "glib/number.h"
#include "glib/text.h"
#include "image/file.h"
#include "scene/file_lookup.h"
#include "suite/file/selection.h"
#include "suite/file/shot_keys.h"
#include "suite/file/shot_name.h"
#include "suite/file/sweep.h"
#include "suite/file/toml_reader.h"

namespace glibra::suite {
namespace {

// Finds the shots that `match` and `differ` name.

/// A `match` or `differ` of shot number `shot` of the suite. `suffix` is that of its sweep and time.
struct PairRequest {
    std::size_t shot = 0;
    bool isMatch = true;
    PlacedText name;
    std::string suffix;
};

struct Edge {
    std::size_t to = 0;
    const PairRequest* request = nullptr;
};
using Edges = std::vector<std::vector<Edge>>;  // one list per shot

using Names = std::unordered_map<std::string_view, std::size_t>;

std::optional<std::size_t> find(const Names& names, const PairRequest& request) {
    auto found = names.end();
    if (!request.suffix.empty()) found = names.find(request.name.text + request.suffix);
    if (found == names.end()) found = names.find(request.name.text);
    if (found == names.end()) return std::nullopt;
    return found->second;
}

/// Suggests a shot of a sweep, or the nearest name.
std::string hint(const Suite& suite, const std::string& wanted) {
    std::vector<std::string_view> names;
    for (const Shot& shot : suite.shots) {
        if (shot.name.starts_with(wanted + '@'))
            return fmt::format("; there is '{}', one of several", shot.name);
        names.emplace_back(shot.name);
    }
    return base::suggestion(wanted, names);
}

/// The names of a cycle: "a, b, c, a". Long cycles are cut.
std::string cycleText(const Suite& suite, std::span<const std::size_t> path, std::size_t begin) {
    constexpr std::size_t kShown = 6;
    std::string text;
    for (std::size_t i = begin; i < path.size() && i < begin + kShown; ++i)
        text += suite.shots[path[i]].name + ", ";
    return text + (path.size() > begin + kShown ? "..., " : "") + suite.shots[path[begin]].name;
}

/// Reports suite-E08 for every edge that closes a cycle.
void reportCycles(TomlReader& reader, const Suite& suite, const Edges& edges) {
    enum class State : char { unseen, onPath, done };
    std::vector<State> states(edges.size(), State::unseen);
    std::vector<std::size_t> next(edges.size());  // the next edge to follow, per shot
    for (std::size_t start = 0; start < edges.size(); ++start) {
        if (states[start] != State::unseen) continue;
        std::vector<std::size_t> path{start};
        states[start] = State::onPath;
        while (!path.empty()) {
            const std::size_t here = path.back();
            if (next[here] == edges[here].size()) {
                states[here] = State::done;
                path.pop_back();
                continue;
            }
            const Edge& edge = edges[here][next[here]++];
            if (states[edge.to] == State::unseen) {
                states[edge.to] = State::onPath;
                path.push_back(edge.to);
            } else if (states[edge.to] == State::onPath) {
                const auto begin = std::ranges::find(path, edge.to) - path.begin();
                reader.report("suite-E08",
                              fmt::format("{}: the shots name each other in a cycle: {}",
                                          edge.request->isMatch ? "match" : "differ",
                                          cycleText(suite, path, static_cast<std::size_t>(begin))),
                              edge.request->name.place);
            }
        }
    }
}

/// Sets `match` and `differ` of the shots. A name stands for the shot with that name and the suffix of the
/// shot that names it, if there is one, so that two sweeps over the same values are compared one by one;
/// otherwise for the shot with exactly that name. Where an entry of the suite makes several shots and names
/// one of them, that one is compared with nothing. Errors: suite-E07 there is no such shot; suite-E08 a cycle
/// of names; suite-E12 the named shot makes no picture, or `match` and `differ` name the same shot.
void resolvePairs(TomlReader& reader, std::span<const PairRequest> requests, Suite& suite) {
    Names names;
    for (std::size_t i = 0; i < suite.shots.size(); ++i) names.emplace(suite.shots[i].name, i);
    // One entry of the suite may make several shots and name one of them, with which the others are compared.
    std::set<std::tuple<int, int, std::size_t>> namedByOthers;
    for (const PairRequest& request : requests)
        if (const auto other = find(names, request); other && *other != request.shot)
            namedByOthers.emplace(request.name.place.line, request.name.place.column, *other);
    Edges edges(suite.shots.size());
    for (const PairRequest& request : requests) {
        const char* word = request.isMatch ? "match" : "differ";
        const auto other = find(names, request);
        if (other == request.shot &&
            namedByOthers.contains({request.name.place.line, request.name.place.column, *other}))
            continue;
        if (!other) {
            reader.report("suite-E07",
                          fmt::format("{}: there is no shot {}{}", word, glib::inQuotes(request.name.text),
                                      hint(suite, request.name.text)),
                          request.name.place);
            continue;
        }
        Shot& shot = suite.shots[request.shot];
        if (suite.shots[*other].expectedError)
            reader.report("suite-E12",
                          fmt::format("{}: '{}' expects an error, so it makes no picture", word,
                                      suite.shots[*other].name),
                          request.name.place);
        (request.isMatch ? shot.match : shot.differ) = suite.shots[*other].name;
        if (shot.match == shot.differ)
            reader.report("suite-E12", fmt::format("match and differ both name '{}'", shot.match),
                          request.name.place);
        edges[request.shot].push_back({*other, &request});
    }
    reportCycles(reader, suite, edges);
}

namespace fs = std::filesystem;

constexpr std::uint64_t kLargestSuiteFile = std::uint64_t{16} << 20;

/// The pairs of names whose goldens are one file, or one the variant of the other, on disks that ignore case,
/// but not on others.
std::vector<std::pair<std::string, std::string>> sharedOnSomeDisk(const std::vector<std::string>& names) {
    std::unordered_map<std::string, std::string> byForm;
    for (const std::string& each : names) byForm.emplace(nameOnAnyDisk(each), each);
    std::vector<std::pair<std::string, std::string>> shared;
    for (const std::string& each : names) {
        const std::string form = nameOnAnyDisk(each);
        if (const std::string& first = byForm.at(form); first != each) shared.emplace_back(each, first);
        const auto other = byForm.find(std::string(shotOfVariant(form)));
        if (other != byForm.end() && other->second != shotOfVariant(each))
            shared.emplace_back(each, other->second);
    }
    return shared;
}

std::string shareText(const std::string& name, const std::string& other) {
    return fmt::format(
        "the goldens of '{}' and '{}' would be one file on disks that ignore upper and lower case; rename "
        "one",
        other, name);
}

/// The limits that let every picture pass, as "flip = 1"; empty if some picture fails.
std::string limitsOfNothing(const image::Tolerance& tolerance) {
    constexpr double kAll = 255;
    constexpr int kMostPixels = 1'000'000;  // of a group: of pictures of a suite's usual size
    if ((tolerance.flip || tolerance.structure) && tolerance.flip.value_or(1) >= 1 &&
        tolerance.structure.value_or(1) >= 1)
        return !tolerance.flip        ? "structure = 1"
               : !tolerance.structure ? "flip = 1"
                                      : "flip = 1 with structure = 1";
    if (tolerance.bias < std::min(tolerance.largest, kAll)) return {};
    if (tolerance.largest >= kAll) return "max = 255 with this bias";
    const bool countsNone =
        tolerance.fraction >= 1 && tolerance.cluster >= kMostPixels && tolerance.line >= kMostPixels;
    return countsNone ? "fraction = 1 with these limits" : "";
}

/// Makes shots of templates.
class SuiteBuilder {
  public:
    SuiteBuilder(TomlReader& reader, Suite& suite) : reader_(reader), suite_(suite) {}

    void add(const TomlValue& value, const TomlTable& table, const fs::path& folder,
             const ShotTemplate& defaults) {
        const std::size_t errorsBefore = reader_.errorCount();
        ShotTemplate shot = defaults;
        shot.shot.place = reader_.placeOf(value);
        readTemplate(reader_, table, folder, false, shot);
        if (!hasKey(table, "script")) reader_.report("suite-E12", "the shot has no script", shot.shot.place);
        checkAgreement(shot);
        if (const std::string limits = limitsOfNothing(shot.shot.tolerance); !limits.empty())
            reader_.report(
                "suite-E33",
                fmt::format("tolerance: {} passes every picture, so the shot compares nothing", limits),
                shot.shot.place);
        dropSwept(shot, defaults);
        if (shot.scripts.empty()) return;
        const std::vector<FoundScript> scripts = findScripts(reader_, folder, shot);
        // Later messages about a wrong shot would only confuse.
        if (reader_.errorCount() > errorsBefore || !isFewEnough(shot, scripts.size())) return;
        if (scripts.size() == 1) nameOwnUniforms(shot, defaults);
        const std::vector<Combination> all = combinations(shot.sweeps);
        for (const FoundScript& script : scripts)
            for (const Combination& combination : all)
                for (const double time : shot.times) addOne(shot, script, combination, time);
    }

    void finish() {
        checkVariants();
        checkOtherDisks();
        resolvePairs(reader_, requests_, suite_);
    }

  private:
    /// A scene with an expected error makes no picture, and a warning alone is not an error.
    void checkAgreement(const ShotTemplate& shot) {
        if (!shot.shot.expectedError) return;
        const glib::CatalogueRow* row = glib::findDiagnostic(shot.shot.expectedError->id);
        if (row && row->severity() != Severity::error &&
            !(row->severity() == Severity::warning && shot.shot.options.strict))
            reader_.report(
                "suite-E12",
                fmt::format(
                    "expect-error: {} is a {}, which fails {}", row->id, name(row->severity()),
                    row->severity() == Severity::warning ? "a scene only with strict = true" : "no scene"),
                shot.shot.place);
        for (const auto* each : {&shot.match, &shot.differ})
            if (*each)
                reader_.report("suite-E12",
                               "a shot with expect-error makes no picture that could match or differ",
                               (*each)->place);
    }

    /// A uniform in a sweep is not in `set`: it is an error if the shot states both, and the sweep replaces a
    /// value of [defaults].
    void dropSwept(ShotTemplate& shot, const ShotTemplate& defaults) {
        for (const UniformValues& sweep : shot.sweeps) {
            const auto isIt = [&](const UniformValues& each) { return each.name == sweep.name; };
            const auto set = std::ranges::find_if(shot.set, isIt);
            if (set == shot.set.end()) continue;
            const auto old = std::ranges::find_if(defaults.set, isIt);
            if (old == defaults.set.end() || old->place != set->place)
                reader_.report("suite-E12", fmt::format("'{}' is in both set and sweep", sweep.name),
                               sweep.place);
            shot.set.erase(set);
        }
    }

    static void nameOwnUniforms(ShotTemplate& shot, const ShotTemplate& defaults) {
        const auto isOfDefaults = [&](const UniformValues& own) {
            return std::ranges::any_of(defaults.set, [&](const UniformValues& each) {
                return each.name == own.name && each.place == own.place;
            });
        };
        for (const auto* all : {&shot.set, &shot.sweeps})
            for (const UniformValues& each : *all)
                if (!isOfDefaults(each)) shot.shot.ownUniforms.push_back({each.name, each.place});
    }

    bool isFewEnough(const ShotTemplate& shot, std::size_t scripts) {
        const std::size_t left = kMostShots - suite_.shots.size();
        const std::uint64_t each = combinationCount(shot.sweeps);
        if (each <= left && each * shot.times.size() <= left && each * shot.times.size() * scripts <= left)
            return true;
        reader_.report(
            "suite-E11",
            fmt::format("{} scripts, {} sweep values and {} times are too many shots; a suite has at most {}",
                        scripts, each, shot.times.size(), base::groupedText(kMostShots)),
            shot.sweeps.empty() ? shot.shot.place : shot.sweeps.front().place);
        return false;
    }

    void addOne(const ShotTemplate& from, const FoundScript& script, const Combination& combination,
                double time) {
        std::string suffix = combination.suffix;
        if (from.namesTimes) suffix += "@time=" + glib::numberText(time);
        Shot shot = from.shot;
        shot.name = script.name + suffix;
        shot.script = script.path;
        shot.options.time = time;
        for (const UniformValues& each : from.set)
            shot.options.set.push_back(each.name + "=" + each.values.front().text);
        shot.options.set.insert(shot.options.set.end(), combination.set.begin(), combination.set.end());

        const Place place = from.name ? from.name->place : script.place;
        if (const auto [old, isNew] = byName_.emplace(shot.name, place); !isNew) {
            const std::string name = glib::inQuotes(shot.name);
            reader_.report("suite-E06",
                           old->second == place
                               ? fmt::format("this makes two shots {}", name)
                               : fmt::format("there are two shots {}; the other one is on line {}", name,
                                             old->second.line),
                           place);
            return;
        }
        const std::size_t index = suite_.shots.size();
        if (from.match) requests_.push_back({index, true, *from.match, suffix});
        if (from.differ) requests_.push_back({index, false, *from.differ, suffix});
        suite_.shots.push_back(std::move(shot));
    }

    /// The golden of a shot "teapot.nvidia" would be taken for the golden of the shot "teapot" for that
    /// driver.
    void checkVariants() {
        for (const Shot& shot : suite_.shots) {
            const auto other = byName_.find(std::string(shotOfVariant(shot.name)));
            if (other != byName_.end())
                reader_.report("suite-E06",
                               fmt::format("the golden of {} would be a variant of that of '{}' on line {}",
                                           glib::inQuotes(shot.name), other->first, other->second.line),
                               byName_.at(shot.name));
        }
    }

    /// A repository is checked out on other systems, too.
    void checkOtherDisks() {
        std::vector<std::string> names;
        for (const Shot& shot : suite_.shots) names.push_back(shot.name);
        for (const auto& [name, other] : sharedOnSomeDisk(names))
            reader_.report("suite-E23",
                           fmt::format("{}; the other one is on line {}", shareText(name, other),
                                       byName_.at(other).line),
                           byName_.at(name));
    }

    TomlReader& reader_;
    Suite& suite_;
    std::unordered_map<std::string, Place> byName_;
    std::vector<PairRequest> requests_;
};

/// suite-E04 for a text that is neither a folder nor an address of pictures.
void readStore(TomlReader& reader, const TomlValue& value, const fs::path& folder, Suite& suite) {
    const auto text = reader.text(value, "store");
    if (!text) return;
    if (const std::string why = whyNoStore(*text); !why.empty())
        reader.report("suite-E04", fmt::format("store: {}, found {}", why, glib::inQuotes(*text)), value);
    else
        suite.store = isAddress(*text) ? *text : (folder / *text).lexically_normal().generic_string();
}

/// Reads the top level of the file and returns the list of shots.
const TomlList* readTopLevel(TomlReader& reader, const TomlTable& root, const fs::path& folder, Suite& suite,
                             ShotTemplate& defaults) {
    static constexpr std::array<std::string_view, 4> kKeys{"goldens", "store", "defaults", "shot"};
    const TomlList* shots = nullptr;
    for (const TomlEntry& entry : root) {
        if (entry.key == "goldens") {
            const auto text = reader.text(entry.value, "goldens");
            if (text && isAddress(*text))
                reader.report(
                    "suite-E04",
                    fmt::format("goldens: expected a folder, found {}; 'store' takes the address of "
                                "their pictures",
                                glib::inQuotes(*text)),
                    entry.value);
            else if (text)
                suite.goldens = (folder / *text).lexically_normal();
        } else if (entry.key == "store") {
            readStore(reader, entry.value, folder, suite);
        } else if (entry.key == "defaults") {
            if (const TomlTable* table = reader.table(entry.value, "defaults"))
                readTemplate(reader, *table, folder, true, defaults);
        } else if (entry.key == "shot") {
            shots = entry.value.as<TomlList>();
            if (!shots) reader.wrongType(entry.value, "shot", "[[shot]]");
        } else if (isShotKey(entry.key)) {
            reader.report("suite-E02",
                          fmt::format("'{}' belongs under {}[[shot]]", entry.key,
                                      isDefaultsKey(entry.key) ? "[defaults] or " : ""),
                          entry.position);
        } else {
            reader.unknownKey(entry, "at the top of the file", kKeys);
        }
    }
    return shots;
}

Result<Suite> readFolder(const fs::path& folder) {
    Suite suite;
    suite.file = folder;
    std::error_code failed;
    const fs::path whole = fs::absolute(folder, failed).lexically_normal();
    suite.name = (whole.has_filename() ? whole : whole.parent_path()).filename().generic_string();
    suite.goldens = folder / "golden";

    const Place place{folder.generic_string(), 1, 1};
    const Result<std::vector<fs::path>> scenes = scenesBelow(folder);
    if (!scenes.diagnostics.empty()) return scenes.diagnostics;
    if (!scenes || scenes->size() > kMostShots)
        return diagnose("suite-E11",
                        fmt::format("the folder is too large for a suite; that has at most {} scenes",
                                    base::groupedText(kMostShots)),
                        place);
    if (scenes->empty()) return diagnose("suite-E14", "there is no .glib file in the folder", place);
    Diagnostics problems;
    const auto report = [&](const char* id, const std::string& text) {
        problems.push_back(diagnose(id, text, place));
    };
    std::unordered_map<std::string, std::string> byName;
    for (const fs::path& script : *scenes) {
        Shot shot;
        shot.name = nameOfScene(script.lexically_relative(folder).generic_string());
        shot.script = script;
        shot.place = place;
        const auto [old, isNew] = byName.emplace(shot.name, script.generic_string());
        const std::string why = whyNotAName(shot.name);
        if (!isNew)
            report("suite-E06", fmt::format("{} and {} would both be the shot '{}'; rename one",
                                            glib::inQuotes(old->second),
                                            glib::inQuotes(script.generic_string()), shot.name));
        else if (!why.empty())
            report("suite-E05", fmt::format("shot {} of {} {}", glib::inQuotes(shot.name),
                                            glib::inQuotes(script.generic_string()), why));
        else
            suite.shots.push_back(std::move(shot));
    }
    for (const Shot& shot : suite.shots)
        if (const auto other = byName.find(std::string(shotOfVariant(shot.name))); other != byName.end())
            report("suite-E06",
                   fmt::format("the golden of {} would be a variant of that of {}; rename one",
                               glib::inQuotes(shot.script.generic_string()), glib::inQuotes(other->second)));
    std::vector<std::string> names;
    for (const Shot& shot : suite.shots) names.push_back(shot.name);
    for (const auto& [name, other] : sharedOnSomeDisk(names)) report("suite-E23", shareText(name, other));
    if (hasError(problems)) return problems;
    return suite;
}

/// The most similar name of a file in the same folder, or empty.
std::string nearestFile(const fs::path& file) {
    const fs::path folder = file.parent_path();
    scene::FolderListings listings;
    const auto near = scene::nearestFiles(file.filename().generic_string(), std::span(&folder, 1), listings);
    return near.empty() ? "" : near.front();
}

}  // namespace

Result<Suite> readSuiteText(std::string_view text, const fs::path& file) {
    Suite suite;
    suite.file = file;
    suite.name = file.stem().generic_string();
    const fs::path folder = file.parent_path();
    suite.goldens = folder / "golden" / suite.name;

    TomlReader reader(file.generic_string(), text);
    const TomlTable* root = reader.root();
    if (!root) return reader.take();
    ShotTemplate defaults;
    const TomlList* shots = readTopLevel(reader, *root, folder, suite, defaults);
    SuiteBuilder builder(reader, suite);
    if (shots)
        for (const TomlValue& each : *shots) {
            if (const auto* table = each.as<TomlTable>())
                builder.add(each, *table, folder, defaults);
            else
                reader.wrongType(each, "shot", "a table under [[shot]]");
        }
    if ((!shots || shots->empty()) && !reader.hasErrors())
        reader.report("suite-E14", "the suite has no [[shot]]", Place{file.generic_string(), 1, 1});
    if (!reader.hasErrors()) builder.finish();
    if (reader.hasErrors()) return reader.take();
    return suite;
}

Result<Suite> readSuite(const fs::path& fileOrFolder) {
    const Place place{fileOrFolder.generic_string(), 1, 1};
    std::error_code failure;
    if (fs::is_directory(fileOrFolder, failure)) return readFolder(fileOrFolder);
    if (glib::sameWord(fileOrFolder.extension().generic_string(), ".glib"))
        return diagnose("suite-E13", "this is a scene; a suite is a .toml file or a folder of scenes", place);
    auto bytes = image::readFile(fileOrFolder, {fileOrFolder.generic_string(), place}, kLargestSuiteFile);
    if (!bytes) {
        if (const std::string near = nearestFile(fileOrFolder);
            !near.empty() && !fs::exists(fileOrFolder, failure))
            bytes.diagnostics.front().text += fmt::format("; nearest: '{}'", near);
        return bytes.diagnostics;
    }
    return readSuiteText(base::asText(*bytes), fileOrFolder);
}

}  // namespace glibra::suite
