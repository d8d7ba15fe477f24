// Reports names that no program of the scene has: of --set and of Set (language, 12.1).

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "plan/frame_plan.h"
#include "plan/overrides.h"
#include "plan/uniform_names.h"

namespace glibra::plan {
namespace {

/// True if a program declares the uniform without using it. Drivers differ in which unused uniforms they
/// keep.
bool isDeclaredUnused(const scene::Scene& scene, const FramePlan& plan, const Override& override) {
    return std::any_of(plan.programs.begin(), plan.programs.end(), [&](const PlannedProgram& program) {
        const scene::ProgramIndex own = program.variant.program;
        return own && isFor(override, scene.programs[own]) &&
               program.interface->facts.uniforms.contains(std::string(rootName(override.name)));
    });
}

Diagnostics reportOverrides(const scene::Scene& scene, std::span<const FramePlan* const> plans,
                            std::span<const Override> overrides) {
    std::vector<bool> used(overrides.size());
    std::vector<std::string> names;
    for (const scene::Variable& each : scene.variables) names.push_back(each.name);
    std::set<scene::ProgramIndex> known;
    for (const FramePlan* plan : plans) {
        for (std::size_t i = 0; i < used.size(); ++i)
            if (plan->usedOverrides.at(i)) used[i] = true;
        for (const PlannedProgram& program : plan->programs) {
            if (program.interface->usable) known.insert(program.variant.program);
            for (const ActiveUniform& uniform : program.interface->uniforms)
                if (!isInternalName(uniform.name) && suppliedBy(uniform) == nullptr)
                    names.push_back(uniform.name);
        }
    }
    for (const scene::ProgramIndex i : scene.programs.indices()) {
        if (known.contains(i)) continue;
        for (const glib::UniformSpec& spec : scene.programs[i].uniforms)
            for (std::size_t each = 0; each < overrides.size(); ++each)
                if (overrides[each].name == spec.tag) used[each] = true;
    }
    Diagnostics diagnostics;
    for (std::size_t i = 0; i < overrides.size(); ++i) {
        const auto declares = [&](const FramePlan* plan) {
            return isDeclaredUnused(scene, *plan, overrides[i]);
        };
        if (used[i] || !overrides[i].word.empty() || std::none_of(plans.begin(), plans.end(), declares))
            continue;
        used[i] = true;
        diagnostics.push_back(diagnose(
            "glib-W24", fmt::format("uniform '{}' is declared but unused, so setting it has no effect",
                                    overrides[i].name)));
    }
    append(diagnostics, unusedOverrides(overrides, used, names));
    return diagnostics;
}

/// True for the name of a block, of its instance, of a member, or of an atomic counter.
bool namesMemory(const glsl::MemoryFacts& memory, const std::string& name) {
    return memory.counters.contains(name) ||
           std::any_of(memory.blocks.begin(), memory.blocks.end(), [&](const glsl::MemoryBlock& each) {
               return each.name == name || each.instance == name ||
                      std::any_of(each.members.begin(), each.members.end(),
                                  [&](const auto& member) { return member.name == name; });
           });
}

/// What the programs of all plans have.
struct KnownNames {
    std::vector<std::string> uniforms;  ///< for suggestions
    std::set<scene::ProgramIndex> programs;

    KnownNames(std::span<const FramePlan* const> plans) {
        for (const FramePlan* plan : plans)
            for (const PlannedProgram& program : plan->programs) {
                if (program.interface->usable) programs.insert(program.variant.program);
                for (const auto& [name, declared] : program.interface->facts.uniforms)
                    if (!isInternalName(name) && !isSuppliedName(name)) uniforms.push_back(name);
            }
    }
};

bool isKnown(std::string_view tag, std::span<const FramePlan* const> plans) {
    const std::string root(rootName(tag));
    return isSuppliedName(root) || std::any_of(plans.begin(), plans.end(), [&](const FramePlan* plan) {
               return std::any_of(plan->programs.begin(), plan->programs.end(), [&](const auto& program) {
                   const ProgramInterface& interface = *program.interface;
                   return interface.facts.uniforms.contains(root) ||
                          namesMemory(interface.facts.memory, root) ||
                          !UniformNames(interface).find(tag).empty();
               });
           });
}

/// The hint for a name that looks misspelt. Names of a row (uLight1, uLight2) do not: a Set is for all
/// programs, and not all of them need the whole row.
std::string misspelling(std::string_view tag, const KnownNames& known) {
    const auto withoutDigits = [](std::string_view name) {
        std::string text(name);
        std::erase_if(text, [](char c) { return c >= '0' && c <= '9'; });
        return text;
    };
    const std::string base = withoutDigits(tag);
    if (std::any_of(known.uniforms.begin(), known.uniforms.end(),
                    [&](const std::string& each) { return withoutDigits(each) == base; }))
        return {};
    return suggestionFor(tag, known.uniforms);
}

Diagnostics reportSets(const scene::Scene& scene, std::span<const FramePlan* const> plans) {
    const KnownNames known(plans);
    for (const scene::ProgramIndex i : scene.programs.indices())
        if (!known.programs.contains(i)) return {};  // it may have any name
    Diagnostics diagnostics;
    for (const auto& [tag, place] : scene.setNames) {
        if (isKnown(tag, plans)) continue;
        if (const std::string hint = misspelling(rootName(tag), known); !hint.empty())
            diagnostics.push_back(diagnose(
                "glib-W23", fmt::format("no program of the scene has a uniform '{}'{}", tag, hint), place));
    }
    return diagnostics;
}

}  // namespace

Diagnostics reportNames(const scene::Scene& scene, std::span<const FramePlan* const> plans,
                        std::span<const Override> overrides) {
    Diagnostics diagnostics;
    if (!overrides.empty()) diagnostics = reportOverrides(scene, plans, overrides);
    if (!scene.setNames.empty()) append(diagnostics, reportSets(scene, plans));
    return diagnostics;
}

}  // namespace glibra::plan
