// One step of the model of Gray and Scott (1984), with the numbers of J. E. Pearson, Science 261 (1993).
#version 430 core

uniform sampler2D uLast;
uniform float uFeed, uKill;

out vec2 fSubstances;

vec2 at(int x, int y) {
    ivec2 size = textureSize(uLast, 0);
    return texelFetch(uLast, (ivec2(gl_FragCoord.xy) + ivec2(x, y) + size) % size, 0).rg;
}

void main() {
    vec2 now = at(0, 0);
    vec2 sides = at(1, 0) + at(-1, 0) + at(0, 1) + at(0, -1);
    vec2 corners = at(1, 1) + at(-1, 1) + at(1, -1) + at(-1, -1);
    vec2 spread = vec2(1., .5) * (.2 * sides + .05 * corners - now);
    float reacts = now.x * now.y * now.y;
    fSubstances = now + spread + vec2(uFeed * (1. - now.x) - reacts, reacts - (uKill + uFeed) * now.y);
}
