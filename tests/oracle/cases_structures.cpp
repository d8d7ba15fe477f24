// Built-in structures and matrices as values, global variables, and less common forms of declarations.

#include "case.h"

namespace glibra::oracle {
namespace {

constexpr const char* kPointNormalVertex = R"glsl(
varying vec3 vPoint, vNormal;
void main() {
    vPoint = gl_Vertex.xyz;
    vNormal = gl_NormalMatrix * gl_Normal;
    gl_Position = ftransform();
}
)glsl";

}  // namespace

std::vector<Case> casesOfStructures() {
    return {
        {.name = "structures_of_built_in_types", .stages = {.vertex = kPointNormalVertex, .fragment = R"glsl(
varying vec3 vPoint, vNormal;
vec4 lit(gl_LightSourceParameters light, const in gl_MaterialParameters material, vec3 n) {
    float d = max(dot(n, light.position.xyz), 0.);
    return d * light.diffuse * material.diffuse;
}
void main() {
    gl_LightSourceParameters first = gl_LightSource[0];
    gl_FogParameters fog = gl_Fog;
    gl_DepthRangeParameters range = gl_DepthRange;
    gl_LightModelParameters model = gl_LightModel;
    vec4 c = lit(first, gl_FrontMaterial, normalize(vNormal)) + model.ambient;
    for (int i = 1; i < 3; ++i) c += lit(gl_LightSource[i], gl_BackMaterial, normalize(vNormal));
    gl_FragColor = vec4(c.rgb * fog.density + .1 * range.far * fract(vPoint), 1.);
}
)glsl"}},
        {.name = "structures_of_light_products", .stages = {.vertex = kPointNormalVertex, .fragment = R"glsl(
varying vec3 vPoint, vNormal;
vec3 sum(gl_LightProducts products) { return products.ambient.rgb + products.diffuse.rgb + products.specular.rgb; }
void main() {
    gl_LightModelProducts scene = gl_FrontLightModelProduct;
    gl_PointParameters point = gl_Point;
    vec3 c = sum(gl_FrontLightProduct[0]) * (.5 + .5 * normalize(vNormal)) + sum(gl_BackLightProduct[1]);
    c += gl_BackLightModelProduct.sceneColor.rgb + scene.sceneColor.rgb;
    gl_FragColor = vec4(c + point.size * .1 * fract(vPoint.x), 1.);
}
)glsl"}},
        {.name = "matrices_by_column_and_in_the_fragment_stage",
         .stages = {.vertex = kPointNormalVertex, .fragment = R"glsl(
varying vec3 vPoint, vNormal;
void main() {
    vec3 away = gl_ModelViewMatrix[3].xyz + gl_NormalMatrix[2] * .5;
    vec4 clip = gl_ModelViewProjectionMatrix * vec4(vPoint, 1.);
    mat4 copy = gl_ProjectionMatrix;
    copy[2][3] *= .5;
    vec3 world = (gl_ModelViewMatrixInverse * vec4(0., 0., 0., 1.)).xyz;
    vec3 c = .5 + .2 * vNormal + .1 * away.xyx + .1 * clip.xyz / clip.w + .1 * copy[2].w + .05 * world;
    gl_FragColor = vec4(c * gl_TextureMatrix[0][0].x, 1.);
}
)glsl"}},
        {.name = "varyings_that_are_matrices_and_arrays",
         .stages = {.vertex = R"glsl(
#version 120
attribute vec3 Tangent, aNormal;
varying mat3 vFrame;
varying vec2 vA, vB[2], vC;
void main() {
    vFrame = mat3(Tangent, aNormal, cross(Tangent, aNormal));
    vA = gl_Vertex.xy;
    for (int i = 0; i < 2; ++i) vB[i] = gl_Vertex.yz * float(i + 1);
    vC = gl_MultiTexCoord0.st;
    gl_Position = ftransform();
}
)glsl",
                    .fragment = R"glsl(
#version 120
varying mat3 vFrame;
varying vec2 vA, vB[2], vC;
void main() {
    vec3 n = normalize(vFrame * vec3(.5, 1., .25)), m = vFrame[1] * vFrame;
    gl_FragColor = vec4(.5 + .25 * n + .1 * m, 1.);
    gl_FragColor.rg += .1 * vA + .05 * (vB[0] + vB[int(vC.s * 1.99)]);
}
)glsl"}},
        {.name = "globals_with_values",
         .stages = {.vertex = R"glsl(
#version 120
uniform float uScale;
varying vec3 vPoint;
vec4 place = gl_Vertex;
float factor = uScale * 2., never;
void lift() { place.xyz *= factor; }
void main() {
    lift();
    vPoint = place.xyz;
    gl_Position = gl_ModelViewProjectionMatrix * place;
}
)glsl",
                    .fragment = R"glsl(
#version 120
float bands(float x);
uniform vec3 uTint;
vec3 color = uTint * .5;
void main() {
    color.r = bands(color.r);
    gl_FragColor = vec4(color, 1.);
}
varying vec3 vPoint;
const float kStep = .25;
float bands(float x) { return x + kStep * floor(fract(vPoint.y * 2.) / kStep); }
)glsl"},
         .tags = "uScale .45 uTint [.5 .8 1.5]"},
        {.name = "arrays_of_structures_as_uniforms",
         .stages = {.vertex = kPointNormalVertex, .fragment = R"glsl(
#version 120
struct Spot { vec3 color; float radius; vec2 at[2]; };
uniform Spot uSpots[2];
uniform vec3 uColors[2] = vec3[2](vec3(.1, .2, .3), vec3(.4, .1, .2)), uPlain;
uniform mat2 uSkew;
varying vec3 vPoint, vNormal;
void main() {
    vec3 c = uColors[0] + uPlain;
    for (int i = 0; i < 2; ++i)
        for (int j = 0; j < 2; ++j)
            if (distance(uSkew * vPoint.xy, uSpots[i].at[j]) < uSpots[i].radius) c += uSpots[i].color;
    gl_FragColor = vec4(c, 1.);
}
)glsl"},
         .tags = "uSpots[0].color {1 0 0} uSpots[0].radius .5 uSpots[0].at [.5 .5  -.5 .5] uSpots[1].color "
                 "[0 .5 .5] \\\n"
                 "uSpots[1].radius <0 .7 1> uSpots[1].at [0 -1  1 -.5] uPlain [0 0 .2] uSkew [1 .25 0 1]"},
        {.name = "interfaces_redeclared",
         .stages = {.vertex = R"glsl(#version 150 compatibility
out gl_PerVertex {
    vec4 gl_Position;
    vec4 gl_FrontColor;
    float gl_PointSize;
};
void main() {
    gl_FrontColor = vec4(.5 + .5 * gl_Normal, 1.);
    gl_Position = ftransform();
}
)glsl",
                    .geometry = R"glsl(#version 150 compatibility
layout(triangles) in;
layout(triangle_strip) out;
layout(max_vertices = 3) out;
in gl_PerVertex {
    vec4 gl_Position;
    vec4 gl_FrontColor;
    float gl_PointSize;
} gl_in[];
out gl_PerVertex {
    vec4 gl_Position;
    vec4 gl_FrontColor;
};
void main() {
    for (int i = 0; i < gl_in.length(); ++i) {
        gl_FrontColor = gl_in[i].gl_FrontColor.bgra;
        gl_Position = gl_in[i].gl_Position;
        EmitVertex();
    }
    EndPrimitive();
}
)glsl",
                    .fragment = "void main() { gl_FragColor = gl_Color; }\n"}},
        {.name = "fragment_coordinates_from_above",
         .stages = {.vertex = kPointNormalVertex, .fragment = R"glsl(#version 150 compatibility
layout(origin_upper_left, pixel_center_integer) in vec4 gl_FragCoord;
in vec3 vPoint;
void main() { gl_FragColor = vec4(mod(gl_FragCoord.xy, 16.) / 16., .5 + .5 * vPoint.z, 1.); }
)glsl"}},
        {.name = "clip_distances_of_a_given_number",
         .stages =
             {.vertex = R"glsl(#version 130
out float gl_ClipDistance[3];
out vec3 vPoint;
void main() {
    vPoint = gl_Vertex.xyz;
    for (int i = 0; i < 3; ++i) gl_ClipDistance[i] = gl_Vertex[i] + 1. - .2 * float(i);
    gl_Position = ftransform();
}
)glsl",
              .fragment =
                  "#version 130\nin vec3 vPoint; void main() { gl_FragColor = vec4(.5 + .5 * vPoint, 1.); }"},
         .written = {.clipDistances = 3}},
        {.name = "texture_coordinates_of_unstated_size",
         .stages = {.vertex = R"glsl(
#version 120
varying vec4 gl_TexCoord[];
void main() {
    gl_TexCoord[5] = gl_Vertex;
    gl_TexCoord[2] = gl_MultiTexCoord0;
    gl_Position = ftransform();
}
)glsl",
                    .fragment = R"glsl(
#version 120
void main() { gl_FragColor = vec4(gl_TexCoord[2].st, .5 + .5 * gl_TexCoord[5].z, 1.); }
)glsl"}},
        {.name = "outputs_changed_in_place",
         .stages = {.vertex = R"glsl(
void main() {
    gl_FrontColor = vec4(.2);
    gl_FrontColor.rg += gl_MultiTexCoord0.st;
    ++gl_FrontColor.b;
    gl_FrontColor.b *= .5 * gl_Normal.z;
    gl_TexCoord[0] = gl_TexCoord[1] = gl_Vertex;
    gl_TexCoord[0].xy -= .25;
    gl_Position = gl_ModelViewMatrix * gl_Vertex;
    gl_Position.y += .1;
    gl_Position = gl_ProjectionMatrix * gl_Position;
}
)glsl",
                    .fragment = R"glsl(
void main() {
    gl_FragColor = gl_Color;
    gl_FragColor[2] += gl_TexCoord[0].x - gl_TexCoord[1].x + fract(gl_TexCoord[1].y);
    gl_FragColor.a = 1.;
}
)glsl"}},
        {.name = "wide_lines",
         .stages = {.vertex = kPointNormalVertex,
                    .fragment =
                        "varying vec3 vPoint; void main() { gl_FragColor = vec4(.5 + .5 * vPoint, 1.); }"},
         .draws = "LineWidth 3\nWireTorus 1 .4 8 12\n"},
    };
}

}  // namespace glibra::oracle
