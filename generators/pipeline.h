// A pipe along a polyline: elbows in its corners, fittings in its straights, everything joined
// exactly.
#pragma once

#include "generators/fittings.h"

#include <span>
#include <string>

namespace quartic {

// An end of equipment where a pipe begins.
struct Nozzle {
    glm::dvec3 position;
    glm::dvec3 out;  // unit
    double radius;
};

struct PipeSpec {
    std::string name;
    double radius = 0.1;
    Finish service = Finish::process;
    bool insulated = false;
    double valve_chance = 0.3;
    double flange_every = 12.0;  // metres; 0: none in straights
    bool flanged_start = false;
    bool flanged_end = false;
    double bend_ratio = 3.0;  // of bend radius to pipe radius: 1.5 diameters
};

class Pipeline {
public:
    Pipeline(Model& model, Random& random, PipeSpec spec);

    // Any polyline; corners too tight for the bend get a smaller one.
    void run(std::span<const glm::dvec3> corners);

private:
    struct Bend {
        glm::dvec3 start;
        glm::dvec3 end;
        double bend_radius = 0.0;  // 0: none
    };

    Bend bend_at(std::span<const glm::dvec3> corners, std::size_t index) const;
    void add_straight(const glm::dvec3& from, const glm::dvec3& to, bool first, bool last);
    void add_fittings(Station& at, double& room);
    void add_tube(const glm::dvec3& from, const glm::dvec3& to);
    void add_elbow(const Bend& bend, const glm::dvec3& along, const glm::dvec3& next);
    glm::dvec3 spindle(const glm::dvec3& along);

    Model& model_;
    Random& random_;
    PipeSpec spec_;
    int tubes_ = 0;
    int elbows_ = 0;
    int flanges_ = 0;
    int valves_ = 0;
    double since_flange_ = 0.0;
};

// Names pipes as plants do: size in millimetres, a letter for the service, a number.
std::string pipe_name(double radius, Finish service, int number);

}  // namespace quartic
