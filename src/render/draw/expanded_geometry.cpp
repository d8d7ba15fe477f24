#include "render/draw/expanded_geometry.h"

#include <limits>

#include "geometry/tessellator.h"
#include "gpu/object/uniform.h"

namespace glibra::render {

void setOwnUniform(const BuiltProgram& built, std::string_view name, double value) {
    const auto uniform = std::ranges::find(built.interface.uniforms, name, &base::ActiveUniform::emittedName);
    if (uniform != built.interface.uniforms.end())
        gpu::setUniform(*built.program, *uniform, std::array<double, 1>{value});
}

bool CapturedOutputs::read(const BuiltProgram& built, const Switch& tells, int count, std::span<std::byte> to,
                           Diagnostics& problems) {
    if (!room_ || room_->size() < to.size()) {
        Result<gpu::Buffer> room = gpu::Buffer::create(to.size(), GL_STREAM_READ);
        append(problems, std::move(room.diagnostics));
        if (!room) return false;
        room_ = std::move(*room);
    }
    setOwnUniform(built, tells.uniform, tells.value);
    room_->bindBase(GL_TRANSFORM_FEEDBACK_BUFFER, 0);
    // WebGL writes into no buffer that is bound for something else, too.
    glBindBuffer(GL_COPY_READ_BUFFER, 0);
    glBindBuffer(GL_COPY_WRITE_BUFFER, 0);
    glEnable(GL_RASTERIZER_DISCARD);
    glBeginTransformFeedback(GL_POINTS);
    glDrawArraysInstanced(GL_POINTS, 0, 1, count);
    glEndTransformFeedback();
    glDisable(GL_RASTERIZER_DISCARD);
    glBindBufferBase(GL_TRANSFORM_FEEDBACK_BUFFER, 0, 0);
    setOwnUniform(built, tells.uniform, 0);
    room_->read(0, to);
    return true;
}

// ---- Inputs

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

// ---- Patches

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

// ---- Emitted vertices

std::vector<std::uint32_t> indicesOf(const EmittedStrips& strips, int corners) {
    std::vector<std::uint32_t> indices;
    std::uint32_t first = 0;  // of the strip
    for (std::uint32_t i = 0; i < strips.vertices; ++i) {
        if ((strips.begins.at(i / 32) >> (i % 32) & 1U) != 0) first = i;
        const std::uint32_t place = i - first;
        if (place + 1 < static_cast<std::uint32_t>(corners)) continue;
        for (std::uint32_t each = i + 1 - static_cast<std::uint32_t>(corners); each <= i; ++each)
            indices.push_back(each);
        if (corners == 3 && place % 2 != 0)
            std::swap(indices[indices.size() - 3], indices[indices.size() - 2]);
    }
    return indices;
}

const StripDrawer::Indices* StripDrawer::indicesFor(const EmittedStrips& strips, int corners) {
    constexpr std::size_t kMostKnown = 64;
    const std::pair key{strips, corners};
    if (const auto known = known_.find(key); known != known_.end()) return &known->second;
    const std::vector<std::uint32_t> indices = indicesOf(strips, corners);
    Result<gpu::Buffer> buffer = gpu::Buffer::create(std::as_bytes(std::span(indices)));
    append(problems_, std::move(buffer.diagnostics));
    if (!buffer) return nullptr;
    if (known_.size() == kMostKnown) {
        known_.clear();
        edges_ = {};  // of these buffers
    }
    return &known_.try_emplace(key, std::move(*buffer), static_cast<int>(indices.size())).first->second;
}

void StripDrawer::draw(const BuiltProgram& built, int count, bool asEdges, const QuadDrawer& quads) {
    const glsl::ExpandedGeometry& expanded = built.interface.facts.expanded;
    constexpr std::array<GLenum, 3> kModes{GL_POINTS, GL_LINES, GL_TRIANGLES};
    const GLenum mode = kModes.at(static_cast<std::size_t>(expanded.ofPrimitive) - 1);
    int vertices = expanded.vertices;
    if (expanded.mostEmitted > 0 && count > 0) {
        std::vector<EmittedStrips> strips(static_cast<std::size_t>(count));
        if (!captured_.read(built, {"glibra_Mode", 2}, count, std::as_writable_bytes(std::span(strips)),
                            problems_))
            return;
        std::size_t most = 0;
        for (EmittedStrips& each : strips) {
            each.vertices = std::min(each.vertices, static_cast<std::uint32_t>(expanded.mostEmitted));
            if (&each == &strips.front() || each != *(&each - 1))
                most = std::max(most, indicesOf(each, expanded.ofPrimitive).size());
        }
        if (most == 0) return;
        if (std::ranges::adjacent_find(strips, std::ranges::not_equal_to()) == strips.end()) {
            const Indices* indices = indicesFor(strips.front(), expanded.ofPrimitive);
            if (indices == nullptr) return;
            setOwnUniform(built, "glibra_Mode", 1);
            if (asEdges && expanded.ofPrimitive == 3) {
                edges_.draw(&indices->buffer, 0, indices->count, GL_TRIANGLES, count);
            } else {
                indices->buffer.bind(GL_ELEMENT_ARRAY_BUFFER);
                glDrawElementsInstanced(mode, indices->count, GL_UNSIGNED_INT, nullptr, count);
            }
            glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, 0);  // a part of the vertex array, which has none
            setOwnUniform(built, "glibra_Mode", 0);
            return;
        }
        vertices = std::min(vertices, static_cast<int>(most));
    }
    if (quads && quads(mode, vertices, count)) return;
    if (asEdges && expanded.ofPrimitive == 3)
        edges_.draw(nullptr, 0, vertices, GL_TRIANGLES, count);
    else
        glDrawArraysInstanced(mode, 0, vertices, count);
}

}  // namespace glibra::render
