#version 330

layout(location = 0) in vec3 i_position;
layout(location = 1) in vec3 i_normal;
in vec2 aTexCoord0;

uniform mat4 u_model_mat;
uniform mat4 u_modelViewProj_mat;
uniform mat4 uModelViewerMatrix;

out vec3 v_position, v_normal, v_fromEye, v_reflected;
out vec2 v_st;

void main(void)
{
    vec4 position = vec4( i_position, 1. );
    v_position = vec3( u_model_mat * position );
    v_normal = mat3( u_model_mat ) * i_normal;
    v_fromEye = vec3( uModelViewerMatrix * position );
    v_reflected = reflect( normalize( v_fromEye ), normalize( v_normal ) );
    v_st = aTexCoord0;
    gl_Position = u_modelViewProj_mat * position;
}
