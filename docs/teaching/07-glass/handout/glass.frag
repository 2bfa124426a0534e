#version 330 compatibility

uniform samplerCube uAround;

in vec3 vFromEye, vNormal;

void main()
{
    gl_FragColor = texture( uAround, normalize( vNormal ) );
}
