const vec3 LIGHT = normalize(vec3(1., 2., 3.));

in vec3 vColor;
in vec3 vNormal;
out vec4 fFragColor;

void main()
{
    float diffuse = max(dot(normalize(vNormal), LIGHT), 0.);
    fFragColor = vec4((.3 + .7 * diffuse) * vColor, 1.);
}
