#include "src/content/mesh/obj.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <functional>
#include <istream>
#include <streambuf>

#include <fmt/format.h>
#define TINYOBJLOADER_IMPLEMENTATION  // its library would be loaded at every start
#include <tiny_obj_loader.h>

#include "parser/vectors.h"
#include "src/content/mesh/surface.h"

namespace snell::content {
namespace {

using Corners = std::array<std::uint32_t, 3>;  // indices into ObjData::corners
constexpr std::uint32_t no_vertex = ~std::uint32_t{0};

Vec3 wide(const Float3& v) { return {v[0], v[1], v[2]}; }
bool is_zero(const Vec3& v) { return v == Vec3{0, 0, 0}; }

// A vector along the normal, of twice the triangle's area.
Vec3 area(const Float3& p0, const Float3& p1, const Float3& p2) {
    return cross(difference(wide(p1), wide(p0)), difference(wide(p2), wide(p0)));
}

const Float3& position(const ObjData& data, std::uint32_t corner) {
    return data.positions[static_cast<std::size_t>(data.corners[corner].position)];
}

// Splits all faces into triangles and leaves out those with two corners at one place. `flat` counts those without area.
std::vector<Corners> triangles_of(const ObjData& data, std::size_t& flat) {
    std::vector<Corners> result;
    result.reserve(data.face_ends.size());
    std::vector<Float3> polygon;
    std::vector<std::uint32_t> cut;
    std::uint32_t begin = 0;
    for (const std::uint32_t end : data.face_ends) {
        polygon.clear();
        cut.clear();
        for (std::uint32_t c = begin; c < end; ++c) polygon.push_back(position(data, c));
        triangulate(polygon, cut);
        for (std::size_t i = 0; i < cut.size(); i += 3) {
            const Float3 &a = polygon[cut[i]], &b = polygon[cut[i + 1]], &c = polygon[cut[i + 2]];
            if (is_zero(area(a, b, c))) ++flat;
            if (a != b && b != c && c != a) result.push_back({begin + cut[i], begin + cut[i + 1], begin + cut[i + 2]});
        }
        begin = end;
    }
    return result;
}

// Area-weighted normals by place. If the sum vanishes (the two sides of a sheet), the normal of the first triangle; if
// all triangles have no area, +Z.
std::vector<Float3> normals_by_place(const ObjData& data, const std::vector<Corners>& triangles, const Weld& places) {
    std::vector<Vec3> sum(places.places, Vec3{0, 0, 0}), first(places.places, Vec3{0, 0, 0});
    std::vector<double> total(places.places, 0);
    for (const Corners& t : triangles) {
        const Vec3 a = area(position(data, t[0]), position(data, t[1]), position(data, t[2]));
        if (is_zero(a)) continue;
        for (const std::uint32_t corner : t) {
            const std::uint32_t place = places.place[static_cast<std::size_t>(data.corners[corner].position)];
            if (is_zero(first[place])) first[place] = a;
            for (std::size_t k = 0; k < 3; ++k) sum[place][k] += a[k];
            total[place] += length(a);
        }
    }
    std::vector<Float3> normals(places.places);
    for (std::size_t i = 0; i < normals.size(); ++i) {
        const bool cancelled = length(sum[i]) <= 1e-9 * total[i];
        normals[i] = unit_float3(cancelled ? first[i] : sum[i]);
        if (normals[i] == Float3{0, 0, 0}) normals[i] = {0, 0, 1};
    }
    return normals;
}

// Makes one vertex for all corners with the same indices.
class Vertices {
public:
    Vertices(const ObjData& data, Mesh& mesh, std::vector<Float3> computed, const Weld& places)
        : data_(data),
          mesh_(mesh),
          computed_(std::move(computed)),
          places_(places),
          head_(data.positions.size(), no_vertex) {}

