// The normal in eye space; alpha 1 where there is a surface.
#version 430 core

in vec3 vNormal;
out vec4 fNormal;

void main() {
    fNormal = vec4(normalize(vNormal), 1.);
}
