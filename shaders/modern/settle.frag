// Temperatures between the points, as colours with lines of equal temperature.
#version 430 core

const int SIDE = 48;

layout(std430) readonly buffer Plate { float plate[]; };
in vec2 vST;
out vec4 fColor;

float at(ivec2 p) {
    p = clamp(p, ivec2(0), ivec2(SIDE - 1));
    return plate[SIDE * p.y + p.x];
}

void main() {
    vec2 place = vST * float(SIDE - 1);
    ivec2 p = ivec2(floor(place));
    vec2 f = fract(place);
    vec2 low = vec2(at(p), at(p + ivec2(1, 0))), high = vec2(at(p + ivec2(0, 1)), at(p + ivec2(1)));
    vec2 left = vec2(low.x, high.x), right = vec2(low.y, high.y);
    float t = mix(mix(low.x, low.y, f.x), mix(high.x, high.y, f.x), f.y);
    vec3 color = mix(vec3(.10, .18, .50), vec3(.95, .90, .80), smoothstep(0., .5, t));
    color = mix(color, vec3(.85, .20, .08), smoothstep(.5, 1., t));

    // From here to the next pixel, by the slopes between the points: dFdx of what comes from a buffer is not exact everywhere.
    vec2 slope = vec2(mix(right.x - left.x, right.y - left.y, f.y), mix(high.x - low.x, high.y - low.y, f.x));
    float pixel = 10. * length(slope * vec2(dFdx(place.x), dFdy(place.y)));
    float line = abs(fract(10. * t + .5) - .5) / max(pixel, 1e-6);
    fColor = vec4(mix(.55 * color, color, smoothstep(.5, 1.3, line)), 1.);
}
