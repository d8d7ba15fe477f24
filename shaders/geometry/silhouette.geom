// SH077 Silhouettes: draws an edge when the triangle faces the eye and the one across the edge does not.
// Facing is the sign of normal . line of sight, which also holds in perspective.
#version 330
#extension GL_EXT_geometry_shader4 : enable

layout(triangles_adjacency) in;
layout(line_strip, max_vertices = 6) out;

uniform mat4 uProjectionMatrix;

bool facesEye(vec3 a, vec3 b, vec3 c) {
    return dot(cross(b - a, c - a), a) < 0.;
}

// Moved toward the eye along the line of sight: the same place in the picture, but in front of the body.
void emitPoint(vec4 position) {
    gl_Position = uProjectionMatrix * vec4(.997 * position.xyz, 1.);
    EmitVertex();
}

void main() {
    vec3 v0 = gl_PositionIn[0].xyz, v2 = gl_PositionIn[2].xyz, v4 = gl_PositionIn[4].xyz;
    if (!facesEye(v0, v2, v4)) return;
    for (int i = 0; i < 6; i += 2) {
        int j = (i + 2) % 6;
        // The neighbour traverses the edge in the other direction.
        if (facesEye(gl_PositionIn[j].xyz, gl_PositionIn[i].xyz, gl_PositionIn[i + 1].xyz)) continue;
        emitPoint(gl_PositionIn[i]);
        emitPoint(gl_PositionIn[j]);
        EndPrimitive();
    }
}
