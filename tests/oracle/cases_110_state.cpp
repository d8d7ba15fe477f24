// GLSL 1.10: the variables that hold fixed-function state, limits and uniforms.

#include "case.h"

namespace glibra::oracle {

std::vector<Case> casesOf110State() {
    return {
        {.name = "v110_light_sources",
         .stages = {.vertex = R"glsl(
varying vec3 vNormal;
void main() {
    vNormal = gl_NormalMatrix * gl_Normal;
    gl_Position = ftransform();
}
)glsl",
                    .fragment = R"glsl(
varying vec3 vNormal;
void main() {
    vec3 n = normalize(vNormal);
    vec3 l = normalize(gl_LightSource[0].position.xyz);
    float d = max(dot(n, l), 0.), s = pow(max(dot(n, gl_LightSource[0].halfVector.xyz), 0.), 8.);
    vec4 c = gl_FrontLightModelProduct.sceneColor;
    c += gl_LightSource[0].ambient * gl_FrontMaterial.ambient;
    c += .5 * d * gl_LightSource[0].diffuse * gl_FrontMaterial.diffuse;
    c += .2 * d * gl_FrontLightProduct[0].diffuse + s * gl_FrontLightProduct[0].specular;
    c += s * gl_LightSource[0].specular * .25;
    gl_FragColor = vec4(c.rgb + .3 * d * gl_BackMaterial.diffuse.rgb, 1.);
}
)glsl"}},
        {.name = "v110_other_light_state", .stages = {.vertex = kPointVertex, .fragment = R"glsl(
varying vec3 vPoint;
void main() {
    float a = .5 + .5 * sin(6. * vPoint.x), b = .5 + .5 * vPoint.y;
    vec3 c = gl_LightModel.ambient.rgb + gl_FrontMaterial.emission.rgb + gl_LightSource[1].diffuse.rgb;
    c.r += .25 * gl_LightSource[2].constantAttenuation * a + gl_LightSource[2].linearAttenuation;
    c.g += .5 * gl_LightSource[0].constantAttenuation * b + gl_LightSource[0].quadraticAttenuation;
    c.b += gl_LightSource[3].spotCutoff / 360. * a - gl_LightSource[3].spotDirection.z * .2;
    gl_FragColor = vec4(c + gl_FrontMaterial.shininess + gl_LightSource[0].spotExponent, gl_FrontMaterial.diffuse.a);
}
)glsl"}},
        {.name = "v110_fog",
         .stages = {.vertex = R"glsl(
void main() {
    gl_FogFragCoord = abs((gl_ModelViewMatrix * gl_Vertex).z) + gl_FogCoord;
    gl_Position = ftransform();
}
)glsl",
                    .fragment = R"glsl(
void main() {
    float exponential = exp(-gl_Fog.density * .5 * gl_FogFragCoord);
    float linear = clamp((gl_Fog.end - .25 * gl_FogFragCoord) * gl_Fog.scale, gl_Fog.start, 1.);
    gl_FragColor = vec4(mix(gl_Fog.color.rgb, vec3(1., .8, .2), exponential) + vec3(0., 0., .5 * linear), 1.);
}
)glsl"}},
        {.name = "v110_depth_range_and_normal_scale",
         .stages = {.vertex = R"glsl(
varying vec3 vNormal;
varying float vSize;
void main() {
    vNormal = gl_NormalScale * (gl_NormalMatrix * gl_Normal);
    vSize = gl_Point.size * gl_Point.distanceConstantAttenuation + gl_Point.distanceLinearAttenuation;
    gl_Position = ftransform();
}
)glsl",
                    .fragment = R"glsl(
varying vec3 vNormal;
varying float vSize;
void main() {
    float depth = (gl_FragCoord.z - gl_DepthRange.near) / gl_DepthRange.diff * gl_DepthRange.far;
    gl_FragColor = vec4(.5 + .5 * vNormal.xy, vSize / 8. * depth, 1.);
}
)glsl"},
         .before = "PointSize 4\n"},
        {.name = "v110_matrices_and_their_relatives",
         .stages = {.vertex = R"glsl(
varying vec4 vA, vB, vC;
void main() {
    vec4 eye = gl_ModelViewMatrix * gl_Vertex;
    vec4 clip = gl_ModelViewProjectionMatrix * gl_Vertex;
    gl_Position = clip;
    vA = gl_ModelViewMatrixInverse * eye;                    // the vertex again
    vA.w = (gl_ProjectionMatrixInverse * clip).x;            // eye x
    vB = gl_ModelViewProjectionMatrixInverse * clip;
    vB.w = (gl_ModelViewMatrixTranspose * vec4(eye.xyz, 0.)).x;
    vC.x = (gl_ModelViewMatrixInverseTranspose * vec4(gl_Normal, 0.)).z;
    vC.y = (gl_ProjectionMatrixTranspose * eye).z * .25;
    vC.z = (gl_ModelViewProjectionMatrixTranspose * eye).y * .25;
    vC.w = (gl_ProjectionMatrixInverseTranspose * vec4(gl_Normal, 1.)).y;
    vC += (gl_ModelViewProjectionMatrixInverseTranspose * vec4(gl_Normal, 0.)) * .125;
}
)glsl",
                    .fragment = R"glsl(
varying vec4 vA, vB, vC;
void main() {
    vec4 sum = .5 + .2 * vA + .15 * vB.wzyx + vC * vec4(.1, .1, .1, .25);
    gl_FragColor = vec4(sum.rgb + sum.a - .5, 1.);
}
)glsl"},
         .draws = "Scale 1.25 .75 1\nRotate 35 1 2 0\nTorus 1.1 .5 24 36\n"},
        {.name = "v110_texture_matrices",
         .stages = {.vertex = R"glsl(
void main() {
    gl_TexCoord[0] = gl_TextureMatrix[0] * gl_MultiTexCoord0;
    gl_TexCoord[1] = gl_TextureMatrixInverse[1] * gl_Vertex + gl_TextureMatrixTranspose[2] * gl_Vertex;
    gl_TexCoord[1] += gl_TextureMatrixInverseTranspose[0] * gl_Vertex;
    gl_Position = ftransform();
}
)glsl",
                    .fragment = R"glsl(
void main() { gl_FragColor = vec4(gl_TexCoord[0].st, .5 + .1 * gl_TexCoord[1].z, 1.); }
)glsl"}},
        {.name = "v110_texture_generation_planes_and_environment",
         .stages = {.vertex = R"glsl(
varying vec4 vPlanes, vZero;
void main() {
    vPlanes.s = dot(gl_ObjectPlaneS[0], gl_Vertex);
    vPlanes.t = dot(gl_ObjectPlaneT[1], gl_Vertex);
    vPlanes.p = dot(gl_EyePlaneS[0], gl_ModelViewMatrix * gl_Vertex);
    vPlanes.q = dot(gl_EyePlaneT[0], gl_ModelViewMatrix * gl_Vertex);
    vZero = gl_ObjectPlaneR[0] + gl_EyePlaneQ[0] + gl_ClipPlane[0] + gl_TextureEnvColor[0];
    gl_Position = ftransform();
}
)glsl",
                    .fragment = R"glsl(
varying vec4 vPlanes, vZero;
void main() { gl_FragColor = vec4(.5 + .25 * vPlanes.stp, 1.) + .25 * vec4(0., 0., vPlanes.q, 0.) + vZero; }
)glsl"}},
        {.name = "v110_limits", .stages = {.vertex = kPointVertex, .fragment = R"glsl(
varying vec3 vPoint;
void main() {
    float wave[gl_MaxTextureCoords];
    for (int i = 0; i < gl_MaxTextureCoords; ++i) wave[i] = fract(vPoint.x * float(i + 1));
    float sum = 0.;
    for (int i = 0; i < gl_MaxLights; ++i) sum += wave[i] * gl_LightSource[i].diffuse.r + .125;
    gl_FragColor = vec4(sum * .5, wave[gl_MaxClipPlanes - 1], wave[gl_MaxTextureUnits - 5], 1.);
}
)glsl"}},
        {.name = "v110_uniforms",
         .stages = {.vertex = R"glsl(
struct Wave { float amplitude; vec2 direction; };
uniform Wave uWave;
uniform float Timer;
uniform mat3 uTurn;
varying vec3 vPoint;
void main() {
    vPoint = uTurn * gl_Vertex.xyz;
    vPoint.y += uWave.amplitude * sin(5. * dot(uWave.direction, gl_Vertex.xz)) + Timer;
    gl_Position = ftransform();
}
)glsl",
                    .fragment = R"glsl(
uniform vec3 uPalette[3];
uniform int uSteps;
uniform bool uInvert;
uniform vec4 uTint;
uniform ivec2 uShift;
varying vec3 vPoint;
void main() {
    float level = floor(fract(vPoint.y) * float(uSteps)) / float(uSteps);
    vec3 c = level < .3 ? uPalette[0] : level < .6 ? uPalette[1] : uPalette[2];
    if (uInvert) c = 1. - c;
    gl_FragColor = vec4(c * uTint.rgb + float(uShift.x - uShift.y) * .1, 1.);
}
)glsl"},
         .tags =
             "uWave.amplitude <0. .3 1.> uWave.direction [1. .5] uTurn [0 1 0  -1 0 0  0 0 1] \\\n"
             "uPalette [1 0 0  0 1 .5  .2 .2 1] uSteps <1 5 9> uInvert <true> uTint {.8 .9 1} uShift [3 1]"},
        {.name = "v110_clip_vertex_without_planes",
         .stages = {.vertex = R"glsl(
varying vec3 vPoint;
void main() {
    gl_ClipVertex = gl_ModelViewMatrix * gl_Vertex;
    vPoint = gl_ClipVertex.xyz;
    gl_Position = ftransform();
}
)glsl",
                    .fragment = R"glsl(
varying vec3 vPoint;
void main() { gl_FragColor = vec4(fract(vPoint), 1.); }
)glsl"}},
    };
}

}  // namespace glibra::oracle
