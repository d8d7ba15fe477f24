// Checked cloth; the normal is that of the triangle.
#version 430 core

in vec3 vPlace;
in vec2 vSquare;
out vec4 fColor;

void main() {
    vec3 normal = normalize(cross(dFdx(vPlace), dFdy(vPlace)));
    float light = .25 + .75 * abs(dot(normal, normalize(vec3(1., 2., 2.))));
    vec2 check = floor(vSquare / 4.);
    vec3 color = mod(check.x + check.y, 2.) == 0. ? vec3(.8, .2, .25) : vec3(.95, .9, .8);
    fColor = vec4(light * color, 1.);
}
