// R31 One far light on everything that the first pass has seen.
#version 330 core

uniform sampler2D uPaints, uNormals;
uniform vec3 uToSun;      // eye space

in vec2 vST;
out vec4 fColor;

void main() {
    vec4 paint = texture(uPaints, vST), normal = texture(uNormals, vST);
    float sun = max(dot(normal.xyz, normalize(uToSun)), 0.);
    fColor = vec4(paint.a > 0. ? paint.rgb * (.3 + .8 * sun) : vec3(.55, .68, .85), 1.);
}
