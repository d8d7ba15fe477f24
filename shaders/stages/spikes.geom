// G13.3 Spikes: three triangles stand on each triangle; their common corner is the mean of its corners, each moved along its
// normal.
#version 410 core
layout(triangles) in;
layout(triangle_strip, max_vertices = 9) out;

uniform mat4 vp_matrix;
uniform float uLength;

in Corner {
    vec3 place, normal;
} corners[];
out Corner {
    vec3 place, normal;
} corner;

void emit(vec3 place, vec3 normal) {
    corner.place = place;
    corner.normal = normal;
    gl_Position = vp_matrix * vec4(place, 1.);
    EmitVertex();
}

void main() {
    vec3 tip = vec3(0.);
    for (int i = 0; i < 3; ++i) tip += (corners[i].place + uLength * corners[i].normal) / 3.;
    for (int i = 0; i < 3; ++i) {
        vec3 a = corners[i].place, b = corners[(i + 1) % 3].place;
        vec3 normal = normalize(cross(b - a, tip - a));
        emit(a, normal);
        emit(b, normal);
        emit(tip, normal);
        EndPrimitive();
    }
}
