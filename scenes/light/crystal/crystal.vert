#version 330

layout(location = 0) in vec3 i_position;
layout(location = 1) in vec3 i_normal;

uniform mat4 u_model_mat;           // world from the object's coordinates
uniform mat4 u_modelViewProj_mat;   // clip from the object's coordinates
uniform mat4 uModelViewerMatrix;    // world, relative to the eye, from the object's coordinates

out vec3 v_fromEye;
out vec3 v_normal;

void main(void)
{
    v_normal = mat3( u_model_mat ) * i_normal;
    v_fromEye = vec3( uModelViewerMatrix * vec4( i_position, 1. ) );
    gl_Position = u_modelViewProj_mat * vec4( i_position, 1. );
}
