// Exercise EX16.7: the sun behind a thin veil.
#version 330 core

uniform float uView;   // from the middle of the picture to its edge, degrees

in vec2 vST;
in vec2 vXY;

out vec4 fColor;

void main() {
    float angle = degrees(atan(length(vXY) * tan(radians(uView))));
    vec4 octaves = texture(Noise3, vec3(vec2(.9, .35) * vST, .2));
    float veil = clamp(.75 + .8 * (octaves.r + octaves.g + octaves.b + octaves.a - 2.), .3, 1.);
    vec3 color = mix(vec3(.24, .40, .66), vec3(.36, .52, .75), .5 - .5 * vXY.y) + .10 * veil;
    // <- the halo
    color += .9 * exp(-angle * angle / 14.) + .25 * exp(-angle / 6.);
    fColor = vec4(min(color, 1.), 1.);
}
