// Noise in three dimensions from one texture of white noise: a texel holds a random value; between texels the filter of the
// texture mixes eight of them, and at its end the texture begins again.

uniform sampler3D uWhite;  // filtered, repeating

/// Random values that are `zoom` units apart, and between them their mixture; in 0..1.
float smoothNoise(vec3 p, float zoom) {
    return textureLod(uWhite, (p / zoom + .5) / vec3(textureSize(uWhite, 0)), 0.).r;
}

/// The sum of smooth noises of zoom, zoom/2, zoom/4 ... 1, each as strong as its zoom; in 0..256.
float turbulence(vec3 p, float zoom) {
    float sum = 0.;
    for (float z = zoom; z >= 1.; z /= 2.) sum += z * smoothNoise(p, z);
    return 128. * sum / zoom;
}

/// From 0 to 1, most quickly where x is 0.
float logistic(float x, float k) {
    return 1. / (1. + exp(-k * x));
}
