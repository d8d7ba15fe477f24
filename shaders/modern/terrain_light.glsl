// The light of the Moon's ground: a colour map, and normals (east, north, up) from a map.

uniform sampler2D colorMap, normalMap;
uniform vec3 uLight;

vec3 litGround(vec3 place, vec2 st) {
    vec3 mapped = 2. * texture(normalMap, st).rgb - 1.;
    vec3 normal = normalize(vec3(mapped.x, mapped.z, -mapped.y));
    return (.04 + 1.1 * max(dot(normal, normalize(uLight - place)), 0.)) * texture(colorMap, st).rgb;
}
