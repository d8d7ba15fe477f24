// SH119 Bathroom glass: two lookups of noise turn the normal about x and about y; then the line of sight is refracted.
#version 330 core

uniform samplerCube uTexUnit;
uniform float uNoiseAmp, uNoiseFreq;
uniform float uMix;   // share of white

in vec3 vModel;
in vec3 vPosition;

out vec4 fColor;

const float kEta = 1.4;

float noise(float offset) {
    vec4 octaves = texture(Noise3, uNoiseFreq * vModel + vec3(0., 0., offset));
    return octaves.r + octaves.g + octaves.b + octaves.a - 2.;
}

void main() {
    float aboutX = uNoiseAmp * noise(0.), aboutY = uNoiseAmp * noise(.5);
    vec3 turned = vec3(cos(aboutX) * sin(aboutY), -sin(aboutX), cos(aboutX) * cos(aboutY));   // from (0, 0, 1)
    vec3 normal = normalize(uNormalMatrix * turned);

    vec3 sight = normalize(vPosition);
    if (dot(normal, sight) > 0.) normal = -normal;
    vec3 bent = refract(sight, normal, kEta);
    if (bent == vec3(0.)) bent = reflect(sight, normal);   // beyond 45.6 degrees nothing is refracted
    vec3 seen = textureCube(uTexUnit, mat3(uModelViewMatrixInverse) * bent).rgb;
    fColor = vec4(mix(seen, vec3(1.), uMix), 1.);
}
