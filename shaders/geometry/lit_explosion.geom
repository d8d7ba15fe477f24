// EX16.16 Lit explosion: a triangle becomes (n + 1)(n + 2) / 2 points, n = 2^uLevel, which leave its middle and fall. Each carries
// the normal of the surface, turned about the axis across its flight.
#version 330 core

layout(triangles) in;
layout(points, max_vertices = 45) out;

uniform int uLevel;        // 0..3
uniform float uT;
uniform float uVelScale;
uniform float uGravity;    // along y; negative is down
uniform float uTumble;     // radians in a second
uniform float uSize;       // pixels at the distance 4

in vec4 vColor[3];
in vec3 vNormal[3];        // eye space

out vec3 gColor;
out vec3 gNormal;          // eye space
out vec3 gPosition;        // eye space

vec3 turned(vec3 v, vec3 axis, float angle) {
    return mix(dot(axis, v) * axis, v, cos(angle)) + sin(angle) * cross(axis, v);
}

void main() {
    vec3 v0 = gl_in[0].gl_Position.xyz;
    vec3 v01 = gl_in[1].gl_Position.xyz - v0, v02 = gl_in[2].gl_Position.xyz - v0;
    vec3 middle = v0 + (v01 + v02) / 3.;
    int n = 1 << clamp(uLevel, 0, 3);
    for (int i = 0; i <= n; ++i)
        for (int j = 0; j <= n - i; ++j) {
            float s = float(j) / float(n), t = float(i) / float(n);
            vec3 velocity = uVelScale * (s * v01 + t * v02 + v0 - middle);
            vec3 place = v0 + s * v01 + t * v02 + velocity * uT + vec3(0., .5 * uGravity * uT * uT, 0.);
            vec3 normal = normalize(vNormal[0] + s * (vNormal[1] - vNormal[0]) + t * (vNormal[2] - vNormal[0]));
            vec3 axis = cross(normal, uNormalMatrix * velocity);
            float length2 = dot(axis, axis);
            gNormal = length2 > 1e-8 ? turned(normal, axis * inversesqrt(length2), uTumble * uT) : normal;
            gColor = vColor[0].rgb;
            vec4 position = uModelViewMatrix * vec4(place, 1.);
            gPosition = position.xyz;
            gl_PointSize = max(uSize * 4. / max(-position.z, .1), 1.);
            gl_Position = uProjectionMatrix * position;
            EmitVertex();
            EndPrimitive();
        }
}
