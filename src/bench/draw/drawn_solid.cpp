#include "bench/draw/drawn_solid.h"

#include <algorithm>
#include <span>
#include <string_view>
#include <vector>

#include "bench/draw/offscreen.h"
#include "gpu/object/buffer.h"
#include "gpu/object/framebuffer.h"
#include "gpu/object/program.h"
#include "gpu/object/readback.h"
#include "gpu/object/vertex_array.h"

namespace glibra::bench {
namespace {

constexpr std::string_view kSolidVertex = R"(layout(location = 0) in vec3 aPosition;
uniform float uScale;
void main() { gl_Position = vec4(aPosition.xy * uScale, 0., 1.); }
)";
constexpr std::string_view kSolidFragment = R"(out vec4 fColor;
void main() { fColor = vec4(1); }
)";

Diagnostics uploadAndDraw(const geometry::Mesh& mesh, const gpu::Program& program) {
    const Result<gpu::Buffer> positions =
        gpu::Buffer::create(std::as_bytes(std::span(mesh.attribute(geometry::kPosition)->values)));
    const Result<gpu::Buffer> indices = gpu::Buffer::create(std::as_bytes(std::span(mesh.indices)));
    if (!positions) return positions.diagnostics;
    if (!indices) return indices.diagnostics;
    const gpu::AttributeSource source{.buffer = &*positions, .location = 0, .components = 3};
    const gpu::VertexArray array(std::span(&source, 1), &*indices);
    array.bind();
    program.use();
    glDrawElements(GL_TRIANGLES, static_cast<GLsizei>(mesh.indices.size()), GL_UNSIGNED_INT, nullptr);
    glFinish();
    return {};
}

}  // namespace

Result<DrawnMesh> drawMesh(Bench& bench, const geometry::Mesh& mesh, int side, double radius) {
    const Result<gpu::Context*> context = bench.context();
    if (!context) return context.diagnostics;
    const gpu::Capabilities& capabilities = (*context)->capabilities();
    const Result<gpu::Program> drawing = program(capabilities, kSolidVertex, kSolidFragment);
    if (!drawing) return drawing.diagnostics;
    setFloats(*drawing, "uScale", {static_cast<float>(2 * radius / side)});
    const Result<gpu::Target> target = gpu::Target::window(capabilities, side, side, gpu::TexelFormat::rgba8);
    if (!target) return target.diagnostics;
    target->bind();
    target->clearColor(0, {0, 0, 0, 0});

    Diagnostics problems = uploadAndDraw(mesh, *drawing);
    const Result<std::vector<std::byte>> pixels =
        gpu::readPixels(capabilities, target->readable(), 0, {0, 0, side, side}, {1, gpu::TexelType::u8});
    append(problems, pixels.diagnostics);
    if (hasError(problems)) return problems;
    DrawnMesh drawn;
    drawn.area = static_cast<double>(std::ranges::count(*pixels, std::byte{255}));
    drawn.time = bench.time([&] { uploadAndDraw(mesh, *drawing); });
    return drawn;
}

}  // namespace glibra::bench
