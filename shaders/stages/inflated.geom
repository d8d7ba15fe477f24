// G13.1 Inflated solid: each corner moves along its own normal, before the projection.
#version 410 core
layout(triangles) in;
layout(triangle_strip, max_vertices = 3) out;

uniform mat4 vp_matrix;
uniform float uDistance;

in Corner {
    vec3 place, normal;
} corners[];
out Corner {
    vec3 place, normal;
} corner;

void main() {
    for (int i = 0; i < 3; ++i) {
        corner.normal = normalize(corners[i].normal);
        corner.place = corners[i].place + uDistance * corner.normal;
        gl_Position = vp_matrix * vec4(corner.place, 1.);
        EmitVertex();
    }
    EndPrimitive();
}
