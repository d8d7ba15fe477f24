// G15.4 G15.6 G15.7 Waves: the normal moves the places where the two pictures are read; the angle of view mixes them.
#version 430 core
#include "waves.glsl"

uniform sampler2D reflection, refraction;
uniform bool isAbove;
uniform vec3 uSun, cameraPosition;
uniform vec4 uFog;  // colour below water
uniform float uDistortion;

in vec3 vPlace;
out vec4 fColor;

void main() {
    vec3 normal = waveNormal(vPlace.xz);
    if (!isAbove) normal.y = -normal.y;
    vec3 toSun = normalize(uSun), toEye = normalize(cameraPosition - vPlace);

    vec2 place = gl_FragCoord.xy / vec2(textureSize(reflection, 0)) + uDistortion * normal.xz;
    vec3 mirrored = texture(reflection, place).rgb, through = texture(refraction, place).rgb;
    // Fresnel: a flat view mirrors, a steep one looks through.
    float grazing = clamp(acos(clamp(dot(toEye, normal), 0., 1.)) - .3, 0., 1.);
    vec3 color = mix(through, mirrored, grazing * grazing * grazing);

    if (isAbove) {
        color = mix(color, vec3(0., .25, .55), .12);
        color += .75 * pow(max(dot(normal, normalize(toSun + toEye)), 0.), 300.);
    } else {
        float far = distance(cameraPosition, vPlace);
        color = mix(.5 * vec3(0., .25, 1.) + .6 * color, uFog.rgb, 1. - pow(clamp((300. - far) / 290., 0., 1.), 5.));
    }
    fColor = vec4(color, 1.);
}
