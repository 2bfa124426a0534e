// Whether the current method traces the ball, or draws its mesh. Of the two draws one stays empty.
#ifdef METHOD_sphere_map_2
#define TRACED (METHOD >= METHOD_sphere_map_2)
#else
#define TRACED (METHOD == METHOD_reference)
#endif
