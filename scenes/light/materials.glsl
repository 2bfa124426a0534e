#ifndef MATERIALS_GLSL
#define MATERIALS_GLSL
// What things are made of. A test holds all but aluminium against src/optics/glass.h, which names the sources.

const int AIR = 0, ICE = 1, WATER = 2, PYREX = 3, WINDOW_GLASS = 4, QUARTZ = 5, BK7 = 6, SF11 = 7, CUBIC_ZIRCONIA = 8,
          DIAMOND = 9, MOISSANITE = 10, GLASSES = 11;

// Cauchy's index a + b / w^2, w in micrometres, fitted from 430 to 670 nm: within .0025.
const vec2 GLASS[11] = vec2[11]( vec2( 1.000272, .000002 ), vec2( 1.300838, .002970 ), vec2( 1.324446, .003079 ),
                                 vec2( 1.460467, .003774 ), vec2( 1.511115, .004223 ), vec2( 1.532515, .004050 ),
                                 vec2( 1.504626, .004195 ), vec2( 1.736704, .016623 ), vec2( 2.105502, .018414 ),
                                 vec2( 2.378191, .013582 ), vec2( 2.579745, .038012 ) );

// Complex indices eta + i k at 611, 549 and 464 nm: gold, silver, copper; and aluminium at 650, 550 and 450 nm (Rakic
// 1995).
const vec3 METAL_ETA[4] = vec3[4]( vec3( .2234, .4283, 1.3353 ), vec3( .0583, .0599, .0464 ),
                                   vec3( .3669, 1.0162, 1.2464 ), vec3( 1.3456, .9652, .6172 ) );
const vec3 METAL_K[4] = vec3[4]( vec3( 3.2036, 2.4599, 1.8725 ), vec3( 4.1029, 3.5892, 2.7925 ),
                                 vec3( 3.1213, 2.5785, 2.4520 ), vec3( 7.4746, 6.3995, 5.3031 ) );
#endif
