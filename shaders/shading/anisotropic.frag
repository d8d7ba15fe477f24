// SH015 Anisotropic: a thread shines by its angles to the light and to the eye (Kajiya and Kay 1989).
#version 330 core

uniform float uKa, uKd, uKs, uShininess;
uniform vec3 uColor;
uniform vec3 uLightColor;

in vec3 vPosition;
in vec3 vTangent;
in vec3 vNormal;

out vec4 fColor;

const vec3 kLight = vec3(-3., 4., 4.);   // eye space

void main() {
    vec3 tangent = normalize(vTangent);
    vec3 toLight = normalize(kLight - vPosition);
    vec3 toEye = normalize(-vPosition);
    float alongLight = dot(tangent, toLight);
    float alongEye = dot(tangent, toEye);
    float acrossLight = sqrt(max(1. - alongLight * alongLight, 0.));
    float acrossEye = sqrt(max(1. - alongEye * alongEye, 0.));

    // A thread reflects light into a cone that makes the same angle with it as the light does, on the other side.
    float lit = smoothstep(-.1, .4, dot(normalize(vNormal), toLight));   // the unlit side of the ball
    float specular = pow(max(acrossLight * acrossEye - alongLight * alongEye, 0.), uShininess);
    vec3 light = uKa * uColor + lit * uLightColor * (uKd * acrossLight * uColor + uKs * min(specular, 1.));
    fColor = vec4(light, 1.);
}
