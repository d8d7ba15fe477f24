// R64 Point sprites: a spiral of points whose size on the screen the shader computes from their distance.
#version 330 core

uniform int uCount;
uniform float uTime;
uniform float uRadius;          // of a ball in the world
uniform float uPixels;          // pixels of a ball of the size 1 at the distance 1

out vec3 vEye;
out vec3 vColor;

void main() {
    float t = (float(gl_VertexID) + .5) / float(uCount);
    // Equal areas on a sphere: the golden angle from point to point.
    float y = 1. - 2. * t, r = sqrt(1. - y * y);
    float angle = 2.3999632 * float(gl_VertexID) + .3 * uTime;
    vEye = (uModelViewMatrix * vec4(r * cos(angle), y, r * sin(angle), 1.)).xyz;
    vColor = .55 + .45 * cos(6.2831853 * (t + vec3(0., .33, .67)));
    gl_Position = uProjectionMatrix * vec4(vEye, 1.);
    gl_PointSize = 2. * uRadius * uPixels / gl_Position.w;
}
