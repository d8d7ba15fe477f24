// S04 Cartoon: lit or dark red, a white spot, and black where the surface turns away from the eye.
#version 110

uniform vec3 uLightPlace;       // eye space
uniform vec3 uLit, uDark, uHighlight;
uniform float uRim, uShade, uSpot, uShininess;

varying vec3 vPlace, vNormal;

void main() {
    vec3 normal = normalize(vNormal), toEye = normalize(-vPlace), toLight = normalize(uLightPlace - vPlace);
    float inside = step(uRim, dot(normal, toEye));
    float lit = step(uShade, dot(normal, toLight));
    float spot = step(uSpot, pow(max(dot(normal, normalize(toLight + toEye)), 0.), uShininess));
    gl_FragColor = vec4(inside * mix(mix(uDark, uLit, lit), uHighlight, spot), 1.);
}