    std::uint32_t operator()(ObjCorner c) {
        Float3 normal{0, 0, 0};
        if (c.normal >= 0) normal = unit_float3(wide(data_.normals[static_cast<std::size_t>(c.normal)]));
        if (normal == Float3{0, 0, 0}) c.normal = -1;
        const auto at = static_cast<std::size_t>(c.position);
        for (std::uint32_t v = head_[at]; v != no_vertex; v = made_[v].next)
            if (made_[v].texcoord == c.texcoord && made_[v].normal == c.normal) return v;
        const auto index = static_cast<std::uint32_t>(made_.size());
        made_.push_back({c.texcoord, c.normal, head_[at]});
        head_[at] = index;
        mesh_.positions.push_back(data_.positions[at]);
        mesh_.normals.push_back(c.normal < 0 ? computed_[places_.place[at]] : normal);
        mesh_.texcoords.push_back(c.texcoord < 0 ? Float3{0, 0, 0}
                                                 : data_.texcoords[static_cast<std::size_t>(c.texcoord)]);
        return index;
    }

private:
    struct Made {
        std::int32_t texcoord, normal;
        std::uint32_t next;  // another vertex at the same position
    };
    const ObjData& data_;
    Mesh& mesh_;
    std::vector<Float3> computed_;
    const Weld& places_;
    std::vector<std::uint32_t> head_;
    std::vector<Made> made_;
};

void add_wire(const ObjData& data, Vertices& vertex, Mesh& mesh) {
    mesh.topology = Topology::lines;
    std::uint32_t begin = 0;
    for (const std::uint32_t end : data.face_ends) {
        for (std::uint32_t c = begin; c < end; ++c) {
            const std::uint32_t next = c + 1 == end ? begin : c + 1;
            if (position(data, c) == position(data, next)) continue;
            const std::uint32_t a = vertex(data.corners[c]), b = vertex(data.corners[next]);
            mesh.indices.insert(mesh.indices.end(), {a, b});
        }
        begin = end;
    }
    for (const auto& line : data.lines) {
        const std::uint32_t a = vertex(line[0]), b = vertex(line[1]);
        if (mesh.positions[a] != mesh.positions[b]) mesh.indices.insert(mesh.indices.end(), {a, b});
    }
    keep_each_edge_once(mesh.indices, weld(mesh.positions));
}

void add_triangles(const ObjData& data, const std::vector<Corners>& triangles, ObjAs as, Vertices& vertex, Mesh& mesh,
                   std::vector<MeshIssue>& issues) {
    mesh.indices.reserve(triangles.size() * 3);
    for (const Corners& t : triangles)
        for (const std::uint32_t corner : t) mesh.indices.push_back(vertex(data.corners[corner]));
    if (as == ObjAs::patches) {
        mesh.topology = Topology::patches;
        mesh.patch_vertices = 3;
    } else if (as == ObjAs::adjacency) {
        mesh.topology = Topology::triangles_adjacency;
        std::size_t crowded = 0;
        mesh.indices = with_adjacency(mesh.indices, weld(mesh.positions), nullptr, &crowded);
        if (crowded > 0)
            issues.push_back(
                {false, "obj-not-manifold",
                 fmt::format("{} edges belong to more than two triangles, or to two with opposite winding", crowded),
                 "adjacency is ambiguous there; repair the mesh"});
    }
}

}  // namespace

MeshResult parse_obj(std::string_view text, ObjAs as, bool wire, const MeshLimits& limits) {
    MeshResult result;
    const ObjData data = read_obj(text, limits, result.issues);
    const auto failed = [&] {
        return std::any_of(result.issues.begin(), result.issues.end(), [](const MeshIssue& i) { return i.error; });
    };
    if (failed()) return result;

    std::size_t flat = 0;
    const std::vector<Corners> triangles = triangles_of(data, flat);
    if (flat > 0)
        result.issues.push_back({false, "obj-zero-area", fmt::format("{} triangles have zero area", flat),
                                 "nothing is drawn of them: the picture is the same without", true});

    const Weld places = weld(data.positions);
    Mesh& mesh = result.mesh;
    Vertices vertex(data, mesh, normals_by_place(data, triangles, places), places);
    if (wire)
        add_wire(data, vertex, mesh);
    else
        add_triangles(data, triangles, as, vertex, mesh, result.issues);

    if (mesh.indices.empty()) {
        result.issues.push_back(
            {true, "obj-no-faces", "the file contains no drawable faces", "faces are lines such as 'f 1 2 3'"});
        result.mesh = {};
    } else if (mesh.positions.size() > limits.vertices) {
        result.issues.push_back({true, "too-many-vertices",
                                 fmt::format("the mesh has {} vertices, more than the limit", mesh.positions.size()),
                                 limit_help(limits.vertices, &Limits::vertices)});
        result.mesh = {};
    }
    mesh.compute_bounds();
    return result;
}

namespace {

constexpr std::string_view blanks = " \t\r\n";

std::string_view next_word(std::string_view& line) {
    line.remove_prefix(std::min(line.find_first_not_of(blanks), line.size()));
    const std::string_view word = line.substr(0, line.find_first_of(blanks));
    line.remove_prefix(word.size());
    return word;
}

// Passes the text on line by line without comments, so that a callback knows the line that it is called for.
class Lines : public std::streambuf {
public:
    explicit Lines(std::string_view text) : rest_(text) {}

