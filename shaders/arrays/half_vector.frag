// V05 Modified Phong: the highlight follows the angle between the normal and the vector half way from light to eye.
#version 110

varying vec3 place, normal;

void main() {
    vec3 n = normalize(normal), l = normalize(gl_LightSource[0].position.xyz - place), h = normalize(l + normalize(-place));
    vec4 color = gl_LightSource[0].ambient * gl_FrontMaterial.ambient;
    if (dot(n, l) >= 0.) {
        color += dot(n, l) * gl_LightSource[0].diffuse * gl_FrontMaterial.diffuse;
        color += pow(max(dot(n, h), 0.), gl_FrontMaterial.shininess) * gl_LightSource[0].specular * gl_FrontMaterial.specular;
    }
    gl_FragColor = vec4(color.rgb, 1.);
}
