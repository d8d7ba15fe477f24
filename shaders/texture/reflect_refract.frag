// SH035 Reflection and refraction: mixes what the reflected ray sees with what the refracted ray sees, a little whitened.
#version 330 core

uniform samplerCube uTexUnit;
uniform float uMix;    // 0 all refracted, 1 all reflected
uniform float uIofR;   // ratio of the indices of refraction, outside to inside

in vec3 vPosition;
in vec3 vNormal;

out vec4 fColor;

// The cube map is fixed in the world; the rays are in eye space.
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
