// D01 First pass: light, texture coordinates and the model position for the noise.
#version 330 core

out vec2 vST;
out vec3 vModel;   // model space
out vec3 vColor;

const vec3 kLight = vec3(-3., 5., 4.);   // eye space

void main() {
    vST = aTexCoord0.st;
    vModel = aVertex.xyz;
    vec3 position = vec3(uModelViewMatrix * aVertex);
    vec3 normal = normalize(uNormalMatrix * aNormal);
    vColor = (.35 + .65 * abs(dot(normal, normalize(kLight - position)))) * aColor.rgb;
    gl_Position = uModelViewProjectionMatrix * aVertex;
}
