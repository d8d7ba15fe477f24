// R10 The light of the fixed pipeline, per vertex, from a light in a structure: ambient, diffuse, specular, attenuation, cone.
#version 330 core

struct Light {
    bool on;
    vec4 position;             // eye space; w is 0 for a light that is infinitely far away
    vec3 ambient, diffuse, specular;
    vec3 attenuation;          // constant, linear and quadratic part
    vec3 spotDirection;        // eye space
    float spotCutoff;          // degrees; 180 is no cone
    float spotExponent;
};
uniform Light uLight;
uniform vec3 uModelAmbient, uColor, uSpecular;
uniform float uShininess;

out vec3 vFront, vBack;
out float vHeight;

vec3 lit(vec3 place, vec3 normal) {
    vec3 color = uModelAmbient * uColor;
    if (!uLight.on) return color;
    vec3 toLight = uLight.position.xyz - uLight.position.w * place;
    float distance = length(toLight);
    toLight /= distance;
    float share = 1.;
    if (uLight.position.w != 0.) {
        share /= dot(uLight.attenuation, vec3(1., distance, distance * distance));
        float cone = dot(-toLight, normalize(uLight.spotDirection));
        if (uLight.spotCutoff < 180.) share *= cone < cos(radians(uLight.spotCutoff)) ? 0. : pow(cone, uLight.spotExponent);
    }
    float diffuse = max(dot(normal, toLight), 0.);
    vec3 middle = normalize(toLight + vec3(0., 0., 1.));   // the viewer is far away
    float specular = diffuse > 0. ? pow(max(dot(normal, middle), 0.), uShininess) : 0.;
    return color + share * (uColor * (uLight.ambient + diffuse * uLight.diffuse) + specular * uSpecular * uLight.specular);
}

void main() {
    vec3 place = vec3(uModelViewMatrix * aVertex), normal = normalize(uNormalMatrix * aNormal);
    vFront = lit(place, normal);
    vBack = lit(place, -normal);
    vHeight = aVertex.y;
    gl_Position = uModelViewProjectionMatrix * aVertex;
}
