// The light of the Moon's ground: a colour map, and normals (east, north, up) from a map.

#include "level_of_detail.glsl"

uniform sampler2D colorMap, normalMap;
uniform vec3 uLight;

vec3 litGround(vec3 place, vec2 st) {
    float level = levelOfDetail(st * vec2(textureSize(normalMap, 0)));
    vec3 mapped = 255. * textureLod(normalMap, st, level).rgb - 128.;
    vec3 normal = normalize(vec3(mapped.x, mapped.z, -mapped.y));
    return (.04 + 1.1 * max(dot(normal, normalize(uLight - place)), 0.)) * textureLod(colorMap, st, level).rgb;
}
