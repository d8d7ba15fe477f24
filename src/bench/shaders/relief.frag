// Lit by the slopes of a map of heights.
in vec2 vST;
out vec4 fColor;
uniform sampler2D uTexture;
float at(vec2 st) { return texture(uTexture, st).r; }
void main() {
    vec2 texel = 1. / vec2(textureSize(uTexture, 0)), x = vec2(texel.x, 0.), y = vec2(0., texel.y);
    float east = at(vST + x) - at(vST - x), north = at(vST + y) - at(vST - y);
    vec3 n = normalize(vec3(-east / (4. * texel.x), -north / (4. * texel.y), 1.));
    fColor = vec4(vec3(max(dot(n, normalize(vec3(-.4, .5, .8))), 0.)), 1.);
}
