// G15.2 Opaque water: Phong light on a blue plane, which has a side toward the sky and one toward the floor.
#version 410 core

uniform vec3 uSun, viewPos;
uniform bool isAbove;

in vec3 vPlace;
out vec4 fColor;

void main() {
    vec3 normal = vec3(0., isAbove ? 1. : -1., 0.);
    vec3 toSun = normalize(uSun), toEye = normalize(viewPos - vPlace);
    // Seen from below, the light comes through the surface.
    float diffuse = abs(dot(normal, toSun));
    float specular = isAbove ? pow(max(dot(reflect(-toSun, normal), toEye), 0.), 120.) : 0.;
    fColor = vec4((.35 + .5 * diffuse) * vec3(.05, .30, .75) + .8 * specular, 1.);
}
