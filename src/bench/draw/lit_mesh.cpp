#include "bench/draw/lit_mesh.h"

#include <fmt/format.h>

#include <array>
#include <string>
#include <utility>

#include "bench/draw/offscreen.h"

namespace glibra::bench {
namespace {

constexpr std::string_view kModel = R"(
uniform vec3 uLight;
uniform float uExponent;
float intensity(vec3 n) {
    float facing = dot(n, uLight);
    float shine = facing > 0. ? pow(max(reflect(-uLight, n).z, 0.), uExponent) : 0.;
    return .1 + .5 * max(facing, 0.) + .4 * shine;
}
)";

constexpr std::string_view kLitVertex = R"(
layout(location = 0) in vec3 aPosition;
layout(location = 1) in vec3 aNormal;
uniform mat4 uToEye;
uniform float uScale;
out vec3 vModel;
out vec3 vNormal;
out float vIntensity;
void main() {
    vModel = aPosition;
    vNormal = mat3(uToEye) * aNormal;
    vIntensity = intensity(vNormal);
    vec3 eye = mat3(uToEye) * aPosition;
    gl_Position = vec4(eye.xy * uScale, -.5 * eye.z, 1.);
}
)";

constexpr std::string_view kLitFragment = R"(
in vec3 vModel;
in vec3 vNormal;
in float vIntensity;
uniform mat4 uToEye;
out vec4 fColor;
)";

/// GLSL that computes the intensity of a fragment.
std::string_view expression(LitSurface surface, LightingMethod method) {
    switch (method) {
        case LightingMethod::perVertex:
            return "vIntensity";
        case LightingMethod::interpolated:
            return "intensity(vNormal)";
        case LightingMethod::renormalised:
            return "intensity(normalize(vNormal))";
        case LightingMethod::analytic:
            break;
    }
    return surface == LitSurface::sphere
               ? "intensity(normalize(mat3(uToEye) * vModel))"
               : "intensity(mat3(uToEye) * normalize(vModel - vec3(normalize(vModel.xy) * uRing, 0.)))";
}

}  // namespace

Result<gpu::Program> lightingProgram(const gpu::Capabilities& capabilities, LitSurface surface,
                                     LightingMethod method, const glm::dvec3& light, double exponent) {
    Result<gpu::Program> built = program(
        capabilities, fmt::format("{}{}", kModel, kLitVertex),
        fmt::format("{}{}uniform float uRing;\nvoid main() {{\n    fColor = vec4({}, 1., 0., 1.);\n}}\n",
                    kModel, kLitFragment, expression(surface, method)));
    if (!built) return built;
    const glm::dmat3 turn = surface == LitSurface::sphere ? glm::dmat3(1) : torusRotation();
    std::array<float, 16> matrix{};
    matrix[15] = 1;
    for (std::size_t column = 0; column < 3; ++column)
        for (std::size_t row = 0; row < 3; ++row)
            matrix[4 * column + row] =
                static_cast<float>(turn[static_cast<int>(column)][static_cast<int>(row)]);
    setFloats(*built, "uToEye", matrix);
    setFloats(*built, "uScale", {static_cast<float>(1 / kSeen)});
    setFloats(*built, "uRing", {static_cast<float>(kRingRadius)});
    setFloats(*built, "uExponent", {static_cast<float>(exponent)});
    setVector(*built, "uLight", light);
    return built;
}

Result<gpu::Program> highlightProgram(const gpu::Capabilities& capabilities, Highlight model) {
    const std::string_view cosine = model == Highlight::reflection
                                        ? "reflect(-uLight, n).z"
                                        : "dot(n, normalize(uLight + vec3(0., 0., 1.)))";
    return program(capabilities, kWholeTarget,
                   fmt::format(R"(
in vec2 vPlace;
uniform vec3 uLight;
uniform float uExponent;
out vec4 fColor;
void main() {{
    vec2 p = vPlace * 2. - 1.;
    float depth = 1. - dot(p, p);
    vec3 n = vec3(p, sqrt(max(depth, 0.)));
    float shine = dot(n, uLight) > 0. ? pow(max({}, 0.), uExponent) : 0.;
    fColor = vec4(shine, depth >= 0. ? 1. : 0., 0., 1.);
}}
)",
                               cosine));
}

LitMesh::LitMesh(gpu::Buffer positions, gpu::Buffer normals, gpu::Buffer indices, int count)
    : positions_(std::move(positions)),
      normals_(std::move(normals)),
      indices_(std::move(indices)),
      array_(std::array<gpu::AttributeSource, 2>{{{.buffer = &positions_, .location = 0, .components = 3},
                                                  {.buffer = &normals_, .location = 1, .components = 3}}},
             &indices_),
      count_(count) {}

Result<LitMesh> LitMesh::create(const geometry::Mesh& mesh) {
    const auto floats = [&](std::string_view name) {
        return gpu::Buffer::create(std::as_bytes(std::span<const float>(mesh.attribute(name)->values)));
    };
    Result<gpu::Buffer> positions = floats(geometry::kPosition), normals = floats(geometry::kNormal);
    Result<gpu::Buffer> indices =
        gpu::Buffer::create(std::as_bytes(std::span<const std::uint32_t>(mesh.indices)));
    for (Result<gpu::Buffer>* each : {&positions, &normals, &indices})
        if (!*each) return std::move(each->diagnostics);
    return LitMesh(std::move(*positions), std::move(*normals), std::move(*indices),
                   static_cast<int>(mesh.indices.size()));
}

void LitMesh::draw(const gpu::Program& program, const gpu::Target& target) const {
    target.bind();
    target.clearColor(0, {0, 0, 0, 0});
    target.clearDepth();
    glEnable(GL_DEPTH_TEST);
    program.use();
    array_.bind();
    glDrawElements(GL_TRIANGLES, count_, GL_UNSIGNED_INT, nullptr);
    glDisable(GL_DEPTH_TEST);
}

double LitMesh::bytes() const {
    return static_cast<double>(positions_.size() + normals_.size() + indices_.size());
}

}  // namespace glibra::bench
