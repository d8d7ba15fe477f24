// G10.4 Height map: each vertex moves along its normal by the height that the texture has there.
#version 410 core

uniform mat4 mvp_matrix;
uniform sampler2D uHeights;
uniform float uFlatness;

in vec3 vertPos, vertNormal;
in vec2 tc;
out vec2 vST;
out float vHeight;

void main() {
    vST = tc;
    vHeight = textureLod(uHeights, tc, 0.).r;
    // The offset is a direction: its fourth component is 0.
    gl_Position = mvp_matrix * (vec4(vertPos, 1.) + vec4(vertNormal * vHeight / uFlatness, 0.));
}
