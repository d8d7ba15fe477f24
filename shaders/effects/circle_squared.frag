// SH127 Circle squared: odd integers are discarded, even ones are coloured by their remainder modulo 360.
#version 330 core

uniform float uSide;   // side of a pixel; a change of one per cent changes the whole picture

out vec4 fColor;

void main() {
    vec2 xy = uSide * gl_FragCoord.xy;
    int c = int(dot(xy, xy));
    if ((c & 1) == 1) discard;
    float hue = float(c % 360) / 359.;
    fColor = vec4(clamp(abs(fract(hue + vec3(0., 2. / 3., 1. / 3.)) * 6. - 3.) - 1., 0., 1.), 1.);
}
