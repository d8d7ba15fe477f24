#include "bench/draw/shader_values.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>

#include "bench/draw/offscreen.h"
#include "gpu/object/sampler.h"

namespace glibra::bench {
namespace {

constexpr std::size_t kColumns = 64;

std::string fragmentShader(std::string_view glsl, int inputsPerValue, std::size_t rows) {
    return fmt::format(R"(uniform sampler2D uInputs;
out vec4 fColor;
vec4 given(int k) {{
    // Pixels are read back from the top row.
    return texelFetch(uInputs, ivec2(int(gl_FragCoord.x) * {} + k, {} - int(gl_FragCoord.y)), 0);
}}
{}
void main() {{ fColor = value(); }}
)",
                       inputsPerValue, rows - 1, glsl);
}

}  // namespace

Result<ShaderValues> ShaderValues::create(Bench& bench, std::string_view glsl, std::span<const Four> inputs,
                                          int inputsPerValue) {
    const Result<gpu::Context*> context = bench.context();
    if (!context) return context.diagnostics;
    const gpu::Capabilities& capabilities = (*context)->capabilities();
    const auto each = static_cast<std::size_t>(inputsPerValue);
    const std::size_t count = inputs.size() / each, rows = (count + kColumns - 1) / kColumns;

    std::vector<Four> texels(rows * kColumns * each);
    std::ranges::copy(inputs, texels.begin());
    Result<gpu::Texture> texture = gpu::Texture::create(
        capabilities, gpu::TextureShape::texture2D, gpu::TexelFormat::rgba32f,
        {static_cast<int>(kColumns * each), static_cast<int>(rows), 1},
        {.data = std::as_bytes(std::span(texels)), .components = 4, .type = gpu::TexelType::f32});
    if (!texture) return std::move(texture.diagnostics);
    Result<gpu::Program> built =
        bench::program(capabilities, kWholeTarget, fragmentShader(glsl, inputsPerValue, rows));
    if (!built) return std::move(built.diagnostics);
    Result<gpu::Target> target = gpu::Target::window(capabilities, static_cast<int>(kColumns),
                                                     static_cast<int>(rows), gpu::TexelFormat::rgba32f);
    if (!target) return std::move(target.diagnostics);
    return ShaderValues(capabilities, count, std::move(*built), std::move(*texture), std::move(*target));
}

double ShaderValues::bytes() const {
    const gpu::TextureSize size = inputs_.size();
    const double texels = static_cast<double>(size.width) * size.height;
    const double pixels = static_cast<double>(target_.width()) * target_.height();
    return (texels + pixels) * sizeof(Four);
}

void ShaderValues::compute() const {
    target_.bind();
    inputs_.bind(0);
    const gpu::Sampler nearest(gpu::SamplerState{.filter = base::Filter::nearest, .border = {}});
    nearest.bind(0);
    setInt(program_, "uInputs", 0);
    drawWhole(program_);
    glFinish();
}

Result<std::vector<Four>> ShaderValues::values() const {
    compute();
    const Result<std::vector<float>> floats = readFloats(*capabilities_, target_);
    if (!floats) return floats.diagnostics;
    std::vector<Four> values(count_);
    std::memcpy(values.data(), floats->data(), count_ * sizeof(Four));
    return values;
}

}  // namespace glibra::bench
