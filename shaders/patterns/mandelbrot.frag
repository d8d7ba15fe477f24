// SH031 Mandelbrot: z = z^2 + c from z = c until |z| passes a limit; the number of iterations chooses the colour.
#version 330 core

uniform int uMaxIters;
uniform float uTS;        // side of the window
uniform float uS0, uT0;   // its lower left corner
uniform float uCS;        // iterations per cycle of the colours
uniform float uLimit;
uniform vec3 uConvergeColor;
uniform vec3 uDivergeColor1, uDivergeColor2;

in vec2 vST;

out vec4 fColor;

void main() {
    vec2 c = vST * uTS + vec2(uS0, uT0);
    vec2 z = c;
    int iterations = 0;
    while (iterations < uMaxIters && dot(z, z) < uLimit * uLimit) {
        z = vec2(z.x * z.x - z.y * z.y, 2. * z.x * z.y) + c;
        ++iterations;
    }
    if (iterations == uMaxIters) {
        fColor = vec4(uConvergeColor, 1.);
        return;
    }
    // The fraction of an iteration at which |z| passed the limit makes the bands continuous.
    float smoothed = float(iterations) + 1. - log2(log(length(z)) / log(uLimit));
    float t = .5 - .5 * cos(6.2831853 * fract(max(smoothed, 0.) / uCS));
    fColor = vec4(mix(uDivergeColor1, uDivergeColor2, t), 1.);
}
