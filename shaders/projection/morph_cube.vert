// SH126 Morph: each vertex moves in a straight line from its place to the cube -2..2 around the middle of the model.
#version 330 core

uniform float uBlend;

out vec3 vPosition;   // eye space

const vec3 kMiddle = vec3(-.3, 1.2, 0.);

void main() {
    vec3 fromMiddle = aVertex.xyz - kMiddle;
    float distance = max(length(fromMiddle), 1e-6);
    vec3 onCube = clamp(4. * fromMiddle / distance, -2., 2.);
    vec4 place = vec4(mix(fromMiddle, onCube, uBlend), 1.);
    vPosition = vec3(uModelViewMatrix * place);
    gl_Position = uModelViewProjectionMatrix * place;
}
