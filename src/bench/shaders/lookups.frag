// uGrid x uGrid lookups of a shadow map, over a square as wide as the penumbra.
in vec2 vPlace;
out vec4 fColor;
uniform sampler2D uTexture;
uniform int uGrid;
void main() {
    float sum = 0.;
    for (int i = 0; i < uGrid; ++i)
        for (int j = 0; j < uGrid; ++j) {
            vec2 at = (vec2(i, j) + .5) / float(uGrid) - .5;
            sum += texture(uTexture, vPlace + .2 * at).r > .6 ? 1. : 0.;
        }
    fColor = vec4(sum / float(uGrid * uGrid));
}
