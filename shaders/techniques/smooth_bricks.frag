// R06 One wall with three kinds of edges: steps, soft steps as wide as a pixel, and the mean over the pixel.
#version 330 core

uniform vec3 uBrickColor, uMortarColor;
uniform vec2 uBrickSize, uBrickPct;
uniform int uMethod;    // 0 step, 1 smoothstep, 2 integral
uniform float uEdge;    // width of a soft edge in pixels

in vec3 vModel;
out vec4 fColor;

// The integral of the brick's pulse from 0 to x: 1 up to `part` of each period, then 0.
vec2 integral(vec2 x, vec2 part) { return floor(x) * part + min(fract(x), part); }

vec2 isBrick(vec2 place, vec2 width, vec2 part) {
    vec2 x = fract(place);
    if (uMethod == 0) return step(x, part);
    if (uMethod == 1) {
        vec2 edge = min(uEdge * width, .5 * min(part, 1. - part));
        vec2 begins = smoothstep(-edge, edge, x) + smoothstep(1. - edge, 1. + edge, x);
        return begins - smoothstep(part - edge, part + edge, x);
    }
    return (integral(place + .5 * width, part) - integral(place - .5 * width, part)) / width;
}

void main() {
    vec2 place = vModel.xz / uBrickSize + vec2(.37, 0.);  // no edge of a brick is in the middle
    vec2 width = max(fwidth(place), 1e-4);
    if (fract(.5 * place.y) > .5) place.x += .5;
    vec2 brick = clamp(isBrick(place, width, uBrickPct), 0., 1.);
    fColor = vec4(mix(uMortarColor, uBrickColor, brick.x * brick.y), 1.);
}
