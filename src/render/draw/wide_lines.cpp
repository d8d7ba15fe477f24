#include "render/draw/wide_lines.h"

#include <algorithm>
#include <array>
#include <limits>
#include <numeric>
#include <span>

#include "gpu/object/buffer.h"
#include "gpu/object/uniform.h"
#include "render/draw/expanded_geometry.h"

namespace glibra::render {
namespace {

constexpr std::size_t kEndsInRow = glsl::kEndsWidth;

std::size_t endRowsOf(std::uint64_t numbers) {
    return static_cast<std::size_t>((numbers + kEndsInRow - 1) / kEndsInRow);
}

void setLineLook(const LineWidener::Look& look) {
    const auto& uniforms = look.built->interface.uniforms;
    const auto line = std::ranges::find(uniforms, "glibra_Line", &base::ActiveUniform::emittedName);
    if (line != uniforms.end())
        gpu::setUniform(*look.built->program, *line,
                        std::array<double, 4>{look.viewportWidth, look.viewportHeight, look.lineWidth,
                                              look.hasSamples ? 1.0 : 0.0});
    setOwnUniform(*look.built, "glibra_Wide", static_cast<double>(look.mode));
}

}  // namespace

bool LineWidener::makeTexture(std::optional<gpu::Texture>& texture, int rows) {
    Result<gpu::Texture> made =
        gpu::Texture::create(capabilities_, gpu::TextureLayout{.format = gpu::TexelFormat::r32ui,
                                                               .size = {glsl::kEndsWidth, rows},
                                                               .isFilled = false});
    bindings_.forgetWorkUnit();
    append(problems_, std::move(made.diagnostics));
    if (!made) return false;
    bindings_.bind(*made, unit());  // before the earlier one is deleted, whose number may come again
    texture = std::move(*made);
    glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit()));
    for (const GLenum each : std::array<GLenum, 2>{GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER})
        glTexParameteri(GL_TEXTURE_2D, each, GL_NEAREST);
    return true;
}

void LineWidener::prepare(const BuiltProgram& built) {
    if (!nothing_ && !makeTexture(nothing_, 1)) return;
    bindings_.bind(*nothing_, unit());
    if (prepared_.insert(&built).second)
        glUniform1i(glGetUniformLocation(built.program->id(), glsl::kLineEnds), unit());
}

void LineWidener::list(Ends& ends, const Lines& lines) {
    const Key key{lines.indices != nullptr ? lines.indices->content() : 0, lines.offset, lines.count,
                  lines.mode};
    if (ends.key == key) return;
    ends.key = key;
    std::vector<std::uint32_t> indices(static_cast<std::size_t>(std::max(0, lines.count)));
    if (lines.indices != nullptr)
        lines.indices->read(static_cast<std::size_t>(lines.offset),
                            std::as_writable_bytes(std::span(indices)));
    else
        std::iota(indices.begin(), indices.end(), 0U);
    std::vector<std::uint32_t>& pairs = ends.vertexPairs = gpu::edgesOf(indices, lines.mode);
    ends.pairs = static_cast<int>(pairs.size() / 2);
    ends.vertices = pairs.empty() ? 0 : std::int64_t{std::ranges::max(pairs)} + 1;
    pairs.resize(endRowsOf(pairs.size()) * kEndsInRow);
    ends.isFilled = false;
}

