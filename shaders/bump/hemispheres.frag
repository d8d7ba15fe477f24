// Hemisphere bump map: in every cell of the texture square a half ball, on flat ground.
#version 330 core

uniform float uBumpDensity;   // number of half balls along t; along s there are twice as many
uniform float uRadius;        // in cells
uniform float uHeight;        // 1 half balls, less flattens them
uniform float uAmbient;
uniform float uShininess;
uniform vec3 uSurfaceColor;

in vec2 vST;
in vec3 vToLight, vToEye;     // in the frame (along s, along t, outwards)

out vec4 fColor;

void main() {
    vec2 place = (fract(vST * uBumpDensity * vec2(2., 1.)) - .5) / uRadius;
    float r2 = dot(place, place);
    vec3 normal = vec3(0., 0., 1.);
    if (r2 < 1.) normal = normalize(vec3(uHeight * place, sqrt(1. - r2)));   // a point of the half ball is its normal

    vec3 toLight = normalize(vToLight), toEye = normalize(vToEye);
    float diffuse = max(dot(normal, toLight), 0.) * smoothstep(-.1, .2, toLight.z);
    float specular = diffuse > 0. ? pow(max(dot(reflect(-toLight, normal), toEye), 0.), uShininess) : 0.;
    fColor = vec4((uAmbient + (1. - uAmbient) * diffuse) * uSurfaceColor + .5 * specular, 1.);
}
