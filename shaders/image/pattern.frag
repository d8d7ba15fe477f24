// EX11.17 A pattern that controls a transition: dark places change first.
#version 330 core

uniform int uPattern;       // clock, iris, blinds, diamonds, noise

in vec2 vST;

out vec4 fColor;

void main() {
    vec2 xy = vST - .5;
    float value;
    if (uPattern == 0) value = atan(-xy.x, -xy.y) / 6.2831853 + .5;
    else if (uPattern == 1) value = length(xy) / .7072;
    else if (uPattern == 2) value = fract(8. * vST.t);
    else if (uPattern == 3) value = dot(abs(fract(6. * vST) - .5), vec2(.9)) + .1 * vST.s;
    else value = (dot(texture(Noise3, vec3(vST, .2)), vec4(1.)) - 1.7) / .6;
    fColor = vec4(vec3(clamp(value, 0., 1.)), 1.);
}
