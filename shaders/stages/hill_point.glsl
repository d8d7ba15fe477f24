// The evaluation stage of hills, but for the layout.
#include "hills.glsl"

uniform mat4 m_matrix, vp_matrix;

out vec3 vPlace;

void hillPoint() {
    vec2 at = gl_TessCoord.xy;
    vec3 place = mix(mix(gl_in[0].gl_Position.xyz, gl_in[1].gl_Position.xyz, at.x),
                     mix(gl_in[2].gl_Position.xyz, gl_in[3].gl_Position.xyz, at.x), at.y);
    place.y = hillHeight(place.xz);
    vPlace = vec3(m_matrix * vec4(place, 1.));
    gl_Position = vp_matrix * vec4(vPlace, 1.);
}
