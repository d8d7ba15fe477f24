// Sunlight with the shadow map of the slice in which the place lies.
#version 430 core

uniform mat4 v_matrix;
uniform sampler2DArrayShadow shadows;
uniform mat4 uToShadow[3];
uniform vec3 uSun, uEnds, uColor;
uniform bool uTinted;

in vec3 vPlace, vNormal;
out vec4 fColor;

void main() {
    float depth = -(v_matrix * vec4(vPlace, 1.)).z;
    int slice = depth < uEnds.x ? 0 : depth < uEnds.y ? 1 : 2;
    vec4 place = uToShadow[slice] * vec4(vPlace, 1.);
    float lit = texture(shadows, vec4(place.xy, slice, place.z));
    float diffuse = max(dot(normalize(vNormal), normalize(uSun)), 0.);
    vec3 tint = vec3(1.);
    if (uTinted) tint = .6 + .4 * vec3(slice == 0, slice == 1, slice == 2);
    fColor = vec4(tint * (.2 + .8 * lit * diffuse) * uColor, 1.);
}
