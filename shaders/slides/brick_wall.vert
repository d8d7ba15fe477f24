// S13 Light per vertex, and the place on the wall.
#version 110

uniform vec3 uLightPlace;       // eye space

varying float vLight;
varying vec2 vWall;

void main() {
    vec3 place = vec3(gl_ModelViewMatrix * gl_Vertex), normal = normalize(gl_NormalMatrix * gl_Normal);
    vec3 toLight = normalize(uLightPlace - place);
    float diffuse = max(dot(toLight, normal), 0.);
    float specular = diffuse > 0. ? pow(max(dot(reflect(-toLight, normal), normalize(-place)), 0.), 16.) : 0.;
    vLight = .7 * diffuse + .3 * specular;
    vWall = gl_Vertex.xy;
    gl_Position = ftransform();
}
