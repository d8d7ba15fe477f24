// What shaders do that GLSL leaves undefined, as their programs count it (RenderOptions::checkUndefined).

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "base/text.h"
#include "render/load/programs.h"

namespace glibra::render {
namespace {

constexpr std::size_t kNumbersPerSite = 3;

/// `first` is the first number that was found, `limit` the one that it must stay below.
Diagnostic reportOf(const glsl::UndefinedSite& site, std::int32_t count, std::int32_t first,
                    std::int32_t limit) {
    using Kind = glsl::UndefinedSite::Kind;
    const std::string times = count == 1 ? "once" : base::groupedText(count) + " times";
    switch (site.kind) {
        case Kind::subscript:
            return diagnose("glsl-W29",
                            fmt::format("the subscript in '{}' is outside of the {} elements {}, the first "
                                        "time {}",
                                        site.text, limit, times, first),
                            site.place);
        case Kind::vertices:
            return diagnose(
                "glsl-W30",
                fmt::format("EmitVertex() exceeds max_vertices = {} {}; the surplus is lost", limit, times),
                site.place);
        case Kind::texel:
            return diagnose("glsl-W31",
                            fmt::format("'{}' is outside {}, the first time at {} of {} texels", site.text,
                                        times, first, limit),
                            site.place);
        case Kind::level:
            return diagnose("glsl-W31",
                            fmt::format("'{}' names a level that the texture lacks {}, the first time {} of "
                                        "{} levels",
                                        site.text, times, first, limit),
                            site.place);
        case Kind::divisor:
            break;
    }
    return diagnose("glsl-W32", fmt::format("the divisor '{}' is 0 {}", site.text, times), site.place);
}

}  // namespace

void ProgramLibrary::countUndefined(const glsl::TranslatedProgram& translated, BuiltProgram& built,
                                    Diagnostics& diagnostics) const {
    std::vector<base::StorageBlock>& blocks = built.interface.storageBlocks;
    const auto found = std::ranges::find_if(
        blocks, [](const base::StorageBlock& each) { return each.name == glsl::kUndefinedBlock; });
    if (found == blocks.end()) return;
    const unsigned index = found->index;
    blocks.erase(found);
    // Blocks of the scene are bound by their positions.
    built.undefinedBinding = static_cast<unsigned>(blocks.size());
    glShaderStorageBlockBinding(built.program->id(), index, built.undefinedBinding);
    const std::vector<std::int32_t> none(kNumbersPerSite * translated.undefinedSites.size());
    Result<gpu::Buffer> made = gpu::Buffer::create(std::as_bytes(std::span(none)), GL_DYNAMIC_READ);
    append(diagnostics, std::move(made.diagnostics));
    if (made) built.undefined = std::move(*made);
}

Diagnostics ProgramLibrary::takeUndefined() {
    Diagnostics found;
    glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
    for (const auto& [variant, built] : programs_) {
        if (!built->undefined) continue;
        const std::vector<glsl::UndefinedSite>& sites = built->interface.facts.undefinedSites;
        std::vector<std::int32_t> numbers(kNumbersPerSite * sites.size());
        built->undefined->read(0, std::as_writable_bytes(std::span(numbers)));
        for (std::size_t i = 0; i < sites.size(); ++i)
            if (numbers[3 * i] != 0)
                found.push_back(reportOf(sites[i], numbers[3 * i], numbers[3 * i + 1], numbers[3 * i + 2]));
        std::fill(numbers.begin(), numbers.end(), 0);
        built->undefined->update(0, std::as_bytes(std::span(numbers)));
        sources_.hideTexts(variant.program, found);
    }
    return found;
}

}  // namespace glibra::render
