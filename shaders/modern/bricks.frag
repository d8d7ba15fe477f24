// G5.1 Brick recipe: a picture of a brick wall that repeats without a seam if the number of rows is even. Each brick has
// its own shade, and all of it a fine grain.
#version 430 core

uniform vec2 uBricks;       // columns and rows
uniform vec4 uBrick, uMortar;
uniform float uJoint;       // width of the joints, as a part of the height of a row

in vec2 vST;
out vec4 fColor;

float random(vec2 cell) {
    uvec2 n = uvec2(ivec2(cell)) * uvec2(1597334673u, 3812015801u);
    uint h = (n.x ^ n.y) * 1597334673u;
    return float((h ^ (h >> 15)) & 0xffffu) / 65535.;
}

void main() {
    vec2 p = vST * uBricks;
    if (mod(floor(p.y), 2.) == 1.) p.x += .5;
    vec2 brick = mod(floor(p), uBricks), inside = fract(p);

    // Distances to the nearest joint, in heights of a row; a brick is twice as long as high.
    vec2 edge = min(inside, 1. - inside) * vec2(2., 1.);
    float isBrick = smoothstep(.5 * uJoint, .5 * uJoint + .06, min(edge.x, edge.y));

    float shade = .75 + .3 * random(brick);
    float grain = .9 + .2 * random(floor(vST * 256.) + 512.);
    fColor = vec4(grain * mix(uMortar.rgb, shade * uBrick.rgb, isBrick), 1.);
}
