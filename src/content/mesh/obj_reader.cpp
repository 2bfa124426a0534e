#include "src/content/mesh/obj_reader.h"

#include <fmt/format.h>
#include <tiny_obj_loader.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <functional>
#include <istream>
#include <streambuf>

namespace snell::content {
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

}  // namespace snell::content
