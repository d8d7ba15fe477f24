// A torus of RINGS x RINGS cells, each of two triangles.
out vec3 vPosition;
void main() {
    int cell = gl_VertexID / 6, corner = gl_VertexID % 6;
    vec2 at = vec2(cell % RINGS + (corner == 1 || corner == 2 || corner == 4 ? 1 : 0),
                   cell / RINGS + (corner == 2 || corner > 3 ? 1 : 0)) * 6.283185307 / float(RINGS);
    float r = .6 + .25 * cos(at.y);
    vPosition = vec3(r * cos(at.x), r * sin(at.x), .25 * sin(at.y));
    gl_Position = vec4(vPosition, 1.);
}
