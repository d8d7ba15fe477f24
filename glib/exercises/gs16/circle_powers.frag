// Exercise EX16.10: circle squared in whole numbers; x and y are odd multiples of uFractions / 128.
#version 330 core

uniform int uFractions;   // side of a pixel, in 1/64

out vec4 fColor;

void main() {
    uvec2 place = uint(uFractions) * (2u * uvec2(gl_FragCoord.xy) + 1u);   // in 1/128
    uvec2 power = place * place;                                           // in 1/128^2
    uint c = (power.x + power.y) >> 14;
    if ((c & 1u) == 1u) discard;
    float hue = float(c % 360u) / 359.;
    fColor = vec4(clamp(abs(fract(hue + vec3(0., 2. / 3., 1. / 3.)) * 6. - 3.) - 1., 0., 1.), 1.);
}
