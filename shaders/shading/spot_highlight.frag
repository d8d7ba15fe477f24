// Spot light with a highlight: the soft edge of the cone dims the diffuse and the specular light alike.
#version 330 core

uniform vec3 uLight;        // eye space
uniform vec3 uAim;          // eye space
uniform float uAngle;       // of the middle of the edge of the cone, degrees
uniform float uWidth;       // half the width of the edge, degrees
uniform float uKs;
uniform float uShininess;
uniform vec3 uColor;

in vec3 vPosition;
in vec3 vNormal;

out vec4 fColor;

void main() {
    vec3 normal = normalize(vNormal);
    vec3 toLight = normalize(uLight - vPosition);
    vec3 toEye = normalize(-vPosition);
    float inner = cos(radians(max(uAngle - uWidth, 0.)));
    float outer = cos(radians(uAngle + uWidth));
    float inCone = smoothstep(outer, inner, dot(normalize(uLight - uAim), toLight));

    float diffuse = max(dot(normal, toLight), 0.);
    float specular = diffuse > 0. ? pow(max(dot(reflect(-toLight, normal), toEye), 0.), uShininess) : 0.;
    fColor = vec4((.12 + .88 * inCone * diffuse) * uColor + inCone * uKs * specular, 1.);
}
