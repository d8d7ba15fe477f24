// Patches are numbered over several draws.
uniform float uFirst;
out float vPatch;
void main() { vPatch = uFirst + float(gl_VertexID); gl_Position = vec4(0.); }
