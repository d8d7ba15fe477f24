// Dots: dots or stripes in one colour on a white ball, with diffuse light.
#version 330 core

uniform float uKd;       // strength of the diffuse light
uniform vec3 uColor;
uniform bool uStripes;   // stripes in place of dots

in vec3 vNormal;   // eye space
in vec2 vST;

out vec4 fColor;

void main() {
    vec2 cell = fract(vST * vec2(16., 8.)) - .5;
    float size = uStripes ? abs(cell.t) : length(cell);
    float edge = fwidth(size);
    vec3 surface = mix(uColor, vec3(1.), smoothstep(.3 - edge, .3 + edge, size));
    float diffuse = max(dot(normalize(vNormal), normalize(vec3(-.5, .6, .8))), 0.);
    fColor = vec4(surface * (.25 + uKd * diffuse), 1.);
}
