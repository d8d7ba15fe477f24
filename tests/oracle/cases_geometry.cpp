// Geometry stages: GL_EXT_geometry_shader4, which Mesa has never had, so that the oracle compiles a stage of 1.50
// written by hand in its place; and 1.50 itself.

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

constexpr const char* kColorFragment = R"glsl(
varying vec3 gNormal;
void main() { gl_FragColor = vec4(gl_Color.rg, fract(4. * gl_TexCoord[0].s) * .5 + .25 * gNormal.z + .25, 1.); }
)glsl";

constexpr const char* kTriangles =
    "GeometryInput gl_triangles\nGeometryOutput gl_triangle_strip\nGeometryVerticesOut 12\n";

}  // namespace

std::vector<Case> casesOf150() {
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
                    .fragment = kColorFragment},
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
         // What the vertex stage writes is not clamped on its way to the geometry stage: clamping comes before
         // rasterisation (language, 7.6).
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
                    .fragment = kColorFragment},
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
        {.name = "v150_geometry_with_built_in_varyings",
         .stages = {.vertex = R"glsl(#version 150 compatibility
out vec3 vNormal;
void main() {
    vNormal = gl_Normal;
    gl_FrontColor = vec4(3. * gl_Normal.x, .5 + .5 * gl_Normal.yz, 1.);
    gl_TexCoord[1] = gl_MultiTexCoord0;
    gl_Position = ftransform();
}
)glsl",
                    .geometry = R"glsl(#version 150 compatibility
layout(triangles) in;
layout(triangle_strip, max_vertices = 6) out;
in vec3 vNormal[];
out vec3 gNormal;
void emit(int i, float grow) {
    gl_Position = gl_in[i].gl_Position + gl_ProjectionMatrix * vec4(grow * gl_NormalMatrix * vNormal[i], 0.);
    gl_FrontColor = gl_in[i].gl_FrontColor * (1. - grow);
    gl_FrontColor.a = 1.;
    gl_TexCoord[1] = gl_in[i].gl_TexCoord[1];
    gNormal = vNormal[i];
    gl_PrimitiveID = gl_PrimitiveIDIn;
    EmitVertex();
}
void main() {
    emit(0, 0.); emit(1, 0.); emit(2, 0.);
    EndPrimitive();
    if (gl_PrimitiveIDIn % 3 != 0) return;
    emit(0, .25); emit(1, .25); emit(2, .25);
}
)glsl",
                    .fragment = R"glsl(#version 150 compatibility
in vec3 gNormal;
out vec4 fColor;
void main() {
    float stripe = float(gl_PrimitiveID % 5) / 5.;
    fColor = vec4(gl_Color.rg, .5 * fract(3. * gl_TexCoord[1].t) + .25 * gNormal.z + .25 * stripe, 1.);
}
)glsl"}},
        {.name = "v150_interface_blocks",
         .stages = {.vertex = R"glsl(#version 150 compatibility
out Data {
    vec3 normal;
    flat int which;
} dataOut;
void main() {
    dataOut.normal = gl_Normal;
    dataOut.which = gl_VertexID % 5;
    gl_Position = gl_ModelViewProjectionMatrix * gl_Vertex;
}
)glsl",
                    .geometry = R"glsl(#version 150 compatibility
layout(triangles) in;
layout(triangle_strip, max_vertices = 3) out;
in Data {
    vec3 normal;
    flat int which;
} dataIn[];
out Shade { vec3 normal; float which; };
void main() {
    for (int i = 0; i < gl_in.length(); ++i) {
        normal = dataIn[i].normal;
        which = float(dataIn[0].which);
        gl_Position = gl_in[i].gl_Position;
        EmitVertex();
    }
}
)glsl",
                    .fragment = R"glsl(#version 150 compatibility
in Shade { vec3 normal; float which; };
void main() { gl_FragColor = vec4(.5 + .5 * normal.xy, which / 4., 1.); }
)glsl"}},
        {.name = "v150_triangles_with_adjacency",
         .stages = {.vertex = "#version 150 compatibility\nvoid main() { gl_Position = gl_Vertex; }\n",
                    .geometry = R"glsl(#version 150 compatibility
layout(triangles_adjacency) in;
layout(triangle_strip, max_vertices = 3) out;
out vec4 gColor;
void main() {
    for (int i = 0; i < 6; i += 2) {
        gColor = vec4(.5 + .5 * gl_in[i + 1].gl_Position.xyz, 1.);
        gl_Position = gl_ModelViewProjectionMatrix * gl_in[i].gl_Position;
        EmitVertex();
    }
}
)glsl",
                    .fragment = "#version 150 compatibility\nin vec4 gColor; void main() { gl_FragColor = gColor; }\n"},
         .draws = "glBegin gl_triangles_adjacency\nglVertex -1 -1 0\nglVertex 0 -1.5 0\nglVertex 1 -1 0\n"
                  "glVertex 1 .5 1\nglVertex 0 1 0\nglVertex -1 .5 .3\nglEnd\n"},
        {.name = "v150_flat_colors_of_a_geometry_stage",
         .stages = {.vertex = "void main() { gl_FrontColor = vec4(.5 + .5 * gl_Normal, 1.); gl_Position = ftransform(); }",
                    .geometry = R"glsl(#version 150 compatibility
layout(triangles) in;
layout(triangle_strip, max_vertices = 3) out;
void main() {
    for (int i = 0; i < 3; ++i) {
        gl_Position = gl_in[i].gl_Position;
        gl_FrontColor = gl_in[i].gl_FrontColor;
        EmitVertex();
    }
}
)glsl",
                    .fragment = "void main() { gl_FragColor = gl_Color; }"},
         .draws = "Flat\nRotate 35 1 2 0\nTorus 1.1 .5 12 16\n"},
    };
}

}  // namespace glibra::oracle
