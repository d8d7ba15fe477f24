// Moves each point toward the distances that its eight neighbours should have (Jakobsen 2001).
#version 430 core

layout(local_size_x = 8, local_size_y = 8) in;

layout(std430) readonly buffer Last { vec4 last[]; };
layout(std430) writeonly buffer Cloth { vec4 points[]; };
uniform float uLength;  // of the sides
uniform int uSide;      // points per side

void main() {
    ivec2 place = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(place, ivec2(uSide)))) return;
    int i = place.y * uSide + place.x;
    vec3 here = last[i].xyz, pull = vec3(0.);
    for (int y = max(place.y - 1, 0); y <= min(place.y + 1, uSide - 1); ++y)
        for (int x = max(place.x - 1, 0); x <= min(place.x + 1, uSide - 1); ++x) {
            if (ivec2(x, y) == place) continue;
            float rest = uLength / float(uSide - 1) * length(vec2(ivec2(x, y) - place));
            vec3 way = last[y * uSide + x].xyz - here;
            pull += (1. - rest / max(length(way), 1e-5)) * way;
        }
    bool isPinned = place.y == 0 && (place.x == 0 || place.x == uSide - 1);
    points[i] = vec4(isPinned ? here : here + .14 * pull, 0.);
}
