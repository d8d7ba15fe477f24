// The directions to the light and to the eye in the frame of a vertex: along s, along t, outwards.
#version 330 core

uniform vec3 uLight;   // eye space

out vec2 vST;
out vec3 vToLight, vToEye;

void main() {
    vST = aTexCoord0.st;
    vec3 position = vec3(uModelViewMatrix * aVertex);
    vec3 normal = normalize(uNormalMatrix * aNormal);
    vec3 tangent = normalize(mat3(uModelViewMatrix) * aTangent);
    mat3 toFrame = transpose(mat3(cross(tangent, normal), tangent, normal));
    vToLight = toFrame * (uLight - position);
    vToEye = toFrame * -position;
    gl_Position = uModelViewProjectionMatrix * aVertex;
}
