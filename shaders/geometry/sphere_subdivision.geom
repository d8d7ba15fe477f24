// SH076 Sphere subdivision: 2^uLevel strips over V0 + s V01 + t V02, with every point pushed to the sphere.
#version 330
#extension GL_EXT_geometry_shader4 : enable

layout(triangles) in;
layout(triangle_strip, max_vertices = 80) out;

uniform int uLevel;     // 0..3; level 3 emits 80 vertices
uniform float uRadius;
uniform mat4 uModelViewMatrix;
uniform mat4 uProjectionMatrix;
uniform mat3 uNormalMatrix;

in vec4 vColor[3];

out vec3 gColor;

const vec3 kLight = vec3(-4., 6., 4.);   // eye space

void emitPoint(vec3 corner, vec3 alongS, vec3 alongT, float s, float t) {
    vec3 normal = normalize(corner + s * alongS + t * alongT);
    vec4 position = uModelViewMatrix * vec4(uRadius * normal, 1.);
    float light = dot(normalize(uNormalMatrix * normal), normalize(kLight - position.xyz));
    gColor = (.25 + .75 * max(light, 0.)) * vColor[0].rgb;
    gl_Position = uProjectionMatrix * position;
    EmitVertex();
}

void main() {
    vec3 corner = gl_PositionIn[0].xyz;
    vec3 alongS = gl_PositionIn[1].xyz - corner;
    vec3 alongT = gl_PositionIn[2].xyz - corner;
    int rows = 1 << clamp(uLevel, 0, 3);
    for (int row = 0; row < rows; ++row) {
        float low = float(row) / float(rows), high = float(row + 1) / float(rows);
        int columns = rows - row;
        for (int i = 0; i <= columns; ++i) {
            emitPoint(corner, alongS, alongT, (1. - low) * float(i) / float(columns), low);
            if (i < columns) {
                float s = columns > 1 ? (1. - high) * float(i) / float(columns - 1) : 0.;
                emitPoint(corner, alongS, alongT, s, high);
            }
        }
        EndPrimitive();
    }
}
