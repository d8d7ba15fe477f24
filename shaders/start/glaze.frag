// Start, the teapot: ambient, diffuse and specular light on a glaze with two painted bands.
#version 330 core

uniform vec3 uGlazeColor;
uniform vec3 uBandColor;
uniform bool uBands;
uniform float uAmbient, uDiffuse, uSpecular, uShininess;
uniform float uLightX, uLightY, uLightZ;   // eye space

in vec3 vPosition;
in vec3 vNormal;
in vec2 vST;
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
    if (dot(normal, toEye) < 0.) normal = -normal;   // the inside of the pot can be seen through the spout

    vec3 color = uGlazeColor;
    if (uBands) color = mix(color, uBandColor, max(band(vHeight, .16, .035), band(vHeight, .07, .012)));

    float diffuse = max(dot(normal, toLight), 0.);
    float specular = diffuse > 0. ? pow(max(dot(reflect(-toLight, normal), toEye), 0.), uShininess) : 0.;
    float rim = pow(1. - max(dot(normal, toEye), 0.), 4.);
    vec3 light = color * (uAmbient + uDiffuse * diffuse) + vec3(uSpecular * specular) + .25 * rim * vec3(.7, .85, 1.);
    fColor = vec4(light, 1.);
}
