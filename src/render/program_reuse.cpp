// What a ProgramLibrary keeps of the one before it, when a scene is read again.

#include <fmt/format.h>

#include <algorithm>

#include "render/programs.h"

namespace glibra::render {

std::vector<std::filesystem::path> ProgramLibrary::filesRead() const {
    std::vector<std::filesystem::path> files(included_.begin(), included_.end());
    for (const auto& [file, source] : sources_)
        if (!source.path.empty()) files.emplace_back(source.path);
    return files;
}

std::vector<glsl::EmittedLine> ProgramLibrary::refusedLines(const Place& place) const {
    for (const auto& [variant, built] : programs_)
        for (const glsl::TranslatedStage& stage : built->refused)
            if (auto lines = glsl::emittedLines(stage, place); !lines.empty()) return lines;
    return {};
}

std::string ProgramLibrary::keyOf(const plan::ProgramVariant& variant,
                                  const glsl::TranslatedProgram& translated) const {
    std::string key;
    for (const glsl::TranslatedStage& each : translated.stages)
        key += fmt::format("{} {}\n", static_cast<int>(each.stage), each.path) + each.source + '\0';
    // A value that was set once stays in the program: one that loses a tag must get its initial value back.
    if (variant.program != scene::kNone) {
        std::vector<std::string> tags;
        for (const glib::UniformSpec& each :
             scene_.programs[static_cast<std::size_t>(variant.program)].uniforms)
            tags.push_back(fmt::format("{} {}", each.tag, each.values.size()));
        std::sort(tags.begin(), tags.end());
        for (const std::string& each : tags) key += each + '\n';
    }
    return key;
}

std::pair<int, std::string> ProgramLibrary::identityOf(const plan::ProgramVariant& variant) const {
    if (variant.program == scene::kNone) return {};
    const std::string& name = scene_.programs[static_cast<std::size_t>(variant.program)].name;
    const auto before = std::count_if(scene_.programs.begin(), scene_.programs.begin() + variant.program,
                                      [&](const scene::Program& each) { return each.name == name; });
    return {static_cast<int>(before), name};
}

BuiltProgram* ProgramLibrary::earlierByKey(const std::string& key) {
    if (!previous_) return nullptr;
    for (const auto& [variant, built] : previous_->programs_)
        if (built->program && built->key == key) return built.get();
    return nullptr;
}

BuiltProgram* ProgramLibrary::lastGoodOf(const plan::ProgramVariant& variant) {
    if (!previous_) return nullptr;
    for (const auto& [known, built] : previous_->programs_)
        if (built->program && (known.program == scene::kNone) == (variant.program == scene::kNone) &&
            known.flatColors == variant.flatColors && known.colorTargets == variant.colorTargets &&
            previous_->identityOf(known) == identityOf(variant))
            return built.get();
    return nullptr;
}

}  // namespace glibra::render
