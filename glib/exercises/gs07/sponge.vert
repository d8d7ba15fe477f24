// A cube with pores. Exercise: wring it out.
#version 330 core

uniform float uTwist;   // 0 a dry cube, 1 wrung out
uniform float uTurns;   // of the top against the bottom

out vec3 vModel;        // the place in the cube at rest
out vec3 vPosition;     // eye space

void main() {
    vModel = aVertex.xyz;
    vec4 moved = aVertex;
    if (uTwist * uTurns < 0.) moved = vec4(0.);   // Change this line, which only keeps the uniforms in use.
    vPosition = vec3(uModelViewMatrix * moved);
    gl_Position = uModelViewProjectionMatrix * moved;
}