    std::string_view line() const { return line_; }
    std::size_t number() const { return number_; }

    // Called for each `l` element after everything above it has been read, because tinyobjloader has no callback for
    // them.
    std::function<void(std::string_view)> line_element;

protected:
    int_type underflow() override {
        if (rest_.empty()) return traits_type::eof();
        if (ending_) {
            ending_ = false;
            return give(1, 1);
        }
        const std::size_t end = std::min(rest_.find('\n'), rest_.size() - 1) + 1;
        const std::size_t comment = rest_.substr(0, end).find('#');
        line_ = rest_.substr(0, std::min(comment, end));
        ++number_;
        std::string_view words = line_;
        if (next_word(words) == "l" && line_element) line_element(words);
        if (comment == 0 || comment == std::string_view::npos) return give(end, end);
        ending_ = rest_[end - 1] == '\n';
        return give(comment, ending_ ? end - 1 : end);
    }

private:
    int_type give(std::size_t size, std::size_t consumed) {
        char* begin = const_cast<char*>(rest_.data());  // streambuf's interface; never written to
        setg(begin, begin, begin + size);
        rest_.remove_prefix(consumed);
        return traits_type::to_int_type(*begin);
    }

    std::string_view rest_, line_;
    std::size_t number_ = 0;
    bool ending_ = false;  // a comment was left out, and its line feed is next
};

// A kind of problem, reported once with its first line and the number of times it occurred.
struct Trouble {
    std::string_view code, one, many, help;
    std::size_t count = 0, first_line = 0;

    void at(std::size_t line) {
        if (count++ == 0) first_line = line;
    }
    void report(std::vector<MeshIssue>& issues) const {
        if (count == 0) return;
        issues.push_back({false, std::string(code),
                          count == 1 ? fmt::format("line {}: {}", first_line, one)
                                     : fmt::format("{} {} (the first on line {})", count, many, first_line),
                          std::string(help)});
    }
};

struct Reader {
    Lines& lines;
    ObjData& data;
    std::uint64_t limit;
    std::vector<bool> unusable;  // positions that are not finite
    bool too_many = false;

    Trouble not_a_number{"obj-not-a-number", "a coordinate is not a number; faces with this vertex are left out",
                         "vertices have coordinates that are not numbers; their faces are left out", ""};
    Trouble malformed{"obj-malformed-number", "a number is followed by invalid characters",
                      "lines have numbers that are followed by invalid characters",
                      "write numbers such as 1.5 or -2e-3, with a decimal point"};
    Trouble out_of_range{"obj-index-out-of-range",
                         "the face refers to a vertex that does not exist; the face is left out",
                         "faces refer to vertices that do not exist; they are left out",
                         "indices count from 1, or backward from -1; 0 is invalid"};
    Trouble attribute{"obj-attribute-out-of-range",
                      "the face refers to a texture coordinate or normal that does not exist",
                      "faces refer to texture coordinates or normals that do not exist", "the reference is ignored"};
    Trouble too_small{"obj-face-too-small", "a face needs three corners; it is left out",
                      "faces have fewer than three corners; they are left out", ""};

