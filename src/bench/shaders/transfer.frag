// The mean COLOR of 32 texels along a ray, from a texture of colours or by a transfer function.
in vec2 vPlace;
out vec4 fColor;
uniform sampler3D uTexture;
uniform float uTurn;
vec3 transfer(float t) {
    float band = 4. * clamp(t, 0., 1.);
    return clamp(vec3(band - uTurn, 2. - abs(band - 2.), uTurn - band), 0., 1.);
}
void main() {
    vec3 sum = vec3(0.);
    for (int i = 0; i < 32; ++i) {
        vec4 texel = texture(uTexture, vec3(vPlace, (float(i) + .5) / 32.));
        sum += COLOR;
    }
    fColor = vec4(sum / 32., 1.);
}