bool LineWidener::capture(const Ends& ends, const BuiltProgram& built, int instances, std::size_t rows) {
    const std::size_t bytes = rows * kEndsInRow * sizeof(std::uint32_t);
    if (!outputs_ || outputs_->size() < bytes) {
        Result<gpu::Buffer> made = gpu::Buffer::create(bytes, GL_STREAM_COPY);
        append(problems_, std::move(made.diagnostics));
        if (!made) return false;
        outputs_ = std::move(*made);
    }
    setOwnUniform(built, "glibra_Wide", 0);
    outputs_->bindBase(GL_TRANSFORM_FEEDBACK_BUFFER, 0);
    // WebGL writes into no buffer that is bound for something else, too.
    glBindBuffer(GL_COPY_READ_BUFFER, 0);
    glBindBuffer(GL_COPY_WRITE_BUFFER, 0);
    glEnable(GL_RASTERIZER_DISCARD);
    glBeginTransformFeedback(GL_POINTS);
    glDrawArraysInstanced(GL_POINTS, 0, static_cast<GLsizei>(ends.vertices), instances);
    glEndTransformFeedback();
    glDisable(GL_RASTERIZER_DISCARD);
    glBindBufferBase(GL_TRANSFORM_FEEDBACK_BUFFER, 0, 0);
    return true;
}

bool LineWidener::draw(const Look& look, const Lines& lines) {
    const BuiltProgram& built = *look.built;
    Ends& ends = ends_[look.draw];
    list(ends, lines);
    if (ends.pairs == 0 || lines.instances <= 0) return true;
    const auto components = static_cast<std::uint64_t>(built.interface.facts.wideLines.components);
    const std::size_t listed = endRowsOf(ends.vertexPairs.size());
    const std::size_t captured = endRowsOf(static_cast<std::uint64_t>(ends.vertices) *
                                           static_cast<std::uint64_t>(lines.instances) * components);
    // Numbers of texels are ints in the shader.
    const auto most = std::min<std::size_t>(
        static_cast<std::size_t>(gpu::largestSide(capabilities_, gpu::TextureShape::texture2D)),
        std::numeric_limits<int>::max() / kEndsInRow);
    if (listed + captured > most || ends.pairs > std::numeric_limits<int>::max() / lines.instances) {
        if (!std::exchange(isReported_, true))
            problems_.push_back(
                diagnose("draw-W04", "LineWidth limited, because the lines have too many vertices"));
        return false;
    }
    const auto rows = static_cast<int>(listed + captured);
    if (!ends.texture || ends.texture->size().height < rows) {
        ends.isFilled = false;
        const bool isMade = makeTexture(ends.texture, rows);
        if (look.bindAgain) look.bindAgain();
        if (!isMade) return false;
    }
    if (!capture(ends, built, lines.instances, captured)) return false;
    bindings_.bind(*ends.texture, unit());
    glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit()));
    const auto upload = [](std::size_t row, std::size_t count, const void* from) {
        glTexSubImage2D(GL_TEXTURE_2D, 0, 0, static_cast<GLint>(row), glsl::kEndsWidth,
                        static_cast<GLsizei>(count), GL_RED_INTEGER, GL_UNSIGNED_INT, from);
    };
    glBindBuffer(GL_PIXEL_UNPACK_BUFFER, 0);
    if (!std::exchange(ends.isFilled, true)) upload(0, listed, ends.vertexPairs.data());
    outputs_->bind(GL_PIXEL_UNPACK_BUFFER);
    upload(listed, captured, nullptr);
    glBindBuffer(GL_PIXEL_UNPACK_BUFFER, 0);

    setLineLook(look);
    setOwnUniform(built, "glibra_Pairs", ends.pairs);
    setOwnUniform(built, "glibra_Vertices", static_cast<double>(ends.vertices));
    if (!noInputs_) noInputs_.emplace(std::span<const gpu::AttributeSource>());
    bindings_.bind(*noInputs_);
    // WebGL compares the types of inputs that are not read, too.
    const int corners = std::max(1, built.interface.facts.expanded.corners);
    for (const base::ActiveInput& each : built.interface.inputs)
        for (int i = 0; i < corners && each.location >= 0 && each.type.base != base::BaseType::floating; ++i)
            gpu::setConstantAttribute(static_cast<GLuint>(each.location + i), each.type, {0, 0, 0, 1});
    glDrawArraysInstanced(GL_TRIANGLES, 0, 6, ends.pairs * lines.instances);
    bindings_.bind(*look.vertices);
    setOwnUniform(built, "glibra_Wide", 0);
    return true;
}

}  // namespace glibra::render
