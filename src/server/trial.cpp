#include "src/server/trial.h"

#include <chrono>

#include "parser/text/ranges.h"
#include "src/plan/values/write_back.h"
#include "src/server/documents.h"

namespace snell::server {

namespace {

constexpr std::chrono::milliseconds most_trial_time{1500};  // for all fixes of a scene

// What is read with the fixes applied; nullopt if one is in no file of the user's.
std::optional<Access> fixed(const Diagnostic& diagnostic, const Sources& sources, const Access& access) {
    std::map<FileId, std::vector<Edit>> by_file;
    for (const Fix& fix : diagnostic.fixes) by_file[fix.span.file].push_back(fix);
    auto texts = std::make_shared<std::map<std::string, std::string>>();
    if (access.instead) *texts = *access.instead;
    for (auto& [file, fixes] : by_file) {
        const std::string name(sources.name(file));
        if (name.empty() || name.starts_with('<')) return std::nullopt;
        ranges::stable_sort(fixes, {}, [](const Edit& fix) { return fix.span.begin; });
        texts->insert_or_assign(real_path(name), with_edits(sources.text(file), file, fixes));
    }
    Access with = access;
    with.instead = std::move(texts);
    return with;
}

std::ptrdiff_t same(const Diagnostics& all, const Diagnostic& one) {
    std::ptrdiff_t count = 0;
    for (const Diagnostic& d : all.items())
        if (d.code == one.code && d.message == one.message) count += 1 + static_cast<std::ptrdiff_t>(d.also.size());
    return count;
}

// Where the diagnostic is once it is fixed, if it is there at all.
std::uint32_t place_after(const Diagnostic& diagnostic) {
    std::uint32_t at = diagnostic.span.begin;
    for (const Fix& fix : diagnostic.fixes)
        if (fix.span.file == diagnostic.span.file && fix.span.begin < diagnostic.span.begin)
            at += static_cast<std::uint32_t>(fix.text.size()) - (fix.span.end - fix.span.begin);
    return at;
}

// How much is said at a place of a file, by whatever code.
std::ptrdiff_t said_at(const Checked& checked, std::string_view name, std::uint32_t at) {
    const auto there = [&](const Span& span) { return span.begin == at && checked.sources.name(span.file) == name; };
    std::ptrdiff_t count = 0;
    for (const Diagnostic& d : checked.diagnostics.items())
        if (d.has_span) count += (there(d.span) ? 1 : 0) + ranges::count_if(d.also, there);
    return count;
}

bool is_good(const Diagnostic& diagnostic, const Checked& before, const Checked& after) {
    if (after.diagnostics.errors() > before.diagnostics.errors()) return false;
    if (same(after.diagnostics, diagnostic) >= same(before.diagnostics, diagnostic)) return false;
    if (!diagnostic.has_span) return true;
    // Another message in its place would only be the next one.
    const std::string_view name = before.sources.name(diagnostic.span.file);
    return said_at(after, name, place_after(diagnostic)) < said_at(before, name, diagnostic.span.begin);
}

}  // namespace

void keep_good_fixes(Checked& checked, const Access& access, const std::function<Checked(const Access&)>& check) {
    const auto end = std::chrono::steady_clock::now() + most_trial_time;
    Diagnostics kept;
    for (Diagnostic diagnostic : checked.diagnostics.items()) {
        if (!diagnostic.fixes.empty()) {
            const auto with =
                std::chrono::steady_clock::now() < end ? fixed(diagnostic, checked.sources, access) : std::nullopt;
            if (!with || !is_good(diagnostic, checked, check(*with))) diagnostic.fixes.clear();
        }
        kept.add(std::move(diagnostic));
    }
    checked.diagnostics = std::move(kept);
}

}  // namespace snell::server
