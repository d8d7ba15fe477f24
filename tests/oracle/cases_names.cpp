// Names that later versions use: keywords and functions of 4.50 that were free in the declared version.

#include "case.h"

namespace glibra::oracle {

std::vector<Case> casesOfNames() {
    return {
        {.name = "names_of_variables", .stages = {.vertex = kPointCoordinateVertex, .fragment = R"glsl(
#version 110
varying vec3 vPoint;
void main() {
    float sample = fract(3. * vPoint.x), patch = .5, flat = .25, smooth = vPoint.y;
    vec3 buffer = vec3(sample, patch, flat), shared = buffer.bgr;
    int uint = 2, precise = 1, subroutine = 3;
    bool coherent = smooth > 0., restrict = !coherent;
    float readonly = coherent ? 1. : .5, writeonly = restrict ? .8 : .2;
    float layout = float(uint + precise) / float(subroutine), centroid = .1, noperspective = .05, invariant = .1;
    vec2 image2D = vec2(readonly, writeonly), isampler2D = image2D.yx;
    float resource = isampler2D.x, common = isampler2D.y, filter = .1, active = .9, partition = .3, superp = .1;
    gl_FragColor = vec4(shared * layout + centroid + noperspective - invariant, 1.);
    gl_FragColor.gb *= vec2(resource, common) * active + filter * partition + superp;
}
)glsl"}},
        {.name = "names_of_uniforms_and_varyings",
         .stages = {.vertex = R"glsl(
#version 110
uniform float sample;
uniform vec3 buffer;
varying vec3 smooth;
varying float patch[2];
void main() {
    smooth = gl_Normal * buffer;
    patch[0] = gl_Vertex.y * sample;
    patch[1] = gl_MultiTexCoord0.s;
    gl_Position = ftransform();
}
)glsl",
                    .fragment = R"glsl(
#version 110
uniform float sample;
uniform struct { vec3 shared; float flat; } precise;
varying vec3 smooth;
varying float patch[2];
void main() {
    gl_FragColor = vec4(.5 + .5 * smooth.xy * precise.flat, .5 + patch[0] * sample, 1.);
    gl_FragColor.rgb = mix(gl_FragColor.rgb, precise.shared, fract(4. * patch[1]));
}
)glsl"},
         .tags = "sample <0. .5 1.> buffer [1 .5 .25] precise.shared {1 .8 .1} precise.flat .75"},
        {.name = "names_of_functions_arguments_and_members",
         .stages = {.vertex = kPointCoordinateVertex, .fragment = R"glsl(
#version 120
varying vec3 vPoint;
struct filter { float sample; vec2 texture; };
filter patch(float buffer, vec2 shared) { return filter(buffer * .5, shared + buffer); }
float texture(vec2 st) { return mod(floor(8. * st.s) + floor(8. * st.t), 2.); }
float textureLod(float level) { return level * level; }
void subroutine(inout vec3 common) { common *= .9; }
void main() {
    filter active = patch(vPoint.x, vPoint.yz);
    vec3 c = vec3(texture(active.texture), textureLod(active.sample), .5 + active.texture.y * .25);
    subroutine(c);
    gl_FragColor = vec4(c, 1.);
}
)glsl"}},
        {.name = "names_of_samplers",
         .stages = {.vertex = kPointCoordinateVertex, .fragment = R"glsl(
#version 110
uniform sampler2D texture;
uniform sampler2D sample;
varying vec2 vST;
vec4 image(sampler2D buffer, vec2 st) { return texture2D(buffer, st); }
void main() { gl_FragColor = .5 * texture2D(texture, vST) + .5 * image(sample, vST.ts); }
)glsl"},
         .before = "Texture2D 5 pattern.png\nTexture2D 6 back.png\n",
         .tags = "texture 5 sample 6"},
        {.name = "names_of_later_built_in_functions",
         .stages = {.vertex = R"glsl(
#version 110
varying vec3 vPoint;
mat3 transpose(mat3 m) {
    return mat3(m[0][0], m[1][0], m[2][0], m[0][1], m[1][1], m[2][1], m[0][2], m[1][2], m[2][2]);
}
float inverse(float x) { return 1. / (2. + x); }
vec3 round(vec3 p) { return floor(p * 4. + .5) * .25; }
void main() {
    mat3 turn = mat3(.8, .6, 0., -.6, .8, 0., 0., 0., 1.);
    vPoint = round(transpose(turn) * gl_Vertex.xyz) * inverse(gl_Vertex.z);
    gl_Position = ftransform();
}
)glsl",
                    .fragment = R"glsl(
#version 110
varying vec3 vPoint;
float noise3(vec3 p) { return .5 + .5 * sin(p.x + 2. * p.y + 3. * p.z); }
float noise(vec2 p) { return fract(p.x * 3. + p.y); }
float fma(float a, float b, float c) { return a * b - c; }
float trunc(float x) { return x < 0. ? -.25 : .25; }
vec3 isnan(vec3 c) { return c.bgr; }
void main() {
    vec3 c = vec3(noise3(4. * vPoint), noise(vPoint.xy), fma(vPoint.z, .5, -.5));
    gl_FragColor = vec4(isnan(c) + trunc(vPoint.y), 1.);
}
)glsl"}},
        {.name = "names_of_built_in_functions_of_the_same_version",
         .stages = {.vertex = kPointCoordinateVertex, .fragment = R"glsl(
#version 110
varying vec3 vPoint;
varying vec2 vST;
float smoothstep(float a, float b, float x) { return clamp((x - a) / (b - a), 0., 1.); }
float mod(float a, float b) { return a - b * floor(a / b) - .5 * b; }
vec3 mix(vec3 a, vec3 b, float t) { return a * t + b * (1. - t); }
void main() {
    float edge = smoothstep(.4, .6, fract(4. * vST.s)) + mod(vPoint.y, .5);
    gl_FragColor = vec4(mix(vec3(1., .2, 0.), vec3(0., .4, 1.), edge), 1.);
}
)glsl"}},
        {.name = "names_that_hide_one_another",
         .stages = {.vertex = kPointCoordinateVertex, .fragment = R"glsl(
#version 110
varying vec3 vPoint;
varying vec2 vST;
float length = 2.;
float wave(float vST) { float vPoint = sin(vST); return vPoint * vPoint; }
void main() {
    vec3 normal = normalize(vPoint), color = vec3(0.);
    for (int sample = 0; sample < 3; ++sample) {
        float vPoint = wave(float(sample) + 5. * vST.s) / length;
        color += vPoint * vec3(.5, .3, .6);
    }
    { vec2 vST = vec2(1., .5); color.rg *= vST; }
    float distance = distance(vPoint, vec3(0.)), dot = .1;
    gl_FragColor = vec4(color + dot * distance + .1 * normal, vST.t * .5 + .5);
}
)glsl"}},
        {.name = "names_of_v130_free_words",
         .stages = {.vertex = R"glsl(#version 130
out vec3 sample;
out vec2 buffer;
void main() {
    sample = gl_Vertex.xyz;
    buffer = gl_MultiTexCoord0.st;
    gl_Position = ftransform();
}
)glsl",
                    .fragment = R"glsl(#version 130
in vec3 sample;
in vec2 buffer;
out vec4 shared;
float patch(float precise) { return fract(precise * 3.); }
void main() {
    float subroutine = patch(sample.x);
    shared = vec4(subroutine, buffer, 1.);
}
)glsl"}},
        {.name = "names_free_in_one_stage_only",
         .stages = {.vertex = R"glsl(#version 110
varying vec3 vPoint;
uniform float patch;
void main() {
    vPoint = gl_Vertex.xyz * patch;
    gl_Position = ftransform();
}
)glsl",
                    .fragment = R"glsl(#version 400 compatibility
in vec3 vPoint;
sample in vec4 gl_TexCoord[1];
void main() { gl_FragColor = vec4(.5 + .5 * vPoint, 1.); }
)glsl"},
         .tags = "patch .9"},
    };
}

}  // namespace glibra::oracle
