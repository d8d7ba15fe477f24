// One pass of a filter over uPicture; a macro names it. Tables of weights precede this.
in vec2 vPlace;
uniform sampler2D uPicture;
out vec4 fColor;
vec4 at(ivec2 place) {
    return texelFetch(uPicture, clamp(place, ivec2(0), textureSize(uPicture, 0) - 1), 0);
}
void main() {
    ivec2 p = ivec2(gl_FragCoord.xy);
#ifdef BLUR
    vec4 sum = vec4(0.);
    for (int y = -RADIUS; y <= RADIUS; ++y)
        for (int x = -RADIUS; x <= RADIUS; ++x)
            sum += kWeight[abs(x)] * kWeight[abs(y)] * at(p + ivec2(x, y));
    fColor = sum;
#endif
#ifdef BLUR_ALONG  // a direction
    vec4 sum = vec4(0.);
    for (int i = -RADIUS; i <= RADIUS; ++i)
        sum += kWeight[abs(i)] * at(p + i * BLUR_ALONG);
    fColor = sum;
#endif
#ifdef BLUR_PAIRS_ALONG
    // The linear filter weights two neighbours by a place between them.
    vec2 texel = 1. / vec2(textureSize(uPicture, 0));
    vec4 sum = MIDDLE * at(p);
    for (int i = 0; i < PAIRS; ++i)
        sum += kTogether[i] * (texture(uPicture, (gl_FragCoord.xy + kPlace[i] * vec2(BLUR_PAIRS_ALONG)) * texel) +
                               texture(uPicture, (gl_FragCoord.xy - kPlace[i] * vec2(BLUR_PAIRS_ALONG)) * texel));
    fColor = sum;
#endif
#ifdef SOBEL
    float across = 0.;
    float up = 0.;
    for (int i = -1; i <= 1; ++i) {
        float weight = i == 0 ? 2. : 1.;
        across += weight * (at(p + ivec2(1, i)).r - at(p + ivec2(-1, i)).r);
        up += weight * (at(p + ivec2(i, 1)).r - at(p + ivec2(i, -1)).r);
    }
    fColor = vec4(length(vec2(across, up)), 0., 0., 1.);
#endif
#ifdef SOBEL_COLUMN
    float below = at(p - ivec2(0, 1)).r;
    float above = at(p + ivec2(0, 1)).r;
    vec2 column = vec2(below + 2. * at(p).r + above, above - below);
    fColor = vec4(column * SCALE + BIAS, 0., 1.);
#endif
#ifdef SOBEL_ROW
    vec2 left = (at(p - ivec2(1, 0)).rg - BIAS) / SCALE;
    vec2 middle = (at(p).rg - BIAS) / SCALE;
    vec2 right = (at(p + ivec2(1, 0)).rg - BIAS) / SCALE;
    fColor = vec4(length(vec2(right.x - left.x, left.y + 2. * middle.y + right.y)), 0., 0., 1.);
#endif
}
