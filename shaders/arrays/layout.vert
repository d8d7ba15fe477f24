// V01 Two arrays: a place in pixels (integers) and a colour per vertex.
#version 330

in ivec2 aPlace;
in vec3 aColor;
out vec3 vColor;

void main() {
    vColor = aColor;
    gl_Position = vec4(vec2(aPlace) / 150. - 1., 0., 1.);
}
