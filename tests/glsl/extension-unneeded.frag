#version 330 compatibility
#extension GL_EXT_gpu_shader4: enable
#extension GL_EXT_geometry_shader4 : enable
#extension GL_ARB_gpu_shader_fp64 : enable
in vec3 vN;
void main() { gl_FragColor = vec4(abs(vN), 1.); }
