// EX13.5 Two spheres: shrinks each triangle, and passes on how large it is beside the mean, as a power of two.
#version 400 core

layout(triangles) in;
layout(triangle_strip, max_vertices = 3) out;

uniform float uMean;     // 4 pi over the number of triangles
uniform float uShrink;

out float gSize;
out vec3 gNormal;        // eye space

void main() {
    vec3 a = gl_in[0].gl_Position.xyz, b = gl_in[1].gl_Position.xyz, c = gl_in[2].gl_Position.xyz;
    float size = log2(max(.5 * length(cross(b - a, c - a)) / uMean, 1e-4));
    vec3 centre = (a + b + c) / 3.;
    for (int i = 0; i < 3; ++i) {
        vec3 point = gl_in[i].gl_Position.xyz;
        gSize = size;
        gNormal = uNormalMatrix * point;
        gl_Position = uModelViewProjectionMatrix * vec4(mix(centre, point, uShrink), 1.);
        EmitVertex();
    }
    EndPrimitive();
}
