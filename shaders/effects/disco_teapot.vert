// D24 Disco inside the teapot: place and normal in the world, which is the teapot's own space.
#version 330 core

uniform bool uBall;

out vec3 vPosition;
out vec3 vNormal;

void main() {
    vPosition = aVertex.xyz + (uBall ? vec3(0., .22, 0.) : vec3(0.));
    vNormal = aNormal;
    gl_Position = uModelViewProjectionMatrix * aVertex;
}
