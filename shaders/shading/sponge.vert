// Sponge: wrung out by a twist about y, which also presses it flat and makes it narrower.
#version 330 core

uniform float uTwist;   // 0 a dry cube, 1 wrung out
uniform float uTurns;   // of the top against the bottom

out vec3 vModel;        // the place in the cube at rest
out vec3 vPosition;     // eye space

void main() {
    vModel = aVertex.xyz;
    float angle = 6.2831853 * uTurns * uTwist * aVertex.y * .5;
    float narrow = 1. - .3 * uTwist;                 // 30 percent
    float flattened = 1. - uTwist;                   // y goes to 0
    mat2 turn = mat2(cos(angle), sin(angle), -sin(angle), cos(angle));
    vec2 xz = narrow * (turn * aVertex.xz);
    vec4 moved = vec4(xz.x, flattened * aVertex.y, xz.y, 1.);
    vPosition = vec3(uModelViewMatrix * moved);
    gl_Position = uModelViewProjectionMatrix * moved;
}
