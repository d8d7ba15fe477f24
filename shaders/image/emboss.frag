// SH055 Emboss: the largest change of a channel toward the diagonal neighbour, added to a middle grey.
#version 330 core

uniform bool uColored;
uniform sampler2D uImageUnit;

in vec2 vST;

out vec4 fColor;

void main() {
    vec2 step = 1.4 / vec2(textureSize(uImageUnit, 0));
    vec3 here = texture(uImageUnit, vST).rgb;
    vec3 change = here - texture(uImageUnit, vST + vec2(-step.s, step.t)).rgb;

    vec3 size = abs(change);
    float largest = size.r >= size.g && size.r >= size.b ? change.r : (size.g >= size.b ? change.g : change.b);
    float grey = clamp(.5 + largest, 0., 1.);
    fColor = vec4(uColored ? here * (.4 + 1.2 * grey) : vec3(grey), 1.);
}
