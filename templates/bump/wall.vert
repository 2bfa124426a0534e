#version 330 compatibility

out vec2 vAt;           // on the wall, -1 to 1
out vec3 vPosition;     // in eye coordinates, as the lamp

void main()
{
    vAt = gl_Vertex.xy;
    vPosition = ( gl_ModelViewMatrix * gl_Vertex ).xyz;
    gl_Position = gl_ModelViewProjectionMatrix * gl_Vertex;
}
