// A weather satellite's three pictures, made from noise: what is visible, the temperature, and the vapour above.
#version 330 core

uniform int uBand;   // 0 visible, 1 infrared, 2 water vapour
uniform float uSnowline;

in vec2 vST;

out vec4 fColor;

float cloudsAt(vec2 place) {
    vec4 n = texture(Noise3, vec3(place, .31));
    return smoothstep(.08, .45, 2.2 * (n.r + n.g + n.b + n.a - 2.) + .12);
}

void main() {
    vec4 n = texture(Noise3, vec3(.7 * vST, .77));
    float height = .5 + 2.4 * (n.r + n.g + n.b + n.a - 2.) + .25 * (vST.t - .5);   // higher in the north
    float sea = 1. - smoothstep(.38, .40, height);
    float snow = smoothstep(uSnowline - .02, uSnowline + .02, height);
    float clouds = cloudsAt(1.1 * vST + vec2(.2, .45));

    float ground = mix(mix(.42, .12, sea), .92, snow);
    float visible = mix(ground, .97, clouds);
    float warmth = mix(mix(mix(.78, .70, sea), .38, snow), .25, clouds);     // clouds are as cold as snow or colder
    float vapour = mix(.72 - .25 * height * (1. - sea), .15, clouds);        // dark where vapour hides the ground
    float value = uBand == 0 ? visible : uBand == 1 ? warmth : vapour;
    fColor = vec4(vec3(value), 1.);
}
