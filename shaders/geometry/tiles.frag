// New solids: a chequered pattern that shows the texture coordinates, in diffuse light.
#version 330 core

uniform vec3 uColor;
uniform vec2 uTiles;   // pairs of squares per unit of s and of t

in vec3 vNormal;
in vec2 vST;

out vec4 fColor;

const vec3 kToLight = normalize(vec3(-.35, .8, .55));   // eye space

// The mean of the square wave that is 0, 1, 0, 1 ... on steps of 1/2, over `width` around x (Heckbert 1989).
float squareWave(float x, float width) {
    vec2 ends = x + .5 * width * vec2(-1., 1.);
    vec2 areas = .5 * floor(ends) + max(fract(ends) - .5, 0.);
    return (areas.y - areas.x) / width;
}

void main() {
    vec2 place = vST * uTiles;
    vec2 width = max(fwidth(place), 1e-4);
    float a = squareWave(place.x, width.x), b = squareWave(place.y, width.y);
    float dark = a + b - 2. * a * b;
    float light = .3 + .7 * max(dot(normalize(vNormal), kToLight), 0.);
    fColor = vec4(light * mix(uColor, .45 * uColor, dark), 1.);
}