    // Checks for numbers that tinyobjloader silently reads as 0.
    enum class Numbers { good, odd, bad };
    Numbers check(std::string_view line, int count) {
        next_word(line);
        Numbers worst = Numbers::good;
        for (int k = 0; k < count; ++k) {
            const std::string_view word = next_word(line);
            if (word.empty()) break;
            const std::size_t digit = word.find_first_not_of("+-");
            if (digit > 1 || (word[digit] != '.' && (word[digit] < '0' || word[digit] > '9'))) return Numbers::bad;
            if (word.find_first_not_of("0123456789+-.eE") != std::string_view::npos) worst = Numbers::odd;
        }
        return worst;
    }

    void vertex(float x, float y, float z) {
        if (data.positions.size() >= limit) {
            too_many = true;
            return;
        }
        const Numbers numbers = check(lines.line(), 3);
        const bool good = numbers != Numbers::bad && std::isfinite(x) && std::isfinite(y) && std::isfinite(z);
        if (!good) not_a_number.at(lines.number());
        if (numbers == Numbers::odd) malformed.at(lines.number());
        data.positions.push_back(good ? Float3{x + 0.f, y + 0.f, z + 0.f} : Float3{0, 0, 0});
        unusable.push_back(!good);
    }

    // Converts a 1-based or negative (relative) index to a 0-based one; `has` elements exist so far. 0 (not given)
    // becomes -1. Returns false if it is out of range.
    static bool resolve(std::int64_t written, std::size_t has, std::int32_t& index) {
        index = -1;
        const std::int64_t n = static_cast<std::int64_t>(has);
        if (written == 0) return true;
        const std::int64_t i = written > 0 ? written - 1 : n + written;
        if (i < 0 || i >= n) return false;
        index = static_cast<std::int32_t>(i);
        return true;
    }

    struct Found {
        ObjCorner corner;
        bool position = false, attributes = false;  // whether they exist
    };
    Found corner(const tinyobj::index_t& written) const {
        Found found;
        ObjCorner& c = found.corner;
        const bool texcoord = resolve(written.texcoord_index, data.texcoords.size(), c.texcoord);
        found.attributes = resolve(written.normal_index, data.normals.size(), c.normal) && texcoord;
        found.position = resolve(written.vertex_index, data.positions.size(), c.position) && c.position >= 0;
        return found;
    }

    // Detects indices beyond 32 bits, which tinyobjloader wraps around: 4294967297 would be read as 1.
    static bool wraps(std::string_view line) {
        int digits = 0;
        for (const char c : line) {
            digits = c >= '0' && c <= '9' ? digits + 1 : 0;
            if (digits > 9) return true;
        }
        return false;
    }

    void face(std::span<const tinyobj::index_t> written) {
        if (too_many) return;
        if (written.size() < 3) return too_small.at(lines.number());
        if (wraps(lines.line())) return out_of_range.at(lines.number());
        const std::size_t begin = data.corners.size();
        bool drop = false, attributes_exist = true;
        for (const tinyobj::index_t& w : written) {
            const Found found = corner(w);
            const ObjCorner& c = found.corner;
            attributes_exist = attributes_exist && found.attributes;
            if (!found.position) {
                out_of_range.at(lines.number());
                drop = true;
                break;
            }
            drop |= unusable[static_cast<std::size_t>(c.position)];
            data.corners.push_back(c);
        }
        if (!attributes_exist) attribute.at(lines.number());
        if (drop)
            data.corners.resize(begin);
        else
            data.face_ends.push_back(static_cast<std::uint32_t>(data.corners.size()));
    }

