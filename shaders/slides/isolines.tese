// S20 Lines from one side of the patch to the other, each bent and lifted by its number.
#version 400
layout(isolines, equal_spacing) in;

uniform float uBend, uPhase;

out float vLine;

void main() {
    vec2 at = gl_TessCoord.xy;
    vec4 below = mix(gl_in[0].gl_Position, gl_in[1].gl_Position, at.x);
    vec4 above = mix(gl_in[3].gl_Position, gl_in[2].gl_Position, at.x);
    vec4 place = mix(below, above, at.y);
    place.y += uBend * sin(3.1415927 * at.x) * sin(6.2831853 * (at.x + .8 * at.y) + uPhase);
    vLine = at.y;
    gl_Position = uModelViewProjectionMatrix * place;
}
