// G9.3 Chrome: the sky in the direction of the reflected view. All vectors are in the world.
#version 430 core

uniform samplerCube uSky;
uniform vec3 cameraPosition;
uniform vec3 uTint;

in vec3 vPlace, vNormal;
out vec4 fColor;

void main() {
    vec3 direction = reflect(vPlace - cameraPosition, normalize(vNormal));
    // The level of detail: how many texels of a face lie between this pixel and its neighbours.
    vec3 toSky = normalize(direction) * .5 * float(textureSize(uSky, 0).x);
    vec3 across = dFdx(toSky), up = dFdy(toSky);
    float level = .5 * log2(max(max(dot(across, across), dot(up, up)), 1e-12));
    fColor = vec4(uTint * textureLod(uSky, direction, level).rgb, 1.);
}
