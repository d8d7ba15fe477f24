// EX13.2 Cracks: the colour of the patch, lit.
#version 400 core

uniform vec3 uColor;
uniform float uLevel;

in vec3 teNormal;
in vec2 teUV;

out vec4 fColor;

void main() {
    float light = .3 + .7 * abs(dot(normalize(teNormal), normalize(vec3(-.4, .8, .5))));
    vec2 toLine = abs(fract(teUV * uLevel + .5) - .5) / max(fwidth(teUV * uLevel), 1e-5);
    fColor = vec4(light * uColor * mix(.55, 1., smoothstep(.4, 1.4, min(toLine.x, toLine.y))), 1.);
}
