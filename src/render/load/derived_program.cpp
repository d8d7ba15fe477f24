#include "render/load/derived_program.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>

#include "base/text.h"
#include "glsl/translate.h"
#include "gpu/object/uniform.h"
#include "render/load/gl_names.h"

namespace glibra::render {

std::vector<gpu::NamedLocation> inputLocations(const BuiltProgram& of) {
    std::vector<gpu::NamedLocation> locations;
    for (const base::ActiveInput& each : of.interface.inputs)
        if (each.location >= 0) locations.push_back({each.name, static_cast<GLuint>(each.location)});
    return locations;
}

std::optional<gpu::Program> capturingProgram(const gpu::Capabilities& capabilities, const BuiltProgram& of,
                                             const std::vector<glsl::TranslatedStage>& stages,
                                             std::vector<std::string> captured) {
    std::vector<gpu::StageSource> sources;
    for (const glsl::TranslatedStage& each : stages) sources.push_back({glStage(each.stage), each.source});
    return gpu::buildProgram(capabilities, {.stages = sources,
                                            .vertexInputs = inputLocations(of),
                                            .fragmentOutputs = {},
                                            .captured = std::move(captured)})
        .program;
}

void copyUniforms(const BuiltProgram& from, const gpu::Program& program,
                  const base::ActiveResources& reflected) {
    for (const base::ActiveUniform& to : reflected.uniforms)
        for (const base::ActiveUniform& each : from.interface.uniforms) {
            if (each.emittedName != to.emittedName || each.block >= 0 || to.block >= 0) continue;
            for (int element = 0; element < std::min(each.arraySize, to.arraySize); ++element)
                gpu::setUniform(program, to, gpu::getUniform(*from.program, each, element), element);
        }
    for (const base::UniformBlock& to : reflected.blocks)
        for (std::size_t i = 0; i < from.interface.blocks.size(); ++i)
            if (from.interface.blocks[i].name == to.name)
                glUniformBlockBinding(program.id(), to.index, static_cast<GLuint>(i));
    for (const base::StorageBlock& to : reflected.storageBlocks)
        for (std::size_t i = 0; i < from.interface.storageBlocks.size(); ++i)
            if (from.interface.storageBlocks[i].name == to.name)
                glShaderStorageBlockBinding(program.id(), to.index, static_cast<GLuint>(i));
}

// What programs record while they run: what GLSL leaves undefined (RenderOptions::checkUndefined), and the
// loops that the driver ends.

namespace {

/// `first` is the first number that was found, `limit` the one that it must stay below.
Diagnostic reportOf(const glsl::UndefinedSite& site, std::int32_t count, std::int32_t first,
                    std::int32_t limit) {
    using Site = glsl::UndefinedSite::Kind;
    const std::string times = count == 1 ? "once" : base::groupedText(count) + " times";
    const auto warn = [&](const char* id, const std::string& text) { return diagnose(id, text, site.place); };
    switch (site.kind) {
        case Site::subscript:
            return warn(
                "glsl-W29",
                fmt::format("the subscript in '{}' is outside of the {} elements {}, the first time {}",
                            site.text, limit, times, first));
        case Site::vertices:
            return warn(
                "glsl-W30",
                fmt::format("EmitVertex() exceeds max_vertices = {} {}; the surplus is lost", limit, times));
        case Site::texel:
            return warn("glsl-W31", fmt::format("'{}' is outside {}, the first time at {} of {} texels",
                                                site.text, times, first, limit));
        case Site::level:
            return warn(
                "glsl-W31",
                fmt::format("'{}' names a level that the texture lacks {}, the first time {} of {} levels",
                            site.text, times, first, limit));
        case Site::divisor:
            break;
    }
    return warn("glsl-W32", fmt::format("the divisor '{}' is 0 {}", site.text, times));
}

/// What a program has recorded, which is then 0 again.
std::vector<std::int32_t> takeNumbers(gpu::Buffer& record, std::size_t count) {
    std::vector<std::int32_t> numbers(count);
    record.read(0, std::as_writable_bytes(std::span(numbers)));
    const std::vector<std::int32_t> none(count);
    record.update(0, std::as_bytes(std::span(none)));
    return numbers;
}

/// The first loop that the driver has ended since the last call.
std::optional<Place> recordedLoop(const BuiltProgram& built) {
    if (!built.loopCounter || !built.loopCounter->record) return std::nullopt;
    const std::vector<Place>& sites = built.loopCounter->interface.facts.loopSites;
    glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
    const std::vector<std::int32_t> numbers = takeNumbers(*built.loopCounter->record, sites.size());
    const auto cut = std::ranges::find_if(numbers, [](std::int32_t each) { return each != 0; });
    if (cut == numbers.end()) return std::nullopt;
    return sites[static_cast<std::size_t>(cut - numbers.begin())];
}

/// The guarded loop that was ended.
std::optional<Place> triedLoop(const BuiltProgram& built) {
    const std::vector<Place>& sites = built.interface.facts.loopSites;
    const int site = std::exchange(built.tried.site, 0);
    if (site < 1 || static_cast<std::size_t>(site) > sites.size()) return std::nullopt;
    return sites[static_cast<std::size_t>(site) - 1];
}

}  // namespace

void ProgramLibrary::takeRecord(const char* block, std::size_t numbers, BuiltProgram& built,
                                Diagnostics& diagnostics) {
    std::vector<base::StorageBlock>& blocks = built.interface.storageBlocks;
    const auto found =
        std::ranges::find_if(blocks, [&](const base::StorageBlock& each) { return each.name == block; });
    if (found == blocks.end()) return;
    const unsigned index = found->index;
    blocks.erase(found);
    // Blocks of the scene are bound by their positions.
    built.recordBinding = static_cast<unsigned>(blocks.size());
    glShaderStorageBlockBinding(built.program->id(), index, built.recordBinding);
    const std::vector<std::int32_t> none(numbers);
    Result<gpu::Buffer> made = gpu::Buffer::create(std::as_bytes(std::span(none)), GL_DYNAMIC_READ);
    append(diagnostics, std::move(made.diagnostics));
    if (made) built.record = std::move(*made);
}

Diagnostics ProgramLibrary::takeUndefined() {
    Diagnostics found;
    glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
    for (const auto& [variant, built] : programs_) {
        if (!built->record) continue;
        const std::vector<glsl::UndefinedSite>& sites = built->interface.facts.undefinedSites;
        const std::vector<std::int32_t> numbers =
            takeNumbers(*built->record, glsl::kNumbersPerSite * sites.size());
        for (std::size_t i = 0; i < sites.size(); ++i)
            if (numbers[3 * i] != 0)
                found.push_back(reportOf(sites[i], numbers[3 * i], numbers[3 * i + 1], numbers[3 * i + 2]));
        sources_.hideTexts(variant.program, found);
    }
    return found;
}

void ProgramLibrary::countLoops(const plan::FramePlan& plan) {
    if (!context_.capabilities().compute) return;  // storage blocks
    for (const plan::PlannedProgram& each : plan.programs) {
        const auto known = std::ranges::find_if(
            programs_, [&](const KnownProgram& program) { return program.first == each.variant; });
        if (!each.hasOpenLoops || known == programs_.end() || known->second->loopCounter) continue;
        BuiltProgram& built = *known->second;
        built.loopCounter = std::make_unique<BuiltProgram>();  // tried once
        Diagnostics unused;
        glsl::ProgramRequest asked = request(each.variant, unused);
        asked.recordsLoops = true;
        asked.checksUndefined = false;  // the program itself does so
        glsl::TranslatedProgram translated = glsl::translate(asked);
        if (translated.loopSites.empty() || hasError(translated.diagnostics)) continue;
        BuiltProgram& counter = *built.loopCounter;
        counter.program = capturingProgram(context_.capabilities(), built, translated.stages, {});
        if (!counter.program) continue;
        static_cast<base::ActiveResources&>(counter.interface) = gpu::reflect(*counter.program);
        takeRecord(glsl::kCutLoopsBlock, translated.loopSites.size(), counter, unused);
        counter.interface.facts = std::move(translated);
    }
}

Diagnostics ProgramLibrary::takeCutLoops(int limit) {
    Diagnostics found;
    const bool isEs = context_.capabilities().isEs;
    for (const auto& [variant, built] : programs_) {
        const std::optional<Place> place = isEs ? triedLoop(*built) : recordedLoop(*built);
        if (!place) continue;
        Diagnostics said{diagnose(
            "draw-W08",
            fmt::format(
                "{0} ended this loop before its condition did, because it ends a shader's loops after "
                "{1} rounds together{2}; the picture may be wrong",
                isEs ? "glibra" : "the driver", base::groupedText(limit),
                isEs ? ", or after fewer if these take long" : ""),
            *place)};
        sources_.hideTexts(variant.program, said);
        for (Diagnostic& each : said) {
            const bool isKnown = std::ranges::any_of(cutLoops_, [&](const Diagnostic& earlier) {
                return earlier.text == each.text && earlier.place == each.place;
            });
            if (isKnown) continue;
            cutLoops_.push_back(each);
            found.push_back(std::move(each));
        }
    }
    return found;
}

}  // namespace glibra::render
