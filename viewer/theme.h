// Colours, sizes and the font of the panels.
#pragma once

namespace quartic::viewer {

// For widgets at this scale; may be called again when the window moves to another screen, between
// frames.
void apply_theme(double scale);

}  // namespace quartic::viewer
