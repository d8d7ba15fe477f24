// Subdivides octants into ROWS of strips each, which have VERTICES in all; after octants.glsl.
layout(points) in;
layout(triangle_strip, max_vertices = VERTICES) out;
flat in int vNumber[];
out vec3 vPosition;
void put(int row, int column, vec3 signs, int ball) {
    vec3 p = vec3(float(ROWS - row), float(row - column), float(column)) / float(ROWS);
    vPosition = placed(signs * normalize(p), ball);
    gl_Position = vec4(vPosition, 1.);
    EmitVertex();
}
void main() {
    vec3 signs = octantSigns(vNumber[0] % 8);
    int ball = vNumber[0] / 8;
    for (int row = 0; row < ROWS; ++row) {
        put(row + 1, 0, signs, ball);
        for (int column = 0; column <= row; ++column) {
            put(row, column, signs, ball);
            put(row + 1, column + 1, signs, ball);
        }
        EndPrimitive();
    }
}
