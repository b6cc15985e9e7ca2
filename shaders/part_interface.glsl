// What a part's vertices hand to its pixels, all of it the same at every vertex: pixels that read
// the records themselves would each pay for it. Defines: PART_INTERFACE (in or out), THIS_SHAPE,
// [FACETS], [THIS_FORM].
flat PART_INTERFACE THIS_SHAPE part_shape;
flat PART_INTERFACE vec4 part_rotation;
flat PART_INTERFACE uvec2 part_and_bits;
#ifndef FACETS
flat PART_INTERFACE RaySetup setup;
#endif
#ifdef THIS_FORM
flat PART_INTERFACE vec4 part_planes;
#endif
