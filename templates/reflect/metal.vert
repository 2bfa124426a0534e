#version 330 compatibility

// A cube map is looked up by directions in world coordinates. Eye coordinates would turn the sky with the camera.
uniform mat4 uModelViewerMatrix;    // from the model to the world's axes, relative to the viewer; snell sets both
uniform mat3 uModelNormalMatrix;    // the same for normals

out vec3 vFromEye, vNormal;

void main()
{
    vFromEye = ( uModelViewerMatrix * gl_Vertex ).xyz;
    vNormal = uModelNormalMatrix * gl_Normal;
    gl_Position = gl_ModelViewProjectionMatrix * gl_Vertex;
}
