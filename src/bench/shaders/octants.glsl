// The corners of octant i of a sphere, moved so that many spheres stand in a grid.
vec3 octantSigns(int i) { return vec3(i & 1, (i >> 1) & 1, (i >> 2) & 1) * 2. - 1.; }
vec3 placed(vec3 p, int ball) {
    return vec3(vec2(ball % 8, ball / 8) * .24 - .84, 0.) + .11 * p;
}
