// Reads POV-Ray's scene language as far as it describes objects, leniently.
#pragma once

#include "importers/load.h"
#include "importers/pov_object.h"

#include <map>
#include <string>
#include <vector>

namespace quartic {

// The top-level objects of a file, in order.
struct PovFile {
    std::vector<PovPlaced> objects;
    Findings findings;
    std::string first_loss;  // "line 12: expected ..."; empty if nothing was lost
};

class PovReader {
public:
    // Included files are looked for in the folder.
    PovReader(std::string_view text, std::string folder);

    // False if it was cancelled.
    bool run(Progress& progress);
    PovFile take() { return std::move(file_); }

private:
    using Object = std::shared_ptr<PovObject>;

    void statement();
    void directive();
    void declare();
    void include();
    void read_include(const std::string& name);
    void skip_conditional();

    bool starts_object() const;
    Object object();  // null if it is lost: then its block has been skipped
    bool block(PovObject& object);
    bool parameters(PovObject& object);
    bool coefficients(PovObject& object);
    bool poly(PovObject& object);
    bool quadric(PovObject& object);
    bool numbers(PovObject& object, std::string_view pattern);
    bool reference(PovObject& object);
    bool mesh2(PovObject& object);
    bool mesh_vectors(std::vector<glm::vec3>& into);
    bool mesh_faces(std::vector<std::uint32_t>& into);
    bool modifier(PovObject& object);
    bool transformation(PovObject& object);
    bool matrix(glm::dmat4& result);
    bool limits(PovObject& object);
    bool child(PovObject& object, std::vector<PovPlaced>& into);
    void look(PovObject& object);
    void pigment(PovObject& object);
    void skip_unknown();
    bool fail(std::string reason);

    void lose(std::size_t line, const std::string& text);
    void note(Severity severity, std::size_t line, const std::string& text);

    PovTokens tokens_;
    PovExpressions expressions_;
    std::string folder_;
    PovFile file_;
    std::map<std::string, PovValue, std::less<>> values_;
    std::map<std::string, std::shared_ptr<const PovObject>, std::less<>> objects_;
    std::map<std::string, PovValue, std::less<>> pigments_;
    std::string reason_;  // why the object that is being read is lost
    int nesting_ = 0;
    int include_count_ = 0;
};

// What POV-Ray's own include files declare, as far as scenes of algebraic surfaces use it.
std::string_view pov_prelude();

}  // namespace quartic
