#include "src/app/grade/submissions.h"

#include <fmt/format.h>

#include <array>
#include <filesystem>
#include <optional>

#include "parser/text/ranges.h"
#include "parser/text/words.h"
#include "src/content/archive/api.h"
#include "src/content/load_module.h"
#include "src/content/replace.h"
#include "src/plan/locate.h"

namespace snell::app {

namespace {

namespace fs = std::filesystem;

constexpr std::size_t message_size = 512;
using Message = std::array<char, message_size>;

struct ArchiveModule {
    decltype(&snell_archive_open) open = nullptr;
    decltype(&snell_archive_next) next = nullptr;
    decltype(&snell_archive_read) read = nullptr;
    decltype(&snell_archive_close) close = nullptr;
    std::string error;
};

ArchiveModule open_archive_module() {
    ArchiveModule result;
    result.error = content::open_functions(
        "snell_archive.so", "libarchive", "snell_archive_api_version", snell_archive_version,
        std::pair{"snell_archive_open", &result.open}, std::pair{"snell_archive_next", &result.next},
        std::pair{"snell_archive_read", &result.read}, std::pair{"snell_archive_close", &result.close});
    return result;
}

std::string as_utf8(std::string_view bytes) {
    std::string text;
    for (std::size_t at = 0; at < bytes.size();) {
        const utf8::Char c = utf8::decode(bytes, at);
        utf8::append(text, c.code);
        at += c.length;
    }
    return text;
}

// The parts of a name below the folder; nullopt for one that leads out of it.
std::optional<std::vector<std::string>> parts_of(std::string name) {
    std::replace(name.begin(), name.end(), '\\', '/');
    if (name.starts_with('/') || (name.size() > 1 && name[1] == ':')) return std::nullopt;
    std::vector<std::string> parts;
    for (const std::string_view part : split(name, '/')) {
        if (part == "..") return std::nullopt;
        if (!part.empty() && part != ".") parts.emplace_back(part);
    }
    return parts;
}

// Most file systems hold no longer ones.
bool too_long(const std::string& part) { return part.size() > 240; }

bool of_macos(const std::vector<std::string>& parts) {
    return ranges::any_of(parts, [](const std::string& part) {
        return part == "__MACOSX" || part == ".DS_Store" || part.starts_with("._");
    });
}

class Unpacking {
public:
    Unpacking(const ArchiveModule& module, void* archive, const std::string& folder, const UnpackLimits& limits)
        : module_(module), archive_(archive), folder_(folder), limits_(limits), left_(limits.bytes) {}

    Unpacked run() {
        SnellArchiveEntry entry{};
        Message message{};
        for (;;) {
            const int more = module_.next(archive_, &entry, message.data(), message.size());
            if (more < 0) result_.error = utf8::printable(message.data());
            if (more <= 0 || !one(entry)) return std::move(result_);
        }
    }

private:
    // False: nothing more is read.
    bool one(const SnellArchiveEntry& entry) {
        if (++entries_ > limits_.files) return stop(fmt::format("it has more than {} entries", limits_.files));
        const std::string name = as_utf8(entry.name);
        const auto parts = parts_of(name);
        if (!parts) return leave_out(name, "leads out of the archive's folder");
        if (parts->size() > limits_.depth + 1)
            return leave_out(name, fmt::format("is more than {} folders deep", limits_.depth));
        if (ranges::any_of(*parts, too_long)) return leave_out(name, "has a name of more than 240 bytes");
        if (parts->empty() || of_macos(*parts)) return true;
        if (entry.kind == snell_archive_other) return leave_out(name, "is a link or a device");
        fs::path place(folder_);
        for (const std::string& part : *parts) place /= part;
        std::error_code error;
        fs::create_directories(entry.kind == snell_archive_folder ? place : place.parent_path(), error);
        if (error) return leave_out(name, "cannot be written: " + error.message());
        return entry.kind == snell_archive_folder || file(name, place);
    }

    bool file(const std::string& name, const fs::path& place) {
        content::PartFile out(place);
        std::vector<char> some(1 << 16);
        Message message{};
        std::string wrong;
        for (;;) {
            const long long got = module_.read(archive_, some.data(), some.size(), message.data(), message.size());
            if (got < 0) return stop(fmt::format("'{}': {}", utf8::printable(name), utf8::printable(message.data())));
            if (got == 0) break;
            const auto count = static_cast<std::size_t>(got);
            if (count > left_) return stop(fmt::format("it holds more than {} MB", limits_.bytes >> 20));
            left_ -= count;
            if (wrong = out.write({some.data(), count}); !wrong.empty()) break;
        }
        if (wrong.empty()) wrong = out.close();
        return wrong.empty() || leave_out(name, "cannot be written: " + wrong);
    }

    bool stop(std::string why) {
        result_.error = std::move(why);
        return false;
    }

    bool leave_out(const std::string& name, const std::string& why) {
        constexpr std::size_t most = 20;
        if (result_.notes.size() < most)
            result_.notes.push_back(fmt::format("'{}' was left out: it {}", utf8::printable(name), why));
        return true;
    }

    const ArchiveModule& module_;
    void* archive_;
    const std::string& folder_;
    UnpackLimits limits_;
    std::uint64_t left_;
    std::size_t entries_ = 0;
    Unpacked result_;
};

}  // namespace

bool is_archive(const std::string& path) {
    constexpr std::array endings{"zip", "tar", "tgz", "gz", "xz", "bz2", "7z", "rar", "zst"};
    return ranges::any_of(endings, [&](const char* e) { return has_extension(path, e); });
}

Unpacked unpack(const std::string& archive, const std::string& folder, const UnpackLimits& limits) {
    const ArchiveModule module = open_archive_module();
    Unpacked result;
    result.error = module.error;
    if (!result.error.empty()) return result;
    Message message{};
    void* opened = module.open(archive.c_str(), message.data(), message.size());
    if (!opened) {
        result.error = utf8::printable(message.data());
        return result;
    }
    result = Unpacking(module, opened, folder, limits).run();
    module.close(opened);
    return result;
}

}  // namespace snell::app
