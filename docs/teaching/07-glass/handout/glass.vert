#version 330 compatibility

uniform mat4 uModelViewerMatrix;    // from the model to the world's axes, relative to the viewer; snell sets both
uniform mat3 uModelNormalMatrix;    // the same for normals

out vec3 vFromEye, vNormal;         // along the world's axes

void main()
{
    vFromEye = ( uModelViewerMatrix * gl_Vertex ).xyz;
    vNormal = uModelNormalMatrix * gl_Normal;
    gl_Position = gl_ModelViewProjectionMatrix * gl_Vertex;
}
