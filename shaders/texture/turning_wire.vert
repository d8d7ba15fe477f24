// D12 Render to texture, first pass: rotates the model around y, once per timer period.
#version 330 core

uniform float uStart;   // turns at time 0

out vec3 vColor;

void main() {
    float angle = 6.2831853 * (uStart + Timer);
    vec4 turned = vec4(cos(angle) * aVertex.x + sin(angle) * aVertex.z, aVertex.y,
                       cos(angle) * aVertex.z - sin(angle) * aVertex.x, 1.);
    vColor = aColor.rgb;
    gl_Position = uModelViewProjectionMatrix * turned;
}
