// GLSL 1.50 with its own geometry stage and interfaces.

#include "case.h"

namespace glibra::oracle {

std::vector<Case> casesOf150() {
    return {
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
         .stages =
             {.vertex = "#version 150 compatibility\nvoid main() { gl_Position = gl_Vertex; }\n",
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
              .fragment =
                  "#version 150 compatibility\nin vec4 gColor; void main() { gl_FragColor = gColor; }\n"},
         .draws = "glBegin gl_triangles_adjacency\nglVertex -1 -1 0\nglVertex 0 -1.5 0\nglVertex 1 -1 0\n"
                  "glVertex 1 .5 1\nglVertex 0 1 0\nglVertex -1 .5 .3\nglEnd\n"},
        {.name = "v150_flat_colors_of_a_geometry_stage",
         .stages = {.vertex = "void main() { gl_FrontColor = vec4(.5 + .5 * gl_Normal, 1.); gl_Position = "
                              "ftransform(); }",
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
