// A mirror that shows a cube map of what is around it.
#version 430 core

uniform samplerCube uAround;
uniform vec3 cameraPosition;

in vec3 vPlace, vNormal;
out vec4 fColor;

void main() {
    vec3 direction = reflect(vPlace - cameraPosition, normalize(vNormal));
    fColor = vec4(vec3(.93, .95, 1.) * texture(uAround, direction).rgb, 1.);
}
