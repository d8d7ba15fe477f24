// Gives each vertex its number, for the stages after it.
flat out int vNumber;
void main() {
    vNumber = gl_VertexID;
    gl_Position = vec4(0.);
}
