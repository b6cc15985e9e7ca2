// Names that scenes take from POV-Ray's include files (shapes.inc, shapesq.inc, colors.inc), in its
// own language; the surfaces' equations are those of the manual's list of quartics. Endless
// cylinders get the length of the default limits.
#include "importers/pov_reader.h"

namespace quartic {

std::string_view pov_prelude() {
    return R"(
#declare UnitBox = box { -1, 1 }
#declare Cube = box { -1, 1 }
#declare Sphere = sphere { 0, 1 }
#declare UnitSphere = sphere { 0, 1 }
#declare Cylinder_X = cylinder { -5*x, 5*x, 1 open }
#declare Cylinder_Y = cylinder { -5*y, 5*y, 1 open }
#declare Cylinder_Z = cylinder { -5*z, 5*z, 1 open }
#declare Disk_X = cylinder { -x, x, 1 }
#declare Disk_Y = cylinder { -y, y, 1 }
#declare Disk_Z = cylinder { -z, z, 1 }
#declare Paraboloid_X = quadric { <0, 1, 1>, 0, <-1, 0, 0>, 0 }
#declare Paraboloid_Y = quadric { <1, 0, 1>, 0, <0, -1, 0>, 0 }
#declare Paraboloid_Z = quadric { <1, 1, 0>, 0, <0, 0, -1>, 0 }
#declare Hyperboloid_Y = quadric { <1, -1, 1>, 0, 0, -1 }
#declare QCone_X = quadric { <-1, 1, 1>, 0, 0, 0 }
#declare QCone_Y = quadric { <1, -1, 1>, 0, 0, 0 }
#declare QCone_Z = quadric { <1, 1, -1>, 0, 0, 0 }
#declare Crossed_Trough = quartic {
  <0,0,0,0,0,0,0,4,0,0, 0,0,0,0,0,0,0,0,0,0, 0,0,0,0,0,0,0,0,0,-1, 0,0,0,0,0> }
#declare Folium = quartic {
  <0,0,0,0,0,0,0,0,0,2, 0,0,-3,0,0,0,0,-3,0,0, 0,0,0,0,0,1,0,0,0,0, 0,0,1,0,0> }
#declare Helix = quartic {
  <0,0,0,0,0,0,0,0,0,0, 0,0,0,0,0,0,-0.1666,0,1,0, 0,0,0,0,0,0,0,0.5,0,-1, 0,0,0,0,0>
  clipped_by { cylinder { 0, 1.4142*z, 2 } } }
#declare Lemniscate = quartic {
  <1,0,0,0,0,0,0,0,0,-1, 0,0,0,0,0,0,0,0,0,0, 0,0,0,0,0,1,0,0,0,0, 0,0,1,0,0> }
#declare Monkey_Saddle = quartic {
  <0,0,0,1,0,0,0,0,0,0, 0,0,-3,0,0,0,0,0,0,0, 0,0,0,0,0,0,0,0,0,0, 0,0,0,-1,0> }
#declare Piriform = quartic {
  <4,0,0,-4,0,0,0,0,0,0, 0,0,0,0,0,0,0,0,0,0, 0,0,0,0,0,1,0,0,0,0, 0,0,1,0,0> }
#declare Quartic_Paraboloid = quartic {
  <0.1,0,0,0,0,0,0,0,0,-1, 0,0,0,0,0,0,0,0,0,0, 0,0,0,0,0,0,0,0,0,-1, 0,0,-1,0,0.9> }
#declare Steiner_Surface = quartic {
  <0,0,0,0,1,0,0,1,0,0, 0,0,0,0,1,0,0,0,0,0, 0,0,0,1,0,0,0,0,0,0, 0,0,0,0,0> }
#declare Torus_40_12 = quartic {
  <1,0,0,0,2,0,0,2,0,-104, 0,0,0,0,0,0,0,0,0,0, 1,0,0,2,0,56,0,0,0,0, 1,0,-104,0,784> }
#declare Red = color red 1
#declare Green = color green 1
#declare Blue = color blue 1
#declare Yellow = color red 1 green 1
#declare Cyan = color green 1 blue 1
#declare Magenta = color red 1 blue 1
#declare White = rgb 1
#declare Black = rgb 0
#declare Clear = color red 1 green 1 blue 1 filter 1
#declare Gray25 = rgb 0.25
#declare Gray50 = rgb 0.5
#declare Gray75 = rgb 0.75
#declare Gray = rgb 0.752941
#declare Grey = rgb 0.752941
#declare Orange = color red 1 green 0.5
#declare Brown = color red 0.647059 green 0.164706 blue 0.164706
#declare Gold = color red 0.8 green 0.498039 blue 0.196078
#declare Silver = color red 0.90 green 0.91 blue 0.98
#declare Copper = color red 0.72 green 0.45 blue 0.20
#declare Brass = color red 0.71 green 0.65 blue 0.26
#declare Pink = color red 0.737255 green 0.560784 blue 0.560784
#declare Violet = color red 0.309804 green 0.184314 blue 0.309804
#declare SkyBlue = color red 0.196078 green 0.6 blue 0.8
#declare SteelBlue = color red 0.137255 green 0.419608 blue 0.556863
#declare NavyBlue = color red 0.137255 green 0.137255 blue 0.556863
#declare ForestGreen = color red 0.137255 green 0.556863 blue 0.137255
#declare SeaGreen = color red 0.137255 green 0.556863 blue 0.419608
#declare Wheat = color red 0.847059 green 0.847059 blue 0.74902
)";
}

}  // namespace quartic
