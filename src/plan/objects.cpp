#include "src/plan/objects.h"

#include <glm/gtc/matrix_transform.hpp>

#include <map>
#include <utility>

#include "parser/text/ranges.h"
#include "src/plan/identity.h"
#include "src/plan/plan.h"

namespace snell {

glm::dmat4 placed(const Transformation& object, const Camera& camera, const glm::dmat4& model) {
    if (object == Transformation{}) return model;
    const glm::dmat4 view = view_matrix(camera);
    const glm::dvec3 origin(view * model[3]);
    const glm::dmat4 in_eye = glm::translate(glm::dmat4(1), origin) * object.matrix(vertical_of(camera, view)) *
                              glm::translate(glm::dmat4(1), -origin);
    return glm::inverse(view) * in_eye * view * model;
}

std::vector<std::string> object_names(const Scene& scene) {
    std::map<std::string, int> before;
    std::vector<std::string> names;
    for (const Draw& draw : scene.draws) {
        std::string name = shape_key(scene, draw.shape, draw.wire);
        name += '#' + std::to_string(before[name]++);
        names.push_back(std::move(name));
    }
    return names;
}

bool flat_picture(const Scene& scene) {
    const Draw* first = nullptr;
    const auto matrix = [&](const Draw& draw) { return draw.matrix == none ? Mat4{} : scene.matrices[draw.matrix]; };
    for (const Pass& pass : scene.passes) {
        if (pass.kind != Pass::Kind::window) continue;
        for (const Item& item : pass.items) {
            if (item.kind != Item::Kind::draw) continue;
            const Draw& draw = scene.draws[item.index];
            const Quad* quad = std::get_if<Quad>(&draw.shape);
            if (!quad || quad->n1 != 1 || quad->n2 != 1) return false;
            if (!first) first = &draw;
            const Quad& other = std::get<Quad>(first->shape);
            if (quad->plane != other.plane || quad->offset != other.offset || draw.camera != first->camera)
                return false;
            if (draw.matrix != first->matrix && matrix(draw) != matrix(*first)) return false;
        }
    }
    return first != nullptr;
}

Index carried(const std::vector<std::string>& from, const std::vector<std::string>& to, Index object) {
    if (object >= from.size()) return none;
    if (from.size() == to.size()) return object;
    const auto same = ranges::find(to, from[object]);
    return same == to.end() ? none : static_cast<Index>(same - to.begin());
}

void carry_objects(const std::vector<std::string>& from, const std::vector<std::string>& to, View& view) {
    for (const auto& [draw, transformation] : std::exchange(view.objects, {}))
        if (const Index found = carried(from, to, draw); found != none) view.objects[found] = transformation;
}

}  // namespace snell
