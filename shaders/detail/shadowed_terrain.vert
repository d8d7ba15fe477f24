// Gx10.4 A grid that a height map raises, with its place in the shadow map.
#version 410 core

uniform mat4 m_matrix, v_matrix, p_matrix, uToSun;
uniform sampler2D uHeights;
uniform float uHeight;

in vec3 vertPos;
in vec2 tc;
out vec2 vST;
out vec4 vSunPlace;

void main() {
    vec4 raised = vec4(vertPos + vec3(0., uHeight * textureLod(uHeights, tc, 0.).r, 0.), 1.);
    vST = tc;
    vSunPlace = uToSun * raised;
    gl_Position = p_matrix * v_matrix * m_matrix * raised;
}
