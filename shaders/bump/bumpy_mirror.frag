// Bumpy mirror: what the cube map shows in the direction that the bumped normal reflects.
#version 330 core

uniform samplerCube uRoom;
uniform vec3 uEye;            // world space
uniform float uBumpDensity;
uniform float uHeight;
uniform vec3 uTint;

in vec2 vST;
in vec3 vWorld;
in vec3 vAlongS, vAlongT, vOutwards;

out vec4 fColor;

void main() {
    // Smooth bumps: the slopes of sin^2 hills in s and t.
    vec2 slope = uHeight * sin(6.2831853 * uBumpDensity * vec2(2., 1.) * vST);
    vec3 outwards = normalize(vOutwards);
    vec3 alongT = normalize(vAlongT - dot(vAlongT, outwards) * outwards);
    vec3 normal = normalize(outwards + slope.s * cross(alongT, outwards) + slope.t * alongT);
    vec3 sight = normalize(vWorld - uEye);
    fColor = vec4(uTint * texture(uRoom, reflect(sight, normal)).rgb, 1.);
}
