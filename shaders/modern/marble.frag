// G14.5 Marble: the solid texture with Phong shading.
#version 430 core
#include "lighting.glsl"

uniform sampler3D uMarble;
uniform vec3 cameraPosition;

in vec3 vPlace, vNormal, vTexCoord;
out vec4 fColor;

void main() {
    vec3 normal = normalize(vNormal);
    vec3 toLight = normalize(light.position - vPlace), toEye = normalize(cameraPosition - vPlace);
    vec3 color = texture(uMarble, vTexCoord).rgb;
    fColor = vec4(.7 * color * (ambientLight() + diffuseLight(normal, toLight)) +
                  .5 * specularLight(normal, toLight, toEye), 1.);
}
