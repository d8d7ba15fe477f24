// All hues along a 1D texture.
#version 430 core

layout(local_size_x = 64) in;
layout(rgba8) writeonly uniform image1D uRainbow;

void main() {
    int at = int(gl_GlobalInvocationID.x);
    float turn = float(at)/float(imageSize(uRainbow));
    imageStore(uRainbow, at, vec4(clamp(abs(6.*fract(turn + vec3(0., 2., 1.)/3.) - 3.) - 1., 0., 1.), 1.));
}
