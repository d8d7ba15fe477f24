// SH130 Explosion: a triangle becomes (n + 1)(n + 2) / 2 points, n = 2^uLevel, which leave its centroid C with the
// velocity uVelScale (v - C) and fall with uGravity.
#version 330
#extension GL_EXT_geometry_shader4 : enable
#extension GL_EXT_gpu_shader4 : enable

layout(triangles) in;
layout(points, max_vertices = 45) out;

uniform int uLevel;        // 0..3; level 3 emits 45 points
uniform float uT;          // time
uniform float uVelScale;
uniform float uGravity;    // acceleration along y; negative is down
uniform mat4 uModelViewMatrix;
uniform mat4 uProjectionMatrix;

in vec4 vColor[3];
in vec3 vNormal[3];

out vec3 gColor;

const vec3 kLight = vec3(-4., 6., 6.);   // eye space

void main() {
    vec3 v0 = gl_PositionIn[0].xyz;
    vec3 v01 = gl_PositionIn[1].xyz - v0, v02 = gl_PositionIn[2].xyz - v0;
    vec3 middle = v0 + (v01 + v02) / 3.;
    int n = 1 << clamp(uLevel, 0, 3);
    for (int i = 0; i <= n; ++i) {
        for (int j = 0; j <= n - i; ++j) {
            vec3 start = v0 + (float(j) * v01 + float(i) * v02) / float(n);
            vec3 velocity = uVelScale * (start - middle);
            vec3 place = start + velocity * uT + vec3(0., .5 * uGravity * uT * uT, 0.);
            vec4 position = uModelViewMatrix * vec4(place, 1.);
            float light = .3 + .7 * abs(dot(normalize(vNormal[0]), normalize(kLight - position.xyz)));
            gColor = light * vColor[0].rgb;
            gl_Position = uProjectionMatrix * position;
            EmitVertex();
            EndPrimitive();
        }
    }
}
