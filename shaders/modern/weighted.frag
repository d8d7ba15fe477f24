// A fragment of glass for weighted, blended transparency (McGuire and Bavoil 2013): nearer ones weigh more.
#version 430 core

uniform vec4 uGlass;  // colour and cover
uniform float uWeight;  // 0: all fragments weigh the same

in vec3 vNormal;
layout(location = 0) out vec4 fSum;
layout(location = 1) out float fThrough;

void main() {
    float light = .4 + .6 * abs(normalize(vNormal).z);
    float nearness = pow(1. - gl_FragCoord.z, 3.);
    float weight = mix(1., clamp(3e4 * nearness, .01, 3e3), uWeight);
    fSum = weight * vec4(uGlass.a * light * uGlass.rgb, uGlass.a);
    fThrough = uGlass.a;
}
