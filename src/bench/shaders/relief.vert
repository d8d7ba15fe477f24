// A map of heights as a mesh with a vertex for each texel (MESH), or as one rectangle.
out vec2 vST;
uniform sampler2D uTexture;
void show(vec2 st, float height) {
    vST = st;
    vec2 p = 2. * st - 1.;
    gl_Position = vec4(.9 * p.x, .8 * p.y + .6 * height, .3 * p.y - height, 1.);
}
/// The place of a corner of the two triangles of a cell.
ivec2 cornerOf(int corner) {
    return ivec2(corner == 1 || corner == 2 || corner == 4 ? 1 : 0, corner == 2 || corner > 3 ? 1 : 0);
}
void main() {
#ifdef MESH
    ivec2 size = textureSize(uTexture, 0);
    int cell = gl_VertexID / 6;
    ivec2 place = ivec2(cell % (size.x - 1), cell / (size.x - 1)) + cornerOf(gl_VertexID % 6);
    show((vec2(place) + .5) / vec2(size), texelFetch(uTexture, place, 0).r);
#else
    show(vec2(cornerOf(gl_VertexID)), 0.);
#endif
}
