// noise1 ... noise4 as GLSL (language, 7.5): gradient noise after Perlin (2002) with integer hashes, so that
// every driver gives the same values.

#include <fmt/format.h>

#include "glsl/rules/rules.h"

namespace glibra::glsl {

std::vector<std::string> noiseFunctions(unsigned wanted) {
    std::vector<std::string> lines = {
        "uint glibra_mix(uint x) {",
        "    x ^= x >> 16; x *= 0x7feb352du; x ^= x >> 15; x *= 0x846ca68bu; x ^= x >> 16;",
        "    return x;",
        "}",
        "float glibra_cornerNoise(uint h, vec4 offset, int dimension) {",
        "    vec4 g = vec4(0.);",
        "    for (int j = 0; j < dimension; ++j)",
        "        g[j] = float(glibra_mix(h + 0x9e3779b9u * uint(j)) >> 8) / 8388608. - 1.;",
        "    float size = length(g);",
        "    return dot(size < .001 ? vec4(1., 0., 0., 0.) : g / size, offset);",
        "}",
        "float glibra_latticeNoise(vec4 p, int dimension, uint component) {",
        "    vec4 cell = floor(p);",
        "    vec4 t = p - cell;",
        "    vec4 w = t * t * t * (10. + t * (6. * t - 15.));",
        "    float sum = 0.;",
        "    for (int i = 0; i < 1 << dimension; ++i) {",
        "        ivec4 corner = ivec4(i, i >> 1, i >> 2, i >> 3) & 1;",
        "        uvec4 c = uvec4(ivec4(cell) + corner);",
        "        c *= uvec4(0x8da6b343u, 0xd8163841u, 0xcb1ab31fu, 0x165667b1u);",
        "        uint h = glibra_mix(c.x ^ c.y ^ c.z ^ c.w ^ component * 0x85ebca6bu);",
        "        vec4 s = mix(1. - w, w, vec4(corner));",
        "        sum += s.x * s.y * s.z * s.w * glibra_cornerNoise(h, t - vec4(corner), dimension);",
        "    }",
        "    return 2. / sqrt(float(dimension)) * sum;",
        "}",
    };
    static constexpr const char* kParameters[] = {"float p", "vec2 p", "vec3 p", "vec4 p"};
    static constexpr const char* kPoints[] = {"vec4(p, 0., 0., 0.)", "vec4(p, 0., 0.)", "vec4(p, 0.)", "p"};
    for (int components = 1; components <= 4; ++components) {
        if ((wanted >> (components - 1) & 1U) == 0) continue;
        const std::string type = components == 1 ? "float" : "vec" + std::to_string(components);
        for (int dimension = 1; dimension <= 4; ++dimension) {
            std::string values;
            for (int k = 0; k < components; ++k)
                values += fmt::format("{}glibra_latticeNoise({}, {}, {}u)", k == 0 ? "" : ", ",
                                      kPoints[dimension - 1], dimension, k);
            lines.push_back(fmt::format("{0} glibra_noise{1}({2}) {{ return {0}({3}); }}", type, components,
                                        kParameters[dimension - 1], values));
        }
    }
    return lines;
}

}  // namespace glibra::glsl
