// D07 Enneper's surface: position and normal at the parameters (u, v) of a grid vertex.
#version 330 core

uniform float uSize;   // u and v run from -uSize to uSize

out vec2 vUV;
out vec3 vPosition;   // eye space
out vec3 vNormal;     // eye space

void main() {
    float u = uSize * aVertex.x, v = uSize * aVertex.y;
    vec3 point = vec3(u - u * u * u / 3. + u * v * v, -v - u * u * v + v * v * v / 3., u * u - v * v);
    vec3 alongU = vec3(1. - u * u + v * v, -2. * u * v, 2. * u);
    vec3 alongV = vec3(2. * u * v, -1. - u * u + v * v, -2. * v);
    vUV = vec2(u, v);
    vPosition = vec3(uModelViewMatrix * vec4(point, 1.));
    vNormal = uNormalMatrix * cross(alongU, alongV);
    gl_Position = uModelViewProjectionMatrix * vec4(point, 1.);
}
