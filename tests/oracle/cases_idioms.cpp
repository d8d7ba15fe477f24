// Idioms of shaders that compile everywhere, ES versions, and mistakes that are repaired (language, 7.10).
// Mesa's compiler refuses such mistakes, so there the oracle gets the shader that the author meant.

#include "case.h"

namespace glibra::oracle {

std::vector<Case> casesOfIdioms() {
    return {
        {.name = "idiom_old_words_defined_as_new_ones",
         .stages = {.vertex = R"glsl(#version 130
#if __VERSION__ >= 130
#define attribute in
#define varying out
#endif
attribute vec4 aVertex;
uniform mat4 uModelViewProjectionMatrix;
varying vec3 vPoint;
void main() {
    vPoint = aVertex.xyz;
    gl_Position = uModelViewProjectionMatrix * aVertex;
}
)glsl",
                    .fragment = R"glsl(#version 130
#if __VERSION__ >= 130
#define varying in
#define texture2D texture
out vec4 fColor;
#define gl_FragColor fColor
#endif
uniform sampler2D uPicture;
varying vec3 vPoint;
void main() { gl_FragColor = texture2D(uPicture, vPoint.xy) * vec4(.5 + .5 * vPoint.z); }
)glsl"},
         .before = "Texture2D 5 pattern.png\n",
         .tags = "uPicture 5"},
        {.name = "idiom_new_words_defined_as_old_ones",
         .stages = {.vertex = R"glsl(#version 120
#if __VERSION__ < 130
#define in attribute
#define out varying
#endif
in vec4 aVertex;
in vec3 aNormal;
out vec3 vNormal;
void main() {
    vNormal = aNormal;
    gl_Position = gl_ModelViewProjectionMatrix * aVertex;
}
)glsl",
                    .fragment = R"glsl(#version 120
#if __VERSION__ < 130
#define in varying
#define texture texture2D
#define fColor gl_FragColor
#endif
uniform sampler2D uPicture;
in vec3 vNormal;
void main() { fColor = texture(uPicture, vNormal.xy); }
)glsl"},
         .before = "Texture2D 5 pattern.png\n",
         .tags = "uPicture 5"},
        {.name = "idiom_precision_for_es_only",
         .stages = {.vertex = R"glsl(
#ifdef GL_ES
precision highp float;
#else
#define highp
#define mediump
#define lowp
#endif
varying mediump vec3 vPoint;
void main() {
    highp vec4 p = gl_Vertex;
    vPoint = p.xyz;
    gl_Position = ftransform();
}
)glsl",
                    .fragment = R"glsl(
#ifdef GL_ES
precision mediump float;
#define GREEN 0.
#else
#define mediump
#define GREEN .75
#endif
varying mediump vec3 vPoint;
void main() { gl_FragColor = vec4(.5 + .5 * vPoint.x, GREEN, fract(3. * vPoint.z), 1.); }
)glsl"}},
        {.name = "idiom_functions_made_by_macros",
         .stages = {.vertex = kPointCoordinateVertex, .fragment = R"glsl(#version 120
#extension all : warn
#pragma optimize(on)
#pragma debug(off)
#define BINARY(name, op) float name(float a, float b) { return a op b; }
#define saturate(x) clamp((x), 0., 1.)
#define PICTURE sampler2D
#define EACH(i, n) for (int i = 0; i < (n); ++i)
BINARY(plus, +)
BINARY(times, *)
uniform PICTURE uPicture;
varying vec3 vPoint;
varying vec2 vST;
void main() {
    float sum = 0.;
    EACH(i, 3) sum = plus(sum, times(texture2D(uPicture, vST * float(i + 1)).r, .4));
    gl_FragColor = vec4(saturate(sum), saturate(vPoint.xy), 1.);
}
)glsl"},
         .before = "Texture2D 5 pattern.png\n",
         .tags = "uPicture 5"},
        {.name = "idiom_declarations_made_by_macros",
         .stages = {.vertex = R"glsl(#version 120
#define VARYING(type, name) varying type name
#define INPUT(type, name) attribute type name;
VARYING(vec3, vPoint);
INPUT(vec3, Tangent)
void main() {
    vPoint = gl_Vertex.xyz + .2 * Tangent;
    gl_Position = ftransform();
}
)glsl",
                    .fragment = R"glsl(#version 120
#define VARYING(type, name) varying type name
VARYING(vec3, vPoint);
void main() { gl_FragColor = vec4(.5 + .5 * vPoint, 1.); }
)glsl"}},
        {.name = "idiom_a_user_function_texture3D_on_a_2D_picture",
         .stages = {.vertex = kPointCoordinateVertex, .fragment = R"glsl(#version 120
uniform sampler2D uPicture;
varying vec3 vPoint;
vec4 texture3D(sampler2D slices, vec3 p, float count) {
    float slice = floor(p.z * count) / count;
    return texture2D(slices, vec2((p.x + slice) / count, p.y));
}
void main() { gl_FragColor = texture3D(uPicture, fract(vPoint), 4.) * .75 + texture2D(uPicture, vPoint.xy) * .25; }
)glsl"},
         .before = "Texture2D 5 pattern.png\n",
         .tags = "uPicture 5"},
        {.name = "es_version_100",
         .stages = {.vertex = R"glsl(#version 100
attribute vec4 aVertex;
attribute vec3 aNormal;
uniform mat4 uModelViewProjectionMatrix;
varying mediump vec3 vNormal;
void main() {
    vNormal = aNormal;
    gl_Position = uModelViewProjectionMatrix * aVertex;
}
)glsl",
                    .fragment = R"glsl(#version 100
precision mediump float;
uniform sampler2D uPicture;
varying vec3 vNormal;
void main() {
    lowp vec4 sample = texture2D(uPicture, vNormal.xy);
    gl_FragColor = vec4(.5 + .5 * normalize(vNormal).xy, sample.g, 1.);
}
)glsl"},
         .before = "Texture2D 5 pattern.png\n",
         .tags = "uPicture 5"},
        {.name = "es_version_300",
         .stages = {.vertex = R"glsl(#version 300 es
in vec4 aVertex;
in vec3 aNormal;
uniform mat4 uModelViewProjectionMatrix;
out vec3 vNormal;
flat out int vWhich;
void main() {
    vNormal = aNormal;
    vWhich = gl_VertexID & 3;
    gl_Position = uModelViewProjectionMatrix * aVertex;
}
)glsl",
                    .fragment = R"glsl(#version 300 es
precision highp float;
precision mediump sampler2D;
uniform sampler2D uPicture;
in vec3 vNormal;
flat in int vWhich;
layout(location = 0) out mediump vec4 fColor;
void main() { fColor = vec4(.5 + .5 * vNormal.x, float(vWhich) / 3., texture(uPicture, vNormal.yz).b, 1.); }
)glsl"},
         .before = "Texture2D 5 pattern.png\n",
         .tags = "uPicture 5"},
        {.name = "repair_constants_of_uniforms_and_inputs_written_to",
         .stages = {.vertex = kPointCoordinateVertex, .fragment = R"glsl(#version 120
uniform float uScale;
varying vec3 vPoint;
varying vec2 vST;
const float kTwice = 2. * uScale;
const vec3 kBase = const vec3(.1, .2, .3);
;
void darken(inout vec3 c) { c *= kTwice; }
void main() {
    vPoint = .5 + .5 * vPoint;
    darken(vPoint);
    vST.s += .25;
    gl_FragColor = vec4(kBase + vPoint.xy.xyx * fract(2. * vST.s), 1.);
}
)glsl"},
         .tags = "uScale .4",
         .byHand = {.fragment = R"glsl(#version 120
uniform float uScale;
varying vec3 vPoint;
varying vec2 vST;
void main() {
    vec3 p = (.5 + .5 * vPoint) * (2. * uScale);
    gl_FragColor = vec4(vec3(.1, .2, .3) + p.xyx * fract(2. * (vST.s + .25)), 1.);
}
)glsl"}},
        {.name = "repair_scalars_beside_vectors",
         .stages = {.vertex = kPointCoordinateVertex, .fragment = R"glsl(
uniform float uPower;
uniform float uPower;
varying vec3 vPoint;
varying vec2 vST;
void main() {
    vec3 a = pow(abs(vPoint), uPower), b = max(.25, vPoint), c = smoothstep(vec3(0.), .5, abs(vPoint));
    float d = min(vST.s, 1.), e = step(.5, fract(4. * vST.t));
    gl_FragColor = vec4(.4 * a + .2 * b + .2 * c + .2 * mix(0., vPoint, .5) + .1 * d * e, 1.);
}
)glsl"},
         .tags = "uPower 2",
         .byHand = {.fragment = R"glsl(
uniform float uPower;
varying vec3 vPoint;
varying vec2 vST;
void main() {
    vec3 a = pow(abs(vPoint), vec3(uPower)), b = max(vPoint, .25), c = smoothstep(vec3(0.), vec3(.5), abs(vPoint));
    float d = min(vST.s, 1.), e = step(.5, fract(4. * vST.t));
    gl_FragColor = vec4(.4 * a + .2 * b + .2 * c + .2 * mix(vec3(0.), vPoint, .5) + .1 * d * e, 1.);
}
)glsl"}},
        {.name = "repair_integers_used_as_samplers_and_inputs_of_no_stage",
         .stages = {.vertex = kPointCoordinateVertex, .fragment = R"glsl(
uniform int uPicture;
uniform float uRamp;
varying vec3 vPoint, vNobody;
varying vec2 vST;
void main() {
    gl_FragColor = texture2D(uPicture, vST) * .75 + texture(uRamp, vPoint.x) * .25 + vec4(vNobody, 0.);
    gl_FragColor.rg += gl_TexCoord[1].st + gl_FogFragCoord + gl_SecondaryColor.r;
}
)glsl"},
         .before = "Texture2D 5 pattern.png\nTexture1D 6 ramp.png\n",
         .tags = "uPicture 5 uRamp 6",
         .byHand = {.fragment = R"glsl(#version 330 compatibility
uniform sampler2D uPicture;
uniform sampler1D uRamp;
in vec3 vPoint;
in vec2 vST;
void main() { gl_FragColor = texture(uPicture, vST) * .75 + texture(uRamp, vPoint.x) * .25; }
)glsl"}},
        {.name = "repair_versions_comments_and_attributes_as_uniforms",
         .stages =
             {.vertex = R"glsl(// a comment that ends in a backslash \
#version 1.20
uniform float FaceIndex;
uniform vec3 Tangent;
varying vec3 vColor;
void main() {
    vColor = vec3(FaceIndex / 32., .5 + .5 * Tangent.xy); // and another \
    gl_Position = ftransform();
}
)glsl",
              .fragment =
                  "#version 4.00\nvarying vec3 vColor; out vec4 f; void main() { f = vec4(vColor, 1.0f); }"},
         .draws = "Soccerball 1.2\n",
         .byHand =
             {.vertex = R"glsl(#version 120
attribute float FaceIndex;
attribute vec3 Tangent;
varying vec3 vColor;
void main() {
    vColor = vec3(FaceIndex / 32., .5 + .5 * Tangent.xy);
    gl_Position = ftransform();
}
)glsl",
              .fragment =
                  "#version 120\nvarying vec3 vColor; void main() { gl_FragColor = vec4(vColor, 1.); }"}},
        {.name = "repair_supplied_names_that_nobody_declares",
         .stages = {.vertex = R"glsl(#version 330 core
out vec3 vNormal;
void main() {
    vNormal = uNormalMatrix * aNormal + .1 * Tangent + Timer;
    gl_Position = uProjectionMatrix * (uModelViewMatrix * aVertex);
}
)glsl",
                    .fragment = R"glsl(#version 330 core
#include "gstap.h"
in vec3 vNormal;
out vec4 fColor;
void main() { fColor = vec4(.5 + .25 * vNormal + (texture(Noise3, vNormal).rgb - .5), 1.); }
)glsl"},
         .byHand = {.vertex = R"glsl(#version 330 compatibility
in vec3 Tangent;
out vec3 vNormal;
void main() {
    vNormal = gl_NormalMatrix * gl_Normal + .1 * Tangent;
    gl_Position = gl_ProjectionMatrix * (gl_ModelViewMatrix * gl_Vertex);
}
)glsl",
                    .fragment = R"glsl(#version 330 compatibility
uniform sampler3D Noise3;
in vec3 vNormal;
out vec4 fColor;
void main() { fColor = vec4(.5 + .25 * vNormal + (texture(Noise3, vNormal).rgb - .5), 1.); }
)glsl"}},
        // The driver's noise functions are 0 everywhere. The reference is a second implementation of the
        // definition in language, 7.5.
        {.name = "noise_functions",
         .stages = {.vertex = kPointCoordinateVertex, .fragment = R"glsl(
varying vec3 vPoint;
varying vec2 vST;
void main() {
    vec3 c = .25 * vec3(noise1(4. * vPoint.x), noise2(4. * vST)) + .5 * noise3(3. * vPoint);
    gl_FragColor = vec4(.5 + .5 * c + .25 * noise4(vec4(2. * vPoint, vST.s)).wzy, 1.);
}
)glsl"},
         .byHand = {.fragment = R"glsl(#version 430 compatibility
in vec3 vPoint;
in vec2 vST;
uint mixed(uint x) {
    x = (x ^ (x >> 16)) * 0x7feb352du;
    x = (x ^ (x >> 15)) * 0x846ca68bu;
    return x ^ (x >> 16);
}
float lattice(vec4 p, int d, int k) {
    vec4 whole = floor(p), t = p - whole, w = t * t * t * (10. - 15. * t + 6. * t * t);
    float sum = 0.;
    for (int corner = 0; corner < (1 << d); ++corner) {
        ivec4 o = ivec4(corner & 1, corner >> 1 & 1, corner >> 2 & 1, corner >> 3 & 1);
        uvec4 c = uvec4(ivec4(whole) + o) * uvec4(0x8da6b343u, 0xd8163841u, 0xcb1ab31fu, 0x165667b1u);
        uint h = mixed(c.x ^ c.y ^ c.z ^ c.w ^ (uint(k) * 0x85ebca6bu));
        vec4 g = vec4(0.);
        for (int j = 0; j < d; ++j) g[j] = float(mixed(h + 0x9e3779b9u * uint(j)) >> 8) / 8388608. - 1.;
        g = length(g) < .001 ? vec4(1., 0., 0., 0.) : g / length(g);
        float weight = 1.;
        for (int j = 0; j < d; ++j) weight *= o[j] == 1 ? w[j] : 1. - w[j];
        sum += weight * dot(g, t - vec4(o));
    }
    return 2. / sqrt(float(d)) * sum;
}
void main() {
    vec4 one = vec4(4. * vPoint.x, 0., 0., 0.), two = vec4(4. * vST, 0., 0.), three = vec4(3. * vPoint, 0.);
    vec4 four = vec4(2. * vPoint, vST.s);
    vec3 c = .25 * vec3(lattice(one, 1, 0), lattice(two, 2, 0), lattice(two, 2, 1));
    c += .5 * vec3(lattice(three, 3, 0), lattice(three, 3, 1), lattice(three, 3, 2));
    gl_FragColor = vec4(.5 + .5 * c + .25 * vec3(lattice(four, 4, 3), lattice(four, 4, 2), lattice(four, 4, 1)), 1.);
}
)glsl"}},
    };
}

}  // namespace glibra::oracle
