// A flat grid of two parameters. Exercise: Enneper's surface.
#version 330 core

uniform float uSize;   // u and v run from -uSize to uSize

out vec2 vUV;
out vec3 vPosition;   // eye space
out vec3 vNormal;     // eye space

void main() {
    float u = uSize * aVertex.x, v = uSize * aVertex.y;
    vec3 point = vec3(u, v, 0.);                     // Change this,
    vec3 normal = vec3(0., 0., 1.);                  // and this.
    vUV = vec2(u, v);
    vPosition = vec3(uModelViewMatrix * vec4(point, 1.));
    vNormal = uNormalMatrix * normal;
    gl_Position = uModelViewProjectionMatrix * vec4(point, 1.);
}
