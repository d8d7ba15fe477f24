// Transparency lists: sorts the list of a pixel, the farthest first, and blends it over the background.
#version 430 core
#include "glass_node.glsl"

layout(r32ui) uniform readonly uimage2D uHeads;
layout(std430) readonly buffer Fragments { Node nodes[]; };
uniform vec3 uBackground;
uniform bool uSorted;

out vec4 fColor;

const int kMost = 24;

void main() {
    Node list[kMost];
    int count = 0;
    for (uint i = imageLoad(uHeads, ivec2(gl_FragCoord.xy)).r; i != 0u && count < kMost; i = nodes[i].next) {
        // Insertion: farther ones stay in front of it.
        Node node = nodes[i];
        int at = count++;
        for (; uSorted && at > 0 && list[at - 1].depth < node.depth; --at) list[at] = list[at - 1];
        list[at] = node;
    }
    vec3 color = uBackground;
    for (int i = 0; i < count; ++i) color = mix(color, list[i].color.rgb, list[i].color.a);
    fColor = vec4(color, 1.);
}
