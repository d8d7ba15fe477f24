// G16.f23 G16.f24 G16.f25 G16.16 Coloured panes: a ray gathers the panes that it meets. Four columns mix
// them in four ways.
#version 430 core
layout(local_size_x = 8, local_size_y = 8) in;

layout(rgba8) uniform writeonly image2D uPicture;
uniform float uSpread, uSize;

const vec3 kRed = vec3(1., 0., 0.), kYellow = vec3(1., 1., 0.), kGreen = vec3(0., 1., 0.), kCyan = vec3(0., 1., 1.),
           kBlue = vec3(0., 0., 1.), kMagenta = vec3(1., 0., 1.);
// From the lowest row: the primary colours of painters, of light, and of printers.
const vec3 kPalettes[3][3] = vec3[][](vec3[](kRed, kYellow, kBlue), vec3[](kRed, kGreen, kBlue),
                                      vec3[](kCyan, kMagenta, kYellow));

float largest(vec3 v) {
    return max(max(v.x, v.y), v.z);
}
float smallest(vec3 v) {
    return min(min(v.x, v.y), v.z);
}

/// From red, green, blue to red, yellow, blue and back (Sugita and Takahashi 2015). White is taken off first, and
/// black is put on last. Greys have nothing else: there, both sizes are 0, and nothing is scaled.
vec3 paintOf(vec3 rgb) {
    float white = smallest(rgb), black = smallest(1. - rgb);
    vec3 c = rgb - white;
    float yellow = min(c.r, c.g);
    vec3 ryb = vec3(c.r - yellow, .5 * (c.g + yellow), .5 * (c.b + c.g - yellow));
    if (largest(ryb) > 0.) ryb *= largest(c) / largest(ryb);
    return ryb + black;
}
vec3 lightOf(vec3 ryb) {
    float black = smallest(ryb), white = smallest(1. - ryb);
    vec3 c = ryb - black;
    float green = min(c.y, c.z);
    vec3 rgb = vec3(c.x + c.y - green, c.y + green, 2. * (c.z - green));
    if (largest(rgb) > 0.) rgb *= largest(c) / largest(rgb);
    return rgb + white;
}

void main() {
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy), size = imageSize(uPicture);
    if (any(greaterThanEqual(pixel, size))) return;
    vec2 cells = vec2(4., 3.) * (vec2(pixel) + .5) / vec2(size);
    int way = int(cells.x);
    vec2 place = (2. * fract(cells) - 1.) * vec2(.75 * float(size.x) / float(size.y), 1.);

    // Parallel rays along z; the panes are disks in front of each other.
    int count = 0;
    vec3 sum = vec3(0.), ink = vec3(0.), paint = vec3(0.);
    for (int i = 0; i < 3; ++i) {
        float angle = radians(210. + 120. * float(i));
        if (distance(place, uSpread * vec2(cos(angle), sin(angle))) > uSize) continue;
        vec3 color = kPalettes[int(cells.y)][i];
        ++count;
        sum += color;
        ink += 1. - color;
        paint += paintOf(color);
    }
    vec3 color;
    if (count == 0) color = way == 1 ? vec3(.08) : vec3(.97);
    else if (way == 0) color = sum / float(count);
    else if (way == 1) color = sum;
    else if (way == 2) color = 1. - ink;
    else color = lightOf(min(paint, 1.));
    imageStore(uPicture, pixel, vec4(clamp(color, 0., 1.), 1.));
}
