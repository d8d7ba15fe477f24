// Instance i of 1,000 stands at its place in a block of 10 x 10 x 10.
uniform vec3 uCentre;

out vec3 vColor;

void main()
{
    int i = gl_InstanceID;
    vec3 place = vec3(i % 10, i / 10 % 10, i / 100) / 9. - .5;
    vColor = place + .5 + .1;
    gl_Position = uModelViewProjectionMatrix * vec4(aVertex.xyz + place + uCentre, 1.);
}