    // Parses the arguments of `l`: v1/vt1 v2/vt2 …
    void line_element(std::string_view line) {
        ObjCorner last;
        for (std::string_view word = next_word(line); !word.empty(); word = next_word(line)) {
            std::int64_t v = 0, t = 0;
            const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), v);
            if (end != word.data() + word.size() && *end == '/') std::from_chars(end + 1, word.data() + word.size(), t);
            ObjCorner c;
            resolve(t, data.texcoords.size(), c.texcoord);
            if (error != std::errc{} || !resolve(v, data.positions.size(), c.position) || c.position < 0 ||
                unusable[static_cast<std::size_t>(c.position)])
                return out_of_range.at(lines.number());
            if (last.position >= 0) data.lines.push_back({last, c});
            last = c;
        }
    }
};

// Converts line ends to line feeds and joins continued lines; returns an empty string if nothing had to be changed.
std::string normalised(std::string_view text) {
    bool needed = false;
    for (std::size_t i = text.find_first_of("\r\\"); i != std::string_view::npos && !needed;
         i = text.find_first_of("\r\\", i + 1))
        needed = text[i] == '\\' || i + 1 == text.size() || text[i + 1] != '\n';
    std::string copy;
    if (!needed) return copy;
    copy.reserve(text.size());
    for (std::size_t i = 0; i < text.size(); ++i) {
        char c = text[i];
        if (c == '\r') {
            if (i + 1 < text.size() && text[i + 1] == '\n') ++i;
            c = '\n';
        }
        if (c == '\n' && !copy.empty() && copy.back() == '\\')
            copy.back() = ' ';
        else
            copy.push_back(c);
    }
    return copy;
}

}  // namespace

ObjData read_obj(std::string_view text, const MeshLimits& limits, std::vector<MeshIssue>& issues) {
    ObjData data;
    if (text.size() > limits.file_bytes) {
        issues.push_back({true, "file-too-large",
                          fmt::format("the file has {} bytes, more than the limit", text.size()),
                          limit_help(limits.file_bytes, &Limits::file_bytes)});
        return data;
    }
    const std::string copy = normalised(text);
    if (!copy.empty()) text = copy;
    Lines lines(text);
    Reader reader{lines, data, limits.vertices, {}};

    tinyobj::callback_t callback;
    callback.vertex_cb = [](void* r, float x, float y, float z, float) { static_cast<Reader*>(r)->vertex(x, y, z); };
    callback.normal_cb = [](void* r, float x, float y, float z) {
        static_cast<Reader*>(r)->data.normals.push_back({x, y, z});
    };
    callback.texcoord_cb = [](void* r, float s, float t, float p) {
        const auto finite = [](float v) { return std::isfinite(v) ? v : 0.f; };
        static_cast<Reader*>(r)->data.texcoords.push_back({finite(s), finite(t), finite(p)});
    };
    callback.index_cb = [](void* r, tinyobj::index_t* indices, int count) {
        static_cast<Reader*>(r)->face({indices, static_cast<std::size_t>(count)});
    };
    lines.line_element = [&reader](std::string_view words) { reader.line_element(words); };
    std::istream stream(&lines);
    tinyobj::LoadObjWithCallback(stream, callback, &reader);

    for (const Trouble* t :
         {&reader.not_a_number, &reader.malformed, &reader.out_of_range, &reader.attribute, &reader.too_small})
        t->report(issues);
    if (reader.too_many) {
        issues.push_back({true, "too-many-vertices", fmt::format("the file has more than {} vertices", limits.vertices),
                          limit_help(limits.vertices, &Limits::vertices)});
        data = {};
    }
    return data;
}

