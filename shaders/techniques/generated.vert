// R12 Texture coordinates that come from the shape alone: five rules.
#version 330 core

uniform int uRule;            // 0 object, 1 eye, 2 sphere map, 3 reflection map, 4 normal map
uniform mat4 uPlanes;         // the rows: planes for s, t, r and q
uniform mat4 uTextureMatrix;

out vec4 vCoord;
out float vLight;

void main() {
    vec4 place = uModelViewMatrix * aVertex;
    vec3 toPlace = normalize(place.xyz);
    vec3 normal = normalize(uNormalMatrix * aNormal);
    vec3 reflected = reflect(toPlace, normal);
    vec4 coord;
    if (uRule == 0) coord = aVertex * uPlanes;
    else if (uRule == 1) coord = place * uPlanes;
    else if (uRule == 2) {
        float m = 2. * length(reflected + vec3(0., 0., 1.));
        coord = vec4(reflected.xy / max(m, 1e-4) + .5, 0., 1.);
    }
    else if (uRule == 3) coord = vec4(reflected, 1.);
    else coord = vec4(normal, 1.);
    vCoord = uTextureMatrix * coord;
    vLight = .35 + .65 * max(dot(normal, normalize(vec3(-1., 1.5, 1.5))), 0.);
    gl_Position = uModelViewProjectionMatrix * aVertex;
}
