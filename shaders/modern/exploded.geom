// G13.1b Exploded solid: a triangle moves along the mean of the normals of its corners.
#version 430 core
layout(triangles) in;
layout(triangle_strip, max_vertices = 3) out;

uniform mat4 v_matrix, p_matrix;
uniform float uDistance;

in Corner {
    vec3 place, normal;
} corners[];
out Corner {
    vec3 place, normal;
} corner;

void main() {
    vec3 away = uDistance * normalize(corners[0].normal + corners[1].normal + corners[2].normal);
    for (int i = 0; i < 3; ++i) {
        corner.place = corners[i].place + away;
        corner.normal = corners[i].normal;
        gl_Position = p_matrix * v_matrix * vec4(corner.place, 1.);
        EmitVertex();
    }
    EndPrimitive();
}
