// The vertex stage of the axes that --axes draws. A line from aFrom to aTo, in the space before the view transformation,
// becomes a rectangle of constant width on the screen.
#version 410 core

uniform mat4 uMatrix;  // to the clip space of the whole picture
uniform vec4 uPart;    // scale and shift from there to the part of the picture that is drawn
uniform vec2 uHalf;    // half the width of a line in normalized device coordinates

in vec3 aFrom, aTo;
in vec2 aCorner;  // x: 0 at aFrom, 1 at aTo; y: -1 or 1, the side

void main() {
    vec4 from = uMatrix * vec4(aFrom, 1.0), to = uMatrix * vec4(aTo, 1.0);
    // What is before the near plane has no place on the screen.
    float fromDepth = from.z + from.w, toDepth = to.z + to.w;
    if (fromDepth < 0.0 && toDepth < 0.0) {
        gl_Position = vec4(2.0, 2.0, 2.0, 1.0);
        return;
    }
    if (fromDepth < 0.0) from = mix(from, to, fromDepth / (fromDepth - toDepth));
    if (toDepth < 0.0) to = mix(to, from, toDepth / (toDepth - fromDepth));
    vec2 along = (to.xy / to.w - from.xy / from.w) / uHalf;
    float reach = length(along);
    along = reach > 0.0 ? along / reach : vec2(1.0, 0.0);
    vec4 at = aCorner.x < 0.5 ? from : to;
    // Lines end half a width later, so that they meet without a gap.
    vec2 offset = along * (2.0 * aCorner.x - 1.0) + vec2(-along.y, along.x) * aCorner.y;
    at.xy += offset * uHalf * at.w;
    gl_Position = vec4(at.xy * uPart.xy + uPart.zw * at.w, at.zw);
}
