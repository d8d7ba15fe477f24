// SH019 Dome: the angle from straight ahead becomes the distance from the centre of the picture; 90 degrees is its rim.
#version 330 core

out vec3 vColor;

void main() {
    vec4 position = uModelViewMatrix * aVertex;
    float across = length(position.xy);
    if (across > 0.) {
        float angle = atan(across, -position.z);
        position.xy *= angle / (.5 * 3.14159265) / across;
    }
    vColor = aColor.rgb;
    gl_Position = uProjectionMatrix * position;
}
