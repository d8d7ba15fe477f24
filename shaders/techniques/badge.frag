// R13 A badge: a yellow and blue ring around a star, transparent outside.
#version 330 core

in vec2 vST;
out vec4 fColor;

void main() {
    vec2 p = 2. * vST - 1.;
    float r = length(p), angle = atan(p.x, p.y);
    float soft = .02;
    float from = abs(mod(angle + radians(36.), radians(72.)) - radians(36.));   // the angle to the nearest point of the star
    float star = r * sin(radians(18.) + from) / sin(radians(18.));   // the length that this side of the star has at its point
    float inside = 1. - smoothstep(.55 - soft, .55 + soft, star);
    float ring = smoothstep(.6 - soft, .6 + soft, r) - smoothstep(.85 - soft, .85 + soft, r);
    vec3 color = mix(vec3(.1, .3, .75), vec3(1., .8, .1), step(.5, fract(angle * 12. / radians(360.))));
    color = mix(color, vec3(.9, .95, 1.), inside);
    fColor = vec4(color, max(ring, inside));
}
