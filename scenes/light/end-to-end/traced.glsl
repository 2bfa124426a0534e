// True if the current method traces the ball, false if it draws the mesh. One of the two draws stays empty.
#ifdef METHOD_sphere_map_2
#define TRACED (METHOD >= METHOD_sphere_map_2)
#else
#define TRACED (METHOD == METHOD_reference)
#endif
