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

/// The programs of the scene that linked in one of the plans.
std::set<scene::ProgramIndex> knownPrograms(std::span<const FramePlan* const> plans) {
    std::set<scene::ProgramIndex> known;
    for (const FramePlan* plan : plans)
        for (const PlannedProgram& program : plan->programs)
            if (program.interface->usable) known.insert(program.variant.program);
    return known;
}

Diagnostics reportOverrides(const scene::Scene& scene, std::span<const FramePlan* const> plans,
                            std::span<const Override> overrides) {
    std::vector<bool> used(overrides.size());
    std::vector<std::string> names;
    for (const scene::Variable& each : scene.variables) names.push_back(each.name);
    for (const FramePlan* plan : plans) {
        for (std::size_t i = 0; i < used.size(); ++i)
            if (plan->usedOverrides.at(i)) used[i] = true;
        for (const PlannedProgram& program : plan->programs)
            for (const ActiveUniform& uniform : program.interface->uniforms)
                if (!isInternalName(uniform.name) && suppliedBy(uniform) == nullptr)
                    names.push_back(uniform.name);
    }
    const std::set<scene::ProgramIndex> known = knownPrograms(plans);
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

/// True if the tag names a uniform, a member of a uniform block or memory of the program.
bool has(const ProgramInterface& interface, std::string_view tag) {
    const std::string root(rootName(tag));
    const std::string member = "." + root;
    return interface.facts.uniforms.contains(root) || namesMemory(interface.facts.memory, root) ||
           std::any_of(interface.uniforms.begin(), interface.uniforms.end(), [&](const ActiveUniform& each) {
               return rootName(each.name) == root || each.name.ends_with(member);
           });
}

bool isKnown(std::string_view tag, std::span<const FramePlan* const> plans) {
    return isSuppliedName(rootName(tag)) ||
           std::any_of(plans.begin(), plans.end(), [&](const FramePlan* plan) {
               return std::any_of(plan->programs.begin(), plan->programs.end(),
                                  [&](const PlannedProgram& each) { return has(*each.interface, tag); });
           });
}

std::vector<std::string> declaredUniforms(std::span<const FramePlan* const> plans) {
    std::vector<std::string> names;
    for (const FramePlan* plan : plans)
        for (const PlannedProgram& program : plan->programs)
            for (const auto& [name, declared] : program.interface->facts.uniforms)
                if (!isInternalName(name) && !isSuppliedName(name)) names.push_back(name);
    return names;
}

/// The hint for a name that looks misspelt. Names of a row (uLight1, uLight2) do not: a Set is for all
/// programs, and not all of them need the whole row.
std::string misspelling(std::string_view tag, std::span<const std::string> names) {
    const auto withoutDigits = [](std::string_view name) {
        std::string text(name);
        std::erase_if(text, [](char c) { return c >= '0' && c <= '9'; });
        return text;
    };
    const std::string base = withoutDigits(tag);
    if (std::any_of(names.begin(), names.end(),
                    [&](const std::string& each) { return withoutDigits(each) == base; }))
        return {};
    return suggestionFor(tag, names);
}

Diagnostics reportSets(const scene::Scene& scene, std::span<const FramePlan* const> plans) {
    Diagnostics diagnostics;
    for (const auto& [tag, place] : scene.setNames) {
        if (isKnown(tag, plans)) continue;
        const std::set<scene::ProgramIndex> known = knownPrograms(plans);
        for (const scene::ProgramIndex i : scene.programs.indices())
            if (!known.contains(i)) return {};  // it may have any name
        if (const std::string hint = misspelling(rootName(tag), declaredUniforms(plans)); !hint.empty())
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
