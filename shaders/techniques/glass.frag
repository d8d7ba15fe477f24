// R32 Glass: the refracted sky and the mirrored one, mixed by Schlick's formula for Fresnel's reflectance.
#version 330 core

uniform samplerCube uSky;
uniform mat4 inverseView;
uniform float uIndex;
uniform int uPart;    // 0 both, 1 the refracted part, 2 the mirrored part, 3 the share of the mirror as grey

in vec3 vPosition;
in vec3 vNormal;
out vec4 fColor;

void main() {
    vec3 ray = normalize(vPosition), normal = normalize(vNormal);
    normal = faceforward(normal, ray, normal);
    float root = (1. - uIndex) / (1. + uIndex), f0 = root * root;
    float fresnel = f0 + (1. - f0) * pow(1. - max(dot(normal, -ray), 0.), 5.);
    vec3 mirrored = texture(uSky, mat3(inverseView) * reflect(ray, normal)).rgb;
    vec3 through = texture(uSky, mat3(inverseView) * refract(ray, normal, 1. / uIndex)).rgb;
    vec3 color = uPart == 1 ? through : uPart == 2 ? mirrored : uPart == 3 ? vec3(fresnel) : mix(through, mirrored, fresnel);
    fColor = vec4(color, 1.);
}
