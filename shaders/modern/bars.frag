// G16.1 Sums: for each element the two summands, one on the other, beside their sum.
#version 430 core

layout(std430) readonly buffer First { float first[]; };
layout(std430) readonly buffer Second { float second[]; };
layout(std430) readonly buffer Sum { float sum[]; };

uniform float uHighest;

in vec2 vST;
out vec4 fColor;

void main() {
    float across = vST.x * float(sum.length());
    int i = min(int(across), sum.length() - 1);
    float place = fract(across), value = uHighest * vST.y;
    vec3 color = vec3(.10, .11, .13);
    if (fract(value / 10.) < .04) color = vec3(.2, .21, .23);
    if (place > .12 && place < .46 && value < first[i] + second[i])
        color = value < first[i] ? vec3(.28, .52, .82) : vec3(.93, .60, .22);
    if (place > .54 && place < .88 && value < sum[i]) color = vec3(.40, .68, .42);
    fColor = vec4(color, 1.);
}
