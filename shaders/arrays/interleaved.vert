// V01 One array: six numbers per vertex, the colour and then the place, 24 bytes from vertex to vertex.
#version 330

uniform samplerBuffer uMixed;

out vec3 vColor;

float number(int k) {
    return texelFetch(uMixed, 6 * gl_VertexID + k).r;
}

void main() {
    vColor = vec3(number(0), number(1), number(2));
    gl_Position = vec4(vec2(number(3), number(4)) / 150. - 1., number(5), 1.);
}
