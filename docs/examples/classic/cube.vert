out vec3 vColor;
out vec3 vNormal;

void main()
{
    vColor = aColor.rgb;
    vNormal = uNormalMatrix * aNormal;
    gl_Position = uModelViewProjectionMatrix * aVertex;
}
