// The texture functions of GLSL 1.10, and lookups in the vertex stage.

#include "case.h"

namespace glibra::oracle {
namespace {

constexpr const char* kTextures =
    "Texture2D 5 pattern.png\nTexture1D 6 ramp.png\n"
    "CubeMap 7 right.png left.png top.png bottom.png front.png back.png\n";

constexpr const char* kCoordinateVertex = R"glsl(
varying vec3 vPoint, vNormal;
varying vec4 vST;
void main() {
    vPoint = gl_Vertex.xyz;
    vNormal = gl_Normal;
    vST = gl_MultiTexCoord0;
    gl_Position = ftransform();
}
)glsl";

}  // namespace

std::vector<Case> casesOf110Textures() {
    return {
        {.name = "v110_texture2D",
         .stages = {.vertex = kCoordinateVertex, .fragment = R"glsl(
uniform sampler2D uPicture;
varying vec4 vST;
void main() { gl_FragColor = texture2D(uPicture, 2. * vST.st) * .75 + texture2D(uPicture, vST.ts, 0.) * .25; }
)glsl"},
         .before = kTextures,
         .tags = "uPicture 5"},
        {.name = "v110_texture_of_unit_0_without_a_tag",
         .stages = {.vertex = kCoordinateVertex, .fragment = R"glsl(
uniform sampler2D uPicture;
varying vec4 vST;
void main() { gl_FragColor = texture2D(uPicture, 3. * vST.st - 1.); }
)glsl"},
         .before = "Clamp on\nTexture2D 0 pattern.png\n"},
        {.name = "v110_texture1D",
         .stages = {.vertex = kCoordinateVertex, .fragment = R"glsl(
uniform sampler1D uRamp;
varying vec4 vST;
void main() {
    gl_FragColor = .5 * texture1D(uRamp, vST.s) + .25 * texture1DProj(uRamp, vec2(vST.t, 2.));
    gl_FragColor += .25 * texture1DProj(uRamp, vec4(vST.s, 0., 0., 3.));
    gl_FragColor.a = 1.;
}
)glsl"},
         .before = kTextures,
         .tags = "uRamp 6"},
        {.name = "v110_texture3D_noise",
         .stages = {.vertex = kCoordinateVertex, .fragment = R"glsl(
uniform sampler3D Noise3;
uniform float uFrequency;
varying vec3 vPoint;
void main() {
    vec4 octaves = texture3D(Noise3, uFrequency * vPoint);
    float sum = octaves.r + octaves.g + octaves.b + octaves.a - 2.;
    float again = texture3DProj(Noise3, vec4(vPoint, 2.)).r;
    gl_FragColor = vec4(vec3(.5 + sum, 2. * again - .5, .5 - sum), 1.);
}
)glsl"},
         .tags = "uFrequency <0. .75 4.>"},
        {.name = "v110_texture2D_noise", .stages = {.vertex = kCoordinateVertex, .fragment = R"glsl(
uniform sampler2D Noise2;
varying vec4 vST;
void main() {
    vec4 octaves = texture2D(Noise2, vST.st * vec2(4., 2.));
    gl_FragColor = vec4(octaves.rgb * 4. - 1.5, 1.);
}
)glsl"}},
        {.name = "v110_textureCube",
         .stages = {.vertex = kCoordinateVertex, .fragment = R"glsl(
uniform samplerCube uRoom;
varying vec3 vNormal;
void main() { gl_FragColor = textureCube(uRoom, reflect(vec3(0., 0., -1.), normalize(vNormal))); }
)glsl"},
         .before = kTextures,
         .tags = "uRoom 7"},
        {.name = "v110_texture2DProj",
         .stages = {.vertex = kCoordinateVertex, .fragment = R"glsl(
uniform sampler2D uPicture;
varying vec3 vPoint;
void main() {
    gl_FragColor = texture2DProj(uPicture, vec3(vPoint.xy, 2.));
    gl_FragColor.rb = texture2DProj(uPicture, vec4(vPoint.zx, 9., 1.5), 0.).rb;
}
)glsl"},
         .before = kTextures,
         .tags = "uPicture 5"},
        {.name = "v110_lookups_in_the_vertex_stage",
         .stages = {.vertex = R"glsl(
uniform sampler1D uRamp;
uniform sampler2D uHeights;
uniform sampler3D Noise3;
uniform samplerCube uRoom;
varying vec4 vColor;
void main() {
    vec4 height = texture2DLod(uHeights, gl_MultiTexCoord0.st, 0.);
    vColor = .25 * texture1DLod(uRamp, gl_MultiTexCoord0.t, 0.) + .25 * textureCubeLod(uRoom, gl_Normal, 0.);
    vColor += .25 * texture2DProjLod(uHeights, vec3(gl_Vertex.xy, 3.), 0.) + .25 * texture2D(uHeights, gl_Vertex.yz);
    vColor.a = .5 + .5 * texture3DLod(Noise3, gl_Vertex.xyz, 0.).r;
    vColor.b = texture1DProjLod(uRamp, vec4(gl_MultiTexCoord0.s, 0., 0., 2.), 0.).b;
    vColor.g += texture3DProjLod(Noise3, vec4(gl_Vertex.xyz, 2.), 0.).g - .5;
    gl_Position = gl_ModelViewProjectionMatrix * vec4(gl_Vertex.xyz + .25 * height.r * gl_Normal, 1.);
}
)glsl",
                    .fragment = R"glsl(
varying vec4 vColor;
void main() { gl_FragColor = vColor; }
)glsl"},
         .before = kTextures,
         .tags = "uRamp 6 uHeights 5 uRoom 7"},
        {.name = "v110_samplers_of_two_types_on_one_unit",
         .stages = {.vertex = kCoordinateVertex, .fragment = R"glsl(
uniform sampler2D uPicture;
uniform samplerCube uRoom;
varying vec3 vNormal;
varying vec4 vST;
void main() { gl_FragColor = .5 * textureCube(uRoom, vNormal) + .5 * texture2D(uPicture, vST.st); }
)glsl"},
         .before =
             "Texture2D 7 pattern.png\nCubeMap 7 right.png left.png top.png bottom.png front.png back.png\n",
         .tags = "uPicture 7 uRoom 7"},
        {.name = "v110_samplers_as_arguments_and_in_arrays",
         .stages = {.vertex = kCoordinateVertex, .fragment = R"glsl(
uniform sampler2D uPictures[2];
varying vec4 vST;
vec4 blur(sampler2D picture, vec2 st) {
    return .5 * texture2D(picture, st) + .5 * texture2D(picture, st + vec2(.02, .01));
}
void main() { gl_FragColor = mix(blur(uPictures[0], vST.st), blur(uPictures[1], 2. * vST.st), vST.s); }
)glsl"},
         .before = "Texture2D 5 pattern.png\nTexture2D 8 right.png\n",
         .tags = "uPictures [5 8]"},
        {.name = "v120_lookups_by_extensions",
         .stages = {.vertex = kCoordinateVertex, .fragment = R"glsl(
#version 120
#extension GL_ARB_shader_texture_lod : require
#extension GL_EXT_gpu_shader4 : enable
uniform sampler2D uPicture;
uniform samplerCube uRoom;
varying vec4 vST;
varying vec3 vNormal;
void main() {
    gl_FragColor = .5 * texture2DLod(uPicture, vST.st, 0.);
    gl_FragColor += .25 * texture2DGradARB(uPicture, vST.ts, vec2(0.), vec2(0.));
    gl_FragColor += .25 * textureCubeGradARB(uRoom, vNormal, vec3(0.), vec3(0.));
    ivec2 size = textureSize2D(uPicture, 0);
    gl_FragColor.r = texelFetch2D(uPicture, ivec2(vec2(size) * fract(vST.st)), 0).r;
}
)glsl"},
         .before = kTextures,
         .tags = "uPicture 5 uRoom 7"},
    };
}

}  // namespace glibra::oracle
