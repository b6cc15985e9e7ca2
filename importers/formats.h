// The rows of the importer table, one for each file that reads a format.
#pragma once

#include "importers/load.h"

namespace quartic {

Importer rvm_importer();  // AVEVA RVM, binary
Importer rev_importer();  // AVEVA RVM, text form
Importer pov_importer();  // POV-Ray scenes

}  // namespace quartic
