// G16.6 A picture of a brick wall, which repeats.
#version 330

in vec2 vST;
out vec4 fColor;

void main() {
    vec2 at = vST * vec2(4., 8.);
    if (mod(floor(at.y), 2.) > .5) at.x += .5;
    vec2 inBrick = abs(fract(at) - .5);
    float mortar = max(smoothstep(.44, .48, inBrick.x), smoothstep(.38, .46, inBrick.y));
    ivec2 brick = ivec2(floor(at)) % ivec2(4, 8);
    float shade = .85 + .15 * float((brick.x * 7 + brick.y * 5 + brick.x * brick.y) % 11) / 10.;
    fColor = vec4(mix(shade * vec3(.66, .24, .16), vec3(.75, .73, .70), mortar), 1.);
}
