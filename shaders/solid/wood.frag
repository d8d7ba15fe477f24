// G14.6 Wood: half the light on a surface, half the solid texture.
#version 410 core
#include "modern/lighting.glsl"
#include "wood.glsl"

uniform vec3 cameraPosition;
uniform float uPower;

in vec3 vPlace, vNormal, vTexCoord;
out vec4 fColor;

void main() {
    vec3 normal = normalize(vNormal);
    vec3 toLight = normalize(light.position - vPlace), toEye = normalize(cameraPosition - vPlace);
    vec3 lit = ambientLight() + diffuseLight(normal, toLight) + specularLight(normal, toLight, toEye);
    fColor = vec4(.5 * lit + .5 * woodColor(vTexCoord, uPower), 1.);
}
