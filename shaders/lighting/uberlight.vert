// R28 Places in the world and in the space of the lamp, which looks along -z.
#version 330 core

uniform mat4 uToLamp;     // from the model to the lamp

out vec3 vInLamp;
out vec3 vPosition;   // eye space
out vec3 vNormal;     // eye space

void main() {
    vInLamp = vec3(uToLamp * aVertex);
    vPosition = vec3(uModelViewMatrix * aVertex);
    vNormal = uNormalMatrix * aNormal;
    gl_Position = uModelViewProjectionMatrix * aVertex;
}
