// What is drawn over and beside the model with Dear ImGui: one function for each piece, each in a
// file of its own.
#pragma once

#include "viewer/app.h"

namespace quartic::viewer {

// All of it, once a frame; decides where the model is shown.
void show_panels(App& app);

void show_menu_bar(App& app);
void show_status_bar(const App& app);
void show_tree(App& app);                     // inside a window
void show_properties(App& app);               // inside a window
void show_import_report(const Model& model);  // inside a window
void show_maps_menu(App& app);                // inside a menu
void show_solver_menu(App& app);              // inside a menu
void show_second_solver_menu(App& app);       // inside a menu
void show_legends(const App& app);
void show_help(App& app);
void show_loading(App& app);
void show_failure(App& app);
// The model's picture, the axes in its corner, and the box around a selected node.
void show_picture(const App& app);

}  // namespace quartic::viewer
