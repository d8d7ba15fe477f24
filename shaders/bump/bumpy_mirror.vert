// Bumpy mirror: the frame of the surface in world space.
#version 330 core

uniform mat4 uModel;   // without scaling

out vec2 vST;
out vec3 vWorld;
out vec3 vAlongS, vAlongT, vOutwards;

void main() {
    vST = aTexCoord0.st;
    vWorld = vec3(uModel * aVertex);
    vOutwards = mat3(uModel) * aNormal;
    vAlongT = mat3(uModel) * aTangent;
    vAlongS = cross(vAlongT, vOutwards);
    gl_Position = uModelViewProjectionMatrix * aVertex;
}
