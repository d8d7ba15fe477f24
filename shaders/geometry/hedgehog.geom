// SH112 Hedgehog: a hair of uLength pieces grows at every lattice point of the triangle; after i pieces it has sunk
// by uDroop i^2. The normal is interpolated between the corners, without a division that could be by zero.
#version 330
#extension GL_EXT_geometry_shader4 : enable

layout(triangles) in;
layout(line_strip, max_vertices = 110) out;

uniform int uDetail;    // 1..3, which gives 3, 6 or 10 lattice points
uniform float uDroop;   // model units
uniform int uLength;    // 1..10 pieces
uniform float uStep;    // length of a piece, model units
uniform mat4 uModelViewProjectionMatrix;

in vec3 vNormal[3];

out float gAlong;   // 0 at the root, 1 at the tip
out float gLight;

void hair(vec3 root, vec3 normal, int pieces) {
    float light = .35 + .65 * clamp(dot(normal, normalize(vec3(-.1, .8, .6))) * .5 + .5, 0., 1.);
    for (int i = 0; i <= pieces; ++i) {
        vec3 point = root + float(i) * uStep * normal;
        point.y -= uDroop * float(i * i);
        gAlong = float(i) / float(pieces);
        gLight = light;
        gl_Position = uModelViewProjectionMatrix * vec4(point, 1.);
        EmitVertex();
    }
    EndPrimitive();
}

void main() {
    int n = clamp(uDetail, 1, 3);
    int pieces = clamp(uLength, 1, 10);
    for (int i = 0; i <= n; ++i) {
        for (int j = 0; j <= n - i; ++j) {
            vec3 share = vec3(n - i - j, i, j) / float(n);
            vec3 root = share.x * gl_PositionIn[0].xyz + share.y * gl_PositionIn[1].xyz +
                        share.z * gl_PositionIn[2].xyz;
            vec3 normal = share.x * vNormal[0] + share.y * vNormal[1] + share.z * vNormal[2];
            float size = length(normal);
            if (size > 0.) hair(root, normal / size, pieces);
        }
    }
}
