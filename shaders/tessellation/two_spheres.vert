// EX13.5 Two spheres: the corners of the eight octants, three by three; the sign of x, y, z is a bit of the number.
#version 400 core

void main() {
    int octant = gl_VertexID / 3, corner = gl_VertexID % 3;
    vec3 point = vec3(corner == 0, corner == 1, corner == 2);
    vec3 signs = 1. - 2. * vec3(octant & 1, (octant >> 1) & 1, octant >> 2);
    gl_Position = vec4(signs * point, 1.);
}
