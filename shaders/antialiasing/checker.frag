// R52 Frequency clamping: a checkerboard that goes over into its mean colour where squares become smaller than pixels.
#version 330 core

uniform bool uClamped;
uniform float uFrequency;       // squares per two units
uniform vec3 uFirst, uSecond;

in vec2 vPlace;

out vec4 fColor;

void main() {
    vec2 place = vPlace * uFrequency;
    vec2 w = fwidth(place);
    vec2 from = fract(place) - .5;
    if (!uClamped) {
        fColor = vec4(from.x * from.y > 0. ? uFirst : uSecond, 1.);
        return;
    }
    vec2 fuzz = max(w, 1e-5) * 2.;
    float widest = max(fuzz.s, fuzz.t);
    // Each factor goes from -1 to 1 over an edge as wide as the filter, at both edges of a period.
    vec2 edge = clamp(from / fuzz * 2., -1., 1.) * clamp((.5 - abs(from)) / fuzz * 2., 0., 1.);
    vec3 squares = mix(uSecond, uFirst, .5 + .5 * edge.x * edge.y);
    fColor = vec4(mix(squares, .5 * (uFirst + uSecond), smoothstep(.125, .75, widest)), 1.);
}
