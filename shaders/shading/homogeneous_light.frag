// Homogeneous light: one function for lights at a place (w = 1) and in a direction (w = 0), and for everything between.
#version 330 core

uniform vec4 uLight;   // eye space; the place is xyz / w
uniform vec3 uColor;
uniform float uShininess;

in vec3 vPosition;
in vec3 vNormal;

out vec4 fColor;

// The direction from one homogeneous point to another is b.w a - a.w b, which does not divide.
vec3 towards(vec4 from, vec4 to) {
    return normalize(to.xyz * from.w - from.xyz * to.w);
}

vec3 ads(vec3 normal, vec4 place, vec4 light) {
    vec3 toLight = towards(place, light);
    vec3 toEye = towards(place, vec4(0., 0., 0., 1.));
    float diffuse = max(dot(normal, toLight), 0.);
    float specular = diffuse > 0. ? pow(max(dot(reflect(-toLight, normal), toEye), 0.), uShininess) : 0.;
    return (.15 + .85 * diffuse) * uColor + .6 * specular;
}

void main() {
    fColor = vec4(ads(normalize(vNormal), vec4(vPosition, 1.), uLight), 1.);
}
