// V19 V20 Bumps on a sphere: the light and the eye as seen from the surface, along its tangent, bitangent and normal.
#version 110

uniform mat4 mvpMatrix;
uniform vec3 eyeInModel, lightPosition;

attribute vec4 vPosition;
attribute vec2 texCoord;
varying vec2 st;
varying vec3 toLight, toEye;

void main() {
    // The tangent goes along the circle of latitude, around the y axis. At the poles there is none; any will do.
    vec3 n = normalize(vPosition.xyz);
    vec3 around = vec3(n.z, 0., -n.x);
    vec3 t = length(around) > 1e-4 ? normalize(around) : vec3(1., 0., 0.);
    vec3 b = cross(n, t);
    vec3 l = lightPosition - vPosition.xyz, v = eyeInModel - vPosition.xyz;
    toLight = vec3(dot(l, t), dot(l, b), dot(l, n));
    toEye = vec3(dot(v, t), dot(v, b), dot(v, n));
    st = texCoord;
    gl_Position = mvpMatrix * vPosition;
}
