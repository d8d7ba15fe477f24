// S22 Three invocations, one per corner, write their parts; after the barrier each of them reads all parts.
#version 400
layout(vertices = 3) out;

uniform float uLevel;

patch out vec4 tCentre;      // the centre of the patch, and its longest side
out float tSide[];

void main() {
    gl_out[gl_InvocationID].gl_Position = gl_in[gl_InvocationID].gl_Position;
    tSide[gl_InvocationID] = distance(gl_in[gl_InvocationID].gl_Position, gl_in[(gl_InvocationID + 1) % 3].gl_Position);

    barrier();   // in main, outside of any condition

    // What all corners have written is known here, also to the invocation that sets the values of the patch.
    if (gl_InvocationID == 0) {
        float longest = max(tSide[0], max(tSide[1], tSide[2]));
        vec4 sum = gl_out[0].gl_Position + gl_out[1].gl_Position + gl_out[2].gl_Position;
        tCentre = vec4(sum.xyz / 3., longest);
        float level = max(uLevel * longest, 1.);
        for (int i = 0; i < 3; ++i) gl_TessLevelOuter[i] = level;
        gl_TessLevelInner[0] = level;
    }
}
