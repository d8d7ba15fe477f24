#include "bench/draw/noise_shaders.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "bench/draw/offscreen.h"
#include "noise/tables.h"

namespace glibra::bench {
namespace {

constexpr std::string_view kNoiseHead =
    "in vec2 vPlace;\n"
    "uniform vec3 uCorner, uAcross, uUp;\n"
    "uniform sampler3D uNoise;\n"
    "out vec4 fColor;\n";

// Texel i stands for the place i / n; in the driver's coordinates it is at (i + 1/2) / n.
constexpr std::string_view kDriverFilter =
    "vec4 noise(vec3 place) { return texture(uNoise, place + .5 / vec3(textureSize(uNoise, 0))); }\n";

constexpr std::string_view kShaderFilter =
    "vec4 texel(ivec3 at) { return texelFetch(uNoise, at & (textureSize(uNoise, 0) - 1), 0); }\n"
    "vec4 row(ivec3 at, float x) { return mix(texel(at), texel(at + ivec3(1, 0, 0)), x); }\n"
    "vec4 plane(ivec3 at, vec2 share) {\n"
    "    return mix(row(at, share.x), row(at + ivec3(0, 1, 0), share.x), share.y);\n"
    "}\n"
    "vec4 noise(vec3 place) {\n"
    "    vec3 texels = place * vec3(textureSize(uNoise, 0)), cell = floor(texels), share = texels - cell;\n"
    "    ivec3 at = ivec3(cell);\n"
    "    return mix(plane(at, share.xy), plane(at + ivec3(0, 0, 1), share.xy), share.z);\n"
    "}\n";

constexpr std::string_view kMain =
    "void main() { fColor = noise(uCorner + vPlace.x * uAcross + vPlace.y * uUp); }\n";

// One octave; {0} is the number of cells, {1} and {2} are the permutations, {3} the gradients.
constexpr std::string_view kOctave =
    "const int kOuter{0}[{0}] = int[{0}]({1});\n"
    "const int kInner{0}[{0}] = int[{0}]({2});\n"
    "const vec3 kGradients{0}[{0}] = vec3[{0}]({3});\n"
    "float noise{0}(vec3 place) {{\n"
    "    vec3 lattice = place * {0}., cell = floor(lattice), t = lattice - cell;\n"
    "    vec3 n0 = 1. + t * t * t * (-10. + t * (15. - 6. * t)), n1 = 1. - n0;\n"
    "    vec3 g0 = t * (1. + t * t * (-6. + t * (8. - 3. * t))), g1 = t * t * t * (-4. + t * (7. - 3. * "
    "t));\n"
    "    ivec3 near = ivec3(cell);\n"
    "    float sum = .5;\n"
    "    for (int corner = 0; corner < 8; ++corner) {{\n"
    "        ivec3 step = ivec3(corner & 1, corner >> 1 & 1, corner >> 2);\n"
    "        ivec3 at = (near + step) & {4};\n"
    "        vec3 gradient = kGradients{0}[(at.x + kOuter{0}[(at.y + kInner{0}[at.z]) & {4}]) & {4}];\n"
    "        vec3 level = mix(n0, n1, vec3(step)), slope = mix(g0, g1, vec3(step));\n"
    "        sum += gradient.x * slope.x * level.y * level.z + gradient.y * level.x * slope.y * level.z\n"
    "             + gradient.z * level.x * level.y * slope.z;\n"
    "    }}\n"
    "    return sum;\n"
    "}}\n";

/// All octaves, with the tables of noise::noise3.
std::string functionText() {
    std::string text;
    for (const noise::tables::Octave3& octave : noise::tables::kOctaves3) {
        std::vector<std::string> gradients;
        for (const std::array<double, 3>& each : octave.gradients)
            gradients.push_back(fmt::format("vec3({:.4f}, {:.4f}, {:.4f})", each[0], each[1], each[2]));
        text += fmt::format(kOctave, octave.cells, fmt::join(octave.p, ", "), fmt::join(octave.q, ", "),
                            fmt::join(gradients, ", "), octave.cells - 1);
    }
    return text + "vec4 noise(vec3 p) { return vec4(noise4(p), noise8(p), noise16(p), noise32(p)); }\n";
}

std::string textOf(NoiseShader shader) {
    switch (shader) {
        case NoiseShader::driverFilter:
            return std::string(kDriverFilter);
        case NoiseShader::shaderFilter:
            return std::string(kShaderFilter);
        case NoiseShader::function:
            break;
    }
    return functionText();
}

}  // namespace

Result<NoisePicture> NoisePicture::create(const gpu::Capabilities& capabilities, NoiseShader shader,
                                          int side) {
    Result<gpu::Program> built =
        program(capabilities, kWholeTarget, std::string(kNoiseHead) + textOf(shader) + std::string(kMain));
    if (!built) return std::move(built.diagnostics);
    Result<gpu::Target> target = gpu::Target::window(capabilities, side, side, gpu::TexelFormat::rgba32f);
    if (!target) return std::move(target.diagnostics);
    NoisePicture picture(std::move(*built), std::move(*target));
    picture.capabilities_ = &capabilities;
    return picture;
}

void NoisePicture::draw(const NoisePlane& plane, const gpu::Texture* texture, gpu::Wrap wrap) const {
    const gpu::Sampler sampler(wrap);
    if (texture) {
        texture->bind(0);
        sampler.bind(0);
    }
    setInt(program_, "uNoise", 0);
    setVector(program_, "uCorner", plane.corner);
    setVector(program_, "uAcross", plane.across);
    setVector(program_, "uUp", plane.up);
    target_.bind();
    drawWhole(program_);
    glFinish();
    glBindSampler(0, 0);
}

Result<std::vector<float>> NoisePicture::pixels() const {
    return readFloats(*capabilities_, target_);
}

glm::dvec3 NoisePicture::place(const NoisePlane& plane, int column, int row) const {
    const double x = (column + .5) / side(), y = (side() - row - .5) / side();
    return plane.corner + x * plane.across + y * plane.up;
}

}  // namespace glibra::bench
