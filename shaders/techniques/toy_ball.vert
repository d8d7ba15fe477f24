// R22 A square that always faces the eye and is large enough for the ball of radius 1.
#version 330 core

out vec3 vCorner;   // eye space

uniform float uLarge;

void main() {
    vec3 centre = uModelViewMatrix[3].xyz;
    vec3 back = -normalize(centre), right = normalize(cross(vec3(0., 1., 0.), back)), up = cross(back, right);
    vCorner = centre + uLarge * (aVertex.x * right + aVertex.y * up);
    gl_Position = uProjectionMatrix * vec4(vCorner, 1.);
}
