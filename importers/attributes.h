// AVEVA attribute files (CADC_Attributes_File): names and values for the nodes of a model, joined
// by the path of names.
#pragma once

#include "diagnostics/result.h"
#include "files/source.h"
#include "importers/load.h"
#include "scene/scene.h"

#include <cstddef>
#include <span>
#include <string>

namespace quartic {

bool is_attribute_file(std::span<const std::byte> head);

// The file of the same name beside the model with .att or .txt in any letter case, or nothing.
// Whether it holds attributes is another question.
std::string find_attribute_file(const std::string& model_path);

// Adds the attributes of every element whose path of names occurs in the scene; what does not fit
// is counted in the findings. Works on a scene that has no attributes yet.
Status join_attributes(Scene& scene, const Source& source, Progress& progress);

// The file that the options name, else the one beside the model. Only a named file must be there
// and be sound.
Status join_attributes_of(Scene& scene, const Source& model, const ImportOptions& options,
                          Progress& progress);

}  // namespace quartic
