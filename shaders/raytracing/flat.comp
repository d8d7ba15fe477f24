// G16.2 Ray casting: the colour of the nearest object, without light. The picture is 2 units high and 1 unit before the eye.
#version 430 core
layout(local_size_x = 8, local_size_y = 8) in;

layout(rgba8) uniform writeonly image2D uPicture;
uniform vec3 uEye;
uniform vec3 uCenter, uLow, uHigh;  // of the ball; corners of the box
uniform float uRadius;

const float kNone = 1e30;

/// The nearest t > 0 with |eye + t * direction - center| = radius, from the quadratic equation.
float hitBall(vec3 eye, vec3 direction) {
    vec3 start = eye - uCenter;
    float a = dot(direction, direction), b = 2. * dot(direction, start), c = dot(start, start) - uRadius * uRadius;
    float d = b * b - 4. * a * c;
    if (d < 0.) return kNone;
    float near = (-b - sqrt(d)) / (2. * a), far = (-b + sqrt(d)) / (2. * a);
    return near > 0. ? near : far > 0. ? far : kNone;
}

/// Where the ray has entered all three pairs of planes, if it has left none of them before.
float hitBox(vec3 eye, vec3 direction) {
    vec3 toLow = (uLow - eye) / direction, toHigh = (uHigh - eye) / direction;
    vec3 entries = min(toLow, toHigh), exits = max(toLow, toHigh);
    float near = max(max(entries.x, entries.y), entries.z), far = min(min(exits.x, exits.y), exits.z);
    if (near > far || far <= 0.) return kNone;
    return near > 0. ? near : far;
}

void main() {
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy), size = imageSize(uPicture);
    if (any(greaterThanEqual(pixel, size))) return;
    vec3 direction = vec3((2. * (vec2(pixel) + .5) - vec2(size)) / float(size.y), -1.);
    float ball = hitBall(uEye, direction), box = hitBox(uEye, direction);
    vec3 color = vec3(0.);
    if (ball < box) color = vec3(0., 0., 1.);
    else if (box < kNone) color = vec3(1., 0., 0.);
    imageStore(uPicture, pixel, vec4(color, 1.));
}
