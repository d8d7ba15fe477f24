// G13.2 Lattice: every n-th triangle is not passed on.
#version 410 core
layout(triangles) in;
layout(triangle_strip, max_vertices = 3) out;

uniform int uEvery;

in Corner {
    vec3 place, normal;
} corners[];
out Corner {
    vec3 place, normal;
} corner;

void main() {
    if (gl_PrimitiveIDIn % uEvery == 0) return;
    for (int i = 0; i < 3; ++i) {
        corner.place = corners[i].place;
        corner.normal = corners[i].normal;
        gl_Position = gl_in[i].gl_Position;
        EmitVertex();
    }
    EndPrimitive();
}
