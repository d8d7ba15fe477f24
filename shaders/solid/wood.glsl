// Wood: rings around the z axis of the texture, which turbulence bends. 0..1 along each axis is the cube of the texture.
#include "solid_noise.glsl"

uniform float uRings;  // pairs of rings along the side of the cube
uniform float uZoom;
uniform bool uNarrow = false;  // narrow dark rings in light wood

vec3 woodColor(vec3 p, float power) {
    float r = length(p.xy - .5) + power * turbulence(256. * p, uZoom) / 256.;
    float wave = abs(sin(6.2831853 * uRings * r));
    // Rings that are finer than pixels become their mean, 2 / pi.
    wave = mix(wave, .6366, smoothstep(.15, .5, uRings * fwidth(r)));
    // The rings of Gx14.4 are dark only near the zeros of the sine.
    if (uNarrow) return mix(vec3(.28, .14, .05), vec3(.80, .58, .34), smoothstep(.05, .45, wave));
    float s = 128. * wave;
    return vec3(60. + s, 10. + s, 0.) / 255.;
}
