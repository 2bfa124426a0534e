#include <fmt/format.h>
#include <shapefil.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <memory>

#include "src/content/mesh/mesh.h"

namespace snell::content {
namespace {

constexpr std::size_t header_bytes = 100, record_header_bytes = 8;

std::uint32_t big_endian(const char* p) {
    const auto* b = reinterpret_cast<const unsigned char*>(p);
    return std::uint32_t{b[0]} << 24 | std::uint32_t{b[1]} << 16 | std::uint32_t{b[2]} << 8 | b[3];
}
void append_big_endian(std::string& s, std::uint32_t v) {
    for (const int shift : {24, 16, 8, 0}) s.push_back(static_cast<char>(v >> shift & 0xff));
}

struct IndexFile {
    std::string bytes;
    bool cut = false;  // the file is shorter than its header states
};

// Makes the index file of a .shp from its record headers. Sizes are in 16-bit words. An incomplete last record is left
// out.
IndexFile make_index(std::string_view shp) {
    std::string records;
    std::size_t at = header_bytes;
    bool cut = false;
    while (at + record_header_bytes <= shp.size()) {
        const std::uint32_t words = big_endian(shp.data() + at + 4);
        const std::size_t end = at + record_header_bytes + std::size_t{words} * 2;
        if (end > shp.size() || words < 2) {
            cut = true;
            break;
        }
        append_big_endian(records, static_cast<std::uint32_t>(at / 2));
        append_big_endian(records, words);
        at = end;
    }
    cut |= at < shp.size() || std::size_t{big_endian(shp.data() + 24)} * 2 > shp.size();
    std::string index(shp.substr(0, header_bytes));
    std::string size;
    append_big_endian(size, static_cast<std::uint32_t>((header_bytes + records.size()) / 2));
    index.replace(24, 4, size);
    return {index + records, cut};
}

// A file in memory, behind shapelib's file interface. shapelib passes no context to FOpen, so the two files are in
// thread-local variables while they are opened.
struct MemoryFile {
    std::string_view bytes;
    std::size_t at = 0;
};
struct OpenFiles {
    std::string_view shp, shx;
};
thread_local const OpenFiles* opening = nullptr;

MemoryFile& memory(SAFile file) { return *reinterpret_cast<MemoryFile*>(file); }

SAFile open(const char* name, const char*) {
    const std::string_view n = name;
    if (!opening || n.size() < 4) return nullptr;
    if (n.ends_with(".shp")) return reinterpret_cast<SAFile>(new MemoryFile{opening->shp});
    if (n.ends_with(".shx")) return reinterpret_cast<SAFile>(new MemoryFile{opening->shx});
    return nullptr;
}
SAOffset read(void* to, SAOffset size, SAOffset count, SAFile file) {
    MemoryFile& f = memory(file);
    if (size == 0 || f.at > f.bytes.size()) return 0;
    const SAOffset whole = std::min<SAOffset>(count, (f.bytes.size() - f.at) / size);
    std::memcpy(to, f.bytes.data() + f.at, whole * size);
    f.at += whole * size;
    return whole;
}
SAOffset write(void*, SAOffset, SAOffset, SAFile) { return 0; }
SAOffset seek(SAFile file, SAOffset offset, int whence) {
    MemoryFile& f = memory(file);
    f.at = static_cast<std::size_t>(offset) + (whence == SEEK_CUR ? f.at : whence == SEEK_END ? f.bytes.size() : 0);
    return 0;
}
SAOffset tell(SAFile file) { return memory(file).at; }
int flush(SAFile) { return 0; }
int close(SAFile file) {
    delete &memory(file);
    return 0;
}
int remove_nothing(const char*) { return -1; }
void ignore_error(const char*) {}  // the return values report errors too

SAHooks hooks() {
    SAHooks h{};
    SASetupDefaultHooks(&h);
    h.FOpen = open;
    h.FRead = read;
    h.FWrite = write;
    h.FSeek = seek;
    h.FTell = tell;
    h.FFlush = flush;
    h.FClose = close;
    h.Remove = remove_nothing;
    h.Error = ignore_error;
    return h;
}

struct CloseShp {
    void operator()(SHPInfo* h) const { SHPClose(h); }
};
struct DestroyObject {
    void operator()(SHPObject* o) const { SHPDestroyObject(o); }
};
using Shp = std::unique_ptr<SHPInfo, CloseShp>;
using Object = std::unique_ptr<SHPObject, DestroyObject>;

Shp open_shp(std::string_view shp, std::string_view shx) {
    const OpenFiles files{shp, shx};
    SAHooks h = hooks();
    opening = &files;
    Shp result(SHPOpenLL("memory.shp", "rb", &h));
    opening = nullptr;
    return result;
}

bool has_lines(int type) {
    return type == SHPT_ARC || type == SHPT_ARCZ || type == SHPT_ARCM || type == SHPT_POLYGON ||
           type == SHPT_POLYGONZ || type == SHPT_POLYGONM || type == SHPT_MULTIPATCH;
}
bool has_z(int type) { return type == SHPT_ARCZ || type == SHPT_POLYGONZ || type == SHPT_MULTIPATCH; }

// Adds one part, a line strip, as separate lines. s runs from 0 to 1 along the part, by vertex count. Returns false and
// adds nothing if an x or y is not finite; heights that are not finite become 0 and are counted.
bool add_part(const SHPObject& o, int begin, int end, Mesh& mesh, int& heights) {
    for (int i = begin; i < end; ++i)
        if (!(std::abs(o.padfX[i]) <= 1e37 && std::abs(o.padfY[i]) <= 1e37)) return false;
    for (int i = begin; i < end; ++i) {
        double z = has_z(o.nSHPType) && o.padfZ ? o.padfZ[i] : 0;
        if (!(std::abs(z) <= 1e37)) z = 0, ++heights;
        const auto index = static_cast<std::uint32_t>(mesh.positions.size());
        if (i > begin) mesh.indices.insert(mesh.indices.end(), {index - 1, index});
        mesh.positions.push_back(
            {static_cast<float>(o.padfX[i]), static_cast<float>(o.padfY[i]), static_cast<float>(z)});
        mesh.normals.push_back({0, 0, 1});
        mesh.texcoords.push_back(
            {static_cast<float>(i - begin) / static_cast<float>(std::max(end - begin - 1, 1)), 0, 0});
    }
    return true;
}

// Counts of records and values that could not be used.
struct Leftovers {
    int unreadable = 0, without_lines = 0, not_finite = 0, heights = 0;
};

void add_object(const SHPObject& o, Mesh& mesh, Leftovers& left) {
    if (!has_lines(o.nSHPType)) {
        left.without_lines += o.nSHPType != SHPT_NULL;
        return;
    }
    for (int part = 0; part < o.nParts; ++part) {
        const int begin = o.panPartStart[part], end = part + 1 < o.nParts ? o.panPartStart[part + 1] : o.nVertices;
        if (begin < 0 || end > o.nVertices || begin > end)
            ++left.unreadable;
        else if (!add_part(o, begin, end, mesh, left.heights))
            ++left.not_finite;
    }
}

void report(const Leftovers& left, bool cut, std::vector<MeshIssue>& issues) {
    const auto warn = [&](int count, std::string code, std::string_view what) {
        if (count > 0) issues.push_back({false, std::move(code), fmt::format("{} {}", count, what), ""});
    };
    warn(left.unreadable, "shp-damaged", "records cannot be read; they are left out");
    warn(left.not_finite, "shp-not-a-number", "lines have coordinates that are not numbers; they are left out");
    warn(left.heights, "shp-not-a-number", "heights are not numbers; 0 is used");
    warn(left.without_lines, "shp-no-lines", "records are points, not lines; they are left out");
    if (cut)
        issues.push_back({false, "shp-truncated", "the file is incomplete: it is shorter than its header states", ""});
}

}  // namespace

// X and Y are those of the file, Z its height if it has one (PolyLineZ, PolygonZ, MultiPatch), otherwise 0. M is
// ignored.
MeshResult parse_shp(std::string_view shp, const MeshLimits& limits) {
    MeshResult result;
    const auto fail = [&](std::string code, std::string message, std::string help = {}) {
        result.mesh = {};
        result.issues.push_back({true, std::move(code), std::move(message), std::move(help)});
        return result;
    };
    if (shp.size() > limits.file_bytes)
        return fail("file-too-large", fmt::format("the file has {} bytes, more than the limit", shp.size()),
                    limit_help(limits.file_bytes, &Limits::file_bytes));
    if (shp.size() < header_bytes || big_endian(shp.data()) != 9994)
        return fail("shp-not-a-shape-file", "this is not an ESRI shape file: it does not begin with the number 9994");

    const IndexFile shx = make_index(shp);
    const Shp file = open_shp(shp, shx.bytes);
    if (!file) return fail("shp-damaged", "the file's header is invalid");

    Mesh& mesh = result.mesh;
    mesh.topology = Topology::lines;
    Leftovers left;
    for (int i = 0; i < file->nRecords; ++i) {
        const Object object(SHPReadObject(file.get(), i));
        if (!object)
            ++left.unreadable;
        else if (mesh.positions.size() + static_cast<std::size_t>(object->nVertices) > limits.vertices)
            return fail("too-many-vertices", fmt::format("the file has more than {} vertices", limits.vertices),
                        limit_help(limits.vertices, &Limits::vertices));
        else
            add_object(*object, mesh, left);
    }
    report(left, shx.cut, result.issues);
    if (mesh.indices.empty()) return fail("shp-empty", "the file contains no drawable lines");
    mesh.compute_bounds();
    return result;
}

}  // namespace snell::content
