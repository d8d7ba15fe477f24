// A glaze with two painted bands. Exercise: its colours as uniforms.
#version 330 core

const vec3 kGlazeColor = vec3(.5, .5, .5);   // Change this,
const vec3 kBandColor = vec3(.8, .8, .8);    // and this.

uniform bool uBands;
uniform float uAmbient, uDiffuse, uSpecular, uShininess;
uniform float uLightX, uLightY, uLightZ;   // eye space

in vec3 vPosition;
in vec3 vNormal;
in float vHeight;

out vec4 fColor;

// 1 within `halfWidth` of `centre`, with an edge about one pixel wide.
float band(float x, float centre, float halfWidth) {
    float edge = max(fwidth(x), 1e-5);
    return 1. - smoothstep(halfWidth - edge, halfWidth + edge, abs(x - centre));
}

void main() {
    vec3 normal = normalize(vNormal);
    vec3 toEye = normalize(-vPosition);
    vec3 toLight = normalize(vec3(uLightX, uLightY, uLightZ) - vPosition);
    if (dot(normal, toEye) < 0.) normal = -normal;

    vec3 color = kGlazeColor;
    if (uBands) color = mix(color, kBandColor, max(band(vHeight, .16, .035), band(vHeight, .07, .012)));

    float diffuse = max(dot(normal, toLight), 0.);
    float specular = diffuse > 0. ? pow(max(dot(reflect(-toLight, normal), toEye), 0.), uShininess) : 0.;
    float rim = pow(1. - max(dot(normal, toEye), 0.), 4.);
    vec3 light = color * (uAmbient + uDiffuse * diffuse) + vec3(uSpecular * specular) + .25 * rim * vec3(.7, .85, 1.);
    fColor = vec4(light, 1.);
}
