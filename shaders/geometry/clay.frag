// SH077 Silhouettes, the body: three tones of one colour.
#version 330 core

uniform vec3 uColor;

in vec3 vNormal;

out vec4 fColor;

const vec3 kToLight = normalize(vec3(-.4, .8, .5));   // eye space

void main() {
    float light = dot(normalize(vNormal), kToLight);
    float tone = light > .45 ? 1. : (light > -.1 ? .88 : .74);
    fColor = vec4(tone * uColor, 1.);
}
