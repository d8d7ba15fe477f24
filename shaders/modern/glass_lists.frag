// Transparency lists: puts the fragment at the head of the list of its pixel.
#version 430 core
#include "glass_node.glsl"

layout(early_fragment_tests) in;
layout(r32ui) uniform uimage2D uHeads;
layout(std430) buffer Counter { uint used; };
layout(std430) buffer Fragments { Node nodes[]; };
uniform vec4 uColor;
uniform float uAlpha;

in vec3 vNormal;

void main() {
    uint mine = atomicAdd(used, 1u) + 1u;
    if (mine >= uint(nodes.length())) return;
    float light = .35 + .65 * abs(dot(normalize(vNormal), normalize(vec3(-.4, .7, .6))));
    uint next = imageAtomicExchange(uHeads, ivec2(gl_FragCoord.xy), mine);
    // With several samples per pixel, two triangles may share a pixel of their edge: each counts as far as it covers it.
    float covered = float(bitCount(gl_SampleMaskIn[0])) / float(max(gl_NumSamples, 1));
    nodes[mine] = Node(vec4(light * uColor.rgb, covered * uAlpha), gl_FragCoord.z, next);
}
