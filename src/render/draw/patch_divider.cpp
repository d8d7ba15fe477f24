#include "render/draw/patch_divider.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <utility>

#include "geometry/tessellator.h"
#include "render/draw/texel_list.h"

namespace glibra::render {
void PatchDivider::submit(const gpu::Capabilities& capabilities, gpu::BindingTracker& bindings,
                          const BuiltProgram& built, const Work& work) {
    const int count = work.patches * work.instances;
    if (count <= 0) return;
    setOwnUniform(built, "glibra_Instance", work.first);
    setOwnUniform(built, "glibra_Patches", work.patches);
    std::vector<TessellationLevels> levels(static_cast<std::size_t>(count), work.levels);
    if (built.interface.facts.expanded.measuresLevels && !measure(built, levels)) return;
    Divided& divided = divided_[{work.draw, work.first}];
    if (divided.levels != levels) {
        divided = divide(capabilities, built, std::move(levels));
        bindings.forgetWorkUnit();
        if (work.bindAgain) work.bindAgain();
    }
    if (!divided.coordinates || divided.vertices == 0) return;
    const int unit = capabilities.combinedTextureUnits - 1;  // the scene's are counted from 0
    bindings.bind(*divided.coordinates, unit);
    const auto [location, isNew] = locations_.try_emplace(&built, 0);
    if (isNew) location->second = glGetUniformLocation(built.program->id(), glsl::kCoordinates);
    glUniform1i(location->second, unit);
    setOwnUniform(built, "glibra_Count", count);
    const int instances = built.interface.facts.expanded.areInSequence ? 1 : count;
    constexpr std::array<GLenum, 3> kModes{GL_POINTS, GL_LINES, GL_TRIANGLES};
    const auto corners = static_cast<std::size_t>(built.interface.facts.expanded.ofPrimitive);
    if (work.quads && work.quads(kModes.at(corners - 1), divided.vertices, instances)) return;
    if (work.asEdges && corners == 3)
        edges_.draw(nullptr, 0, divided.vertices, GL_TRIANGLES, instances);
    else
        glDrawArraysInstanced(kModes.at(corners - 1), 0, divided.vertices, instances);
}

bool PatchDivider::measure(const BuiltProgram& built, std::vector<TessellationLevels>& levels) {
    // Programs that make quads of lines capture more, after the levels.
    const auto stride = static_cast<std::size_t>(
        std::max(glsl::kLevelComponents, built.interface.facts.wideLines.components));
    std::vector<float> told(levels.size() * stride);
    if (!captured_.read(built, {"glibra_Measures", 1}, static_cast<int>(levels.size()),
                        std::as_writable_bytes(std::span(told)), problems_))
        return false;
    for (std::size_t i = 0; i < levels.size(); ++i)
        std::copy_n(told.begin() + static_cast<std::ptrdiff_t>(i * stride), levels[i].size(),
                    levels[i].begin());
    return true;
}

PatchDivider::Divided PatchDivider::divide(const gpu::Capabilities& capabilities, const BuiltProgram& built,
                                           std::vector<TessellationLevels> levels) {
    const glsl::ExpandedGeometry& expanded = built.interface.facts.expanded;
    const base::TessellationLayout& layout = *expanded.tessellation;
    std::vector<ListTexel> texels(levels.size());
    std::map<TessellationLevels, ListTexel> known;
    Divided divided;
    std::int64_t before = 0;
    for (std::size_t i = 0; i < levels.size(); ++i) {
        const auto [entry, isNew] = known.try_emplace(levels[i]);
        if (isNew) {
            const auto first = static_cast<float>(texels.size());
            const std::vector<std::array<float, 3>> coordinates = geometry::tessellate(layout, levels[i]);
            for (const auto& [u, v, w] : coordinates) texels.push_back({u, v, w, 0});
            const int count = static_cast<int>(coordinates.size()) / cornersOf(layout) * expanded.vertices;
            if (!expanded.areInSequence) divided.vertices = std::max(divided.vertices, count);
            entry->second = {first, static_cast<float>(count), 0, 0};
        }
        texels[i] = entry->second;
        if (!expanded.areInSequence) continue;
        texels[i][2] = static_cast<float>(before / 65536);
        texels[i][3] = static_cast<float>(before % 65536);
        before += static_cast<std::int64_t>(entry->second[1]);
        if (before > std::numeric_limits<int>::max()) {
            problems_.push_back(
                diagnose("draw-E05", "out of memory: the patches have more than 2^31 vertices"));
            return divided;
        }
        divided.vertices = static_cast<int>(before);
    }
    Result<gpu::Texture> texture = listTexture(capabilities, std::move(texels));
    append(problems_, std::move(texture.diagnostics));
    if (texture) divided.coordinates.emplace(std::move(*texture));
    divided.levels = std::move(levels);
    return divided;
}

}  // namespace glibra::render
