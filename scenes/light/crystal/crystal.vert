#version 330

layout(location = 0) in vec3 i_position;
layout(location = 1) in vec3 i_normal;

uniform mat4 u_model_mat;         // world from the object's coordinates
uniform mat4 u_viewProj_mat;      // clip from world
uniform vec3 u_camera_position;   // the eye, in world coordinates

out vec3 v_fromEye;
out vec3 v_normal;

void main(void)
{
    vec3 world = vec3( u_model_mat * vec4( i_position, 1. ) );
    v_normal = mat3( u_model_mat ) * i_normal;
    v_fromEye = world - u_camera_position;
    gl_Position = u_viewProj_mat * vec4( world, 1. );
}
