// A sky with a sun and clouds, as a function of the direction.
#include "noise.glsl"

uniform vec3 uSun;  // the direction of the sun

vec3 skyColor(vec3 direction) {
    float height = max(direction.y, 0.);
    vec3 color = mix(vec3(.78, .88, .96), vec3(.16, .38, .74), sqrt(height));
    float cosine = max(dot(direction, normalize(uSun)), 0.);
    color += vec3(1., .9, .7) * (.35 * pow(cosine, 32.) + 4. * smoothstep(.9990, .9996, cosine));
    // Clouds in a plane above the eye.
    vec2 place = direction.xz / (height + .12);
    float cloud = smoothstep(0., .8, fractalNoise(vec3(1.3 * place, 7.3), 5) + .2) * smoothstep(0., .15, height);
    return mix(color, vec3(1., .99, .97), .8 * cloud);
}
