#include "suite/file/suite_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <span>
#include <string>
#include <string_view>
#include <system_error>
#include <unordered_map>
#include <utility>
#include <vector>

#include "base/files.h"
#include "base/text.h"
#include "glib/diagnostic_catalogue.h"
#include "glib/number.h"
#include "glib/text.h"
#include "image/file.h"
#include "scene/file_lookup.h"
#include "scene/folder_listings.h"
#include "suite/file/glob.h"
#include "suite/file/pairs.h"
#include "suite/file/scripts.h"
#include "suite/file/shot_keys.h"
#include "suite/file/shot_name.h"
#include "suite/file/shot_template.h"
#include "suite/file/sweep.h"
#include "suite/file/toml_reader.h"

namespace glibra::suite {
namespace {

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

/// Reads the top level of the file and returns the list of shots.
const TomlList* readTopLevel(TomlReader& reader, const TomlTable& root, const fs::path& folder, Suite& suite,
                             ShotTemplate& defaults) {
    static constexpr std::array<std::string_view, 3> kKeys{"goldens", "defaults", "shot"};
    const TomlList* shots = nullptr;
    for (const TomlEntry& entry : root) {
        if (entry.key == "goldens") {
            if (const auto text = reader.text(entry.value, "goldens"))
                suite.goldens = (folder / *text).lexically_normal();
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
    suite.name = (whole.has_filename() ? whole : whole.parent_path()).filename().string();
    suite.goldens = folder / "golden";

    const Place place{folder.string(), 1, 1};
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
        const auto [old, isNew] = byName.emplace(shot.name, script.string());
        const std::string why = whyNotAName(shot.name);
        if (!isNew)
            report("suite-E06",
                   fmt::format("{} and {} would both be the shot '{}'; rename one",
                               glib::inQuotes(old->second), glib::inQuotes(script.string()), shot.name));
        else if (!why.empty())
            report("suite-E05", fmt::format("shot {} of {} {}", glib::inQuotes(shot.name),
                                            glib::inQuotes(script.string()), why));
        else
            suite.shots.push_back(std::move(shot));
    }
    for (const Shot& shot : suite.shots)
        if (const auto other = byName.find(std::string(shotOfVariant(shot.name))); other != byName.end())
            report("suite-E06",
                   fmt::format("the golden of {} would be a variant of that of {}; rename one",
                               glib::inQuotes(shot.script.string()), glib::inQuotes(other->second)));
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
    const auto near = scene::nearestFiles(file.filename().string(), std::span(&folder, 1), listings);
    return near.empty() ? "" : near.front();
}

}  // namespace

Result<Suite> readSuiteText(std::string_view text, const fs::path& file) {
    Suite suite;
    suite.file = file;
    suite.name = file.stem().string();
    const fs::path folder = file.parent_path();
    suite.goldens = folder / "golden" / suite.name;

    TomlReader reader(file.string(), text);
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
        reader.report("suite-E14", "the suite has no [[shot]]", Place{file.string(), 1, 1});
    if (!reader.hasErrors()) builder.finish();
    if (reader.hasErrors()) return reader.take();
    return suite;
}

Result<Suite> readSuite(const fs::path& fileOrFolder) {
    const Place place{fileOrFolder.string(), 1, 1};
    std::error_code failure;
    if (fs::is_directory(fileOrFolder, failure)) return readFolder(fileOrFolder);
    if (glib::sameWord(fileOrFolder.extension().string(), ".glib"))
        return diagnose("suite-E13", "this is a scene; a suite is a .toml file or a folder of scenes", place);
    auto bytes = image::readFile(fileOrFolder, {fileOrFolder.string(), place}, kLargestSuiteFile);
    if (!bytes) {
        if (const std::string near = nearestFile(fileOrFolder);
            !near.empty() && !fs::exists(fileOrFolder, failure))
            bytes.diagnostics.front().text += fmt::format("; nearest: '{}'", near);
        return bytes.diagnostics;
    }
    return readSuiteText(base::asText(*bytes), fileOrFolder);
}

}  // namespace glibra::suite
