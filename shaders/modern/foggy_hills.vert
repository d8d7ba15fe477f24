// G14.1 Hills: a grid that a height map raises; the place in eye space for the fog.
#version 430 core

uniform mat4 mv_matrix, p_matrix;
uniform sampler2D heightMap;
uniform float uHeight;

in vec3 vertPos;
in vec2 tc;
out vec3 vEyePlace;
out vec2 vST;

void main() {
    vec3 raised = vertPos + vec3(0., uHeight * (textureLod(heightMap, tc, 0.).r - .5), 0.);
    vec4 place = mv_matrix * vec4(raised, 1.);
    vEyePlace = place.xyz;
    vST = tc;
    gl_Position = p_matrix * place;
}
