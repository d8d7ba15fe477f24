// D02 Second pass: uTSharp goes from blurred to sharpened, and uTEdge mixes in the Sobel edges of the picture.
#version 330 core

uniform sampler2D uInUnit;
uniform bool uEdgeDetect;
uniform float uTEdge;    // 0 the picture, 1 the edges
uniform float uTSharp;   // 0 blurred, 1 unchanged, above 1 sharpened

in vec2 vST;

out vec4 fColor;

const vec3 kLuminance = vec3(.2125, .7154, .0721);

vec3 at(ivec2 offset) {
    return texture(uInUnit, vST + vec2(offset) / vec2(textureSize(uInUnit, 0))).rgb;
}

void main() {
    vec3 p00 = at(ivec2(-1, -1)), p10 = at(ivec2(0, -1)), p20 = at(ivec2(1, -1));
    vec3 p01 = at(ivec2(-1, 0)), p11 = at(ivec2(0, 0)), p21 = at(ivec2(1, 0));
    vec3 p02 = at(ivec2(-1, 1)), p12 = at(ivec2(0, 1)), p22 = at(ivec2(1, 1));

    vec3 blurred = (p00 + p20 + p02 + p22 + 2. * (p10 + p01 + p21 + p12) + 4. * p11) / 16.;
    vec3 color = mix(blurred, p11, uTSharp);
    if (uEdgeDetect) {
        float across = dot(p20 + 2. * p21 + p22 - p00 - 2. * p01 - p02, kLuminance);
        float up = dot(p02 + 2. * p12 + p22 - p00 - 2. * p10 - p20, kLuminance);
        color = mix(color, vec3(length(vec2(across, up))), uTEdge);
    }
    fColor = vec4(color, 1.);
}
