// EX11.20 Timed transition: Timer leads from one picture to the other, rests, and leads back.
#version 330 core

uniform int uKind;      // dissolve, replace, burn, break
uniform sampler2D uBeforeUnit, uAfterUnit;

in vec2 vST;

out vec4 fColor;

vec3 transition(float t) {
    vec3 before = texture(uBeforeUnit, vST).rgb, after = texture(uAfterUnit, vST).rgb;
    if (uKind == 0) return mix(before, after, t);
    if (uKind == 1) {
        if (vST.s < t) return textureLod(uAfterUnit, vec2(vST.s / t, vST.t), 0.).rgb;
        return textureLod(uBeforeUnit, vec2((vST.s - t) / (1. - t), vST.t), 0.).rgb;
    }
    if (uKind == 2) return dot(after, vec3(1. / 3.)) < t * 1.01 ? after : before;
    float noise = (dot(texture(Noise3, vec3(vST, .2)), vec4(1.)) - 1.7) / .6;
    return noise < t ? after : before;
}

void main() {
    // Up between .1 and .4 of the period, down between .6 and .9.
    float t = smoothstep(.1, .4, Timer) - smoothstep(.6, .9, Timer);
    fColor = vec4(transition(t), 1.);
}
