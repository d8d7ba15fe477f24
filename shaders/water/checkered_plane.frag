// G15.1 Checkered plane: mod(floor(64 s) + floor(64 t), 2), where pixels see several tiles their mean.
#version 410 core

uniform float tileScale;

in vec2 vST;
out vec4 fColor;

/// The mean over a pixel of a stripe that is 1 and -1 in turn.
float stripe(float p) {
    float size = fwidth(p) + 1e-6;
    return 2. * (abs(fract((p + .5 * size) / 2.) - .5) - abs(fract((p - .5 * size) / 2.) - .5)) / size;
}

void main() {
    float light = .5 - .5 * stripe(tileScale * vST.s) * stripe(tileScale * vST.t);
    fColor = vec4(mix(vec3(.05), vec3(.95), light), 1.);
}
