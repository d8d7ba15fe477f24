// Exercise EX12.1: edges between a triangle that faces the eye and one that does not.
#version 330 core

layout(triangles_adjacency) in;
layout(line_strip, max_vertices = 6) out;

uniform int uBy;   // 0: direction, 1: primitive

out vec3 gColor;

bool facesEye(vec3 a, vec3 b, vec3 c) {
    return dot(cross(b - a, c - a), a) < 0.;
}

// A colour for h = 0..1, all hues once.
vec3 hue(float h) {
    return clamp(abs(fract(h + vec3(0., 2. / 3., 1. / 3.)) * 6. - 3.) - 1., 0., 1.);
}

void emitPoint(vec4 position, vec3 color) {
    gColor = color;
    gl_Position = uProjectionMatrix * vec4(.997 * position.xyz, 1.);
    EmitVertex();
}

void main() {
    if (!facesEye(gl_in[0].gl_Position.xyz, gl_in[2].gl_Position.xyz, gl_in[4].gl_Position.xyz)) return;
    for (int i = 0; i < 6; i += 2) {
        int j = (i + 2) % 6;
        if (facesEye(gl_in[j].gl_Position.xyz, gl_in[i].gl_Position.xyz, gl_in[i + 1].gl_Position.xyz)) continue;
        float h = uBy == 0 ? .1 : .6;   // <- write this
        vec3 color = .25 + .75 * hue(h);
        emitPoint(gl_in[i].gl_Position, color);
        emitPoint(gl_in[j].gl_Position, color);
        EndPrimitive();
    }
}
