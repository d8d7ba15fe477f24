// Start, the pass: a light line where the picture's brightness changes from one pixel to the next.
#version 430 core

uniform sampler2D uPicture;
uniform float uAmount;

out vec4 fColor;

float brightness(ivec2 place) {
    ivec2 last = textureSize(uPicture, 0) - 1;
    return dot(texelFetch(uPicture, clamp(place, ivec2(0), last), 0).rgb, vec3(.299, .587, .114));
}

void main() {
    ivec2 place = ivec2(gl_FragCoord.xy);
    vec2 change = vec2(brightness(place + ivec2(1, 0)) - brightness(place - ivec2(1, 0)),
                       brightness(place + ivec2(0, 1)) - brightness(place - ivec2(0, 1)));
    vec3 color = texelFetch(uPicture, place, 0).rgb;
    fColor = vec4(mix(color, vec3(1., .95, .8), uAmount * smoothstep(.03, .12, length(change))), 1.);
}
