// S21 point_mode: a point for each vertex of the grid, on a curved sheet.
#version 400
layout(quads, equal_spacing, point_mode) in;

uniform float uBulge, uPointSize;

out vec2 vAt;

void main() {
    vec2 at = gl_TessCoord.xy;
    vec4 below = mix(gl_in[0].gl_Position, gl_in[1].gl_Position, at.x);
    vec4 above = mix(gl_in[3].gl_Position, gl_in[2].gl_Position, at.x);
    vec4 place = mix(below, above, at.y);
    place.z += 16. * uBulge * at.x * (1. - at.x) * at.y * (1. - at.y);
    vAt = at;
    gl_PointSize = uPointSize;
    gl_Position = uModelViewProjectionMatrix * place;
}
