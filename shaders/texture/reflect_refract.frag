// SH035 Reflection and refraction: what the mirrored and the bent ray see, whitened glass, mixed.
#version 330 core

uniform samplerCube uTexUnit;
uniform float uMix;    // 0 all refracted, 1 all reflected
uniform float uIofR;   // ratio of the indices of refraction, outside to inside

in vec3 vPosition;
in vec3 vNormal;

out vec4 fColor;

// The cube map stands still in the world, the rays are in eye space.
vec3 seen(vec3 eyeDirection) {
    return texture(uTexUnit, mat3(uModelViewMatrixInverse) * eyeDirection).rgb;
}

void main() {
    vec3 sight = normalize(vPosition);
    vec3 normal = normalize(vNormal);
    if (dot(normal, sight) > 0.) normal = -normal;

    vec3 reflected = seen(reflect(sight, normal));
    vec3 bent = refract(sight, normal, uIofR);
    if (bent == vec3(0.)) bent = reflect(sight, normal);   // total reflection
    vec3 refracted = mix(seen(bent), vec3(1.), .2);
    fColor = vec4(mix(refracted, reflected, uMix), 1.);
}
