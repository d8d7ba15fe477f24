// SH098 Cutting plane: the slider replaces z.
#version 330 core

uniform float uZ;

out vec3 vModel;

void main() {
    vModel = vec3(aVertex.xy, uZ);
    gl_Position = uModelViewProjectionMatrix * vec4(vModel, 1.);
}
