// S18 A square with equal_spacing.
#version 400
layout(quads, equal_spacing, ccw) in;

void main() {
    vec4 below = mix(gl_in[0].gl_Position, gl_in[1].gl_Position, gl_TessCoord.x);
    vec4 above = mix(gl_in[3].gl_Position, gl_in[2].gl_Position, gl_TessCoord.x);
    gl_Position = uModelViewProjectionMatrix * mix(below, above, gl_TessCoord.y);
}
