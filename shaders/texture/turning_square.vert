// D12 Render to texture, second pass: rotates the square in the other direction.
#version 330 core

uniform float uStart;   // turns at time 0

out vec2 vST;

void main() {
    float angle = -6.2831853 * (uStart + Timer);
    vec4 turned = vec4(cos(angle) * aVertex.x + sin(angle) * aVertex.z, aVertex.y,
                       cos(angle) * aVertex.z - sin(angle) * aVertex.x, 1.);
    vST = aTexCoord0.st;
    gl_Position = uModelViewProjectionMatrix * turned;
}
