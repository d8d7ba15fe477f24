// Tutorial: lit.vert, moved by uOrbit and then turned about the y axis uTurns times per period of Timer.
#version 330 core

uniform float uTurns;   // per period
uniform vec3 uOrbit;    // from the axis, model space

out vec3 vPosition;   // eye space
out vec3 vNormal;     // eye space
out vec4 vColor;
out vec2 vST;
out vec3 vModel;      // model space, before the turn

vec3 turned(vec3 v, float angle) {
    float c = cos(angle), s = sin(angle);
    return vec3(c * v.x + s * v.z, v.y, c * v.z - s * v.x);
}

void main() {
    float angle = 6.2831853 * uTurns * Timer;
    vec4 place = vec4(turned(aVertex.xyz + uOrbit, angle), 1.);
    vPosition = vec3(uModelViewMatrix * place);
    vNormal = uNormalMatrix * turned(aNormal, angle);
    vColor = aColor;
    vST = aTexCoord0.st;
    vModel = aVertex.xyz;
    gl_Position = uModelViewProjectionMatrix * place;
}
