// Tutorial: shiny.frag with a picture of the surface in place of the colour.
#version 330 core

uniform sampler2D uMap;
uniform float uAmbient, uDiffuse, uSpecular, uShininess;
uniform float uSunX, uSunY;   // direction to the sun in eye space; z is 1
uniform vec3 uSunColor;
uniform bool uGrid;

in vec3 vPosition;
in vec3 vNormal;
in vec2 vST;

out vec4 fColor;

void main() {
    vec3 normal = normalize(vNormal);
    vec3 toSun = normalize(vec3(uSunX, uSunY, 1.));
    vec3 toEye = normalize(-vPosition);

    vec3 surface = texture(uMap, vST).rgb;
    vec2 meridians = abs(fract(vST * vec2(24., 12.)) - .5);   // .5 on a line, every 15 degrees
    if (uGrid && max(meridians.x, meridians.y) > .47) surface = mix(surface, vec3(1.), .5);

    float diffuse = max(dot(normal, toSun), 0.);
    float specular = diffuse > 0. ? pow(max(dot(reflect(-toSun, normal), toEye), 0.), uShininess) : 0.;
    vec3 light = (uAmbient + uDiffuse * diffuse) * surface + uSpecular * specular;
    fColor = vec4(light * uSunColor, 1.);
}
