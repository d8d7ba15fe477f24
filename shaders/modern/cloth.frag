// Checked cloth; the normal is that of the triangle.
#version 430 core

flat in vec3 vNormal;
flat in ivec2 vSquare;
out vec4 fColor;

void main() {
    float light = .25 + .75 * abs(dot(normalize(vNormal), normalize(vec3(1., 2., 2.))));
    ivec2 check = vSquare / 4;
    vec3 color = (check.x + check.y) % 2 == 0 ? vec3(.8, .2, .25) : vec3(.95, .9, .8);
    fColor = vec4(light * color, 1.);
}
