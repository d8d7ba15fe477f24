// Spot light per vertex: inside the cone a vertex has light, outside it has none.
#version 330 core

uniform float uAngle;      // half the angle of the cone, degrees
uniform vec2 uAim;         // where the light points on the floor
uniform vec3 uColor;

out vec3 vColor;

const vec3 kLight = vec3(0., 2.6, 0.);   // above the floor, model space

void main() {
    vec3 axis = normalize(vec3(uAim.x, 0., uAim.y) - kLight);
    vec3 ray = normalize(aVertex.xyz - kLight);
    float lit = dot(axis, ray) >= cos(radians(uAngle)) ? max(-ray.y, 0.) : 0.;
    vColor = (.12 + .88 * lit) * uColor;
    gl_Position = uModelViewProjectionMatrix * aVertex;
}
