// Effects of a second pass: six ways to change the picture that the first pass drew.
#version 330 core

uniform sampler2D uPicture;
uniform int uEffect;
uniform float uAmount;   // 0 the picture, 1 the effect

in vec2 vST;

out vec4 fColor;

vec3 at(vec2 place) {
    return texture(uPicture, place).rgb;
}

void main() {
    vec3 color = at(vST), changed = color;
    vec2 texel = 1. / vec2(textureSize(uPicture, 0));
    float gray = dot(color, vec3(.2125, .7154, .0721));
    if (uEffect == 0) {          // negative
        changed = 1. - color;
    } else if (uEffect == 1) {   // few colours
        changed = floor(4. * color + .5) / 4.;
    } else if (uEffect == 2) {   // large pixels
        changed = at((floor(vST * 40.) + .5) / 40.);
    } else if (uEffect == 3) {   // relief: the difference to the neighbour at the lower left
        changed = vec3(.5) + 2. * (gray - dot(at(vST - 2. * texel), vec3(.2125, .7154, .0721)));
    } else if (uEffect == 4) {   // bent by a wave
        changed = at(vST + vec2(.02 * sin(40. * vST.t), 0.));
    } else {                     // an old photograph
        vec2 fromMiddle = vST - .5;
        changed = gray * vec3(1.1, .9, .65) * (1. - 1.6 * dot(fromMiddle, fromMiddle));
    }
    fColor = vec4(mix(color, changed, uAmount), 1.);
}
