// S26 The same Gaussian without blocks: every pixel reads 25 texels.
#version 430

uniform sampler2D uPicture;

out vec4 fColor;

const float kWeights[5] = float[5](1., 4., 6., 4., 1.);

void main() {
    ivec2 size = textureSize(uPicture, 0), corner = ivec2(gl_FragCoord.xy) - 2;
    vec3 sum = vec3(0.);
    for (int y = 0; y < 5; ++y)
        for (int x = 0; x < 5; ++x)
            sum += kWeights[x] * kWeights[y] * texelFetch(uPicture, clamp(corner + ivec2(x, y), ivec2(0), size - 1), 0).rgb;
    fColor = vec4(sum / 256., 1.);
}
