// R31 Within the volume: reads the depth back, finds the place, and how much of a round sun the ball hides from it.
#version 330 core

uniform sampler2D uDepth;
uniform mat4 invProjection;
uniform vec3 uBall;        // eye space
uniform vec3 uToSun;       // eye space
uniform float uRadius, uSoft, uDark;
uniform bool uShowVolume;

out vec4 fColor;

void main() {
    vec2 st = gl_FragCoord.xy / vec2(textureSize(uDepth, 0));
    vec4 h = invProjection * vec4(2. * vec3(st, texelFetch(uDepth, ivec2(gl_FragCoord.xy), 0).r) - 1., 1.);
    vec3 toBall = uBall - h.xyz / h.w, toSun = normalize(uToSun);
    float ahead = dot(toBall, toSun);
    float beside = length(toBall - ahead * toSun);
    // The half-shadow grows with the distance from the ball.
    float blur = max(uSoft * ahead, 1e-3);
    float free = smoothstep(uRadius - blur, uRadius + blur, beside);
    free = mix(1., free, smoothstep(0., 1.5 * uRadius, ahead));   // the ball itself has its own dark side
    fColor = vec4(vec3(mix(1. - uDark, 1., free)) * (uShowVolume ? vec3(1., .85, .6) : vec3(1.)), 1.);
}
