// SH121 Glory, the picture: a deck of clouds from above, with blue gaps.
#version 330 core

in vec2 vST;

out vec4 fColor;

float sum(vec3 place) {
    vec4 n = texture(Noise3, place);
    return n.r + n.g + n.b + n.a - 2.;
}

void main() {
    vec2 place = vec2(1.3, 2.0) * vST;
    float here = sum(vec3(place, .3)), toSun = sum(vec3(place + vec2(.02, .03), .3));
    float cover = smoothstep(-.55, .25, here);
    float light = clamp(.84 + .9 * (here - toSun) + .12 * here, .5, 1.);
    vec3 sea = mix(vec3(.16, .27, .42), vec3(.26, .38, .52), vST.t);
    fColor = vec4(mix(sea, light * vec3(.97, .96, .98), cover), 1.);
}
