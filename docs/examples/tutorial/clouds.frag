// Tutorial: drifting clouds, white where the noise is high and transparent elsewhere.
#version 330 core

uniform float uCover;        // 0 clear, 1 overcast
uniform float uSunX, uSunY;  // direction to the sun in eye space; z is 1
uniform float uScale;        // periods of the noise per unit

in vec3 vNormal;
in vec3 vModel;

out vec4 fColor;

void main() {
    vec4 octaves = texture(Noise3, uScale * vModel);
    float noise = 2. * (octaves.r + octaves.g + octaves.b + octaves.a - 2.);   // about -.6 to .6
    float cloud = smoothstep(.55 - uCover, .95 - uCover, .5 + noise);

    vec3 toSun = normalize(vec3(uSunX, uSunY, 1.));
    float diffuse = max(dot(normalize(vNormal), toSun), 0.);
    fColor = vec4(vec3(.15 + .85 * diffuse), cloud);
}
