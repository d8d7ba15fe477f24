// The highlight alone, from a COSINE, on a unit sphere that fills the target. Green is 1 on the sphere.
in vec2 vPlace;
uniform vec3 uLight;
uniform float uExponent;
out vec4 fColor;
void main() {
    vec2 p = vPlace * 2. - 1.;
    float depth = 1. - dot(p, p);
    vec3 n = vec3(p, sqrt(max(depth, 0.)));
    float shine = dot(n, uLight) > 0. ? pow(max(COSINE, 0.), uExponent) : 0.;
    fColor = vec4(shine, depth >= 0. ? 1. : 0., 0., 1.);
}
