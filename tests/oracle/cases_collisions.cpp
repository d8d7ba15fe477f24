// A user's macros, functions and local names that collide with words that the translation emits or supplies.

#include "case.h"

namespace glibra::oracle {
namespace {

constexpr const char* kPicture = "Texture2D 5 pattern.png\n";

}  // namespace

std::vector<Case> casesOfCollisions() {
    return {
        {.name = "collision_of_macros_with_built_in_varyings",
         .stages = {.vertex = R"glsl(
#define TexCoord gl_TexCoord[0]
#define FrontColor gl_FrontColor
#define Normal gl_Normal
#define FogFragCoord gl_FogFragCoord
void main() {
    TexCoord = gl_MultiTexCoord0;
    FrontColor = vec4(.5 + .5 * Normal, 1.);
    FogFragCoord = gl_Vertex.y;
    gl_Position = ftransform();
}
)glsl",
                    .fragment = R"glsl(
#define TexCoord gl_TexCoord[0]
#define Color gl_Color
#define FrontColor this is not used
#define FragColor gl_FragColor
void main() { FragColor = vec4(Color.rg, .5 * fract(4. * TexCoord.s) + .25 * gl_FogFragCoord + .25, 1.); }
)glsl"}},
        {.name = "collision_of_macros_with_texture_functions",
         .stages = {.vertex = kPointCoordinateVertex, .fragment = R"glsl(
#define texture vST
#define LOD textureLod
#define textureLod(x) (x)
uniform sampler2D uPicture;
varying vec3 vPoint;
varying vec2 vST;
void main() { gl_FragColor = texture2D(uPicture, texture) * LOD(.75) + texture2D(uPicture, vPoint.xy) * .25; }
)glsl"},
         .before = kPicture,
         .tags = "uPicture 5"},
        {.name = "collision_of_macros_with_clamp",
         .stages = {.vertex = R"glsl(
#define clamp(x) (min(max((x), 0.), .5) + .25)
varying float vShade;
void main() {
    vShade = clamp(gl_Normal.y);
    gl_FrontColor = vec4(2. * gl_Normal, 1.);
    gl_Position = ftransform();
}
)glsl",
                    .fragment = R"glsl(
varying float vShade;
void main() { gl_FragColor = vec4(gl_Color.rg, vShade, 1.); }
)glsl"}},
        {.name = "collision_of_functions_with_clamp_and_transpose",
         .stages = {.vertex = R"glsl(
#version 110
vec4 clamp(vec4 v, float low, float high) { return v * .25 + low + high * .1; }
mat4 transpose(mat4 m) { return m * 2.; }
varying vec4 vShade;
void main() {
    vShade = clamp(vec4(gl_Normal, 1.), 0., 1.);
    gl_FrontColor = vec4(2. * gl_Normal, 1.) + transpose(gl_TextureMatrix[0])[0] * .1;
    gl_Position = ftransform();
}
)glsl",
                    .fragment = R"glsl(
varying vec4 vShade;
void main() { gl_FragColor = vec4(gl_Color.rg, vShade.z, 1.); }
)glsl"}},
        {.name = "collision_of_local_names_with_supplied_ones",
         .stages = {.vertex = kPointCoordinateVertex, .fragment = R"glsl(
varying vec3 vPoint;
varying vec2 vST;
struct Frame { vec3 Tangent; float Timer, FaceIndex; };
float shade(vec4 aColor, float Timer) { return dot(aColor, vec4(Timer)); }
void main() {
    vec3 Tangent = normalize(vPoint), aNormal = Tangent.zxy;
    float aVertex = vST.s, Noise3 = fract(5. * aVertex), FaceIndex = 2.;
    Frame frame = Frame(Tangent, Noise3, FaceIndex);
    frame.Tangent *= .5;
    vec2 uModelViewMatrix = vST * frame.FaceIndex;
    gl_FragColor = vec4(frame.Tangent + .5, 1.);
    gl_FragColor.gb = vec2(shade(vec4(aNormal, 1.), .3), fract(uModelViewMatrix.t + frame.Timer));
}
)glsl"}},
        {.name = "collision_of_macros_with_supplied_names",
         .stages = {.vertex = R"glsl(
#define Timer .5
#define aVertex gl_Vertex
#define uModelViewProjectionMatrix gl_ModelViewProjectionMatrix
#define EMPTY
EMPTY varying EMPTY vec3 EMPTY vPoint EMPTY;
void main() {
    vPoint = aVertex.xyz * Timer;
    gl_Position = uModelViewProjectionMatrix * aVertex;
}
)glsl",
                    .fragment =
                        "varying vec3 vPoint; void main() { gl_FragColor = vec4(.5 + vPoint, 1.); }"}},
        {.name = "collision_of_functions_with_texture_names",
         .stages = {.vertex = kPointCoordinateVertex, .fragment = R"glsl(
#version 120
uniform sampler2D uPicture;
varying vec3 vPoint;
varying vec2 vST;
vec4 texture2DBilinear(in sampler2D textureSampler, in vec2 texCoord) {
    vec2 f = fract(texCoord * 64. - .5);
    vec2 at = (floor(texCoord * 64. - .5) + .5) / 64.;
    vec4 low = mix(texture2D(textureSampler, at), texture2D(textureSampler, at + vec2(1. / 64., 0.)), f.x);
    vec4 high = mix(texture2D(textureSampler, at + vec2(0., 1. / 64.)), texture2D(textureSampler, at + 1. / 64.), f.x);
    return mix(low, high, f.y);
}
vec4 textureGrad(sampler2D s, vec2 st) { return texture2D(s, st * 2.); }
float textureSize(vec2 p) { return length(p); }
vec4 texelFetch(sampler2D s, float at) { return texture2D(s, vec2(at)); }
void main() {
    gl_FragColor = texture2DBilinear(uPicture, vST) * .5 + textureGrad(uPicture, vST) * .25;
    gl_FragColor += texelFetch(uPicture, vPoint.x) * .25 * textureSize(vPoint.xy);
}
)glsl"},
         .before = kPicture,
         .tags = "uPicture 5"},
        {.name = "collision_of_later_types_with_variables",
         .stages = {.vertex = kPointCoordinateVertex, .fragment = R"glsl(
#version 110
uniform float precision;
varying vec3 vPoint;
varying vec2 vST;
vec3 uvec3(float uvec2) { return vec3(uvec2, 1. - uvec2, uvec2 * uvec2); }
void main() {
    float mat2x3 = vST.s, mat4x4 = vST.t, samplerBuffer = .5, sampler1DArray = .25;
    float usampler2D = 1., isamplerCube = .1, atomic_uint = .2, sampler2DMS = .3, switchOver = .1, imageCube = .2;
    vec3 c = uvec3(mat2x3) * precision + mat4x4 * samplerBuffer * sampler1DArray * usampler2D;
    gl_FragColor = vec4(c + isamplerCube * atomic_uint + sampler2DMS * switchOver + .1 * imageCube * vPoint, 1.);
}
)glsl"},
         .tags = "precision <0. .75 1.>"},
        {.name = "collision_of_block_members_with_later_words",
         .stages =
             {.vertex = R"glsl(#version 140
layout(std140) uniform Buffer {
    float sample;
    vec3 patch;
};
out vec3 vPoint;
void main() {
    vPoint = gl_Vertex.xyz * patch * sample;
    gl_Position = gl_ModelViewProjectionMatrix * gl_Vertex;
}
)glsl",
              .fragment =
                  "#version 140\nin vec3 vPoint; out vec4 c; void main() { c = vec4(.5 + vPoint, 1.); }"},
         .tags = "sample .5 Buffer.patch [1 .75 .5]"},
        {.name = "collision_of_two_mains_and_two_declarations_in_branches",
         .stages = {.vertex = R"glsl(
#define SECOND
#ifdef SECOND
varying vec3 vPoint;
#else
varying vec2 vPoint;
#endif
void main(void);
vec4 place();
#ifndef SECOND
void main() { vPoint = gl_Vertex.xy; gl_FrontColor = vec4(0.); gl_Position = place(); }
#else
void main() { vPoint = gl_Vertex.xyz; gl_FrontColor = vec4(2. * gl_Normal.x); gl_Position = place(); }
#endif
vec4 place() { return ftransform(); }
)glsl",
                    .fragment = R"glsl(
varying vec3 vPoint;
#if 1
void main() { gl_FragColor = vec4(gl_Color.r, .5 + .5 * vPoint.yz, 1.);
#else
void main() { gl_FragColor = vec4(1.);
#endif
}
)glsl"}},
        {.name = "collision_of_joined_lines_with_names",
         .stages =
             {.vertex =
                  "vary\\\ning vec3 vPoint;\nvoid main() {\n  vPoint = gl_Ver\\\ntex.xyz; // not \\ here\n"
                  "  gl_Position = gl_Model\\\nViewProjectionMatrix * gl_Vertex;\n}\n",
              .fragment = "varying vec3 vPoint; void main() { gl_FragColor = vec4(.5 + .5 * vPoint, 1.); }"}},
        {.name = "collision_of_samplers_with_structure_members",
         .stages = {.vertex = kPointCoordinateVertex, .fragment = R"glsl(
#version 110
struct Material { sampler2D map; float strength; };
uniform Material uMaterial;
uniform struct { sampler2D texture; vec3 sample; } uOther;
varying vec2 vST;
vec4 look(Material m, vec2 st) { return texture2D(m.map, st) * m.strength; }
void main() { gl_FragColor = look(uMaterial, vST) + texture2D(uOther.texture, vST.ts) * vec4(uOther.sample, 1.); }
)glsl"},
         .before = "Texture2D 5 pattern.png\nTexture2D 6 back.png\n",
         .tags = "uMaterial.map 5 uMaterial.strength .6 uOther.texture 6 uOther.sample [.4 .3 .2]"},
        {.name = "collision_of_arb_compatibility_with_v140",
         .stages = {.vertex = R"glsl(#version 140
#extension GL_ARB_compatibility : enable
#extension GL_ARB_explicit_attrib_location : enable
#extension GL_ARB_shading_language_420pack : enable
layout(location = 5) in vec3 aNormal;
varying vec3 vNormal;
void main() {
    const float scale = gl_Vertex.w * .5;
    vec3 n = { aNormal.x, aNormal.y, aNormal.z * scale };
    vNormal = n;
    gl_Position = ftransform();
}
)glsl",
                    .fragment = R"glsl(#version 140
#extension GL_ARB_compatibility : enable
varying vec3 vNormal;
void main() { gl_FragColor = vec4(.5 + .5 * vNormal, 1.); }
)glsl"}},
        {.name = "collision_of_unsigned_int_of_an_extension",
         .stages = {.vertex = R"glsl(#version 120
#extension GL_EXT_gpu_shader4 : require
flat varying int vWhich;
noperspective varying vec2 vScreen;
varying vec3 vPoint;
void main() {
    vWhich = gl_VertexID % 6;
    vPoint = gl_Vertex.xyz;
    gl_Position = ftransform();
    vScreen = gl_Position.xy / gl_Position.w;
}
)glsl",
                    .fragment = R"glsl(#version 120
#extension GL_EXT_gpu_shader4 : require
#extension GL_ARB_draw_buffers : enable
flat varying int vWhich;
noperspective varying vec2 vScreen;
varying vec3 vPoint;
void main() {
    unsigned int bits = 37u >> (vWhich & 3);
    float level = float(bits & 7u) / 7. + .25 * truncate(vPoint.x * 2.);
    int output0 = 0;
    gl_FragData[output0] = vec4(level, .5 + .5 * vScreen, 1.);
}
)glsl"}},
    };
}

}  // namespace glibra::oracle
