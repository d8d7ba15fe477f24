#include "render/draw/fetched_inputs.h"

#include <algorithm>
#include <cstddef>
#include <span>
#include <utility>

#include "render/draw/texel_list.h"

namespace glibra::render {
namespace {

std::vector<ListTexel> texelsOf(const DeviceMesh& mesh, const std::vector<FetchedInputs::Source>& sources) {
    const auto vertices = static_cast<std::size_t>(mesh.indexCount);
    std::vector<ListTexel> texels(vertices * sources.size());
    for (std::size_t i = 0; i < sources.size(); ++i) {
        if (const auto* value = std::get_if<std::array<double, 4>>(&sources[i])) {
            for (std::size_t vertex = 0; vertex < vertices; ++vertex)
                std::ranges::transform(*value, texels[vertex * sources.size() + i].begin(),
                                       [](double each) { return static_cast<float>(each); });
            continue;
        }
        const DeviceMesh::Attribute& attribute = *std::get<const DeviceMesh::Attribute*>(sources[i]);
        const auto size = static_cast<std::size_t>(attribute.components);
        std::vector<float> values(vertices * size);
        attribute.floats.read(0, std::as_writable_bytes(std::span(values)));
        for (std::size_t vertex = 0; vertex < vertices; ++vertex) {
            ListTexel& texel = texels[vertex * sources.size() + i] = {0, 0, 0, 1};
            std::copy_n(values.begin() + static_cast<std::ptrdiff_t>(vertex * size),
                        std::min<std::size_t>(size, 4), texel.begin());
        }
    }
    return texels;
}

}  // namespace

Diagnostics FetchedInputs::bind(const gpu::Capabilities& capabilities, gpu::BindingTracker& bindings,
                                const BuiltProgram& built, const plan::PlannedDraw& draw,
                                const DeviceMesh& mesh, const std::vector<Source>& sources) {
    Made& made = made_[&draw];
    if (!made.texture || made.sources != sources) {
        Result<gpu::Texture> texture = listTexture(capabilities, texelsOf(mesh, sources));
        bindings.forgetWorkUnit();
        if (!texture) return std::move(texture.diagnostics);
        made.texture.emplace(std::move(*texture));
        made.sources = sources;
    }
    const int unit = capabilities.combinedTextureUnits - 2;  // the last one has coordinates (PatchDivider)
    bindings.bind(*made.texture, unit);
    glUniform1i(glGetUniformLocation(built.program->id(), glsl::kFetchedInputs), unit);
    return {};
}

}  // namespace glibra::render
