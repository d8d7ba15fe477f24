// A picture on a surface in diffuse light, with a little from everywhere.
#version 410 core

uniform sampler2D uImage;
uniform vec3 uLamp;         // in the world
uniform float uAmbient;     // 1 for what shines by itself

in vec3 vPlace, vNormal;
in vec2 vST;
out vec4 fColor;

void main() {
    float diffuse = max(dot(normalize(vNormal), normalize(uLamp - vPlace)), 0.);
    fColor = vec4(min(uAmbient + diffuse, 1.) * texture(uImage, vST).rgb, 1.);
}
