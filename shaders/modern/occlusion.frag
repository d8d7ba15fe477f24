// Ambient occlusion in screen space (Mittring 2007): the share of samples around a place that lie behind the depths.
#version 430 core

uniform mat4 projection, invProjection;
uniform sampler2D uNormals, uDepths;
uniform vec3 uSamples[32];  // in the half sphere around +z
uniform float uRadius;

in vec2 vST;
out float fOpen;

vec3 placeAt(vec2 st) {
    vec4 place = invProjection * vec4(2. * vec3(st, texture(uDepths, st).r) - 1., 1.);
    return place.xyz / place.w;
}

void main() {
    vec4 normal = texture(uNormals, vST);
    fOpen = 1.;
    if (normal.a == 0.) return;
    vec3 place = placeAt(vST);
    // Each pixel of a block of 4 x 4 turns the samples by another angle.
    ivec2 pixel = ivec2(gl_FragCoord.xy) % 4;
    float angle = 6.2831853 / 16. * float(4 * pixel.y + pixel.x);
    vec3 other = abs(normal.z) < .9 ? vec3(0., 0., 1.) : vec3(1., 0., 0.);
    vec3 side = normalize(cross(other, normal.xyz)), up = cross(normal.xyz, side);
    mat3 frame = mat3(cos(angle) * side + sin(angle) * up, cos(angle) * up - sin(angle) * side, normal.xyz);
    float covered = 0.;
    for (int i = 0; i < 32; ++i) {
        vec3 sample_ = place + uRadius * (frame * uSamples[i]);
        vec4 clip = projection * vec4(sample_, 1.);
        float depth = placeAt(.5 * clip.xy / clip.w + .5).z;
        if (depth > sample_.z + .03 * uRadius) covered += smoothstep(0., 1., uRadius / abs(place.z - depth));
    }
    fOpen = 1. - covered / 32.;
}
