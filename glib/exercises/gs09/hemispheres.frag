// A smooth ball with the cells of half balls. Exercise: the normals of the half balls.
#version 330 core

uniform float uBumpDensity;   // number of half balls along t; along s there are twice as many
uniform float uRadius;        // in cells
uniform float uAmbient;
uniform float uShininess;
uniform vec3 uSurfaceColor;

in vec2 vST;
in vec3 vToLight, vToEye;     // in the frame (along s, along t, outwards)

out vec4 fColor;

void main() {
    vec2 place = (fract(vST * uBumpDensity * vec2(2., 1.)) - .5) / uRadius;
    vec3 normal = vec3(0., 0., 1.);
    vec3 color = dot(place, place) < 1. ? uSurfaceColor : .8 * uSurfaceColor;   // Drop this: the light will show them.

    vec3 toLight = normalize(vToLight), toEye = normalize(vToEye);
    float diffuse = max(dot(normal, toLight), 0.) * smoothstep(-.1, .2, toLight.z);
    float specular = diffuse > 0. ? pow(max(dot(reflect(-toLight, normal), toEye), 0.), uShininess) : 0.;
    fColor = vec4((uAmbient + (1. - uAmbient) * diffuse) * color + .5 * specular, 1.);
}
