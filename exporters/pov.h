// Saves a scene in POV-Ray's scene language.
#pragma once

#include "diagnostics/result.h"
#include "files/output.h"
#include "scene/scene.h"

namespace quartic {

// Writes everything; the caller commits. The same scene gives the same bytes. Coordinates are
// POV-Ray's: our z is its y. Surfaces, spheres, cylinders, cones, tori, boxes and discs are said
// exactly; dishes, snouts, rectangular tori and pyramids become triangles within half a millimetre
// or a thousandth of their size. A camera and a light make the file a picture.
Status export_pov(const Scene& scene, Output& output);

// Which shapes become triangles.
void remark_pov(const Scene& scene, Findings& findings);

}  // namespace quartic
