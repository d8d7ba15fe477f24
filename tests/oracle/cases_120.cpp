// GLSL 1.20: arrays as values, matrices that are not square, implicit conversions and qualifiers.

#include "case.h"

namespace glibra::oracle {
namespace {

constexpr const char* kPointVertex120 = R"glsl(
#version 120
varying vec3 vPoint;
void main() {
    vPoint = gl_Vertex.xyz;
    gl_Position = gl_ModelViewProjectionMatrix * gl_Vertex;
}
)glsl";

}  // namespace

std::vector<Case> casesOf120() {
    return {
        {.name = "v120_arrays",
         .stages = {.vertex = R"glsl(
#version 120
const float kWeights[3] = float[3](.5, .3, .2);
varying float vSums[3];
float[3] running(float step) {
    float sums[3] = float[](step, step, step);
    for (int i = 1; i < sums.length(); ++i) sums[i] += sums[i - 1] * kWeights[i];
    return sums;
}
void main() {
    float[3] sums = running(gl_Vertex.y);
    for (int i = 0; i < 3; ++i) vSums[i] = sums[i];
    gl_Position = ftransform();
}
)glsl",
                    .fragment = R"glsl(
#version 120
varying float vSums[3];
vec3 kPalette[2] = vec3[](vec3(1., .5, 0.), vec3(0., .5, 1.));
void main() {
    float sums[3] = vSums;
    bool same = sums == vSums;
    gl_FragColor = vec4(mix(kPalette[0], kPalette[1], fract(sums[2] * 2.)) * (same ? 1. : .3), 1.);
}
)glsl"}},
        {.name = "v120_matrices",
         .stages = {.vertex = kPointVertex120, .fragment = R"glsl(
#version 120
uniform mat2x3 uFrame;
varying vec3 vPoint;
void main() {
    mat3 outer = outerProduct(vPoint, vec3(.5, .25, 1.));
    mat3x2 turned = transpose(uFrame);
    vec3 a = uFrame * vPoint.xy;
    vec2 b = turned * vPoint;
    mat4 inverse = gl_ModelViewMatrixInverse;
    vec3 c = mat3(inverse) * vPoint + outer[1] + matrixCompMult(outer, mat3(.5))[2];
    gl_FragColor = vec4(fract(a.xy), .5 + .25 * (b.x + c.z), 1.);
}
)glsl"},
         .tags = "uFrame [1 0 .5  .25 2 0]"},
        {.name = "v120_implicit_conversions_and_initializers",
         .stages = {.vertex = kPointVertex120, .fragment = R"glsl(
#version 120
uniform float uScale = 3;
uniform vec3 uTint = vec3(1, .75, .5);
uniform vec2 uGiven = vec2(9);
varying vec3 vPoint;
const float kHalf = 1 / 2.f;
const vec2 kRange = vec2(0, sqrt(4.));
float level(float a) { return a * 0.5f + kHalf; }
void main() {
    float x = 2;
    x += level(1);
    float bands = mod(floor(vPoint.y * uScale * x), 2) == 0 ? 1 : .4;
    gl_FragColor = vec4(uTint * bands, 1) - vec4(uGiven, 0, 0) * clamp(vPoint.x, kRange.x, kRange.y);
}
)glsl"},
         .tags = "uGiven [.25 .5]"},
        {.name = "v120_invariant_and_centroid",
         .stages = {.vertex = R"glsl(
#version 120
invariant gl_Position;
invariant varying vec3 vPoint;
centroid varying vec2 vST;
void main() {
    vPoint = gl_Vertex.xyz;
    vST = gl_MultiTexCoord0.st;
    gl_Position = ftransform();
}
)glsl",
                    .fragment = R"glsl(
#version 120
invariant varying vec3 vPoint;
centroid varying vec2 vST;
void main() { gl_FragColor = vec4(fract(5. * vST), .5 + .5 * vPoint.x, 1.); }
)glsl"}},
        {.name = "v120_point_coordinates",
         .stages = {.vertex = R"glsl(
#version 120
varying vec3 vPoint;
void main() {
    vPoint = gl_Vertex.xyz;
    gl_PointSize = 9.;
    gl_Position = ftransform();
}
)glsl",
                    .fragment = R"glsl(
#version 120
varying vec3 vPoint;
void main() {
    vec2 fromCentre = 2. * gl_PointCoord - 1.;
    if (dot(fromCentre, fromCentre) > 1.) discard;
    gl_FragColor = vec4(gl_PointCoord, .5 + .5 * vPoint.z, 1.);
}
)glsl"},
         .draws = "PointSizeMode 1\nJitterCloud 4 4 4 7\n"},
        {.name = "v120_generic_attributes_beside_built_in_ones",
         .stages = {.vertex = R"glsl(
#version 120
attribute vec4 aVertex, aColor;
attribute vec3 aNormal;
attribute vec2 aTexCoord0;
uniform mat4 uModelViewMatrix, uProjectionMatrix, uModelViewProjectionMatrix;
uniform mat3 uNormalMatrix;
varying vec4 vColor;
void main() {
    vColor = aColor * vec4(.5 + .5 * uNormalMatrix * aNormal, 1.);
    vColor.b = fract(4. * aTexCoord0.s);
    vec4 eye = uModelViewMatrix * aVertex;
    vColor.g *= (uModelViewProjectionMatrix * aVertex - uProjectionMatrix * eye).x + .8;
    gl_Position = gl_ProjectionMatrix * eye;
}
)glsl",
                    .fragment = R"glsl(
#version 120
varying vec4 vColor;
void main() { gl_FragColor = vColor; }
)glsl"},
         .draws = "Color .9 .8 1 .8\nRotate 35 1 2 0\nTorus 1.1 .5 24 36\n"},
        {.name = "v120_face_index",
         .stages = {.vertex = R"glsl(
#version 120
attribute float FaceIndex;
attribute vec3 Tangent;
varying vec4 vColor;
void main() {
    vColor = vec4(fract(FaceIndex * .37), .5 + .5 * Tangent.y, FaceIndex / 32., 1.);
    gl_Position = ftransform();
}
)glsl",
                    .fragment = R"glsl(
#version 120
varying vec4 vColor;
void main() { gl_FragColor = vColor; }
)glsl"},
         .draws = "Soccerball 1.2\n"},
        {.name = "v120_structures_and_overloads",
         .stages = {.vertex = R"glsl(
#version 120
struct Ray { vec3 from, along; };
struct Bundle { Ray rays[2]; float weight; };
varying vec3 vHit;
vec3 at(const Ray ray, float t) { return ray.from + t * ray.along; }
vec3 at(Bundle bundle, float t) {
    return mix(at(bundle.rays[0], t), at(bundle.rays[1], t), bundle.weight);
}
void main() {
    Ray one = Ray(gl_Vertex.xyz, gl_Normal);
    Bundle both = Bundle(Ray[2](one, Ray(-gl_Vertex.xyz, vec3(0., 1., 0.))), .25);
    vHit = at(both, .5);
    gl_Position = ftransform();
}
)glsl",
                    .fragment = R"glsl(
#version 120
varying vec3 vHit;
void main() { gl_FragColor = vec4(.5 + .5 * vHit, 1.); }
)glsl"}},
        {.name = "v120_vertex_with_v110_fragment", .stages = {.vertex = kPointVertex120, .fragment = R"glsl(
varying vec3 vPoint;
void main() { gl_FragColor = vec4(fract(2. * vPoint), 1.); }
)glsl"}},
    };
}

}  // namespace glibra::oracle
