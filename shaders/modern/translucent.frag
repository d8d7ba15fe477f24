// G14.2 Phong shading with alpha. Back faces are lit from their own side if uFlip is -1.
#version 430 core
#include "lighting.glsl"

uniform vec3 cameraPosition;
uniform float uAlpha = 1.;
uniform float uFlip = 1.;

in vec3 vPlace, vNormal;
out vec4 fColor;

void main() {
    vec3 normal = uFlip * normalize(vNormal);
    vec3 toLight = normalize(light.position - vPlace), toEye = normalize(cameraPosition - vPlace);
    vec3 color = ambientLight() + diffuseLight(normal, toLight) + specularLight(normal, toLight, toEye);
    fColor = vec4(color, uAlpha);
}
