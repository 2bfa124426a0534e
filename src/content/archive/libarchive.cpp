// The module: zip, tar (also compressed), 7z, rar and cpio by libarchive.
#include <archive.h>
#include <archive_entry.h>
#include <locale.h>

#include <cstdio>

#include "src/content/archive/api.h"

#define SNELL_EXPORT __attribute__((visibility("default")))

namespace {

void tell(archive* from, char* message, std::size_t size) {
    const char* text = archive_error_string(from);
    std::snprintf(message, size, "%s", text ? text : "it cannot be read");
}

// libarchive converts names to the thread's locale, and forgets those that it cannot hold. The program's is "C".
class Utf8Names {
public:
    Utf8Names() : utf8_(newlocale(LC_CTYPE_MASK, "C.UTF-8", nullptr)) {
        if (utf8_) before_ = uselocale(utf8_);
    }
    ~Utf8Names() {
        if (!utf8_) return;
        uselocale(before_);
        freelocale(utf8_);
    }
    Utf8Names(const Utf8Names&) = delete;
    Utf8Names& operator=(const Utf8Names&) = delete;

private:
    locale_t utf8_, before_ = nullptr;
};

SnellArchiveKind kind_of(archive_entry* entry) {
    if (archive_entry_hardlink(entry) || archive_entry_symlink(entry)) return snell_archive_other;
    if (archive_entry_filetype(entry) == AE_IFREG) return snell_archive_file;
    return archive_entry_filetype(entry) == AE_IFDIR ? snell_archive_folder : snell_archive_other;
}

}  // namespace

extern "C" {

SNELL_EXPORT void* snell_archive_open(const char* path, char* message, size_t message_size) {
    const Utf8Names names;
    archive* reading = archive_read_new();
    if (!reading) return nullptr;
    // Not all: some of libarchive's filters are other programs, which an archive would choose.
    archive_read_support_filter_gzip(reading);
    archive_read_support_filter_bzip2(reading);
    archive_read_support_filter_xz(reading);
    archive_read_support_filter_zstd(reading);
    archive_read_support_format_zip(reading);
    archive_read_support_format_tar(reading);
    archive_read_support_format_7zip(reading);
    archive_read_support_format_rar(reading);
    archive_read_support_format_rar5(reading);
    archive_read_support_format_cpio(reading);
    if (archive_read_open_filename(reading, path, 1 << 16) == ARCHIVE_OK) return reading;
    tell(reading, message, message_size);
    archive_read_free(reading);
    return nullptr;
}

SNELL_EXPORT int snell_archive_next(void* from, SnellArchiveEntry* entry, char* message, size_t message_size) {
    const Utf8Names names;
    auto* reading = static_cast<archive*>(from);
    archive_entry* found = nullptr;
    const int status = archive_read_next_header(reading, &found);
    if (status == ARCHIVE_EOF) return 0;
    if (status < ARCHIVE_WARN) {
        tell(reading, message, message_size);
        return -1;
    }
    // Names are converted to UTF-8 where the archive says how they are encoded, and otherwise left as they are.
    const char* name = archive_entry_pathname_utf8(found);
    if (!name) name = archive_entry_pathname(found);
    entry->name = name ? name : "";
    entry->kind = kind_of(found);
    return 1;
}

SNELL_EXPORT long long snell_archive_read(void* from, void* bytes, size_t size, char* message, size_t message_size) {
    auto* reading = static_cast<archive*>(from);
    const auto got = archive_read_data(reading, bytes, size);
    if (got < 0) tell(reading, message, message_size);
    return got < 0 ? -1 : static_cast<long long>(got);
}

SNELL_EXPORT void snell_archive_close(void* from) { archive_read_free(static_cast<archive*>(from)); }

SNELL_EXPORT int snell_archive_api_version(void) { return snell_archive_version; }
}
