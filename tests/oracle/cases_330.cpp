// GLSL 3.30: locations, mixtures of old and new words, and sources without a version.

#include <string>

#include "case.h"

namespace glibra::oracle {
namespace {

// Without #version glibra assumes 330 compatibility, and it supplies compatibility names in core versions too
// (language, 7.2). Mesa's compiler assumes 110 and refuses such shaders, so the oracle gets them with a
// #version.
const std::string kCompatibility = "#version 330 compatibility\n";
const std::string kMixedVertex = R"glsl(
in vec3 Tangent;
varying vec3 vNormal;
out vec2 vST;
void main() {
    vNormal = gl_NormalMatrix * gl_Normal + .1 * Tangent;
    vST = gl_MultiTexCoord0.st;
    gl_Position = gl_ModelViewProjectionMatrix * gl_Vertex;
}
)glsl";
const std::string kMixedFragment = R"glsl(
uniform sampler2D uPicture;
varying vec3 vNormal;
in vec2 vST;
void main() {
    gl_FragColor = texture2D(uPicture, vST) * .5 + texture(uPicture, vST.ts) * .25;
    gl_FragColor += vec4(.125 + .125 * normalize(vNormal), .25);
}
)glsl";
const std::string kCoreVertex = R"glsl(
out vec3 vNormal;
void main() {
    vNormal = gl_NormalMatrix * gl_Normal;
    gl_FrontColor = vec4(gl_MultiTexCoord0.st, 0., 1.);
    gl_Position = gl_ModelViewProjectionMatrix * gl_Vertex;
}
)glsl";
const std::string kCoreFragment = R"glsl(
in vec3 vNormal;
out vec4 fColor;
void main() { fColor = vec4(gl_Color.rg, .5 + .5 * normalize(vNormal).z, 1.); }
)glsl";

constexpr const char* kPointVertex330 = R"glsl(#version 330 compatibility
out vec3 vPoint;
out vec2 vST;
void main() {
    vPoint = gl_Vertex.xyz;
    vST = gl_MultiTexCoord0.st;
    gl_Position = gl_ModelViewProjectionMatrix * gl_Vertex;
}
)glsl";

}  // namespace

