// R17 Earth from several textures: the day side lit, the night side with its towns, clouds over both, a highlight on water only.
#version 330 core

uniform sampler2D uDay, uNight;
uniform vec3 uToSun;      // eye space
uniform float uClouds, uGloss, uTowns, uDrift;

in vec3 vPosition;
in vec3 vNormal;
in vec2 vST;
out vec4 fColor;

void main() {
    vec3 normal = normalize(vNormal), toSun = normalize(uToSun);
    vec4 day = texture(uDay, vST);
    float clouds = uClouds * texture(uNight, vST + vec2(uDrift, 0.)).a;
    float sun = dot(normal, toSun);
    float shine = uGloss * day.a * (1. - clouds) * pow(max(dot(reflect(-toSun, normal), normalize(-vPosition)), 0.), 30.);
    vec3 lit = 1.35 * max(sun, 0.) * mix(day.rgb, vec3(1.), clouds) + shine * vec3(1., .95, .8);
    vec3 dark = uTowns * texture(uNight, vST).rgb * (1. - clouds);
    fColor = vec4(mix(dark, lit, smoothstep(-.1, .12, sun)), 1.);
}
