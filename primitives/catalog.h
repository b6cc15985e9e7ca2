// Every primitive. To add one: write its file, then add a line to each list; the rest follows.
//
// SHAPE(id, Type, name): ids are stored in files and pick buffers: append, never renumber or reuse.
#ifdef SHAPE
SHAPE(1, Sphere, sphere)
SHAPE(2, Dish, dish)
SHAPE(3, Cylinder, cylinder)
SHAPE(4, Cone, cone)
SHAPE(5, Snout, snout)
SHAPE(6, Torus, torus)
SHAPE(7, RectangularTorus, rectangular_torus)
SHAPE(8, Box, box)
SHAPE(9, Pyramid, pyramid)
SHAPE(10, Disk, disk)
SHAPE(11, CubicSurface, cubic)
SHAPE(12, QuarticSurface, quartic)
#else
#include "primitives/algebraic.glsl"
#include "primitives/arc.glsl"
#include "primitives/box.glsl"
#include "primitives/cone.glsl"
#include "primitives/cubic_surface.glsl"
#include "primitives/cylinder.glsl"
#include "primitives/dish.glsl"
#include "primitives/disk.glsl"
#include "primitives/pyramid.glsl"
#include "primitives/quartic_surface.glsl"
#include "primitives/rectangular_torus.glsl"
#include "primitives/snout.glsl"
#include "primitives/snout_proxy.glsl"
#include "primitives/sphere.glsl"
#include "primitives/torus.glsl"
#include "primitives/torus_march.glsl"
#include "primitives/torus_roots.glsl"
#include "primitives/torus_solid.glsl"
#endif
