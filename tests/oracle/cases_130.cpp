// GLSL 1.30 and 1.40: in and out, integers, switch, clip distances and uniform blocks. In compatibility
// contexts both versions also have the old names.

#include "case.h"

namespace glibra::oracle {
namespace {

constexpr const char* kPointVertex130 = R"glsl(#version 130
out vec3 vPoint;
out vec2 vST;
void main() {
    vPoint = gl_Vertex.xyz;
    vST = gl_MultiTexCoord0.st;
    gl_Position = gl_ModelViewProjectionMatrix * gl_Vertex;
}
)glsl";

}  // namespace

std::vector<Case> casesOf130() {
    return {
        {.name = "v130_inputs_and_outputs",
         .stages = {.vertex = R"glsl(#version 130
in vec4 aVertex;
in vec3 aNormal;
uniform mat4 uModelViewProjectionMatrix;
smooth out vec3 vNormal;
noperspective out vec2 vScreen;
flat out int vWhich;
flat out vec3 vFlat;
centroid out float vHeight;
void main() {
    vNormal = gl_NormalMatrix * aNormal;
    vFlat = abs(aNormal);
    vWhich = gl_VertexID;
    vHeight = aVertex.y;
    gl_Position = uModelViewProjectionMatrix * aVertex;
    vScreen = gl_Position.xy / gl_Position.w;
}
)glsl",
                    .fragment = R"glsl(#version 130
smooth in vec3 vNormal;
noperspective in vec2 vScreen;
flat in int vWhich;
flat in vec3 vFlat;
centroid in float vHeight;
out vec4 fColor;
void main() {
    float which = float(vWhich % 7) / 6.;
    fColor = vec4(.5 + .25 * vNormal.x + .25 * vScreen.x, which * .5 + .5 * vFlat.y, .5 + vHeight * .5, 1.);
}
)glsl"}},
        {.name = "v130_integers",
         .stages = {.vertex = kPointVertex130, .fragment = R"glsl(#version 130
in vec3 vPoint;
uniform uint uMask;
uniform int uShift;
int popcount(uint bits) {
    int n = 0;
    for (; bits != 0u; bits &= bits - 1u) ++n;
    return n;
}
void main() {
    ivec3 cell = ivec3(floor(vPoint * 8.));
    int mixed = (cell.x ^ (cell.y << uShift)) & 0xF;
    uint bits = (uint(mixed) * 0x9E3779B9u >> 12) | uMask;
    bits = ~bits % 64u;
    gl_FragColor = vec4(float(mixed) / 15., float(popcount(bits)) / 6., float(bits) / 63., 1.);
}
)glsl"},
         .tags = "uMask 5 uShift 1"},
        {.name = "v130_switch_and_functions",
         .stages = {.vertex = kPointVertex130, .fragment = R"glsl(#version 130
in vec3 vPoint;
in vec2 vST;
out vec4 fColor;
vec3 band(int which) {
    switch (which) {
        case 0: return vec3(1., .2, .1);
        case 1:
        case 2: { vec3 c = vec3(0., 1., .5); c.b = trunc(3. * vST.s) / 3.; return c; }
        default: break;
    }
    return vec3(round(vPoint.x), roundEven(2. * vPoint.y) * .5, .25);
}
void main() {
    float whole;
    float rest = modf(vST.t * 6., whole);
    fColor = vec4(band(int(whole) % 4) * (isnan(rest) ? 0. : .5 + .5 * rest), 1.);
    fColor.rgb += .1 * sinh(vPoint) + .05 * vec3(acosh(1. + vST.s));
}
)glsl"}},
        {.name = "v130_texture_functions",
         .stages = {.vertex = R"glsl(#version 130
uniform sampler2D uHeights;
out vec2 vST;
out vec3 vNormal;
void main() {
    vST = gl_MultiTexCoord0.st;
    vNormal = gl_Normal;
    vec4 lifted = gl_Vertex;
    lifted.xyz += .2 * textureLod(uHeights, vST, 0.).g * gl_Normal;
    gl_Position = gl_ModelViewProjectionMatrix * lifted;
}
)glsl",
                    .fragment = R"glsl(#version 130
uniform sampler1D uRamp;
uniform sampler2D uHeights;
uniform sampler3D Noise3;
uniform samplerCube uRoom;
in vec2 vST;
in vec3 vNormal;
out vec4 fColor;
void main() {
    vec4 c = texture(uHeights, vST) * .3 + texture(uRamp, vST.t) * .2 + texture(uRoom, vNormal) * .2;
    c += textureProj(uHeights, vec3(vST, 2.)) * .1 + textureGrad(uHeights, vST.ts, vec2(0.), vec2(0.)) * .1;
    c += textureOffset(uHeights, vST, ivec2(3, -2)) * .1 + (texture(Noise3, vNormal).r - .5);
    ivec2 size = textureSize(uHeights, 0);
    c.b = texelFetch(uHeights, ivec2(vST * vec2(size)) & ivec2(63), 0).b;
    fColor = vec4(c.rgb, 1.);
}
)glsl"},
         .before = "Texture2D 5 pattern.png\nTexture1D 6 ramp.png\n"
                   "CubeMap 7 right.png left.png top.png bottom.png front.png back.png\n",
         .tags = "uHeights 5 uRamp 6 uRoom 7"},
        {.name = "v130_clip_distances",
         .stages = {.vertex = R"glsl(#version 130
out vec3 vPoint;
void main() {
    vPoint = gl_Vertex.xyz;
    gl_ClipDistance[0] = gl_Vertex.x + .55;
    gl_ClipDistance[1] = .8 - gl_Vertex.y - .5 * gl_Vertex.x;
    gl_Position = ftransform();
}
)glsl",
                    .fragment = R"glsl(#version 130
in vec3 vPoint;
void main() { gl_FragColor = vec4(.5 + .5 * vPoint, 1.); }
)glsl"},
         .written = {.clipDistances = 2}},
        {.name = "v130_built_in_varyings_beside_own_ones",
         .stages = {.vertex = R"glsl(#version 130
out vec4 gl_TexCoord[2];
out vec3 vPoint;
void main() {
    gl_FrontColor = vec4(.5 + .5 * gl_Normal, 1.);
    gl_TexCoord[1] = gl_MultiTexCoord0;
    vPoint = gl_Vertex.xyz;
    gl_Position = ftransform();
}
)glsl",
                    .fragment = R"glsl(#version 130
in vec3 vPoint;
in vec4 gl_TexCoord[2];
void main() {
    gl_FragData[0] = gl_Color;
    gl_FragData[0].g = fract(3. * gl_TexCoord[1].t) * (.5 + .25 * vPoint.y);
}
)glsl"}},
        {.name = "v130_own_outputs_to_several_targets",
         .stages = {.vertex = kPointVertex130, .fragment = R"glsl(#version 330 compatibility
in vec3 vPoint;
in vec2 vST;
layout(location = 1) out vec4 fSecond;
layout(location = 0) out vec4 fFirst;
void main() {
    fFirst = vec4(.5 + .5 * vPoint, 1.);
    fSecond = vec4(fract(4. * vST), 0., 1.);
}
)glsl"},
         .before = "Texture2D 5 64 64\nTexture2D 6 64 64\n",
         .draws = "RenderToTexture 5 6\nRotate 35 1 2 0\nTorus 1.1 .5 24 36\nRenderToTexture\n",
         .show = {.vertex = kPointVertex130, .fragment = R"glsl(#version 130
in vec2 vST;
uniform sampler2D uFirst, uSecond;
void main() { gl_FragColor = vST.s > vST.t ? texture(uFirst, vST) : texture(uSecond, vST); }
)glsl"},
         .showTags = "uFirst 5 uSecond 6",
         .showDraws = "Rotate -30 1 0 0\nQuadXY 0 1.5\n"},
        {.name = "v140_uniform_blocks",
         .stages = {.vertex = R"glsl(#version 140
layout(std140) uniform Placement {
    vec3 uOffset;
    float uScale;
    mat3 uTurn;
};
out vec3 vPoint;
void main() {
    vPoint = uTurn * gl_Vertex.xyz;
    gl_Position = gl_ModelViewProjectionMatrix * vec4(uOffset + uScale * vPoint, 1.);
}
)glsl",
                    .fragment = R"glsl(#version 150 compatibility
layout(std140) uniform Paint {
    vec3 colors[2];
    float mixing;
} uPaint;
in vec3 vPoint;
out vec4 fColor;
void main() { fColor = vec4(mix(uPaint.colors[0], uPaint.colors[1], fract(vPoint.y + uPaint.mixing)), 1.); }
)glsl"},
         .tags = "uOffset [.1 -.2 .3] uScale .9 uTurn [0 1 0  -1 0 0  0 0 1] \\\n"
                 "Paint.colors [1 .5 0  0 .25 1] Paint.mixing .4"},
        {.name = "v140_instances_and_inverse",
         .stages = {.vertex = R"glsl(#version 140
out vec3 vNormal;
void main() {
    vNormal = mat3(transpose(inverse(gl_ModelViewMatrix))) * gl_Normal + float(gl_InstanceID);
    gl_Position = gl_ModelViewProjectionMatrix * gl_Vertex;
}
)glsl",
                    .fragment = R"glsl(#version 140
in vec3 vNormal;
out vec4 fColor;
void main() { fColor = vec4(.5 + .5 * normalize(vNormal), 1.); }
)glsl"}},
        {.name = "v130_colors_each_interpolated_its_own_way",
         .stages = {.vertex = R"glsl(#version 130
flat out vec4 gl_FrontColor;
noperspective out vec4 gl_FrontSecondaryColor;
void main() {
    gl_FrontColor = vec4(abs(gl_Normal), 1.);
    gl_FrontSecondaryColor = vec4(gl_MultiTexCoord0.st, 0., 1.);
    gl_TexCoord[0] = gl_MultiTexCoord0;
    gl_Position = ftransform();
}
)glsl",
                    .fragment = R"glsl(#version 130
flat in vec4 gl_Color;
noperspective in vec4 gl_SecondaryColor;
void main() {
    gl_FragColor = vec4(.5 * gl_Color.rgb + .5 * gl_SecondaryColor.rgb, 1.);
    gl_FragColor.b += .5 * fract(8. * gl_TexCoord[0].s);
}
)glsl"},
         .draws = "Rotate 60 1 0 0\nTorus 1.1 .5 12 16\nQuadXY -.5 1.8 3 3\n"},
        {.name = "v130_fragment_after_v120_vertex",
         .stages = {.vertex = R"glsl(#version 120
varying vec3 vPoint;
void main() {
    vPoint = gl_Vertex.xyz;
    gl_FrontColor = vec4(gl_MultiTexCoord0.st, 0., 1.);
    gl_Position = ftransform();
}
)glsl",
                    .fragment = R"glsl(#version 130
in vec3 vPoint;
out vec4 fColor;
void main() { fColor = vec4(gl_Color.rg, .5 + .5 * vPoint.z, 1.); }
)glsl"}},
    };
}

}  // namespace glibra::oracle