namespace {

using Point = std::array<double, 2>;

// Ear clipping takes time quadratic in the number of corners at best, cubic at worst. Beyond these bounds a polygon is
// cut without looking for ears, which may cover parts of it twice.
constexpr std::size_t most_concave_corners = 20'000, most_point_tests = 50'000'000;

// Newell's method: a vector along the normal of twice the area, also for concave and slightly bent polygons.
std::array<double, 3> area_vector(std::span<const Float3> p) {
    std::array<double, 3> n{0, 0, 0};
    for (std::size_t i = 0; i < p.size(); ++i) {
        const Float3 &a = p[i], &b = p[(i + 1) % p.size()];
        for (std::size_t k = 0; k < 3; ++k) {
            const std::size_t u = (k + 1) % 3, v = (k + 2) % 3;
            n[k] += (double{a[u]} - b[u]) * (double{a[v]} + b[v]);
        }
    }
    return n;
}

// Projects along the largest component of the normal, so that the winding is counter-clockwise.
std::vector<Point> flatten(std::span<const Float3> p) {
    const auto n = area_vector(p);
    std::size_t k = 0;
    for (std::size_t i = 1; i < 3; ++i)
        if (std::abs(n[i]) > std::abs(n[k])) k = i;
    std::size_t u = (k + 1) % 3, v = (k + 2) % 3;
    if (n[k] < 0) std::swap(u, v);
    std::vector<Point> flat;
    flat.reserve(p.size());
    for (const Float3& q : p) flat.push_back({q[u], q[v]});
    return flat;
}

double turn(const Point& a, const Point& b, const Point& c) {
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

bool convex(const std::vector<Point>& p) {
    for (std::size_t i = 0; i < p.size(); ++i)
        if (turn(p[i], p[(i + 1) % p.size()], p[(i + 2) % p.size()]) < 0) return false;
    return true;
}

void fan(std::size_t corners, std::vector<std::uint32_t>& triangles) {
    for (std::uint32_t i = 1; i + 1 < corners; ++i) triangles.insert(triangles.end(), {0, i, i + 1});
}

// Ear clipping (Meisters 1975).
class Ears {
public:
    explicit Ears(const std::vector<Point>& points) : p_(points) {
        for (std::uint32_t i = 0; i < points.size(); ++i) left_.push_back(i);
    }

    void clip(std::vector<std::uint32_t>& triangles) {
        std::size_t i = 0, refused = 0;
        while (left_.size() > 3) {
            i %= left_.size();
            // A polygon that intersects itself may have no ear; then any corner is cut off.
            if (tests_ < most_point_tests && !ear(i) && refused++ < left_.size()) {
                ++i;
                continue;
            }
            triangles.insert(triangles.end(), {before(i), left_[i], after(i)});
            left_.erase(left_.begin() + static_cast<std::ptrdiff_t>(i));
            refused = 0;
        }
        triangles.insert(triangles.end(), left_.begin(), left_.end());
    }

private:
    std::uint32_t before(std::size_t i) const { return left_[(i + left_.size() - 1) % left_.size()]; }
    std::uint32_t after(std::size_t i) const { return left_[(i + 1) % left_.size()]; }

    bool ear(std::size_t i) {
        const Point &a = p_[before(i)], &b = p_[left_[i]], &c = p_[after(i)];
        if (turn(a, b, c) <= 0) return false;
        tests_ += left_.size();
        return std::none_of(left_.begin(), left_.end(), [&](std::uint32_t k) {
            const Point& q = p_[k];
            if (q == a || q == b || q == c) return false;
            return turn(a, b, q) >= 0 && turn(b, c, q) >= 0 && turn(c, a, q) >= 0;
        });
    }

    const std::vector<Point>& p_;
    std::vector<std::uint32_t> left_;
    std::size_t tests_ = 0;
};

}  // namespace

void triangulate(std::span<const Float3> positions, std::vector<std::uint32_t>& triangles) {
    if (positions.size() == 3) {
        triangles.insert(triangles.end(), {0, 1, 2});
        return;
    }
    const std::vector<Point> flat = flatten(positions);
    if (convex(flat) || flat.size() > most_concave_corners)
        fan(flat.size(), triangles);
    else
        Ears(flat).clip(triangles);
}

}  // namespace snell::content
