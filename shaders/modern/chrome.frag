// G9.3 Chrome: the sky in the direction of the reflected view. All vectors are in the world.
#version 430 core

uniform samplerCube uSky;
uniform vec3 cameraPosition;
uniform vec3 uTint;

in vec3 vPlace, vNormal;
out vec4 fColor;

void main() {
    vec3 direction = reflect(vPlace - cameraPosition, normalize(vNormal));
    fColor = vec4(uTint * texture(uSky, direction).rgb, 1.);
}
