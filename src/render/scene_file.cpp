#include "render/scene_file.h"

#include <utility>

#include "glib/limits.h"
#include "glib/text.h"
#include "image/file.h"

namespace glibra::render {
namespace {

/// The scene's text. Errors have the ids glib-E14 and glib-E15 in place of those for files that a scene
/// names.
Result<std::string> readScene(const std::filesystem::path& path) {
    const Place place{path.generic_string(), 1, 1};
    std::error_code failure;
    // Windows: the C++ library takes "\\server\share" for the folder "\server\share" of the current drive.
    if (path.has_root_directory() && !path.is_absolute() &&
        !std::filesystem::exists(std::filesystem::absolute(path, failure), failure))
        return diagnose("glib-E14",
                        "cannot read the scene: its path must begin with a drive, which "
                        "'net use S: \\\\server\\share' gives to a folder of another machine",
                        place);
    // Messages about a scene quote it. A folder of scenes may come from somebody else, with a link to a file
    // that is none.
    const auto isNamedAsScene = [](const std::filesystem::path& file) {
        return glib::sameWord(file.extension().generic_string(), ".glib");
    };
    if (isNamedAsScene(path) && std::filesystem::is_symlink(path, failure) &&
        !isNamedAsScene(std::filesystem::canonical(path, failure)) && !failure)
        return diagnose("glib-E14",
                        "cannot read the scene: it is a link to a file whose name does not end with '.glib'",
                        place);
    // An empty scene is valid, unlike every other empty file.
    if (std::filesystem::is_regular_file(path, failure) && std::filesystem::is_empty(path, failure))
        return std::string();
    const auto bytes = image::readFile(path, {path.generic_string(), place}, glib::kLargestFile);
    if (bytes) return std::string(reinterpret_cast<const char*>(bytes->data()), bytes->size());
    const Diagnostic& why = bytes.diagnostics.front();
    return diagnose(why.id == "file-E09" ? "glib-E15" : "glib-E14", "cannot read the scene: " + why.text,
                    place);
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
        script = glib::parse(*text, path.generic_string());
    }
    const StageTimer timer(stats, "interpret");
    Diagnostics diagnostics = std::move(script.diagnostics);
    script.diagnostics.clear();
    InterpretedScene result;
    result.inputs.width = options.width;
    result.inputs.height = options.height;
    for (const std::string& each : options.set)
        if (Result<plan::Override> given = plan::parseOverride(each); given && given->program.empty()) {
            result.inputs.words.erase(given->name);
            if (given->word.empty())
                result.inputs.variables[given->name] = std::move(given->values);
            else
                result.inputs.words[given->name] = std::move(given->word);
        }
    auto source = std::make_shared<scene::Interpretation>(
        std::move(script), scene::InterpretOptions{options.libraryRoots, options.within, inMemory});
    result.scene = source->at(result.inputs);
    if (!source->isFixed()) result.source = std::move(source);
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

}  // namespace glibra::render