std::vector<Case> casesOf330() {
    return {
        {.name = "v330_locations",
         .stages = {.vertex = R"glsl(#version 330 compatibility
layout(location = 3) in vec4 aVertex;
layout(location = 1) in vec3 aNormal;
in vec4 aTexCoord0;
uniform mat4 uModelViewMatrix, uProjectionMatrix;
uniform mat3 uNormalMatrix;
out vec3 vNormal;
out vec2 vST;
void main() {
    vNormal = normalize(uNormalMatrix * aNormal);
    vST = aTexCoord0.st;
    gl_Position = uProjectionMatrix * (uModelViewMatrix * aVertex);
}
)glsl",
                    .fragment = R"glsl(#version 330 compatibility
in vec3 vNormal;
in vec2 vST;
layout(location = 0) out vec4 fFragColor;
void main() { fFragColor = vec4(.5 + .5 * normalize(vNormal).xy, fract(4. * vST.t), 1.); }
)glsl"}},
        {.name = "v330_old_words_beside_new_ones",
         .stages = {.vertex = R"glsl(#version 330 compatibility
uniform mat4 uModelViewProjectionMatrix;
in vec4 aVertex;
varying vec3 vNormal;
out vec4 vClip;
void main() {
    vNormal = gl_Normal;
    gl_TexCoord[0] = gl_MultiTexCoord0;
    vClip = uModelViewProjectionMatrix * aVertex;
    gl_Position = ftransform();
}
)glsl",
                    .fragment = R"glsl(#version 330 compatibility
uniform sampler2D uPicture;
in vec4 vClip;
varying vec3 vNormal;
void main() {
    vec4 picture = texture2D(uPicture, gl_TexCoord[0].st);
    gl_FragColor = vec4(mix(picture.rgb, .5 + .5 * vNormal, .5) + .1 * vClip.x / vClip.w, 1.);
}
)glsl"},
         .before = "Texture2D 5 pattern.png\n",
         .tags = "uPicture 5"},
        {.name = "no_version_with_old_and_new_words",
         .stages = {.vertex = kMixedVertex, .fragment = kMixedFragment},
         .before = "Texture2D 5 pattern.png\n",
         .tags = "uPicture 5",
         .byHand = {.vertex = kCompatibility + kMixedVertex, .fragment = kCompatibility + kMixedFragment}},
        {.name = "v330_core_with_compatibility_names",
         .stages = {.vertex = "#version 330\n" + kCoreVertex,
                    .fragment = "#version 330 core\n" + kCoreFragment},
         .byHand = {.vertex = kCompatibility + kCoreVertex, .fragment = kCompatibility + kCoreFragment}},
        {.name = "v330_texture_as_a_sampler_name",
         .stages = {.vertex = kPointVertex330, .fragment = R"glsl(#version 330 compatibility
uniform sampler2D picture;
in vec2 vST;
vec4 sampleTwice(sampler2D texture, vec2 st) { return texture2D(texture, st) * .5 + texture2D(texture, st.ts) * .5; }
void main() {
    vec4 texture = sampleTwice(picture, vST);
    gl_FragColor = texture * vec4(1., .75, .5, 1.);
}
)glsl"},
         .before = "Texture2D 5 pattern.png\n",
         .tags = "picture 5"},
        {.name = "v330_bits_and_packing",
         .stages = {.vertex = kPointVertex330, .fragment = R"glsl(#version 330 compatibility
#extension GL_ARB_shader_bit_encoding : enable
in vec3 vPoint;
in vec2 vST;
void main() {
    uint bits = floatBitsToUint(vST.s + 1.);
    float exact = uintBitsToFloat((bits & 0xFFF00000u)) - 1.;
    ivec2 cell = ivec2(vST * 16.);
    bool odd = bool((cell.x + cell.y) & 1);
    gl_FragColor = vec4(exact, odd ? .75 : .25, float(uint(cell.y) >> 1) / 8., 1.);
    gl_FragColor.rgb += .25 * sign(vPoint);
}
)glsl"}},
        {.name = "v330_derivatives",
         .stages = {.vertex = kPointVertex330, .fragment = R"glsl(#version 330 compatibility
in vec3 vPoint;
in vec2 vST;
void main() {
    vec3 facing = normalize(cross(dFdx(vPoint), dFdy(vPoint)));
    gl_FragColor = vec4(.5 + .5 * facing.xy, 8. * fwidth(vST.t), 1.);
}
)glsl"},
         .draws = "Rotate 35 1 2 0\nBox 1.5 1.5 1.5\n"},
        {.name = "v420_initializer_lists_and_bindings",
         .stages = {.vertex = kPointVertex330, .fragment = R"glsl(#version 420 compatibility
layout(binding = 5) uniform sampler2D uPicture;
in vec3 vPoint;
in vec2 vST;
const float kSteps[] = { .25, .5, 1. };
const mat2 kSkew = { { 1., .5 }, { 0, 2 } };
struct Light { vec3 color; float power; };
void main() {
    Light lights[2] = { { vec3(1., .5, 0.), 1 }, { vec3(0., .5, 1.), .5 } };
    const float level = kSteps[int(vST.s * 2.99)];
    vec3 c = level * mix(lights[0].color, lights[1].color, .5 + .5 * vPoint.x).rgb * lights[1].power;
    gl_FragColor = vec4(c, 1.) + .5 * texture(uPicture, kSkew * vST) * vec4(vST.sss.r);
}
)glsl"},
         .before = "Texture2D 5 pattern.png\n"},
        {.name = "v430_arrays_of_arrays",
         .stages = {.vertex = R"glsl(#version 430 compatibility
layout(location = 2) uniform float uScale = 1.;
out float vGrid[2][3];
void main() {
    for (int i = 0; i < vGrid.length(); ++i)
        for (int j = 0; j < vGrid[i].length(); ++j) vGrid[i][j] = gl_Vertex[j] * float(i + 1) * uScale;
    gl_Position = ftransform();
}
)glsl",
                    .fragment = R"glsl(#version 430 compatibility
in float vGrid[2][3];
void main() {
    float[2][3] again = vGrid;
    gl_FragColor = vec4(.5 + .5 * again[0][0], fract(again[1][1]), .5 + .25 * again[1][2], 1.);
}
)glsl"},
         .tags = "uScale .8"},
    };
}

}  // namespace glibra::oracle
