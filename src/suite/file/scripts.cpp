#include "suite/file/shot_keys.h"

#include <fmt/format.h>

#include <set>
#include <system_error>

#include "base/suggest.h"
#include "base/text.h"
#include "glib/text.h"
#include "scene/file_lookup.h"
#include "suite/file/selection.h"
#include "suite/file/shot_name.h"

namespace glibra::suite {
namespace {

namespace fs = std::filesystem;

/// Shortens "scenes/../glib/a.glib" to "glib/a.glib", unless `scenes` is a link to another place.
fs::path shortened(const fs::path& path) {
    const fs::path shorter = path.lexically_normal();
    std::error_code failure;
    return fs::equivalent(path, shorter, failure) && !failure ? shorter : path;
}

class ScriptFinder {
  public:
    ScriptFinder(TomlReader& reader, const fs::path& folder, const ShotTemplate& shot)
        : reader_(reader), folder_(folder), shot_(shot) {}

    std::vector<FoundScript> find() {
        for (const PlacedText& each : shot_.exceptions) exclude(each);
        for (const PlacedText& each : shot_.scripts) {
            if (isFile(folder_ / each.text) && !isScene(folder_ / each.text))
                reader_.report("suite-E10",
                               fmt::format("script: {} is not a scene; the name of a scene ends with '.glib'",
                                           glib::inQuotes((folder_ / each.text).generic_string())),
                               each.place);
            else if (isFile(folder_ / each.text))
                add(folder_ / each.text, fs::path(each.text).filename().generic_string(), shot_.isList,
                    each.place);
            else if (isPattern(each.text))
                addFitting(each);
            else
                missing(each);
        }
        if (found_.empty() && !excluded_.empty() && !reader_.hasErrors())
            reader_.report("suite-E09", "script: 'except' excludes every file", shot_.scripts.front().place);
        return std::move(found_);
    }

  private:
    static bool isFile(const fs::path& path) {
        std::error_code failure;
        return fs::is_regular_file(path, failure);
    }

    /// Messages about a scene quote it, so that a suite may name only files that are scenes by their names.
    static bool isScene(const fs::path& path) {
        return glib::sameWord(path.extension().generic_string(), ".glib");
    }

    /// The files that match a pattern, or nothing if it was reported that there are none.
    std::vector<fs::path> fitting(std::string_view key, const PlacedText& pattern) {
        Result<std::vector<fs::path>> files = filesThatFit(folder_, pattern.text);
        // "a/**" matches pictures and shaders too.
        if (files && key == "script")
            std::erase_if(*files, [](const fs::path& each) { return !isScene(each); });
        if (!files && !files.diagnostics.empty()) {
            for (const Diagnostic& each : files.diagnostics)
                reader_.report("suite-E22", fmt::format("{}: {}", key, each.text), pattern.place);
        } else if (!files) {
            reader_.report(
                "suite-E11",
                fmt::format("{}: {} has too much to search; the limits are {} files and {} folders "
                            "below each other",
                            key, glib::inQuotes(pattern.text),
                            base::groupedText(static_cast<long long>(kMostSearched)), kDeepestSearch),
                pattern.place);
        } else if (files->empty()) {
            fitsNothing(key, pattern);
        }
        return files ? *files : std::vector<fs::path>();
    }

    void fitsNothing(std::string_view key, const PlacedText& pattern) {
        std::string text = fmt::format("{}: no file matches {}", key, glib::inQuotes(pattern.text));
        if (const std::string why = whyNoFolder(folder_ / fixedFolder(pattern.text)); !why.empty())
            text += "; " + why;
        else if (const std::string near = nearEnding(pattern.text); !near.empty())
            text += fmt::format("; did you mean '{}'?", near);
        reader_.report("suite-E09", text, pattern.place);
    }

    /// The pattern with the most similar ending that matches a file, or empty.
    std::string nearEnding(const std::string& pattern) {
        const std::string ending = fs::path(pattern).extension().generic_string();
        if (ending.empty() || isPattern(ending)) return {};
        const std::string stem = pattern.substr(0, pattern.size() - ending.size());
        const Result<std::vector<fs::path>> files = filesThatFit(folder_, stem + ".*");
        if (!files) return {};
        std::set<std::string> endings;
        for (const fs::path& each : *files) endings.insert(each.extension().generic_string());
        const std::vector<std::string_view> names(endings.begin(), endings.end());
        const std::string near = base::nearestName(ending, names);
        return near.empty() ? "" : stem + near;
    }

    void exclude(const PlacedText& pattern) {
        for (const fs::path& each : fitting("except", pattern)) excluded_.insert(each.lexically_normal());
    }

    void addFitting(const PlacedText& pattern) {
        const std::vector<fs::path> files = fitting("script", pattern);
        const fs::path fixed = folder_ / fixedFolder(pattern.text);
        for (const fs::path& each : files)
            add(each, each.lexically_relative(fixed).generic_string(), true, pattern.place);
    }

    void add(const fs::path& path, const std::string& relative, bool isOneOfSeveral, const Place& place) {
        if (excluded_.contains(path.lexically_normal())) return;
        const fs::path script = shortened(path);
        if (!seen_.insert(script).second) return;
        std::string name = shot_.name ? shot_.name->text : std::string();
        if (isOneOfSeveral && shot_.name) name += '/';
        if (isOneOfSeveral || !shot_.name) name += nameOfScene(relative);
        if (const std::string why = whyNotAName(name); !why.empty())
            reader_.report("suite-E05",
                           fmt::format("shot {} of {} {}", glib::inQuotes(name),
                                       glib::inQuotes(script.generic_string()), why),
                           place);
        else
            found_.push_back({script, std::move(name), place});
    }

    void missing(const PlacedText& script) {
        const fs::path path = (folder_ / script.text).lexically_normal();
        std::error_code failure;
        std::string hint;
        if (fs::is_directory(path, failure)) {
            hint = fmt::format("; it is a folder, write \"{}/*.glib\"", script.text);
        } else {
            const fs::path parent = path.parent_path();
            const auto near =
                scene::nearestFiles(path.filename().generic_string(), std::span(&parent, 1), listings_);
            const std::string withEnding = path.filename().generic_string() + ".glib";
            if (isFile(parent / withEnding))
                hint = fmt::format("; did you mean '{}'?", withEnding);
            else if (!near.empty())
                hint = fmt::format("; did you mean '{}'?", near.front());
            else if (script.text.find('\\') != std::string::npos)
                hint = "; folders are separated by '/'";
            else if (const std::string why = whyNoFolder(parent); !why.empty())
                hint = "; " + why;
        }
        reader_.report("suite-E10",
                       fmt::format("script: cannot find {}{}", glib::inQuotes(path.generic_string()), hint),
                       script.place);
    }

    TomlReader& reader_;
    const fs::path& folder_;
    const ShotTemplate& shot_;
    scene::FolderListings listings_;
    std::set<fs::path> excluded_, seen_;
    std::vector<FoundScript> found_;
};

}  // namespace

std::vector<FoundScript> findScripts(TomlReader& reader, const fs::path& folder, const ShotTemplate& shot) {
    return ScriptFinder(reader, folder, shot).find();
}

}  // namespace glibra::suite
