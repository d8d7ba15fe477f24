// Each vertex follows the bones beside it, by weights that fall with the distance along y.
#version 430 core

uniform mat4 mvp;
uniform mat3 normalMatrix;
uniform mat4 uBones[4];

in vec3 vertPos, vertNormal;
out vec3 vNormal;
out vec4 vWeights;

void main() {
    vWeights = max(1. - abs(vec4(.5, 1.5, 2.5, 3.5) - clamp(vertPos.y, .5, 3.5)), 0.);
    mat4 skin = mat4(0.);
    for (int i = 0; i < 4; ++i) skin += vWeights[i] * uBones[i];
    vNormal = normalMatrix * mat3(skin) * vertNormal;
    gl_Position = mvp * skin * vec4(vertPos, 1.);
}
