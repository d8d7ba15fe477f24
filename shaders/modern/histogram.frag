// Left of uSplit the picture, right of it with all brightnesses equally frequent; its histogram at the bottom.
#version 430 core

uniform sampler2D uImage;
uniform float uSplit;
layout(std430) readonly buffer Counts { uint counts[256]; };
layout(std430) readonly buffer Shares { float shares[256]; };

in vec2 vST;
out vec4 fColor;

void main() {
    vec3 color = texture(uImage, vST).rgb;
    float brightness = dot(color, vec3(.299, .587, .114));
    if (vST.x > uSplit) {
        // Between two brightnesses the share grows evenly.
        float step = 255. * brightness;
        int below = clamp(int(step), 0, 254);
        color *= mix(shares[below], shares[below + 1], step - float(below)) / max(brightness, 1. / 255.);
    }
    int bar = int(256. * vST.x);
    ivec2 size = textureSize(uImage, 0);
    float height = 10. * float(counts[bar]) / float(size.x * size.y);
    if (vST.y < height) color = mix(color, vec3(1., .85, .2), .7);
    fColor = vec4(color, 1.);
}
