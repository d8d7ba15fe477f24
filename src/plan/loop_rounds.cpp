#include "plan/loop_rounds.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "base/text.h"

namespace glibra::plan {
namespace {

/// The uniform's value from the scene or the command line, or 0 without one. Nothing if the runtime supplies
/// the value or the shader initialises it.
std::optional<double> valueOf(const PlannedProgram& program, std::string_view name) {
    const std::vector<ActiveUniform>& uniforms = program.interface->uniforms;
    const auto found =
        std::ranges::find_if(uniforms, [&](const ActiveUniform& each) { return each.name == name; });
    if (found == uniforms.end()) return std::nullopt;
    const UniformIndex index(static_cast<std::size_t>(found - uniforms.begin()));
    std::optional<double> value;
    const auto declared = program.interface->facts.uniforms.find(std::string(name));
    if (declared == program.interface->facts.uniforms.end() || !declared->second.hasInitializer) value = 0;
    for (const UniformBinding& each : program.values) {
        if (each.uniform != index) continue;
        const auto* literal = std::get_if<Literal>(&each.value);
        if (literal == nullptr || literal->values.empty()) return std::nullopt;
        value = literal->values.front();
    }
    return value;
}

glsl::UniformValue valuesOf(const PlannedProgram& program, const Measure& measure) {
    return [&program, &measure](std::string_view name) -> std::optional<double> {
        if (const auto value = valueOf(program, name)) return value;
        return measure ? measure(name) : std::nullopt;
    };
}

}  // namespace

Diagnostics reportLostVertices(const PlannedProgram& program, const Measure& measure) {
    const glsl::TranslatedProgram& facts = program.interface->facts;
    const glsl::UniformValue value = valuesOf(program, measure);
    for (const glsl::TranslatedStage& stage : facts.stages) {
        if (stage.stage != glsl::Stage::geometry || facts.maxVertices == 0) continue;
        double emitted = stage.emits;
        for (const glsl::CountedLoop& each : stage.loops) emitted += glsl::emittedBy(each, value);
        constexpr double kMost = 1e9;
        if (emitted <= facts.maxVertices || emitted > kMost) continue;
        const auto count = static_cast<long long>(emitted);
        return {diagnose("glsl-W27",
                         fmt::format("max_vertices is {}, but the stage emits {} vertices, of which the last "
                                     "{} lost; write max_vertices = {}",
                                     facts.maxVertices, base::groupedText(count),
                                     count - facts.maxVertices == 1
                                         ? std::string("one is")
                                         : base::groupedText(count - facts.maxVertices) + " are",
                                     count),
                         facts.maxVerticesPlace)};
    }
    return {};
}

bool hasOpenLoops(const PlannedProgram& program, const Measure& measure) {
    const glsl::UniformValue value = valuesOf(program, measure);
    return std::ranges::any_of(program.interface->facts.stages, [&](const glsl::TranslatedStage& stage) {
        double all = 0;
        for (const glsl::CountedLoop& each : stage.loops) all += glsl::totalRounds(each, value);
        return !stage.uncounted.empty() || all > kRoundsOfAnyDriver ||
               std::ranges::any_of(stage.loops, [&](const auto& each) { return glsl::isOpen(each, value); });
    });
}

Diagnostics reportLongLoops(const PlannedProgram& program, const std::function<int()>& limit,
                            const Measure& measure) {
    Diagnostics diagnostics;
    const glsl::UniformValue value = valuesOf(program, measure);
    for (const glsl::TranslatedStage& stage : program.interface->facts.stages) {
        double all = 0;
        double most = 0;
        const glsl::CountedLoop* longest = nullptr;
        for (const glsl::CountedLoop& each : stage.loops) {
            const double rounds = glsl::totalRounds(each, value);
            all += rounds;
            if (rounds <= most) continue;
            most = rounds;
            longest = &each;
        }
        if (longest == nullptr || all <= kRoundsOfAnyDriver) continue;
        const int allowed = limit();
        if (allowed <= 0 || all <= allowed) continue;
        const char* what = most <= allowed                          ? "the loops of this stage run"
                           : glsl::roundsOf(*longest, value) < most ? "this loop and those in it run"
                                                                    : "this loop runs";
        diagnostics.push_back(diagnose(
            "draw-W08",
            fmt::format(
                "{} up to {} rounds, but the driver ends a shader's loops after {}; the picture may be "
                "wrong",
                what, base::groupedText(static_cast<long long>(most <= allowed ? all : most)),
                base::groupedText(allowed)),
            longest->place));
    }
    return diagnostics;
}

}  // namespace glibra::plan
