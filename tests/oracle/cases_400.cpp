// GLSL 4.00 and the tessellation stages.

#include "case.h"

namespace glibra::oracle {
namespace {

constexpr const char* kPassVertex = R"glsl(#version 400 compatibility
out vec3 vNormal;
void main() {
    vNormal = gl_Normal;
    gl_Position = gl_Vertex;
}
)glsl";

constexpr const char* kPatch =
    "NumPatchVertices 4\nglBegin gl_patches\nglVertex -1.2 -1 0\nglVertex 1 -1.2 .5\nglVertex 1.2 1 0\n"
    "glVertex -1 1.1 .6\nglEnd\n";

}  // namespace

std::vector<Case> casesOf400() {
    return {
        {.name = "v400_quads",
         .stages = {.vertex = "#version 400 compatibility\nvoid main() { gl_Position = gl_Vertex; }\n",
                    .tessControl = R"glsl(#version 400 compatibility
layout(vertices = 4) out;
uniform float uLevel;
patch out vec3 pColor;
void main() {
    gl_out[gl_InvocationID].gl_Position = gl_in[gl_InvocationID].gl_Position;
    if (gl_InvocationID == 0) {
        gl_TessLevelOuter[0] = gl_TessLevelOuter[1] = gl_TessLevelOuter[2] = gl_TessLevelOuter[3] = uLevel;
        gl_TessLevelInner[0] = gl_TessLevelInner[1] = uLevel;
        pColor = vec3(1., .5, .25) * float(gl_PatchVerticesIn) / 4.;
    }
}
)glsl",
                    .tessEvaluation = R"glsl(#version 400 compatibility
layout(quads, equal_spacing, ccw) in;
patch in vec3 pColor;
out vec3 eColor;
void main() {
    vec4 low = mix(gl_in[0].gl_Position, gl_in[1].gl_Position, gl_TessCoord.x);
    vec4 high = mix(gl_in[3].gl_Position, gl_in[2].gl_Position, gl_TessCoord.x);
    vec4 p = mix(low, high, gl_TessCoord.y);
    p.z += .4 * sin(6. * p.x) * cos(5. * p.y);
    eColor = pColor * vec3(gl_TessCoord.xy, .5 + p.z);
    gl_Position = gl_ModelViewProjectionMatrix * p;
}
)glsl",
                    .fragment = R"glsl(#version 400 compatibility
in vec3 eColor;
out vec4 fColor;
void main() { fColor = vec4(eColor, 1.); }
)glsl"},
         .tags = "uLevel <1 14 64>",
         .draws = kPatch},
        // Levels are written with constant indices, because with gl_InvocationID as the index llvmpipe (22.3)
        // draws nothing in either profile.
        {.name = "v400_triangles_with_a_geometry_stage",
         .stages = {.vertex = kPassVertex,
                    .tessControl = R"glsl(#version 400 compatibility
layout(vertices = 3) out;
in vec3 vNormal[];
out vec3 cNormal[];
void main() {
    cNormal[gl_InvocationID] = vNormal[gl_InvocationID];
    gl_out[gl_InvocationID].gl_Position = gl_in[gl_InvocationID].gl_Position;
    barrier();
    gl_TessLevelOuter[0] = gl_TessLevelOuter[1] = gl_TessLevelOuter[2] = 3.;
    gl_TessLevelInner[0] = 2.5;
}
)glsl",
                    .tessEvaluation = R"glsl(#version 400 compatibility
layout(triangles, fractional_odd_spacing) in;
in vec3 cNormal[];
out vec3 eNormal;
void main() {
    vec3 w = gl_TessCoord;
    eNormal = normalize(w.x * cNormal[0] + w.y * cNormal[1] + w.z * cNormal[2]);
    gl_Position = w.x * gl_in[0].gl_Position + w.y * gl_in[1].gl_Position + w.z * gl_in[2].gl_Position;
    gl_Position.xyz = normalize(gl_Position.xyz) * 1.3;
}
)glsl",
                    .geometry = R"glsl(#version 400 compatibility
layout(triangles) in;
layout(triangle_strip, max_vertices = 3) out;
in vec3 eNormal[];
out vec3 gNormal;
void main() {
    vec4 middle = (gl_in[0].gl_Position + gl_in[1].gl_Position + gl_in[2].gl_Position) / 3.;
    for (int i = 0; i < 3; ++i) {
        gNormal = eNormal[i];
        gl_Position = gl_ModelViewProjectionMatrix * mix(middle, gl_in[i].gl_Position, .8);
        EmitVertex();
    }
}
)glsl",
                    .fragment = R"glsl(#version 400 compatibility
