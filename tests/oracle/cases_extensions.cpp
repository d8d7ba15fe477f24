// What extensions add to GLSL 1.20, and words of later versions that 1.20 leaves to the user.

#include "case.h"

namespace glibra::oracle {

std::vector<Case> casesOfExtensions() {
    return {
        {.name = "gpu_shader4_outputs_and_unsigned_integers",
         .stages = {.vertex = R"glsl(#version 120
#extension GL_EXT_gpu_shader4 : require
flat varying unsigned int vMask;
flat varying ivec2 vStep;
noperspective varying vec2 vScreen;
centroid varying vec3 vPoint;
unsigned int bits(in unsigned int a, const int b) { unsigned int c = a << 2; return c ^ unsigned int(b); }
void main() {
    vMask = bits(unsigned int(gl_VertexID), 5) % 64u;
    vStep = ivec2(gl_VertexID % 5, gl_InstanceID);
    vPoint = gl_Vertex.xyz;
    gl_Position = gl_ModelViewProjectionMatrix * gl_Vertex;
    vScreen = gl_Position.xy / gl_Position.w;
}
)glsl",
                    .fragment = R"glsl(#version 120
#extension GL_EXT_gpu_shader4 : require
flat varying unsigned int vMask;
flat varying ivec2 vStep;
noperspective varying vec2 vScreen;
centroid varying vec3 vPoint;
struct Pair { unsigned int low; unsigned int list[2]; };
varying out vec4 oColor;
void main() {
    Pair pair;
    pair.low = vMask & 7u;
    pair.list[1] = (vMask >> 3) | (~vMask & 1u);
    uvec2 both = uvec2(pair.low, pair.list[1]);
    both = max(min(both, uvec2(6u)), 1u);
    int odd = gl_PrimitiveID & 1;
    vec2 rounded = round(vScreen * 4.) * .25 + truncate(vPoint.xy);
    oColor = vec4(float(both.x) / 7., float(both.y) / 8. * .5 + .1 * float(odd), .5 + .25 * rounded.x, 1.);
    oColor.g += .05 * float(vStep.x + vStep.y);
}
)glsl"}},
        {.name = "gpu_shader4_texture_functions",
         .stages = {.vertex = kPointCoordinateVertex, .fragment = R"glsl(#version 120
#extension GL_EXT_gpu_shader4 : require
uniform sampler3D Noise3;
varying vec3 vPoint;
varying vec2 vST;
void main() {
    ivec3 size = textureSize3D(Noise3, 0);
    ivec3 texel = ivec3(vST * vec2(size.xy), size.z / 2) % size;
    vec4 a = texelFetch3D(Noise3, texel, 0);
    vec4 b = texture3DLod(Noise3, vPoint, 1.);
    vec4 c = texture3DGrad(Noise3, vPoint, vec3(.01), vec3(.02));
    vec4 d = texelFetch3DOffset(Noise3, texel / 2, 0, ivec3(1, 0, 2));
    gl_FragColor = vec4(a.r, b.g, .5 * (c.b + d.r), 1.);
}
)glsl"}},
        {.name = "draw_instanced_counts_instances",
         .stages = {.vertex = R"glsl(#version 120
#extension GL_ARB_draw_instanced : require
varying vec3 vPoint;
void main() {
    vPoint = gl_Vertex.xyz + float(gl_InstanceIDARB);
    gl_Position = ftransform();
}
)glsl",
                    .fragment = R"glsl(#version 120
varying vec3 vPoint;
void main() { gl_FragColor = vec4(fract(vPoint), 1.); }
)glsl"}},
        {.name = "later_keywords_are_names_of_everything",
         .stages = {.vertex = R"glsl(#version 120
struct uvec2 { vec3 sample; float row_major; };
varying vec3 buffer;
varying float shared;
uvec2 precise(vec3 coherent, float patch) {
    uvec2 subroutine;
    subroutine.sample = coherent;
    subroutine.row_major = patch;
    return subroutine;
}
void main() {
    uvec2 image2D = precise(gl_Vertex.xyz, .5);
    buffer = image2D.sample;
    shared = image2D.row_major;
    gl_Position = ftransform();
}
)glsl",
                    .fragment = R"glsl(#version 120
varying vec3 buffer;
varying float shared;
float atomic_uint(float restrict) { return .5 * restrict; }
void main() {
    float readonly = 0., resource[2];
    resource[0] = .25, resource[1] = shared;
    for (int uint = 0; uint < 2; ++uint) readonly += atomic_uint(resource[uint]);
    vec2 sampler2DArray = buffer.xy;
    gl_FragColor = vec4(fract(sampler2DArray), readonly, 1.);
}
)glsl"}},
        {.name = "commas_in_constants", .stages = {.vertex = kPointVertex, .fragment = R"glsl(#version 120
varying vec3 vPoint;
const float kHalf = (1., .5);
float weights[3];
void main() {
    float i = 0.;
    weights[0] = kHalf, weights[1] = (i += .25, i), weights[2] = 1.;
    gl_FragColor = vec4(fract(vPoint.xy) * weights[0], weights[1], weights[2]);
}
)glsl"}},
    };
}

}  // namespace glibra::oracle
