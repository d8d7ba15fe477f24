// Tutorial: ambient, diffuse and specular light, with a slider for each.
#version 330 core

uniform float uAmbient, uDiffuse, uSpecular, uShininess;
uniform float uSunX, uSunY;   // direction to the sun in eye space; z is 1
uniform vec3 uSunColor;

in vec3 vPosition;
in vec3 vNormal;
in vec4 vColor;

out vec4 fColor;

void main() {
    vec3 normal = normalize(vNormal);
    vec3 toSun = normalize(vec3(uSunX, uSunY, 1.));
    vec3 toEye = normalize(-vPosition);

    float diffuse = max(dot(normal, toSun), 0.);
    float specular = diffuse > 0. ? pow(max(dot(reflect(-toSun, normal), toEye), 0.), uShininess) : 0.;
    vec3 light = (uAmbient + uDiffuse * diffuse) * vColor.rgb + uSpecular * specular;
    fColor = vec4(light * uSunColor, 1.);
}
