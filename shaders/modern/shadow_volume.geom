// G8.V Shadow volume: the part of a solid that the light does not reach, extended away from the light without end. The
// volume is closed: it begins at the triangles that face away from the light and ends with the same ones at infinity; the
// sides stand on the edges between them and the triangles that face the light.
#version 430 core

layout(triangles_adjacency) in;
layout(triangle_strip, max_vertices = 18) out;

uniform mat4 v_matrix, p_matrix;
uniform vec3 uLight;

vec3 corner(int i) {
    return gl_in[i].gl_Position.xyz;
}

bool facesLight(int a, int b, int c) {
    vec3 normal = cross(corner(b) - corner(a), corner(c) - corner(a));
    return dot(normal, uLight - corner(a)) > 0.;
}

void emitNear(int i) {
    gl_Position = p_matrix * v_matrix * vec4(corner(i), 1.);
    EmitVertex();
}

void emitFar(int i) {
    gl_Position = p_matrix * v_matrix * vec4(corner(i) - uLight, 0.);
    EmitVertex();
}

void main() {
    if (facesLight(0, 2, 4)) return;

    emitNear(0);
    emitNear(4);
    emitNear(2);
    EndPrimitive();
    emitFar(0);
    emitFar(2);
    emitFar(4);
    EndPrimitive();

    // Vertex i + 1 is the far corner of the neighbour across the edge from i to i + 2.
    for (int i = 0; i < 6; i += 2) {
        int next = (i + 2) % 6;
        if (!facesLight(i, i + 1, next)) continue;
        emitNear(i);
        emitNear(next);
        emitFar(i);
        emitFar(next);
        EndPrimitive();
    }
}
