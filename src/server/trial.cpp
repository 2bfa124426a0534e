#include "src/server/trial.h"

#include <algorithm>
#include <chrono>

#include "parser/text/ranges.h"
#include "src/server/documents.h"

namespace snell::server {

namespace {

constexpr std::chrono::milliseconds most_time{1500};  // for all fixes of a scene

// What is read with the fixes applied; nullopt if one is in no file of the user's.
std::optional<Access> fixed(const Diagnostic& diagnostic, const Sources& sources, const Access& access) {
    std::map<FileId, std::vector<Fix>> by_file;
    for (const Fix& fix : diagnostic.fixes) by_file[fix.span.file].push_back(fix);
    auto texts = std::make_shared<std::map<std::string, std::string>>();
    if (access.instead) *texts = *access.instead;
    for (auto& [file, fixes] : by_file) {
        const std::string name(sources.name(file));
        if (name.empty() || name.starts_with('<')) return std::nullopt;
        std::string text(sources.text(file));
        std::stable_sort(fixes.begin(), fixes.end(),
                         [](const Fix& a, const Fix& b) { return a.span.begin > b.span.begin; });
        for (const Fix& fix : fixes) text.replace(fix.span.begin, fix.span.end - fix.span.begin, fix.text);
        texts->insert_or_assign(real_path(name), std::move(text));
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

}  // namespace

void keep_good_fixes(Checked& checked, const Access& access, const std::function<Checked(const Access&)>& check) {
    const auto end = std::chrono::steady_clock::now() + most_time;
    Diagnostics kept;
    for (Diagnostic diagnostic : checked.diagnostics.items()) {
        if (!diagnostic.fixes.empty()) {
            const auto with =
                std::chrono::steady_clock::now() < end ? fixed(diagnostic, checked.sources, access) : std::nullopt;
            const Checked after = with ? check(*with) : Checked{};
            if (!with || after.diagnostics.errors() > checked.diagnostics.errors() ||
                same(after.diagnostics, diagnostic) >= same(checked.diagnostics, diagnostic))
                diagnostic.fixes.clear();
        }
        kept.add(std::move(diagnostic));
    }
    checked.diagnostics = std::move(kept);
}

}  // namespace snell::server
