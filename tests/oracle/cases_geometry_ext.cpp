// Geometry stages of GL_EXT_geometry_shader4. Mesa has never had it, so the oracle compiles stages of 1.50
// that are written by hand.

#include "case.h"

namespace glibra::oracle {
namespace {

constexpr const char* kColorVertex = R"glsl(
varying vec3 vNormal;
void main() {
    vNormal = gl_Normal;
    gl_FrontColor = vec4(.5 + .5 * gl_Normal, 1.);
    gl_BackColor = vec4(gl_MultiTexCoord0.st, .5, 1.);
    gl_TexCoord[0] = gl_MultiTexCoord0;
    gl_Position = gl_ProjectionMatrix * (gl_ModelViewMatrix * gl_Vertex);
}
)glsl";

constexpr const char* kGeometryFragment = R"glsl(
varying vec3 gNormal;
void main() { gl_FragColor = vec4(gl_Color.rg, fract(4. * gl_TexCoord[0].s) * .5 + .25 * gNormal.z + .25, 1.); }
)glsl";

constexpr const char* kTriangles =
    "GeometryInput gl_triangles\nGeometryOutput gl_triangle_strip\nGeometryVerticesOut 12\n";

}  // namespace

std::vector<Case> casesOfGeometryShader4() {
    return {
        {.name = "ext_geometry_shrinks_triangles",
         .stages = {.vertex = kColorVertex,
                    .geometry = R"glsl(#version 120
#extension GL_EXT_geometry_shader4 : enable
varying in vec3 vNormal[3];
varying out vec3 gNormal;
uniform float uShrink;
void main() {
    vec4 middle = (gl_PositionIn[0] + gl_PositionIn[1] + gl_PositionIn[2]) / 3.;
    for (int i = 0; i < gl_VerticesIn; i++) {
        gl_Position = middle + uShrink * (gl_PositionIn[i] - middle);
        gl_FrontColor = gl_FrontColorIn[i];
        gl_TexCoord[0] = gl_TexCoordIn[i][0];
        gNormal = vNormal[i];
        EmitVertex();
    }
    EndPrimitive();
}
)glsl",
                    .fragment = kGeometryFragment},
         .before = kTriangles,
         .tags = "uShrink <0. .75 1.>",
         .byHand = {.geometry = R"glsl(#version 150 compatibility
layout(triangles) in;
layout(triangle_strip, max_vertices = 12) out;
in vec3 vNormal[];
out vec3 gNormal;
uniform float uShrink;
void main() {
    vec4 middle = (gl_in[0].gl_Position + gl_in[1].gl_Position + gl_in[2].gl_Position) / 3.;
    for (int i = 0; i < 3; i++) {
        gl_Position = middle + uShrink * (gl_in[i].gl_Position - middle);
        gl_FrontColor = gl_in[i].gl_FrontColor;
        gl_TexCoord[0] = gl_in[i].gl_TexCoord[0];
        gNormal = vNormal[i];
        EmitVertex();
    }
    EndPrimitive();
}
)glsl"}},
        {.name = "ext_geometry_makes_squares_of_points",
         .stages = {.vertex = R"glsl(
varying vec3 vPoint;
void main() {
    vPoint = gl_Vertex.xyz;
    gl_Position = gl_ModelViewMatrix * gl_Vertex;
}
)glsl",
                    .geometry = R"glsl(
#version 120
#extension GL_EXT_geometry_shader4 : require
varying in vec3 vPoint[gl_VerticesIn];
varying out vec2 gST;
varying out vec3 gPoint;
void corner(vec2 st) {
    gST = st;
    gPoint = vPoint[0];
    gl_Position = gl_ProjectionMatrix * (gl_PositionIn[0] + vec4(.15 * (st - .5), 0., 0.));
    EmitVertex();
}
void main() {
    corner(vec2(0., 0.)); corner(vec2(1., 0.)); corner(vec2(0., 1.)); corner(vec2(1., 1.));
    EndPrimitive();
}
)glsl",
                    .fragment = R"glsl(
varying vec2 gST;
varying vec3 gPoint;
void main() { gl_FragColor = vec4(gST, .5 + .5 * gPoint.x, 1.); }
)glsl"},
         .before = "GeometryInput gl_points\nGeometryOutput gl_triangles_strip\nGeometryVerticesOut 4\n",
         .draws = "PointCloud 6 6 4\n",
         .byHand = {.geometry = R"glsl(#version 150 compatibility
layout(points) in;
layout(triangle_strip, max_vertices = 4) out;
in vec3 vPoint[];
out vec2 gST;
out vec3 gPoint;
void corner(vec2 st) {
    gST = st;
    gPoint = vPoint[0];
    gl_Position = gl_ProjectionMatrix * (gl_in[0].gl_Position + vec4(.15 * (st - .5), 0., 0.));
    EmitVertex();
}
void main() {
    corner(vec2(0., 0.)); corner(vec2(1., 0.)); corner(vec2(0., 1.)); corner(vec2(1., 1.));
    EndPrimitive();
}
)glsl"}},
        {.name = "ext_geometry_with_lines_and_adjacency",
         .stages = {.vertex = "void main() { gl_PointSize = 3.; gl_Position = gl_Vertex; }\n",
                    .geometry = R"glsl(#version 120
#extension GL_EXT_geometry_shader4: enable
#extension GL_EXT_gpu_shader4: enable
varying out vec4 gColor;
void main() {
    for (int i = 0; i <= 12; i++) {
        float t = float(i) / 12.;
        vec4 curve = (1. - t) * (1. - t) * (1. - t) * gl_PositionIn[0] + 3. * t * (1. - t) * (1. - t) * gl_PositionIn[1]
                     + 3. * t * t * (1. - t) * gl_PositionIn[2] + t * t * t * gl_PositionIn[3];
        float side = gl_PointSizeIn[0] * .05;
        gColor = vec4(t, float(gl_PrimitiveIDIn), 1. - t, 1.);
        gl_Position = gl_ModelViewProjectionMatrix * (curve + vec4(0., side, 0., 0.));
        EmitVertex();
        gl_Position = gl_ModelViewProjectionMatrix * (curve - vec4(0., side, 0., 0.));
        gColor.b = 1.;
        EmitVertex();
    }
}
)glsl",
                    .fragment = "varying vec4 gColor; void main() { gl_FragColor = gColor; }\n"},
         .before = "GeometryInput lines_adjacency\nGeometryOutput triangle_strip\nGeometryVerticesOut 32\n",
         .draws = "LinesAdjacency [-1 -1 0] [-.5 2 0] [.5 -2 0] [1 1 0]\n"
                  "LinesAdjacency [-1 1 0] [0 1 1] [0 -1 1] [1 -1 0] [-1 0 0] [0 0 1] [0 1 1] [1 .5 0]\n",
         .byHand = {.geometry = R"glsl(#version 150 compatibility
layout(lines_adjacency) in;
layout(triangle_strip, max_vertices = 32) out;
out vec4 gColor;
void main() {
    for (int i = 0; i <= 12; i++) {
        float t = float(i) / 12.;
        vec4 curve = (1. - t) * (1. - t) * (1. - t) * gl_in[0].gl_Position +
                     3. * t * (1. - t) * (1. - t) * gl_in[1].gl_Position +
                     3. * t * t * (1. - t) * gl_in[2].gl_Position + t * t * t * gl_in[3].gl_Position;
        float side = 3. * .05;
        gColor = vec4(t, float(gl_PrimitiveIDIn), 1. - t, 1.);
        gl_Position = gl_ModelViewProjectionMatrix * (curve + vec4(0., side, 0., 0.));
        EmitVertex();
        gl_Position = gl_ModelViewProjectionMatrix * (curve - vec4(0., side, 0., 0.));
        gColor.b = 1.;  // written once more for the second vertex, the rest as it was
        EmitVertex();
    }
}
)glsl"}},
        {.name = "ext_geometry_with_all_built_in_colors",
         .stages = {.vertex = R"glsl(
void main() {
    gl_FrontColor = vec4(2. * gl_Normal.x, .5, .25, 1.);
    gl_BackColor = vec4(.1, gl_MultiTexCoord0.s, .9, 1.);
    gl_FrontSecondaryColor = vec4(0., 0., gl_MultiTexCoord0.t, 0.);
    gl_BackSecondaryColor = vec4(0., .5, 0., 0.);
    gl_FogFragCoord = gl_Vertex.y;
    gl_Position = ftransform();
}
)glsl",
                    .geometry = R"glsl(#version 120
#extension GL_EXT_geometry_shader4 : enable
void main() {
    for (int i = 0; i < gl_PositionIn.length(); ++i) {
        gl_Position = gl_PositionIn[i];
        gl_FrontColor = gl_FrontColorIn[i] * 1.5;
        gl_BackColor = gl_BackColorIn[2 - i];
        gl_FrontSecondaryColor = gl_FrontSecondaryColorIn[i];
        gl_BackSecondaryColor = gl_BackSecondaryColorIn[i];
        gl_FogFragCoord = gl_FogFragCoordIn[i];
        EmitVertex();
    }
}
)glsl",
                    .fragment = R"glsl(
void main() { gl_FragColor = vec4(gl_Color.rgb * .75 + gl_SecondaryColor.rgb * .25 + .1 * gl_FogFragCoord, 1.); }
)glsl"},
         .before = "GeometryVerticesOut 3\n",
         .draws = "Rotate 70 1 .2 0\nCylinder 1 1.2 24 4\nRotate 180 1 0 0\nTranslate 0 0 1.3\nQuadXY 0 .5\n",
         .written = {.backColors = true},
         // Colours from the vertex stage reach the geometry stage unclamped. Only the last stage before
         // rasterisation clamps them (language, 7.6).
         .byHand = {.geometry = R"glsl(#version 150 compatibility
layout(triangles) in;
layout(triangle_strip, max_vertices = 3) out;
void main() {
    for (int i = 0; i < 3; ++i) {
        gl_Position = gl_in[i].gl_Position;
        gl_FrontColor = gl_in[i].gl_FrontColor * 1.5;
        gl_BackColor = gl_in[2 - i].gl_BackColor;
        gl_FrontSecondaryColor = gl_in[i].gl_FrontSecondaryColor;
        gl_BackSecondaryColor = gl_in[i].gl_BackSecondaryColor;
        gl_FogFragCoord = gl_in[i].gl_FogFragCoord;
        EmitVertex();
    }
}
)glsl"}},
        {.name = "ext_geometry_names_with_a_layout",
         .stages = {.vertex = kColorVertex,
                    .geometry = R"glsl(#version 330 compatibility
#extension GL_EXT_geometry_shader4 : enable
layout(triangles) in;
layout(line_strip, max_vertices = 6) out;
in vec3 vNormal[gl_VerticesIn];
out vec3 gNormal;
void main() {
    for (int i = 0; i < gl_VerticesIn; ++i) {
        int to = (i + 1) % gl_VerticesIn;
        gNormal = vNormal[i];
        gl_FrontColor = gl_FrontColorIn[to];
        gl_TexCoord[0] = gl_TexCoordIn[i][0];
        gl_Position = gl_PositionIn[i];
        EmitVertex();
        gNormal = vNormal[to];
        gl_FrontColor = gl_FrontColorIn[to];
        gl_TexCoord[0] = gl_TexCoordIn[to][0];
        gl_Position = gl_PositionIn[ to ];
        EmitVertex();
        EndPrimitive();
    }
}
)glsl",
                    .fragment = kGeometryFragment},
         .draws = "Rotate 35 1 2 0\nTorus 1.1 .5 10 14\n",
         .byHand = {.geometry = R"glsl(#version 330 compatibility
layout(triangles) in;
layout(line_strip, max_vertices = 6) out;
in vec3 vNormal[];
out vec3 gNormal;
void main() {
    for (int i = 0; i < 3; ++i) {
        int to = (i + 1) % 3;
        gNormal = vNormal[i];
        gl_FrontColor = gl_in[to].gl_FrontColor;
        gl_TexCoord[0] = gl_in[i].gl_TexCoord[0];
        gl_Position = gl_in[i].gl_Position;
        EmitVertex();
        gNormal = vNormal[to];
        gl_FrontColor = gl_in[to].gl_FrontColor;
        gl_TexCoord[0] = gl_in[to].gl_TexCoord[0];
        gl_Position = gl_in[to].gl_Position;
        EmitVertex();
        EndPrimitive();
    }
}
)glsl"}},
        {.name = "ext_geometry_with_plain_varyings_and_macros",
         .stages = {.vertex = kColorVertex,
                    .geometry = R"glsl(#version 120
#extension GL_EXT_geometry_shader4 : enable
#define P(i) gl_PositionIn[i]
#define COORDINATES(i) gl_TexCoordIn[(i)][0]
varying in vec3 vNormal[];
varying vec3 gNormal;
int last() { return gl_VerticesIn - 1; }
void emit(vec4 p, int i) {
    gl_Position = p;
    gNormal = vNormal[i];
    gl_TexCoord[0] = COORDINATES(i);
    gl_FrontColor = gl_FrontColorIn[last()] + .1;
    EmitVertex();
}
void main() {
    int order[3];
    order[0] = 1; order[1] = 2; order[2] = 0;
    if (P(0).z < -9.) return;
    for (int k = 0; k < 3; ++k) emit(gl_PositionIn[order[k]] * .8 + P(order[(k + 1) - 3 * ((k + 1) / 3)]) * .2, order[k]);
    EndPrimitive();
}
)glsl",
                    .fragment = kGeometryFragment},
         .before = kTriangles,
         .byHand = {.geometry = R"glsl(#version 150 compatibility
layout(triangles) in;
layout(triangle_strip, max_vertices = 12) out;
in vec3 vNormal[];
out vec3 gNormal;
void emit(vec4 p, int i) {
    gl_Position = p;
    gNormal = vNormal[i];
    gl_TexCoord[0] = gl_in[i].gl_TexCoord[0];
    gl_FrontColor = gl_in[2].gl_FrontColor + .1;
    EmitVertex();
}
void main() {
    for (int k = 0; k < 3; ++k)
        emit(gl_in[(k + 1) % 3].gl_Position * .8 + gl_in[(k + 2) % 3].gl_Position * .2, (k + 1) % 3);
    EndPrimitive();
}
)glsl"}},
        {.name = "ext_geometry_with_several_texture_coordinates",
         .stages = {.vertex = R"glsl(
void main() {
    for (int i = 0; i < 3; ++i) gl_TexCoord[i] = gl_MultiTexCoord0 * float(i + 1);
    gl_Position = ftransform();
}
)glsl",
                    .geometry = R"glsl(#version 120
#extension GL_EXT_geometry_shader4 : enable
void main() {
    for (int i = 0; i < gl_VerticesIn; ++i) {
        for (int n = 0; n < 3; ++n) gl_TexCoord[n] = gl_TexCoordIn[i][2 - n];
        gl_Position = gl_PositionIn[i];
        EmitVertex();
    }
}
)glsl",
                    .fragment = R"glsl(
