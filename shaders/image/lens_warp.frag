// EX11.11 Spherical lens: a ball of glass lies on the picture and bends the rays toward its middle.
#version 330 core

uniform float uEta;         // index of refraction of the lens
uniform float uRadius;      // in widths of the picture
uniform vec2 uCentre;
uniform sampler2D uImageUnit;

in vec2 vST;

out vec4 fColor;

void main() {
    vec2 d = vST - uCentre;
    float zz = uRadius * uRadius - dot(d, d);
    vec2 st = vST;
    if (zz > 0.) {
        // The ray meets the ball at the angle asin(d / sqrt(d^2 + z^2)) and leaves it bent by 1 - 1/eta of that.
        float z = sqrt(zz);
        st -= z * tan((1. - 1. / uEta) * asin(d / sqrt(d * d + zz)));
    }
    fColor = vec4(texture(uImageUnit, st).rgb, 1.);
}
