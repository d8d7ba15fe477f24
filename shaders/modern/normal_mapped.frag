// G10.2 G10.3 G10.f15 Normal mapping: the normal comes from a texture, relative to the axes of the surface.
#version 430 core
#include "level_of_detail.glsl"

uniform sampler2D colorMap, normalMap;
uniform vec3 uLight, cameraPosition;
uniform float uShine;
uniform bool uColored;

in vec3 vPlace, vNormal, vNorth;
in vec2 vST;
out vec4 fColor;

void main() {
    // Gram and Schmidt: the interpolated tangent is made perpendicular to the normal again.
    vec3 up = normalize(vNormal);
    vec3 north = normalize(vNorth - dot(vNorth, up) * up);
    mat3 surface = mat3(cross(north, up), north, up);  // columns: east, north, up
    float level = levelOfDetail(vST * vec2(textureSize(normalMap, 0)));
    vec3 normal = normalize(surface * (255. * textureLod(normalMap, vST, level).rgb - 128.));

    vec3 toLight = normalize(uLight - vPlace), toEye = normalize(cameraPosition - vPlace);
    vec3 color = uColored ? textureLod(colorMap, vST, level).rgb : vec3(.6);
    float diffuse = max(dot(normal, toLight), 0.);
    // Where the sphere itself turns away from the light, bumps are dark, too.
    diffuse *= smoothstep(-.05, .1, dot(up, toLight));
    float specular = diffuse > 0. ? pow(max(dot(normal, normalize(toLight + toEye)), 0.), 60.) : 0.;
    fColor = vec4((.05 + diffuse) * color + uShine * specular, 1.);
}