void main() { gl_FragColor = vec4(fract(gl_TexCoord[0].s), fract(gl_TexCoord[1].t), gl_TexCoord[2].s, 1.); }
)glsl"},
         // The vertex stage is replaced as well, because gl_TexCoord without a size needs constant indices
         // there.
         .byHand = {.vertex = R"glsl(
void main() {
    gl_TexCoord[0] = gl_MultiTexCoord0;
    gl_TexCoord[1] = gl_MultiTexCoord0 * 2.;
    gl_TexCoord[2] = gl_MultiTexCoord0 * 3.;
    gl_Position = ftransform();
}
)glsl",
                    .geometry = R"glsl(#version 150 compatibility
layout(triangles) in;
layout(triangle_strip, max_vertices = 3) out;
out vec4 gl_TexCoord[3];
void main() {
    for (int i = 0; i < 3; ++i) {
        gl_TexCoord[0] = gl_in[i].gl_TexCoord[2];
        gl_TexCoord[1] = gl_in[i].gl_TexCoord[1];
        gl_TexCoord[2] = gl_in[i].gl_TexCoord[0];
        gl_Position = gl_in[i].gl_Position;
        EmitVertex();
    }
}
)glsl"}},
        // A value that the stage in between does not write counts as unwritten: colours are the current
        // colour, coordinates (0, 0, 0, 1), varyings 0 (language, 7.6 and 7.9).
        {.name = "ext_geometry_that_passes_nothing_on",
         .stages = {.vertex = R"glsl(
varying vec3 vNormal;
void main() {
    vNormal = vec3(1.);
    gl_FrontColor = vec4(0.);
    gl_TexCoord[0] = vec4(.5);
    gl_Position = ftransform();
}
)glsl",
                    .geometry = R"glsl(#version 120
#extension GL_EXT_geometry_shader4 : enable
varying out float gWhich;
void main() {
    for (int i = 0; i < gl_VerticesIn; ++i) {
        gWhich = float(i);
        gl_Position = gl_PositionIn[i];
        EmitVertex();
    }
}
)glsl",
                    .fragment = R"glsl(
varying vec3 vNormal;
varying float gWhich;
void main() { gl_FragColor = vec4(gl_Color.rg * .5 * gWhich, gl_TexCoord[0].q - gl_TexCoord[0].s, 1.) + vec4(vNormal, 0.); }
)glsl"},
         .draws = "Color .9 .6 .1\nRotate 35 1 2 0\nTorus 1.1 .5 12 16\n",
         .byHand = {.geometry = R"glsl(#version 150 compatibility
layout(triangles) in;
layout(triangle_strip, max_vertices = 3) out;
out float gWhich;
void main() {
    for (int i = 0; i < 3; ++i) {
        gWhich = float(i);
        gl_Position = gl_in[i].gl_Position;
        EmitVertex();
    }
}
)glsl",
                    .fragment = R"glsl(#version 150 compatibility
in float gWhich;
void main() { gl_FragColor = vec4(vec2(.9, .6) * .5 * gWhich, 1., 1.); }
)glsl"}},
    };
}

}  // namespace glibra::oracle
