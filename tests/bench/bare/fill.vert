// One triangle that covers the whole target.
#version 430 core

out vec2 vST;

void main() {
    vec2 corner = vec2(gl_VertexID % 2, gl_VertexID / 2);
    vST = 2. * corner;
    gl_Position = vec4(4. * corner - 1., 0., 1.);
}