in vec3 gNormal;
out vec4 fColor;
void main() { fColor = vec4(.5 + .5 * gNormal, 1.); }
)glsl"},
         .draws = "Rotate 35 1 2 0\nSphere 1.3 8 6\n"},
        {.name = "v400_evaluation_without_control",
         .stages = {.vertex = kPassVertex,
                    .tessEvaluation = R"glsl(#version 400 compatibility
layout(triangles) in;
in vec3 vNormal[];
out vec3 eNormal;
void main() {
    eNormal = vNormal[0] * gl_TessCoord.x + vNormal[1] * gl_TessCoord.y + vNormal[2] * gl_TessCoord.z;
    gl_Position = gl_ModelViewProjectionMatrix *
                  mat3x4(gl_in[0].gl_Position, gl_in[1].gl_Position, gl_in[2].gl_Position) * gl_TessCoord;
}
)glsl",
                    .fragment = R"glsl(#version 400 compatibility
in vec3 eNormal;
out vec4 fColor;
void main() { fColor = vec4(.5 + .5 * normalize(eNormal), 1.); }
)glsl"}},
        {.name = "v400_built_in_varyings_through_tessellation",
         .stages = {.vertex = R"glsl(#version 400 compatibility
void main() {
    gl_FrontColor = vec4(.5 + gl_Vertex.xyz, 1.);
    gl_TexCoord[0] = gl_Vertex * 2.;
    gl_Position = gl_Vertex;
}
)glsl",
                    .tessControl = R"glsl(#version 400 compatibility
layout(vertices = 4) out;
void main() {
    gl_out[gl_InvocationID].gl_Position = gl_in[gl_InvocationID].gl_Position;
    gl_out[gl_InvocationID].gl_FrontColor = gl_in[gl_InvocationID].gl_FrontColor * 1.25;
    gl_out[gl_InvocationID].gl_TexCoord[0] = gl_in[gl_InvocationID].gl_TexCoord[0];
    gl_TessLevelOuter[0] = gl_TessLevelOuter[1] = gl_TessLevelOuter[2] = gl_TessLevelOuter[3] = 4.;
    gl_TessLevelInner[0] = gl_TessLevelInner[1] = 4.;
}
)glsl",
                    .tessEvaluation = R"glsl(#version 400 compatibility
layout(quads) in;
void main() {
    vec2 t = gl_TessCoord.xy;
    gl_Position = gl_ModelViewProjectionMatrix *
                  mix(mix(gl_in[0].gl_Position, gl_in[1].gl_Position, t.x),
                      mix(gl_in[3].gl_Position, gl_in[2].gl_Position, t.x), t.y);
    gl_FrontColor = mix(mix(gl_in[0].gl_FrontColor, gl_in[1].gl_FrontColor, t.x),
                        mix(gl_in[3].gl_FrontColor, gl_in[2].gl_FrontColor, t.x), t.y);
    gl_TexCoord[0] = gl_in[0].gl_TexCoord[0] + vec4(t, 0., 0.);
}
)glsl",
                    .fragment = R"glsl(#version 400 compatibility
void main() { gl_FragColor = vec4(gl_Color.rg, fract(gl_TexCoord[0].s), 1.); }
)glsl"},
         .draws = kPatch},
        {.name = "arb_tessellation_shader_on_v150",
         .stages = {.vertex = "#version 150 compatibility\nvoid main() { gl_Position = gl_Vertex; }\n",
                    .tessControl = R"glsl(#version 150 compatibility
#extension GL_ARB_tessellation_shader : enable
layout(vertices = 4) out;
void main() {
    gl_out[gl_InvocationID].gl_Position = gl_in[gl_InvocationID].gl_Position;
    gl_TessLevelOuter[0] = 3.;
    gl_TessLevelOuter[1] = 40.;
}
)glsl",
                    .tessEvaluation = R"glsl(#version 150 compatibility
#extension GL_ARB_tessellation_shader : enable
layout(isolines) in;
out vec2 eCoord;
void main() {
    eCoord = gl_TessCoord.xy;
    float t = gl_TessCoord.x, u = 1. - t;
    vec4 p = u * u * u * gl_in[0].gl_Position + 3. * u * u * t * gl_in[1].gl_Position
             + 3. * u * t * t * gl_in[2].gl_Position + t * t * t * gl_in[3].gl_Position;
    p.y += gl_TessCoord.y;
    gl_Position = gl_ModelViewProjectionMatrix * p;
}
)glsl",
                    .fragment = R"glsl(#version 150 compatibility
