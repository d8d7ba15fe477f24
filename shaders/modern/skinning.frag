// Four colours by the weights of the bones, in the light of a lamp behind the eye.
#version 430 core

in vec3 vNormal;
in vec4 vWeights;
out vec4 fColor;

void main() {
    vec3 color = mat4x3(vec3(.9, .3, .2), vec3(.9, .8, .2), vec3(.3, .8, .3), vec3(.3, .4, .9)) * vWeights;
    fColor = vec4((.25 + .75 * max(dot(normalize(vNormal), normalize(vec3(1., 1., 2.))), 0.)) * color, 1.);
}
