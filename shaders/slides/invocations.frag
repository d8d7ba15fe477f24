// S15 One colour for each run.
#version 400

in vec3 gNormal;
flat in int gCopy;
out vec4 fColor;

void main() {
    vec3 color = gCopy == 0 ? vec3(.95, .55, .2) : vec3(.25, .6, .95);
    fColor = vec4(color * (.3 + .7 * max(dot(normalize(gNormal), normalize(vec3(-1., 2., 2.))), 0.)), 1.);
}
