// Reads a scene file into a Scene, and merges its diagnostics.

#include <algorithm>
#include <array>
#include <set>
#include <span>
#include <string_view>
#include <tuple>
#include <utility>

#include "glib/limits.h"
#include "glib/text.h"
#include "image/file.h"
#include "plan/overrides.h"
#include "render/scene_renderer.h"
#include "scene/interpret.h"

namespace glibra::render {
namespace {

/// The scene's text. Errors have the ids glib-E14 and glib-E15 in place of those for files that a scene
/// names.
Result<std::string> readScene(const std::filesystem::path& path) {
    const Place place{path.string(), 1, 1};
    std::error_code failure;
    // Messages about a scene quote it. A folder of scenes may come from somebody else, with a link to a file
    // that is none.
    const auto isNamedAsScene = [](const std::filesystem::path& file) {
        return glib::sameWord(file.extension().string(), ".glib");
    };
    if (isNamedAsScene(path) && std::filesystem::is_symlink(path, failure) &&
        !isNamedAsScene(std::filesystem::canonical(path, failure)) && !failure)
        return diagnose("glib-E14",
                        "cannot read the scene: it is a link to a file whose name does not end with '.glib'",
                        place);
    // An empty scene is valid, unlike every other empty file.
    if (std::filesystem::is_regular_file(path, failure) && std::filesystem::is_empty(path, failure))
        return std::string();
    const auto bytes = image::readFile(path, {path.string(), place}, glib::kLargestFile);
    if (bytes) return std::string(reinterpret_cast<const char*>(bytes->data()), bytes->size());
    const Diagnostic& why = bytes.diagnostics.front();
    return diagnose(why.id == "file-E09" ? "glib-E15" : "glib-E14", "cannot read the scene: " + why.text,
                    place);
}

bool hasId(const Diagnostics& diagnostics, std::string_view id) {
    return std::any_of(diagnostics.begin(), diagnostics.end(),
                       [&](const Diagnostic& each) { return each.id == id; });
}

/// Removes what only follows from another mistake.
void removeConsequences(Diagnostics& diagnostics) {
    const auto removeWarnings = [&](std::span<const std::string_view> ids) {
        std::erase_if(diagnostics, [&](const Diagnostic& each) {
            return each.severity != Severity::error &&
                   std::find(ids.begin(), ids.end(), each.id) != ids.end();
        });
    };
    // A sampler that is not set reads unit 0; that this unit is empty, too, is no second mistake.
    std::set<std::string> unset;
    for (const Diagnostic& each : diagnostics)
        if (each.id == "glib-W37" && !each.subject.empty()) unset.insert(each.subject);
    std::erase_if(diagnostics, [&](const Diagnostic& each) {
        return each.id == "draw-W02" && unset.contains(each.subject);
    });
    // A compiler removes what is computed from an input that no stage writes.
    const bool hasMisspeltInput =
        std::any_of(diagnostics.begin(), diagnostics.end(),
                    [](const Diagnostic& each) { return each.id == "glsl-W11" && !each.suggestion.empty(); });
    if (hasMisspeltInput) removeWarnings(std::array<std::string_view, 1>{"glib-W24"});
    if (!hasError(diagnostics)) return;
    // What nothing writes may be the work of a program that does not compile, or of a dispatch that the
    // driver cannot do.
    removeWarnings(std::array<std::string_view, 2>{"draw-W11", "draw-W13"});
    if (hasId(diagnostics, "memory-E03")) removeWarnings(std::array<std::string_view, 1>{"memory-W05"});
    const auto isOfScript = [](const Diagnostic& each) {
        return each.id.starts_with("glib-E") || each.id.starts_with("expr-E") ||
               each.id.starts_with("file-E");
    };
    if (std::none_of(diagnostics.begin(), diagnostics.end(), isOfScript)) return;
    // What the scene lacks is often what a faulty statement would have given.
    removeWarnings(std::array<std::string_view, 8>{"glib-W23", "glib-W37", "glib-W38", "glib-W39", "draw-N04",
                                                   "draw-W01", "draw-W02", "draw-W16"});
    std::erase_if(diagnostics, [](const Diagnostic& each) { return each.id == "memory-E02"; });
    // Commas of an expression without parentheses.
    std::set<std::pair<std::string, int>> faultyLines;
    for (const Diagnostic& each : diagnostics)
        if (isOfScript(each)) faultyLines.emplace(each.place.file, each.place.line);
    std::erase_if(diagnostics, [&](const Diagnostic& each) {
        return each.id == "glib-W03" && faultyLines.contains({each.place.file, each.place.line});
    });
}

/// The parser and the plan may both report a mistake. The first of equal ids at one place is kept.
void removeRepeats(Diagnostics& diagnostics) {
    std::set<std::tuple<std::string, std::string, int, int, std::string>> seen;
    std::erase_if(diagnostics, [&](const Diagnostic& each) {
        const bool byPlace = each.id == "glib-W15" && !each.place.file.empty();
        return !seen.emplace(each.id, each.place.file, each.place.line, each.place.column,
                             byPlace ? "" : each.text)
                    .second;
    });
}

/// glib-W15 for each value of a variable that does not have its number of components and is therefore
/// ignored.
Diagnostics reportMisfits(const InterpretedScene& scene) {
    Diagnostics problems;
    for (const auto& [name, values] : scene.inputs.variables) {
        const auto known = scene.scene.usedVariables.find(name);
        if (known == scene.scene.usedVariables.end() || known->second == values.size()) continue;
        problems.push_back(plan::misfit(name, values, known->second));
    }
    return problems;
}

}  // namespace

bool InterpretedScene::changesWithTime() const {
    using expression::Depends;
    return source && any(source->depends() & (Depends::time | Depends::frame | Depends::tick));
}

Result<InterpretedScene> interpretFile(const std::filesystem::path& path, const RenderOptions& options,
                                       Stats& stats) {
    stats.add("files read", 1);
    const scene::MemoryFiles inMemory = scene::memoryFiles(options.texts, options.reader);
    const auto content =
        inMemory && !options.sceneText ? inMemory(path) : std::shared_ptr<const std::string>();
    Result<std::string> text = options.sceneText ? Result<std::string>(*options.sceneText)
                               : content         ? Result<std::string>(*content)
                                                 : readScene(path);
    if (!text) return std::move(text.diagnostics);
    glib::Script script;
    {
        const StageTimer timer(stats, "parse");
        script = glib::parse(*text, path.string());
    }
    const StageTimer timer(stats, "interpret");
    Diagnostics diagnostics = std::move(script.diagnostics);
    script.diagnostics.clear();
    InterpretedScene result;
    result.inputs.width = options.width;
    result.inputs.height = options.height;
    if (script.isModern)
        for (const std::string& each : options.set)
            if (Result<plan::Override> given = plan::parseOverride(each); given && given->program.empty()) {
                result.inputs.words.erase(given->name);
                if (given->word.empty())
                    result.inputs.variables[given->name] = std::move(given->values);
                else
                    result.inputs.words[given->name] = std::move(given->word);
            }
    const bool isModern = script.isModern;
    auto source = std::make_shared<scene::Interpretation>(
        std::move(script), scene::InterpretOptions{options.libraryRoots, options.within, inMemory});
    result.scene = source->at(result.inputs);
    if (isModern) result.source = std::move(source);
    append(diagnostics, std::move(result.scene.diagnostics));
    result.scene.diagnostics.clear();
    append(diagnostics, reportMisfits(result));
    return {std::move(result), std::move(diagnostics)};
}

Result<std::vector<plan::Override>> parseOverrides(const std::vector<std::string>& set) {
    Result<std::vector<plan::Override>> overrides{std::vector<plan::Override>{}};
    for (const std::string& each : set) {
        Result<plan::Override> parsed = plan::parseOverride(each);
        append(overrides.diagnostics, std::move(parsed.diagnostics));
        if (parsed) overrides->push_back(std::move(*parsed));
    }
    if (hasError(overrides.diagnostics)) overrides.value.reset();
    return overrides;
}

void applyStrict(Diagnostics& diagnostics, bool strict) {
    removeRepeats(diagnostics);
    removeConsequences(diagnostics);
    // A driver without compute shaders is reported where the scene needs one, not for each of its programs
    // too.
    const auto has = [](std::string_view id) {
        return [id](const Diagnostic& each) { return each.id == id; };
    };
    if (std::any_of(diagnostics.begin(), diagnostics.end(), has("memory-E01")))
        std::erase_if(diagnostics, has("glsl-E12"));
    if (!strict) return;
    for (Diagnostic& each : diagnostics)
        if (each.severity == Severity::warning) each.severity = Severity::error;
}

}  // namespace glibra::render
