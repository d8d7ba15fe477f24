// GLSL 1.10: attributes and varyings, colours, coordinates and fragment outputs.

#include "case.h"

namespace glibra::oracle {
namespace {

/// A fragment stage that shows gl_Color.
constexpr const char* kColorFragment = R"glsl(
void main() { gl_FragColor = gl_Color; }
)glsl";

/// A vertex stage for quads that show textures.
constexpr const char* kShowVertex = R"glsl(
varying vec2 vST;
void main() { vST = gl_MultiTexCoord0.st; gl_Position = ftransform(); }
)glsl";

}  // namespace

std::vector<Case> casesOf110() {
    return {
        {.name = "v110_attributes_and_varyings",
         .stages = {.vertex = R"glsl(
#version 110
attribute vec3 aTangent;
varying vec3 vNormal, vTangent;
varying float vHeight;
void main() {
    vNormal = normalize(gl_NormalMatrix * gl_Normal);
    vTangent = aTangent;
    vHeight = gl_Vertex.y;
    gl_Position = gl_ProjectionMatrix * (gl_ModelViewMatrix * gl_Vertex);
}
)glsl",
                    .fragment = R"glsl(
#version 110
varying vec3 vNormal, vTangent;
varying float vHeight;
void main() {
    vec3 n = normalize(vNormal);
    gl_FragColor = vec4(.5 * n.xy + .5, abs(vTangent.x) * .5 + .25 * vHeight, 1.);
}
)glsl"}},
        {.name = "v110_ftransform",
         .stages = {.vertex = R"glsl(
varying vec4 vClip;
void main() {
    gl_Position = ftransform ( );
    vClip = ftransform();
}
)glsl",
                    .fragment = R"glsl(
varying vec4 vClip;
void main() { gl_FragColor = vec4(.5 + .5 * vClip.xyz / vClip.w, 1.); }
)glsl"}},
        {.name = "v110_front_color",
         .stages = {.vertex = R"glsl(
void main() {
    gl_FrontColor.rgb = .5 + .5 * gl_Normal;
    gl_FrontColor.a = 1. - .5 * gl_MultiTexCoord0.t;
    gl_Position = ftransform();
}
)glsl",
                    .fragment = kColorFragment}},
        {.name = "v110_front_color_is_clamped_where_it_leaves_the_vertex_stage",
         .stages = {.vertex = R"glsl(
varying vec4 vFree;
void main() {
    gl_FrontColor = vec4(3. * gl_Normal, 1.5);
    vFree = gl_FrontColor;
    gl_Position = ftransform();
    if (gl_Vertex.x > 0.) return;
    gl_FrontColor = gl_FrontColor * .5;
}
)glsl",
                    .fragment = R"glsl(
varying vec4 vFree;
void main() { gl_FragColor = vec4(.5 * gl_Color.rgb + .15 * (vFree.rgb + 3.) * .5, gl_Color.a); }
)glsl"}},
        {.name = "v110_current_color",
         .stages = {.vertex = R"glsl(
void main() {
    gl_FrontColor = gl_Color * (.5 + .5 * gl_Normal.z);
    gl_FrontColor.a = gl_Color.a;
    gl_Position = ftransform();
}
)glsl",
                    .fragment = kColorFragment},
         .draws = "Color .9 .5 .2 .75\nRotate 20 1 1 1\nSphere 1.2 24 16\n"},
        {.name = "v110_colors_of_a_vertex_list",
         .stages = {.vertex = R"glsl(
varying vec2 vST;
void main() {
    vST = gl_MultiTexCoord0.pq;
    gl_FrontColor = gl_Color;
    gl_Position = ftransform();
}
)glsl",
                    .fragment = R"glsl(
varying vec2 vST;
void main() { gl_FragColor = gl_Color * vec4(vST, 1., 1.); }
)glsl"},
         .draws = "glBegin quads\n"
                  "glTexCoord 0 0 1 1\nglColor 1 0 0\nglVertex -1 -1 0\n"
                  "glColor 0 1 0 .5\nglVertex 1 -1 .5\n"
                  "glTexCoord 0 0 .5 .75\nglColor 0 0 1\nglVertex 1 1 0\n"
                  "glColor 1 1 0\nglVertex -1 .7 0\n"
                  "glEnd\n"},
        {.name = "v110_texture_coordinates",
         .stages = {.vertex = R"glsl(
void main() {
    gl_TexCoord[0] = gl_MultiTexCoord0;
    gl_TexCoord[3].stp = gl_Vertex.xyz;
    gl_TexCoord[3].q = 2.;
    gl_TexCoord[1] = gl_MultiTexCoord4;
    gl_Position = ftransform();
}
)glsl",
                    .fragment = R"glsl(
void main() {
    vec3 p = gl_TexCoord[3].stp / gl_TexCoord[3].q;
    gl_FragColor = vec4(fract(4. * gl_TexCoord[0].st), .5 + p.z * gl_TexCoord[1].q, 1.);
}
)glsl"}},
        {.name = "v110_texture_coordinates_by_a_variable_index",
         .stages = {.vertex = R"glsl(
varying vec4 gl_TexCoord[4];
void main() {
    for (int i = 0; i < 4; i++)
        gl_TexCoord[i] = gl_MultiTexCoord0 * (1. + float(i));
    gl_Position = ftransform();
}
)glsl",
                    .fragment = R"glsl(
varying vec4 gl_TexCoord[4];
void main() {
    vec2 sum = vec2(0.);
    for (int i = 0; i < 4; ++i) sum += fract(gl_TexCoord[i].st);
    gl_FragColor = vec4(sum * .25, .5, 1.);
}
)glsl"}},
        // spotCosCutoff is left out, because the driver has 0 where GL specifies cos 180 degrees = -1.
        {.name = "v110_back_color_on_back_faces",
         .stages = {.vertex = R"glsl(
void main() {
    gl_FrontColor = vec4(1., .5 + .5 * gl_Normal.x, 0., 1.);
    gl_BackColor = vec4(0., .5 + .5 * gl_Normal.y, 2., 1.);
    gl_Position = ftransform();
}
)glsl",
                    .fragment = kColorFragment},
         .draws = "Rotate 60 0 1 0\nQuadXY -.5 1\nRotate 180 0 1 0\nQuadXY -.5 .7 3 3\nQuadXZ .3 .5\n",
         .written = {.backColors = true}},
        {.name = "v110_secondary_colors",
         .stages = {.vertex = R"glsl(
void main() {
    gl_FrontColor = vec4(.25, .5, .75, 1.) + gl_SecondaryColor;
    gl_FrontSecondaryColor = vec4(gl_Normal * 2., 1.);
    gl_BackColor = vec4(.5);
    gl_BackSecondaryColor = vec4(.2, .1, gl_MultiTexCoord0.s, 1.);
    gl_Position = ftransform();
}
)glsl",
                    .fragment = R"glsl(
void main() { gl_FragColor = vec4(.5 * gl_Color.rgb + .5 * gl_SecondaryColor.rgb, 1.); }
)glsl"},
         .draws = "Rotate 60 1 0 0\nDiskXY 0 1.3 20 3\nTranslate 0 0 .5\nRotate 150 1 1 0\nQuadXY 0 .6\n",
         .written = {.backColors = true}},
        {.name = "v110_frag_data_depth_and_facing", .stages = {.vertex = kPointVertex, .fragment = R"glsl(
varying vec3 vPoint;
void main() {
    gl_FragDepth = 1. - gl_FragCoord.z;
    gl_FragData[0] = vec4(fract(gl_FragCoord.xy / 32.), .5 + .25 * vPoint.z, 1.);
    if (!gl_FrontFacing) gl_FragData[0].rgb *= .5;
}
)glsl"}},
        {.name = "v110_frag_color_in_functions_and_early_returns",
         .stages = {.vertex = kPointVertex, .fragment = R"glsl(
varying vec3 vPoint;
void paint(vec3 rgb) { gl_FragColor = vec4(rgb, 1.); }
void darken(inout vec4 color, float by) { color.rgb *= by; }
void main(void) {
    paint(.5 + .5 * vPoint);
    if (vPoint.y > .2) { darken(gl_FragColor, .6); return; }
    if (fract(vPoint.x * 5.) < .3)
        discard;
    gl_FragColor.r = gl_FragColor.b + .25 * gl_FragColor.g;
    if (vPoint.z > 0.) return;
    gl_FragColor = gl_FragColor.bgra;
}
)glsl"}},
        {.name = "v110_frag_color_goes_to_all_targets",
         .stages = {.vertex = kPointVertex, .fragment = R"glsl(
varying vec3 vPoint;
void main() {
    gl_FragColor = vec4(.5 + .5 * vPoint, .75);
    if (vPoint.x < 0.) return;
    gl_FragColor.g = .5;
}
)glsl"},
         .before = "Texture2D 5 64 64\nTexture2D 6 64 64\n",
         .draws = "RenderToTexture 5 6\nRotate 35 1 2 0\nTorus 1.1 .5 24 36\nRenderToTexture\n",
         .show = {.vertex = kShowVertex, .fragment = R"glsl(
varying vec2 vST;
uniform sampler2D uFirst, uSecond;
void main() { gl_FragColor = vST.s + vST.t > 1. ? texture2D(uFirst, vST) : texture2D(uSecond, vST.ts).bgra; }
)glsl"},
         .showTags = "uFirst 5 uSecond 6",
         .showDraws = "Rotate -30 1 0 0\nQuadXY 0 1.5\n"},
        {.name = "v110_frag_data_goes_to_its_own_target",
         .stages = {.vertex = kPointVertex, .fragment = R"glsl(
varying vec3 vPoint;
void main() {
    gl_FragData[1] = vec4(fract(2. * vPoint), 1.);
    gl_FragData[0] = vec4(.5 + .5 * vPoint.zyx, .5);
}
)glsl"},
         .before = "Texture2D 5 64 64\nTexture2D 6 64 64 RGBA16F\n",
         .draws = "RenderToTexture 5 6\nRotate 35 1 2 0\nTorus 1.1 .5 24 36\nRenderToTexture\n",
         .show = {.vertex = kShowVertex, .fragment = R"glsl(
varying vec2 vST;
uniform sampler2D uFirst, uSecond;
void main() { gl_FragColor = vec4(texture2D(uFirst, vST).rg, texture2D(uSecond, vST).bg).xyzw; }
)glsl"},
         .showTags = "uFirst 5 uSecond 6",
         .showDraws = "Rotate -30 1 0 0\nQuadXY 0 1.5\n"},
        {.name = "v110_flat_colors",
         .stages = {.vertex = R"glsl(
varying float vSmooth;
void main() {
    vSmooth = gl_MultiTexCoord0.s;
    gl_FrontColor = vec4(.5 + .5 * gl_Normal, 1.);
    gl_BackColor = gl_FrontColor.bgra;
    gl_Position = ftransform();
}
)glsl",
                    .fragment = R"glsl(
varying float vSmooth;
void main() { gl_FragColor = gl_Color * vec4(1., 1., vSmooth, 1.); }
)glsl"},
         .draws = "Flat\nRotate 35 1 2 0\nTorus 1.1 .5 12 16\n"
                  "Rotate 200 0 1 0\nCone .8 1 9 3\nQuadXY -1 1.2 3 3\n",
         .written = {.backColors = true}},
        {.name = "v110_point_sizes",
         .stages = {.vertex = R"glsl(
varying vec3 vPoint;
void main() {
    vPoint = gl_Vertex.xyz;
    gl_PointSize = 4. + 3. * gl_Vertex.x;
    gl_Position = ftransform();
}
)glsl",
                    .fragment = R"glsl(
varying vec3 vPoint;
void main() { gl_FragColor = vec4(.5 + .5 * vPoint, 1.); }
)glsl"},
         .draws = "PointSizeMode 1\nPointCloud 5 5 5\n"},
        {.name = "v110_built_in_outputs_as_arguments",
         .stages = {.vertex = R"glsl(
void shade(in vec3 n, out vec4 color, inout vec4 coordinates) {
    color = vec4(abs(n), 1.);
    coordinates.st += coordinates.ts * .5;
}
void main() {
    gl_TexCoord[2] = gl_MultiTexCoord0;
    shade(gl_Normal, gl_FrontColor, gl_TexCoord[2]);
    gl_Position = gl_Vertex;
    gl_Position.y *= 1.5;
    gl_Position = gl_ModelViewProjectionMatrix * vec4(gl_Position.xyz, 1.);
    gl_Position.x += .1 * gl_Position.w;
}
)glsl",
                    .fragment = R"glsl(
void main() { gl_FragColor = vec4(gl_Color.rg, fract(2. * gl_TexCoord[2].s), gl_Color.a); }
)glsl"}},
    };
}

}  // namespace glibra::oracle
