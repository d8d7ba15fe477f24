// G15.3c Flat water: what it mirrors and what shines through come from two pictures of the same view.
#version 430 core

uniform sampler2D reflection, refraction;
uniform bool isAbove;
uniform vec3 uSun, cameraPosition;

in vec3 vPlace;
out vec4 fColor;

void main() {
    // The mirrored camera shows a point of the surface at the same place of its picture as the camera itself.
    vec2 place = gl_FragCoord.xy / vec2(textureSize(reflection, 0));
    vec3 mirrored = texture(reflection, place).rgb, through = texture(refraction, place).rgb;
    vec3 color = isAbove ? .2 * through + mirrored : .5 * vec3(0., .25, 1.) + .6 * through;

    vec3 normal = vec3(0., isAbove ? 1. : -1., 0.);
    vec3 toSun = normalize(uSun), toEye = normalize(cameraPosition - vPlace);
    float diffuse = max(dot(normal, toSun), 0.);
    float specular = pow(max(dot(normal, normalize(toSun + toEye)), 0.), 400.);
    fColor = vec4((.4 + .6 * diffuse) * color + .75 * specular, 1.);
}
