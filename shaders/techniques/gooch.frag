// R54 Gooch: warm toward the light and cool away from it, so that shape is seen without black shadows and white highlights.
#version 330 core

uniform vec3 uSurface, uWarm, uCool, uEdge;
uniform float uWarmShare, uCoolShare;
uniform bool uIsEdge;

in vec3 vPosition;
in vec3 vNormal;
out vec4 fColor;

void main() {
    vec3 normal = normalize(vNormal), toLight = normalize(vec3(-3., 8., 6.) - vPosition);
    float facing = .5 + .5 * dot(normal, toLight);
    vec3 cool = min(uCool + uCoolShare * uSurface, 1.), warm = min(uWarm + uWarmShare * uSurface, 1.);
    float shine = pow(max(dot(reflect(-toLight, normal), normalize(-vPosition)), 0.), 32.);
    fColor = vec4(uIsEdge ? uEdge : min(mix(cool, warm, facing) + shine, 1.), 1.);
}
