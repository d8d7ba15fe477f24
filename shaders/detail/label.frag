// Gx9.2 A face of a cube map with its name, to be read from inside, and a dot in the lower right corner.
#version 410 core

uniform int uFace;      // +x -x +y -y +z -z

in vec2 vST;
out vec4 fColor;

// Letters of 5 x 7 dots, a row of five bits each, from the top.
const int kX[7] = int[](17, 17, 10, 4, 10, 17, 17);
const int kY[7] = int[](17, 17, 10, 4, 4, 4, 4);
const int kZ[7] = int[](31, 1, 2, 4, 8, 16, 31);
const int kPlus[7] = int[](0, 4, 4, 31, 4, 4, 0);
const int kMinus[7] = int[](0, 0, 0, 31, 0, 0, 0);

/// The direction of a texel, by the table of OpenGL (4.6 core, 8.13).
vec3 directionOf(vec2 st) {
    vec2 c = 2. * st - 1.;
    if (uFace == 0) return vec3(1., -c.y, -c.x);
    if (uFace == 1) return vec3(-1., -c.y, c.x);
    if (uFace == 2) return vec3(c.x, 1., c.y);
    if (uFace == 3) return vec3(c.x, -1., -c.y);
    if (uFace == 4) return vec3(c.x, -c.y, 1.);
    return vec3(-c.x, -c.y, -1.);
}

bool dot5x7(int symbol, vec2 place) {
    ivec2 p = ivec2(floor(place));
    if (p.x < 0 || p.x > 4 || p.y < 0 || p.y > 6) return false;
    int row = 6 - p.y;
    int bits = kMinus[row];
    if (symbol == 0) bits = kX[row];
    if (symbol == 1) bits = kY[row];
    if (symbol == 2) bits = kZ[row];
    if (symbol == 3) bits = kPlus[row];
    return ((bits >> (4 - p.x)) & 1) == 1;
}

void main() {
    vec3 direction = directionOf(vST);
    // As a reader sees it who looks along the axis: right is forward x up.
    vec3 forward = vec3(0.), up = uFace == 2 ? vec3(0., 0., 1.) : uFace == 3 ? vec3(0., 0., -1.) : vec3(0., 1., 0.);
    forward[uFace / 2] = uFace % 2 == 0 ? 1. : -1.;
    vec2 place = vec2(dot(direction, cross(forward, up)), dot(direction, up));

    vec3 color = vec3(.12);
    color[uFace / 2] = uFace % 2 == 0 ? .85 : .45;
    vec2 grid = place * 11. + vec2(6., 3.5);
    if (dot5x7(3 + uFace % 2, grid) || dot5x7(uFace / 2, grid - vec2(6.5, 0.))) color = vec3(1., .95, .7);
    if (distance(place, vec2(.8, -.8)) < .1) color = vec3(1.);
    // A frame.
    if (max(abs(place.x), abs(place.y)) > .97) color = vec3(.02);
    fColor = vec4(color, 1.);
}
