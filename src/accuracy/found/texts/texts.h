// What changes of the author's texts are found in: the statements of scenes, and places of shaders for more
// declarations.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "src/accuracy/found/shaders/shader.h"

namespace snell::accuracy::texts {

// A statement of a scene's text.
struct Statement {
    std::string_view command;     // as in the table of commands; empty: unknown
    Span span, name;              // of all of it; of the command
    std::vector<Span> arguments;  // its words and texts
    bool bracketed = false;       // it has brackets, so that arguments are not in the order of the signature
};

// The statements of the scene and of the texts that it includes, each text once.
std::vector<Statement> statements(const Files& files, const Sources& sources);
// The statement that begins at the place; null if there is none.
const Statement* statement_at(const std::vector<Statement>& all, Span place);
// What finds changes of a scene's statements: the scene, its texts, and where the changes go.
class OfStatements {
protected:
    OfStatements(const Reading& reading, std::vector<Change>& changes, std::size_t most)
        : plan_(reading.plan),
          scene_(reading.plan.scene),
          files_(reading.files),
          shaders_(reading.shaders),
          all_(statements(reading.files, reading.sources)),
          to_(reading.files, reading.sources, changes, most) {}

    const Statement* statement(Span span) const { return statement_at(all_, to_.first_reading(span)); }

    const Plan& plan_;
    const Scene& scene_;
    const Files& files_;
    const std::deque<Shader>& shaders_;
    std::vector<Statement> all_;
    Offers to_;
};

// Whether all files of the texture are there, or of the one that it is computed from.
bool is_there(const Scene& scene, Index texture, const Files& files);

// Declares a global variable before the function around the token. The edit is empty if the shader has it, and there is
// none if there is no place for it.
std::optional<Edit> declared(const Shader& shader, int token, std::string_view declaration);
// Includes a file of snell's library, such as "snell/fresnel.glsl". The edit is empty if the shader includes it.
std::optional<Edit> included(const Shader& shader, std::string_view file);
inline bool adds(const Edit& edit) { return !edit.text.empty(); }
inline std::optional<Span> place_of(const Shader& shader, const Expression& e) {
    return shader.place(e.first(), e.last());
}

// Better changes that no lint finds: exact Fresnel equations for Schlick's formula; then add_surroundings.
void add_physics(const Reading& reading, const std::vector<Span>& eye_space, Offers& to);
// Both interfaces of balls of glass, and rooms that are near. `eye_space`: lookups by directions in eye coordinates,
// which no room can mend.
void add_surroundings(const Reading& reading, const std::vector<Span>& eye_space, Offers& to);

}  // namespace snell::accuracy::texts
