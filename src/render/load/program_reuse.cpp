// The programs and translations that a ProgramLibrary takes from other libraries: from its predecessor when a
// scene is read again, and from those of other scenes.

#include <fmt/format.h>

#include <algorithm>

#include "glsl/emit/emit.h"
#include "glsl/es/es.h"
#include "glsl/translate.h"
#include "plan/overrides.h"
#include "render/load/programs.h"

namespace glibra::render {
namespace {

/// Everything that decides a translation, except what the translator asks for: included files and kinds of
/// textures. It takes the request apart by all of its members, so that one more does not compile until it
/// stands here.
std::string requestKeyOf(const glsl::ProgramRequest& asked) {
    const auto& [name, place, stages, constants, constantPlaces, include, target, shim, hasLights, setsLights,
                 suppliesFragment, suppliesFixedVertex, acceptsStorage, suppliesFullScreenVertex, flatColors,
                 colorTargets, tiled, inPieces, checksUndefined, recordsLoops, reversesOrder, geometryInput,
                 geometryOutput, geometryVerticesOut, draws, suppliesMatrices, reportsGeometryConflicts,
                 samplerKindsOfTag] = asked;
    static_cast<void>(constantPlaces);  // their lines may move without another program
    static_cast<void>(target);          // that of the context, which owns what is shared
    std::string key =
        fmt::format("{}\n{}:{}:{} {} {} {} {} {} ", name, place.file, place.line, place.column, colorTargets,
                    geometryInput, geometryOutput, geometryVerticesOut, draws.patchVertices);
    for (const bool each : {shim,
                            hasLights,
                            setsLights,
                            suppliesFragment,
                            suppliesFixedVertex,
                            acceptsStorage,
                            suppliesFullScreenVertex,
                            flatColors,
                            tiled,
                            inPieces,
                            checksUndefined,
                            recordsLoops,
                            reversesOrder,
                            suppliesMatrices,
                            reportsGeometryConflicts,
                            draws.areStrips,
                            draws.haveIndexBuffers,
                            draws.haveInstanceData,
                            draws.haveBufferData,
                            draws.haveWideLines})
        key += each ? '1' : '0';
    key += '\n';
    for (const glsl::Constant& each : constants)
        key += fmt::format("{} {} {}\n", each.type, each.name, glsl::valueText(each));
    for (const auto& [stage, path, text] : stages)
        key += fmt::format("{} {}\n", static_cast<int>(stage), path) + text + '\0';
    return key;
}

}  // namespace

ProgramLibrary::~ProgramLibrary() {
    if (!shared_ || options_.checkUndefined) return;
    for (auto& [variant, built] : programs_)
        if (built->program && !built->key.empty() && !built->isLastGood && built->initialValues.empty())
            shared_->programs.add(built->key,
                                  SharedProgram{std::move(*built->program), std::move(built->interface),
                                                std::move(built->remarks)},
                                  1);
}

bool ProgramLibrary::borrow(const plan::ProgramVariant& variant, BuiltProgram& built) {
    std::optional<SharedProgram> earlier =
        shared_ && !options_.checkUndefined ? shared_->programs.take(built.key) : std::nullopt;
    if (!earlier) return false;
    built.program.emplace(std::move(earlier->program));
    static_cast<base::ActiveResources&>(built.interface) = std::move(earlier->resources);
    built.remarks = std::move(earlier->remarks);
    stats_.add("programs kept", 1);
    const bool isBuiltin = !variant.program;
    const scene::Program* program = isBuiltin ? nullptr : &scene_.programs[variant.program];
    stats_.skip("program", fmt::format("'{}': already linked", isBuiltin ? "built-in" : program->name),
                isBuiltin ? Place{scene_.path, 1, 1} : program->place);
    return true;
}

const ProgramLibrary::Translation& ProgramLibrary::translationOf(const plan::ProgramVariant& variant) {
    for (const auto& [known, translation] : translations_)
        if (known == variant) return *translation;
    translations_.emplace_back(variant, std::make_unique<Translation>());
    Translation& translation = *translations_.back().second;
    const StageTimer timer(stats_, "translate");
    glsl::ProgramRequest asked = request(variant, translation.diagnostics);
    if (!hasError(translation.diagnostics)) translation.program = translate(std::move(asked));
    return translation;
}

/// True if a texture or sampler of the scene has a border.
static bool hasBorders(const scene::Scene& scene) {
    const auto has = [](const base::SamplerState& state) {
        return std::ranges::find(state.wrap, base::Wrap::clampToBorder) != state.wrap.end();
    };
    return std::ranges::any_of(scene.textures, [&](const auto& each) { return has(each.sampler); }) ||
           std::ranges::any_of(scene.samplers, [&](const auto& each) { return has(each.state); });
}

glsl::TranslatedProgram ProgramLibrary::translationFor(const glsl::ProgramRequest& asked) const {
    glsl::TranslatedProgram program = glsl::translate(asked);
    if (!context_.capabilities().isEs || hasError(program.diagnostics)) return program;
    glsl::EsProgram es = glsl::toEs(program, {.hasBorders = hasBorders(scene_), .draws = asked.draws});
    program.stages = std::move(es.stages);
    program.initialValues = std::move(es.initialValues);
    program.expanded = es.expanded;
    program.userNames.merge(es.userNames);
    program.wideLines = std::move(es.wideLines);
    program.loopSites = std::move(es.loopSites);
    append(program.diagnostics, std::move(es.diagnostics));
    return program;
}

std::shared_ptr<const glsl::TranslatedProgram> ProgramLibrary::translate(glsl::ProgramRequest asked) {
    if (!shared_) return std::make_shared<const glsl::TranslatedProgram>(translationFor(asked));
    const std::string key = requestKeyOf(asked);
    if (const auto known = shared_->translations.find(key)) {
        stats_.add("translations kept", 1);
        return *known;
    }
    bool asksMore = false;
    if (asked.include)
        asked.include = [&asksMore, include = std::move(asked.include)](std::string_view name,
                                                                        std::string_view from) {
            asksMore = true;
            return include(name, from);
        };
    if (asked.samplerKindsOfTag)
        asked.samplerKindsOfTag = [&asksMore,
                                   kinds = std::move(asked.samplerKindsOfTag)](std::string_view tag) {
            asksMore = true;
            return kinds(tag);
        };
    auto translated = std::make_shared<const glsl::TranslatedProgram>(translationFor(asked));
    std::size_t size = key.size();
    for (const glsl::TranslatedStage& each : translated->stages) size += each.source.size();
    if (!asksMore) shared_->translations.add(key, translated, size);
    return translated;
}

glsl::Placement ProgramLibrary::placementOf(const plan::ProgramVariant& variant) {
    const Translation& translation = translationOf(variant);
    return translation.program && !hasError(translation.program->diagnostics)
               ? translation.program->knownPlacement()
               : glsl::Placement::unknown;
}

bool ProgramLibrary::mayReadTangents(const plan::ProgramVariant& variant) {
    const Translation& translation = translationOf(variant);
    return !translation.program || translation.program->mayReadTangents;
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
    if (scene_.suppliesNames) key += "with initial values\n";
    // A value that was set stays in the program. A uniform that loses its tag must get its initial value
    // back.
    if (variant.program) {
        std::vector<std::string> tags;
        for (const glib::UniformSpec& each : scene_.programs[variant.program].uniforms)
            tags.push_back(
                fmt::format("{} {} {}", each.tag, static_cast<int>(each.form), each.values.size()));
        for (const std::string& each : options_.set)
            if (const Result<plan::Override> given = plan::parseOverride(each))
                tags.push_back(fmt::format("{}:{} {} {}", given->program, given->name,
                                           static_cast<int>(given->form), given->values.size()));
        std::ranges::sort(tags);
        for (const std::string& each : tags) key += each + '\n';
    }
    return key;
}

std::pair<int, std::string> ProgramLibrary::identityOf(const plan::ProgramVariant& variant) const {
    if (!variant.program) return {};
    const std::string& name = scene_.programs[variant.program].name;
    const auto end = scene_.programs.begin() + static_cast<std::ptrdiff_t>(variant.program.position());
    const auto before = std::count_if(scene_.programs.begin(), end,
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
        if (built->program && !known.program == !variant.program && known.flatColors == variant.flatColors &&
            known.colorTargets == variant.colorTargets && known.inPieces == variant.inPieces &&
            previous_->identityOf(known) == identityOf(variant))
            return built.get();
    return nullptr;
}

}  // namespace glibra::render
