// G14.4 A model carved from a solid of two colours.
#version 410 core
#include "modern/lighting.glsl"

uniform sampler3D uSolid;
uniform vec4 uFirst, uSecond;
uniform vec3 cameraPosition;

in vec3 vPlace, vNormal, vTexCoord;
out vec4 fColor;

void main() {
    vec3 normal = normalize(vNormal);
    vec3 toLight = normalize(light.position - vPlace), toEye = normalize(cameraPosition - vPlace);
    vec3 color = mix(uFirst, uSecond, texture(uSolid, vTexCoord).r).rgb;
    fColor = vec4(color * (ambientLight() + diffuseLight(normal, toLight)) + .4 * specularLight(normal, toLight, toEye), 1.);
}