in vec2 eCoord;
out vec4 fColor;
void main() { fColor = vec4(eCoord, 1., 1.); }
)glsl"},
         .draws = kPatch},
        {.name = "v400_doubles_and_fused_operations",
         .stages = {.vertex = R"glsl(#version 400 compatibility
out vec3 vPoint;
void main() {
    dvec3 p = dvec3(gl_Vertex.xyz) * 1.0LF / 3.0LF;
    vPoint = vec3(p * 3.0LF);
    precise float w = fma(gl_Vertex.x, .5, 1.);
    gl_Position = gl_ModelViewProjectionMatrix * vec4(gl_Vertex.xyz * w, 1.);
}
)glsl",
                    .fragment = R"glsl(#version 400 compatibility
in vec3 vPoint;
out vec4 fColor;
void main() {
    int bits = bitfieldExtract(int(vPoint.x * 255.), 3, 4);
    uint bytes = packUnorm4x8(vec4(.5 + .5 * vPoint, 1.));
    fColor = vec4(unpackUnorm4x8(bytes).yz, float(bitCount(bits)) / 4., 1.);
}
)glsl"}},
        {.name = "v400_subroutines",
         // This is the only function of its type, because the driver chooses which of several functions a
         // subroutine uniform has at first.
         .stages = {.vertex = kPassVertex,
                    .tessEvaluation = R"glsl(#version 400 compatibility
layout(triangles, point_mode) in;
in vec3 vNormal[];
out vec3 eNormal;
void main() {
    eNormal = vNormal[0];
    gl_Position = gl_ModelViewProjectionMatrix * gl_in[1].gl_Position;
}
)glsl",
                    .fragment = R"glsl(#version 400 compatibility
subroutine vec3 Shading(vec3 n);
subroutine uniform Shading shade;
subroutine(Shading) vec3 bright(vec3 n) { return .5 + .5 * n; }
in vec3 eNormal;
out vec4 fColor;
void main() { fColor = vec4(shade(eNormal), 1.); }
)glsl"},
         .draws = "PointSize 3\nRotate 35 1 2 0\nTorus 1.1 .5 12 18\n"},
        {.name = "v400_built_in_colors_from_evaluation_to_geometry",
         .stages = {.vertex = R"glsl(#version 120
void main() {
    gl_FrontColor = vec4(2. * gl_Normal, 1.);
    gl_BackColor = vec4(.5, 0., 1., 1.);
    gl_Position = gl_Vertex;
}
)glsl",
                    .tessEvaluation = R"glsl(#version 400 compatibility
layout(triangles) in;
void main() {
    vec3 w = gl_TessCoord;
    gl_FrontColor = w.x * gl_in[0].gl_FrontColor + w.y * gl_in[1].gl_FrontColor + w.z * gl_in[2].gl_FrontColor;
    gl_BackColor = gl_in[0].gl_BackColor;
    if (w.x > .5) gl_FrontColor.r = 5.;
    gl_Position = gl_ModelViewProjectionMatrix *
                  (w.x * gl_in[0].gl_Position + w.y * gl_in[1].gl_Position + w.z * gl_in[2].gl_Position);
}
)glsl",
                    .geometry = R"glsl(#version 150 compatibility
layout(triangles) in;
layout(triangle_strip, max_vertices = 3) out;
void main() {
    for (int i = 0; i < 3; ++i) {
        gl_FrontColor = gl_in[i].gl_FrontColor * .4;
        gl_BackColor = gl_in[i].gl_BackColor;
        gl_Position = gl_in[i].gl_Position;
        EmitVertex();
    }
}
)glsl",
                    .fragment = "void main() { gl_FragColor = vec4(gl_Color.rgb, 1.); }\n"},
         .draws = "Rotate 70 1 .2 0\nCylinder 1 1.2 24 4\nRotate 180 1 0 0\nTranslate 0 0 1.3\nQuadXY 0 .5\n",
         .written = {.backColors = true}},
        {.name = "v400_patch_arrays_and_structures",
         .stages = {.vertex = "#version 400 compatibility\nvoid main() { gl_Position = gl_Vertex; }\n",
                    .tessControl = R"glsl(#version 400 compatibility
#define ID gl_InvocationID
layout(vertices = 4) out;
struct Shade { vec3 color; float gain; };
patch out Shade pShade[2];
out Data { vec2 at; } cData[];
void main() {
    gl_out[ID].gl_Position = gl_in[ID].gl_Position;
    cData[ID].at = gl_in[ID].gl_Position.xy;
    pShade[0] = Shade(vec3(1., .5, 0.), .75);
    pShade[1] = Shade(vec3(0., .5, 1.), .5);
    gl_TessLevelOuter[0] = gl_TessLevelOuter[1] = gl_TessLevelOuter[2] = gl_TessLevelOuter[3] = 5.;
    gl_TessLevelInner[0] = gl_TessLevelInner[1] = 5.;
}
)glsl",
                    .tessEvaluation = R"glsl(#version 400 compatibility
layout(quads, fractional_even_spacing) in;
struct Shade { vec3 color; float gain; };
patch in Shade pShade[2];
in Data { vec2 at; } cData[];
out vec3 eColor;
void main() {
    vec2 t = gl_TessCoord.xy;
    vec4 p = mix(mix(gl_in[0].gl_Position, gl_in[1].gl_Position, t.x),
                 mix(gl_in[3].gl_Position, gl_in[2].gl_Position, t.x), t.y);
    eColor = mix(pShade[0].color * pShade[0].gain, pShade[1].color * pShade[1].gain, t.x);
    eColor.g += .25 * mix(cData[0].at, cData[2].at, t.y).x;
    gl_Position = gl_ModelViewProjectionMatrix * p;
}
)glsl",
                    .fragment = "#version 400 compatibility\nin vec3 eColor; out vec4 c; void main() { c = "
                                "vec4(eColor, 1.); }"},
         .draws = kPatch},
    };
}

}  // namespace glibra::oracle
