// R35 Ward's model of 1992: the slopes of tiny facets are spread by a Gaussian that is wider across the brush marks.
#version 330 core

uniform vec3 uDiffuse, uSpecular, uLightColor;
uniform float uAlong, uAcross;    // standard deviations of the slope along and across the marks
uniform vec3 uLight;              // eye space
uniform bool uRound;              // marks in circles about the middle, as on a turned lid

in vec3 vPosition;
in vec3 vNormal;
in vec3 vTangent;
in vec2 vST;
out vec4 fColor;

const float kPi = 3.14159265;

void main() {
    vec3 normal = normalize(vNormal), tangent = normalize(vTangent - dot(vTangent, normal) * normal);
    vec3 binormal = cross(tangent, normal);
    vec3 marks = binormal;                            // around the axis
    if (uRound) {
        vec2 p = 2. * vST - 1. + 1e-5;
        marks = normalize(-p.y * binormal + p.x * tangent);
    }
    vec3 across = cross(normal, marks);
    vec3 toLight = normalize(uLight - vPosition), toEye = normalize(-vPosition);
    vec3 middle = normalize(toLight + toEye);
    float nl = dot(normal, toLight), nv = dot(normal, toEye), nh = dot(normal, middle);
    float specular = 0.;
    if (nl > 0. && nv > 0.) {
        vec2 slope = vec2(dot(middle, marks) / uAlong, dot(middle, across) / uAcross) / nh;
        specular = exp(-dot(slope, slope)) / (4. * kPi * uAlong * uAcross * sqrt(nl * nv));
    }
    vec3 light = uDiffuse / kPi + uSpecular * specular;
    fColor = vec4(.08 * uDiffuse + uLightColor * max(nl, 0.) * light, 1.);
}
