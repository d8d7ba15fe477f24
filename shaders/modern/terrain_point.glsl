// The evaluation stage of terrain, but for the layout.

uniform mat4 m_matrix, v_matrix, p_matrix;
uniform sampler2D heightMap;
uniform float uRelief;

in vec2 vPatchCorner[];
out vec3 vPlace;
out vec2 vST;

void terrainPoint() {
    vec2 at = gl_TessCoord.xy;
    vST = mix(mix(vPatchCorner[0], vPatchCorner[1], at.x), mix(vPatchCorner[2], vPatchCorner[3], at.x), at.y);
    vec4 flatPlace = mix(mix(gl_in[0].gl_Position, gl_in[1].gl_Position, at.x),
                         mix(gl_in[2].gl_Position, gl_in[3].gl_Position, at.x), at.y);
    flatPlace.y += uRelief * textureLod(heightMap, vST, 0.).r;
    vec4 place = m_matrix * flatPlace;
    vPlace = place.xyz;
    gl_Position = p_matrix * v_matrix * place;
}
